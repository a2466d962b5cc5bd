// SPDX-License-Identifier: MIT

// Size fields: seconds of process CPU time to build one, and million queries a second on one core, at
// places near the last one (as a mesher asks) and at random places. The last column is the mean of
// the answers: it keeps the work from being left out.

#include "section.h"

#include "base/execution.h"
#include "sizing/area_size.h"
#include "sizing/graded_size.h"
#include "sizing/min_size.h"

#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace tessera;

double cpuSeconds()
{
    timespec t {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

const Box2 kBox {{0, 0}, {1, 1}};
constexpr double kTurn = 2 * std::numbers::pi;

/// Circles of many short chords, as curved outlines ask for sizes.
std::vector<SizeSource> rings(int count, int chords)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<SizeSource> sources;
    for (int ring = 0; ring < count; ++ring) {
        const Vec2 center {uniform(random), uniform(random)};
        const auto at = [&](int k) {
            const double angle = kTurn * k / chords;
            return center + 0.05 * Vec2 {std::cos(angle), std::sin(angle)};
        };
        for (int i = 0; i < chords; ++i) {
            sources.push_back({at(i), at(i + 1), 0.3 / chords});
        }
    }
    return sources;
}

std::vector<Vec2> places(std::size_t count, bool near)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<Vec2> result;
    Vec2 p {0.5, 0.5};
    for (std::size_t i = 0; i < count; ++i) {
        p = !near || i % 64 == 0 ? Vec2 {uniform(random), uniform(random)}
                                 : p + 0.002 * Vec2 {uniform(random) - 0.5, uniform(random) - 0.5};
        result.push_back(p);
    }
    return result;
}

using MakeField = std::function<std::shared_ptr<const SizeField>()>;

void measure(bench::Result& result, const MakeField& make, const std::vector<Vec2> (&where)[2])
{
    const double begin = cpuSeconds();
    const std::shared_ptr<const SizeField> field = make();
    result.columns["build s"] = cpuSeconds() - begin;
    const char* const titles[2] = {"near M/s", "random M/s"};
    double sum = 0.0;
    for (int i = 0; i < 2; ++i) {
        const double start = cpuSeconds();
        for (const Vec2 p : where[i]) {
            sum += field->size(p);
        }
        const auto queries = static_cast<double>(where[i].size());
        result.columns[titles[i]] = 1e-6 * queries / (cpuSeconds() - start);
        result.columns["mean size"] = sum / queries / (i + 1);
    }
}

} // namespace

int main(int argc, char** argv)
{
    constexpr std::size_t kQueries = 2000000;
    constexpr int kRepetitions = 3;
    const std::vector<Vec2> where[2] = {places(kQueries, true), places(kQueries, false)};
    Execution execution;
    const auto graded = [&](int count, int chords) {
        return std::make_shared<GradedSize>(kBox, rings(count, chords),
                                            GradedSize::Options {.maxSize = 0.1}, execution);
    };
    const auto area = [&](const std::function<double(Vec2)>& size) {
        const std::vector<AreaSource> sources {{"size", size}};
        return std::make_shared<AreaSize>(kBox, sources, AreaSize::Options {.maxSize = 0.1},
                                          execution);
    };
    const auto smooth = [](Vec2 p) {
        return 0.02 + 0.015 * std::sin(7 * p.x) * std::cos(9 * p.y);
    };
    const auto jump = [](Vec2 p) { return distance(p, {0.5, 0.5}) < 0.2 ? 0.002 : 0.1; };
    bench::Section section("Size fields: building and 2 x 2,000,000 queries", "");
    const auto add = [&](const std::string& name, const MakeField& make) {
        const auto run = [&where, make](bench::Result& result) { measure(result, make, where); };
        section.add(name, "Tessera", run, kRepetitions);
    };
    add("200 chords", [&] { return graded(4, 50); });
    add("10,000 chords", [&] { return graded(20, 500); });
    add("100,000 chords", [&] { return graded(40, 2500); });
    add("smooth area", [&] { return area(smooth); });
    add("region with a jump", [&] { return area(jump); });
    add("10,000 chords and a smooth area", [&] {
        return std::make_shared<MinSize>(std::vector<std::shared_ptr<const SizeField>> {
            graded(20, 500), area(smooth)});
    });
    return section.run(argc, argv);
}
