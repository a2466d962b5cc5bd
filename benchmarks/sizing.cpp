// SPDX-License-Identifier: MIT

// Size fields: seconds of process CPU time to build one, and million queries a second on one core,
// at places near the last one (as a mesher asks) and at random places. The last column is the sum of
// the answers over their number: it keeps the work from being left out.
//
//     bench_sizing [queries, default 5000000]

#include "base/execution.h"
#include "sizing/area_size.h"
#include "sizing/graded_size.h"
#include "sizing/min_size.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
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

void measure(const char* name, const std::function<std::shared_ptr<const SizeField>()>& make,
             std::size_t queries)
{
    const double begin = cpuSeconds();
    const std::shared_ptr<const SizeField> field = make();
    const double built = cpuSeconds() - begin;
    double rates[2] {};
    double sum = 0.0;
    for (const bool near : {true, false}) {
        const std::vector<Vec2> where = places(queries, near);
        const double start = cpuSeconds();
        for (const Vec2 p : where) {
            sum += field->size(p);
        }
        rates[near ? 0 : 1] = 1e-6 * static_cast<double>(queries) / (cpuSeconds() - start);
    }
    std::printf("%-34s %8.3f %10.1f %10.1f   %.6f\n", name, built, rates[0], rates[1],
                sum / static_cast<double>(2 * queries));
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    const auto queries = static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 5e6);
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
    std::printf("%-34s %8s %10s %10s\n", "field", "build s", "near M/s", "random M/s");
    measure("200 chords", [&] { return graded(4, 50); }, queries);
    measure("10,000 chords", [&] { return graded(20, 500); }, queries);
    measure("100,000 chords", [&] { return graded(40, 2500); }, queries);
    measure("smooth area", [&] { return area(smooth); }, queries);
    measure("region with a jump", [&] { return area(jump); }, queries);
    measure("10,000 chords and a smooth area", [&] {
        return std::make_shared<MinSize>(std::vector<std::shared_ptr<const SizeField>> {
            graded(20, 500), area(smooth)});
    }, queries);
    return 0;
}
