// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "sizing/area_size.h"
#include "sizing/background_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

constexpr double kInfinite = std::numeric_limits<double>::infinity();
const Box2 kBox {{0, 0}, {10, 6}};

struct Case
{
    const char* name;
    std::function<double(Vec2)> size;
};

/// Smooth, steep, kinked, jumping and nearly flat sizes.
const std::vector<Case> kCases {
    {"linear, slow", [](Vec2 p) { return 0.3 + 0.05 * p.x; }},
    {"linear, steep", [](Vec2 p) { return 0.1 + 2.0 * p.x; }},
    {"step", [](Vec2 p) { return p.x + 0.3 * p.y < 4.0 ? 0.1 : 1.0; }},
    {"disk", [](Vec2 p) { return distance(p, {6, 2}) < 1.0 ? 0.05 : kInfinite; }},
    {"waves", [](Vec2 p) { return 0.5 + 0.3 * std::sin(2 * p.x) * std::cos(3 * p.y); }},
    {"bump", [](Vec2 p) { return 1.0 - 0.9 * std::exp(-8.0 * squaredLength(p - Vec2 {5, 3})); }},
    {"valley", [](Vec2 p) { return 0.05 + std::abs(p.x - p.y); }},
};

AreaSize makeField(const Case& c, double growth)
{
    Execution execution;
    const std::vector<AreaSource> sources {{c.name, c.size, false}};
    return AreaSize(kBox, sources, {.maxSize = 1.5, .growth = growth}, execution);
}

/// The definition, over a fine grid of places.
class BruteForce
{
public:
    BruteForce(const std::function<double(Vec2)>& size, double growth)
        : growth_(growth)
    {
        for (int i = 0; i <= kCountX; ++i) {
            for (int j = 0; j <= kCountY; ++j) {
                const Vec2 p {10.0 * i / kCountX, 6.0 * j / kCountY};
                places_.push_back({p, std::min(1.5, size(p))});
            }
        }
    }
    double at(Vec2 p, double here) const
    {
        double least = std::min(1.5, here);
        for (const auto& [place, size] : places_) {
            least = std::min(least, size + growth_ * std::sqrt(squaredLength(place - p)));
        }
        return least;
    }

private:
    static constexpr int kCountX = 300;
    static constexpr int kCountY = 180;

    double growth_;
    std::vector<std::pair<Vec2, double>> places_;
};

TEST(AreaSize, AgreesWithBruteForce)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const Case& c : kCases) {
        for (const double growth : {0.1, 0.3, 1.0}) {
            const AreaSize field = makeField(c, growth);
            const BruteForce exact(c.size, growth);
            double low = 1.0;
            double high = 1.0;
            for (int i = 0; i < 100; ++i) {
                const Vec2 p {10 * uniform(random), 6 * uniform(random)};
                const double ratio = field.size(p) / exact.at(p, c.size(p));
                low = std::min(low, ratio);
                high = std::max(high, ratio);
            }
            std::printf("%-13s growth %.2f: %7zu cells, field / definition %.3f .. %.3f\n", c.name,
                        growth, field.cellCount(), low, high);
            // Below by the slope kept in reserve, and as the grid of the definition is coarse.
            EXPECT_GE(low, 0.91) << c.name << growth;
            EXPECT_LE(high, 1.05) << c.name << growth;
        }
    }
}

TEST(AreaSize, IsLipschitzBetweenPointsASizeApart)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const Case& c : kCases) {
        for (const double growth : {0.1, 0.3, 1.0}) {
            const AreaSize field = makeField(c, growth);
            double steepest = 0.0;
            for (int i = 0; i < 40000; ++i) {
                const Vec2 p {10 * uniform(random), 6 * uniform(random)};
                const double h = field.size(p);
                const double angle = 2 * std::numbers::pi * uniform(random);
                const double reach = (0.7 + uniform(random)) * h;
                const Vec2 q = p + reach * Vec2 {std::cos(angle), std::sin(angle)};
                if (kBox.contains(q)) {
                    steepest = std::max(steepest, std::abs(field.size(q) - h) / distance(p, q));
                }
            }
            EXPECT_LE(steepest, growth) << c.name;
        }
    }
}

TEST(AreaSize, ConstantAndLinearFieldsAreExactAndSmall)
{
    const AreaSize constant = makeField({"constant", [](Vec2) { return 0.25; }}, 0.3);
    EXPECT_EQ(constant.size({3, 2}), 0.25);
    EXPECT_LT(constant.cellCount(), 20000U);
    const AreaSize linear = makeField({"linear", [](Vec2 p) { return 0.1 + 0.1 * p.x; }}, 0.3);
    EXPECT_NEAR(linear.size({3, 2}), 0.4, 1e-12);
    EXPECT_LT(linear.cellCount(), 20000U);
    EXPECT_EQ(linear.size({-5, 2}), linear.size({0, 2}));
    EXPECT_EQ(linear.size({3, 99}), linear.size({3, 6}));
}

TEST(AreaSize, BoxesWithoutHeightAndThinOnes)
{
    Execution execution;
    const std::vector<AreaSource> sources {{"x", [](Vec2 p) { return 0.01 + 0.1 * p.x; }}};
    const AreaSize::Options options {.maxSize = 1.0};
    const AreaSize line({{0, 1}, {10, 1}}, sources, options, execution);
    EXPECT_NEAR(line.size({5, 1}), 0.51, 1e-9);
    const AreaSize point({{2, 1}, {2, 1}}, sources, options, execution);
    EXPECT_NEAR(point.size({2, 1}), 0.21, 1e-12);
    const AreaSize thin({{0, 0}, {1000, 0.01}}, sources, options, execution);
    EXPECT_NEAR(thin.size({5, 0.005}), 0.51, 1e-6);
    const AreaSize upright({{0, 0}, {0.01, 1000}}, sources, options, execution);
    EXPECT_NEAR(upright.size({0.005, 500}), 0.0105, 1e-6);
}

TEST(AreaSize, WorksAtAnyScale)
{
    Execution execution;
    for (const double scale : {1e-100, 1e-30, 1e30, 1e100}) {
        const std::vector<AreaSource> sources {
            {"step", [scale](Vec2 p) { return p.x < 3 * scale ? 0.1 * scale : 2.0 * scale; }}};
        const AreaSize field({{0, 0}, {10 * scale, 6 * scale}}, sources,
                             {.maxSize = 1.5 * scale}, execution);
        EXPECT_NEAR(field.size({scale, scale}) / scale, 0.1, 1e-12);
        EXPECT_NEAR(field.size({5 * scale, scale}) / scale, 0.7, 0.04);
    }
}

TEST(AreaSize, RefusesSizesThatAreNotPositiveNamingThePlace)
{
    Execution execution;
    for (const double bad : {0.0, -1.0, std::nan(""), kInfinite, -kInfinite}) {
        const std::vector<AreaSource> sources {
            {"The size expression 'x'", [bad](Vec2 p) { return p.x > 7.0 ? bad : 1.0; }}};
        try {
            const AreaSize field(kBox, sources, {.maxSize = 2.0}, execution);
            ADD_FAILURE() << "accepted " << bad;
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::InvalidOption);
            ASSERT_EQ(error.places().size(), 1U);
            EXPECT_GT(error.places()[0].position.x, 7.0);
            EXPECT_NE(std::string(error.what()).find("The size expression 'x'"), std::string::npos);
        }
    }
}

TEST(AreaSize, WhatIsNotMeshedMayHaveAnySize)
{
    Execution execution;
    const std::vector<AreaSource> sources {
        {"The size expression 'x - 5'", [](Vec2 p) { return p.x - 5.0; }}};
    AreaSize::Options options {.maxSize = 4.0, .growth = 0.3};
    options.inside = [](Vec2 p) { return p.x > 6.0; };
    const AreaSize field(kBox, sources, options, execution);
    for (double x = 6.001; x < 10.0; x += 0.01) {
        // Limited in growth, from the smallest size that is meshed.
        const double expected = std::min(x - 5.0, 1.0 + 0.3 * (x - 6.0));
        EXPECT_NEAR(field.size({x, 3.0}), expected, 0.05 * expected) << x;
    }
    options.inside = [](Vec2 p) { return p.x > 5.0; };
    EXPECT_THROW(AreaSize(kBox, sources, options, execution), Error);
}

TEST(AreaSize, CanBeCancelled)
{
    Execution execution;
    execution.cancel();
    const std::vector<AreaSource> sources {{"one", [](Vec2) { return 1.0; }}};
    EXPECT_THROW(AreaSize(kBox, sources, {.maxSize = 2.0}, execution), Error);
}

/// A grid over the box, its inner nodes moved, every cell two triangles.
BackgroundMesh randomMesh(std::mt19937& random, int count)
{
    std::uniform_real_distribution<double> uniform(-0.3, 0.3);
    BackgroundMesh mesh {"sizes", {}, {}, {}};
    for (int j = 0; j <= count; ++j) {
        for (int i = 0; i <= count; ++i) {
            const bool inner = i > 0 && i < count && j > 0 && j < count;
            mesh.nodes.push_back({10.0 * (i + (inner ? uniform(random) : 0)) / count,
                                  6.0 * (j + (inner ? uniform(random) : 0)) / count});
            mesh.sizes.push_back(0.3 + 0.5 * uniform(random));
        }
    }
    for (int j = 0; j < count; ++j) {
        for (int i = 0; i < count; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (count + 1) + i);
            const auto b = a + static_cast<std::uint32_t>(count) + 1;
            mesh.triangles.push_back({a, a + 1, b + 1});
            mesh.triangles.push_back({a, b, b + 1}); // clockwise: either will do
        }
    }
    return mesh;
}

double sizeByLookingAtAll(const BackgroundMesh& mesh, Vec2 p)
{
    for (const auto& v : mesh.triangles) {
        const Vec2 a = mesh.nodes[v[0]];
        const Vec2 b = mesh.nodes[v[1]];
        const Vec2 c = mesh.nodes[v[2]];
        const double area = cross(b - a, c - a);
        const double u = cross(b - p, c - p) / area;
        const double w = cross(c - p, a - p) / area;
        if (u >= -1e-12 && w >= -1e-12 && u + w <= 1 + 1e-12) {
            return u * mesh.sizes[v[0]] + w * mesh.sizes[v[1]] + (1 - u - w) * mesh.sizes[v[2]];
        }
    }
    return 0.0;
}

TEST(BackgroundSize, InterpolatesLinearly)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const int count : {1, 4, 23}) {
        const BackgroundMesh mesh = randomMesh(random, count);
        const AreaSource source = backgroundSource(mesh);
        for (int i = 0; i < 500; ++i) {
            const Vec2 p {10 * uniform(random), 6 * uniform(random)};
            EXPECT_NEAR(source.size(p), sizeByLookingAtAll(mesh, p), 1e-9);
        }
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            EXPECT_NEAR(source.size(mesh.nodes[i]), mesh.sizes[i], 1e-9);
        }
    }
}

TEST(BackgroundSize, OutsideTheNearestPointCounts)
{
    const AreaSource source = backgroundSource(
        {"sizes", {{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, {1.0, 2.0, 3.0}});
    EXPECT_NEAR(source.size({0.25, -7}), 1.25, 1e-12);
    EXPECT_NEAR(source.size({9, -9}), 2.0, 1e-12);
    EXPECT_NEAR(source.size({5, 5}), 2.5, 1e-12);
}

TEST(BackgroundSize, TheFieldFollowsSlowMeshesAndLimitsSteepOnes)
{
    Execution execution;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    BackgroundMesh mesh = randomMesh(random, 12);
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        mesh.sizes[i] = 0.2 + 0.1 * mesh.nodes[i].x;
    }
    const std::vector<AreaSource> slow {backgroundSource(mesh)};
    const AreaSize field(kBox, slow, {.maxSize = 5.0, .growth = 0.3}, execution);
    for (int i = 0; i < 300; ++i) {
        const Vec2 p {10 * uniform(random), 6 * uniform(random)};
        EXPECT_NEAR(field.size(p), 0.2 + 0.1 * p.x, 1e-9);
    }
    // One node asks for much less than its neighbors.
    std::fill(mesh.sizes.begin(), mesh.sizes.end(), 1.0);
    mesh.sizes[6 * 13 + 6] = 0.01;
    const Vec2 spot = mesh.nodes[6 * 13 + 6];
    const std::vector<AreaSource> steep {backgroundSource(mesh)};
    const AreaSize limited(kBox, steep, {.maxSize = 5.0, .growth = 0.3}, execution);
    EXPECT_LT(limited.size(spot), 0.03);
    EXPECT_NEAR(limited.size(spot + Vec2 {1.0, 0.0}), 0.31, 0.03);
}

TEST(BackgroundSize, RefusesWhatIsWrong)
{
    const BackgroundMesh good {"sizes.vtu", {{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, {1, 2, 3}};
    const auto refuse = [](const BackgroundMesh& mesh, const char* text) {
        try {
            backgroundSource(mesh);
            ADD_FAILURE() << "accepted; expected: " << text;
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::InvalidOption);
            EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).rfind("sizes.vtu: ", 0), 0U);
        }
    };
    BackgroundMesh bad = good;
    bad.sizes = {1.0, 2.0};
    refuse(bad, "2 sizes for 3 nodes");
    bad.sizes = {1.0, 0.0, 2.0};
    refuse(bad, "the size at node 1, at (1, 0), is 0");
    bad.sizes = {1.0, 1.0, std::nan("")};
    refuse(bad, "at node 2");
    bad = good;
    bad.triangles.clear();
    refuse(bad, "no triangles");
    bad.triangles = {{0, 1, 3}};
    refuse(bad, "a node 3");
}

} // namespace
} // namespace tessera
