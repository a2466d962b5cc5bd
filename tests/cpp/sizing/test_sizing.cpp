// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "curve/arc.h"
#include "curve/polyline.h"
#include "sizing/curve_sources.h"
#include "sizing/graded_size.h"
#include "sizing/make_size_field.h"
#include "sizing/min_size.h"
#include "sizing/uniform_size.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

constexpr double kTurn = 2 * std::numbers::pi;

std::vector<SizeSource> randomSources(std::mt19937& random, int count, double reach)
{
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<SizeSource> sources;
    for (int i = 0; i < count; ++i) {
        const Vec2 a {uniform(random), uniform(random)};
        const Vec2 b = a + Vec2 {reach * uniform(random), reach * uniform(random)};
        sources.push_back({a, random() % 2 == 0 ? a : b, 0.001 * std::pow(50.0, uniform(random))});
    }
    return sources;
}

double bruteForce(const std::vector<SizeSource>& sources, Vec2 p, double growth, double maxSize)
{
    double least = maxSize;
    for (const SizeSource& source : sources) {
        double nearest = std::min(distance(p, source.a), distance(p, source.b));
        for (int i = 0; i <= 100; ++i) {
            const double s = i / 100.0;
            nearest = std::min(nearest, distance(p, (1 - s) * source.a + s * source.b));
        }
        least = std::min(least, source.size + growth * nearest);
    }
    return least;
}

const Box2 kUnitBox {{0, 0}, {1, 1}};

TEST(GradedSize, AgreesWithBruteForce)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const Execution execution;
    for (const int count : {1, 5, 40, 400}) {
        for (const double growth : {0.05, 0.3, 1.0}) {
            const auto sources = randomSources(random, count, 0.1);
            const GradedSize field(kUnitBox, sources, {.maxSize = 0.2, .growth = growth},
                                   execution);
            for (int i = 0; i < 200; ++i) {
                const Vec2 p {uniform(random), uniform(random)};
                const double expected = bruteForce(sources, p, growth, 0.2);
                const double h = field.size(p);
                // Not above the definition; below it by the slope kept in reserve.
                EXPECT_LE(h, expected * (1 + 0.01 * growth + 1e-12));
                EXPECT_GE(h, 0.96 * expected);
            }
        }
    }
}

TEST(GradedSize, DominatedSourcesChangeNothing)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int round = 0; round < 20; ++round) {
        // A chain of segments with sizes equal to their lengths, as short curves make them.
        std::vector<SizeSource> sources;
        Vec2 p {0.5, 0.5};
        for (int i = 0; i < 200; ++i) {
            const double size = 0.001 * std::pow(30.0, uniform(random));
            const double angle = kTurn * uniform(random);
            const Vec2 q = p + size * Vec2 {std::cos(angle), std::sin(angle)};
            sources.push_back({p, q, size});
            p = q;
        }
        const std::vector<SizeSource> rest = withoutDominated(sources, 0.3);
        EXPECT_LT(rest.size(), sources.size());
        for (int i = 0; i < 200; ++i) {
            const Vec2 at {uniform(random), uniform(random)};
            EXPECT_NEAR(bruteForce(rest, at, 0.3, 1.0), bruteForce(sources, at, 0.3, 1.0), 2e-5);
        }
    }
    EXPECT_TRUE(withoutDominated({}, 0.3).empty());
}

TEST(GradedSize, IsLipschitzBetweenPointsASizeApart)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const Execution execution;
    const double growth = 0.3;
    const auto sources = randomSources(random, 300, 0.02);
    const GradedSize field(kUnitBox, sources, {.maxSize = 0.5, .growth = growth}, execution);
    double steepest = 0.0;
    for (int i = 0; i < 200000; ++i) {
        const Vec2 p {uniform(random), uniform(random)};
        const double h = field.size(p);
        const double angle = kTurn * uniform(random);
        const Vec2 q = p + (0.7 + uniform(random)) * h * Vec2 {std::cos(angle), std::sin(angle)};
        if (kUnitBox.contains(q)) {
            steepest = std::max(steepest, std::abs(field.size(q) - h) / distance(p, q));
        }
    }
    EXPECT_LE(steepest, growth);
    EXPECT_GE(steepest, 0.9 * growth);
    RecordProperty("steepest", std::to_string(steepest));
}

TEST(GradedSize, HonorsItsBoundsAndTheBox)
{
    const Execution execution;
    const std::vector<SizeSource> sources {{{0.5, 0.5}, {0.5, 0.5}, 1e-6}};
    const GradedSize field(kUnitBox, sources, {.maxSize = 0.1, .minSize = 0.01}, execution);
    EXPECT_EQ(field.size({0.5, 0.5}), 0.01);
    EXPECT_EQ(field.size({0.0, 0.0}), 0.1);
    EXPECT_EQ(field.size({-5.0, 7.0}), field.size({0.0, 1.0}));
    EXPECT_EQ(field.uniformSize(), 0.0);
    const GradedSize empty(kUnitBox, {}, {.maxSize = 0.1}, execution);
    EXPECT_EQ(empty.size({0.3, 0.3}), 0.1);
    const GradedSize point({{1, 1}, {1, 1}}, sources, {.maxSize = 9}, execution);
    EXPECT_GT(point.size({1, 1}), 0.0);
}

TEST(GradedSize, TenMillionQueriesASecondOnAGradedField)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const Execution execution;
    std::vector<SizeSource> sources;
    for (int ring = 0; ring < 20; ++ring) {
        const Vec2 center {uniform(random), uniform(random)};
        for (int i = 0; i < 500; ++i) {
            const auto at = [&](int k) {
                return center + 0.05 * Vec2 {std::cos(kTurn * k / 500), std::sin(kTurn * k / 500)};
            };
            sources.push_back({at(i), at(i + 1), 6e-4});
        }
    }
    const auto begin = std::clock();
    const GradedSize field(kUnitBox, sources, {.maxSize = 0.1}, execution);
    const auto built = std::clock();
    Vec2 p {0.5, 0.5};
    double sum = 0.0;
    for (int i = 0; i < 1000000; ++i) {
        // Mostly near the last query, as a mesher asks.
        p = i % 64 == 0 ? Vec2 {uniform(random), uniform(random)}
                        : Vec2 {p.x + 0.001 * (uniform(random) - 0.5),
                                p.y + 0.001 * (uniform(random) - 0.5)};
        sum += field.size(p);
    }
    const auto done = std::clock();
    const double buildSeconds = static_cast<double>(built - begin) / CLOCKS_PER_SEC;
    const double querySeconds = static_cast<double>(done - built) / CLOCKS_PER_SEC;
    std::printf("10,000 sources: built in %.3f s, 1e6 queries in %.3f s (sum %g)\n", buildSeconds,
                querySeconds, sum);
    EXPECT_LT(querySeconds, 2.0);
    EXPECT_LT(buildSeconds, 5.0);
}

CurveNetwork squareWith(double side)
{
    CurveNetwork network;
    network.operands.resize(1);
    const std::vector<Vec2> corners {{0, 0}, {side, 0}, {side, side}, {0, side}};
    addPolyline(network, corners, true, OperandId(0U), Role::Boundary);
    return network;
}

TEST(MakeSizeField, UniformWhereNothingIsSmaller)
{
    Execution execution;
    const CurveNetwork network = squareWith(10);
    EXPECT_DOUBLE_EQ(defaultSize(network), std::sqrt(200.0) / 40);
    const auto field = makeSizeField(network, {}, execution);
    EXPECT_DOUBLE_EQ(field->uniformSize(), std::sqrt(200.0) / 40);
    EXPECT_EQ(makeSizeField(network, {.size = 10}, execution)->uniformSize(), 10.0);
    EXPECT_EQ(makeSizeField(CurveNetwork {}, {}, execution)->uniformSize(), 1.0);
}

TEST(MakeSizeField, GrowsFromAShortCurve)
{
    Execution execution;
    CurveNetwork network = squareWith(10);
    const std::vector<Vec2> shortOne {{5, 5}, {5.01, 5}};
    addPolyline(network, shortOne, false, OperandId(0U), Role::Constraint);
    const auto field = makeSizeField(network, {.size = 1, .growth = 0.3}, execution);
    EXPECT_EQ(field->uniformSize(), 0.0);
    EXPECT_NEAR(field->size({5, 5}), 0.01, 1e-12);
    EXPECT_NEAR(field->size({6.01, 5}), 0.31, 0.01);
    EXPECT_EQ(field->size({0, 0}), 1.0);
}

TEST(MakeSizeField, ASmallCircleGetsItsPieces)
{
    Execution execution;
    CurveNetwork network = squareWith(10);
    const PointId p = network.addPoint({5.1, 5});
    network.curves.push_back({makeCircleArc({5, 5}, 0.1, 0, kTurn), p, p, OperandId(0U)});
    for (const double pieces : {8.0, 24.0, 100.0}) {
        const auto field =
            makeSizeField(network, {.size = 1, .local = {.piecesPerTurn = pieces}}, execution);
        for (int i = 0; i < 50; ++i) {
            const Vec2 q {5 + 0.1 * std::cos(i), 5 + 0.1 * std::sin(i)};
            EXPECT_NEAR(field->size(q), 0.2 * std::numbers::pi / pieces,
                        0.07 * 0.2 * std::numbers::pi / pieces);
        }
    }
    const auto byChord =
        makeSizeField(network, {.size = 1, .local = {.piecesPerTurn = 3, .chordError = 1e-4}},
                      execution);
    EXPECT_NEAR(byChord->size({5.1, 5}), std::sqrt(8e-4 * 0.1), 1e-3);
}

TEST(MakeSizeField, AFlatEllipseIsFinestAtItsTips)
{
    Execution execution;
    CurveNetwork network;
    network.operands.resize(1);
    const PointId p = network.addPoint({10, 0});
    network.curves.push_back({makeEllipseArc({0, 0}, 10, 1, 0, 0, kTurn), p, p, OperandId(0U)});
    const auto field = makeSizeField(network, {.size = 2}, execution);
    const double tip = kTurn / 20 * 0.1; // radius of curvature b^2 / a
    EXPECT_NEAR(field->size({10, 0}), tip, 0.1 * tip);
    EXPECT_NEAR(field->size({-10, 0}), tip, 0.1 * tip);
    EXPECT_EQ(field->size({0, 1}), 2.0);
}

TEST(MakeSizeField, MinimumWithAFieldOfTheCaller)
{
    Execution execution;
    const CurveNetwork network = squareWith(10);
    const std::vector<SizeSource> sources {{{0, 0}, {0, 0}, 0.1}};
    const auto base = std::make_shared<GradedSize>(Box2 {{0, 0}, {10, 10}}, sources,
                                                   GradedSize::Options {.maxSize = 3}, execution);
    const auto field = makeSizeField(network, base, {.size = 3}, execution);
    EXPECT_NEAR(field->size({0, 0}), 0.1, 1e-12);
    EXPECT_NEAR(field->size({10, 10}), 3.0, 1e-12);
    const MinSize minimum({std::make_shared<UniformSize>(2.0), std::make_shared<UniformSize>(1.0)});
    EXPECT_EQ(minimum.size({0, 0}), 1.0);
    EXPECT_EQ(minimum.uniformSize(), 1.0);
    EXPECT_EQ(minimum.gradientBound(), 0.0);
}

TEST(MakeSizeField, RefusesBadOptions)
{
    Execution execution;
    const CurveNetwork network = squareWith(10);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<SizeOptions> bad {
        {.size = -1},       {.size = nan},          {.minSize = -1}, {.size = 1, .minSize = 2},
        {.growth = 0},
        {.growth = 2},
        {.growth = nan},
        {.minSize = nan},
        {.local = {.piecesPerTurn = 1}},
        {.local = {.chordError = -1}},
        {.local = {.piecesPerTurn = nan}},
        {.local = {.chordError = nan}},
        {.local = {.gap = -1}},
        {.local = {.gap = nan}},
        {.local = {.points = {{{0, 0}, {0.0}}}}},
        {.local = {.points = {{{0, 0}, {nan}}}}},
        {.local = {.points = {{{nan, 0}, {1.0}}}}},
        {.local = {.points = {{{0, 0}, {1.0, -1.0}}}}},
        {.local = {.points = {{{0, 0}, {1.0, 1.0, 2.0, 0.5}}}}},
        {.local = {.points = {{{0, 0}, {1.0, 1.0, 0.5, 2.0}}}}},
        {.local = {.curves = {{{CurveId(7U)}, {1.0}}}}},
        {.local = {.curves = {{{CurveId(0U)}, {-1.0}}}}},
    };
    for (const SizeOptions& options : bad) {
        EXPECT_THROW(makeSizeField(network, options, execution), Error);
    }
}

} // namespace
} // namespace tessera
