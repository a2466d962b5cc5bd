// SPDX-License-Identifier: MIT
#include "pipeline.h"
#include "pipeline/random_domains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

namespace tessera
{

namespace
{

void addLine(CurveNetwork& network, PointId a, PointId b, Role role)
{
    NetworkCurve curve;
    curve.start = a;
    curve.end = b;
    curve.operand = OperandId(0U);
    curve.role = role;
    network.curves.push_back(curve);
}

CurveNetwork squareOfSide10()
{
    CurveNetwork network;
    network.operands.push_back({"square"});
    const PointId corner[4] = {network.addPoint({0, 0}), network.addPoint({10, 0}),
                               network.addPoint({10, 10}), network.addPoint({0, 10})};
    for (int i = 0; i < 4; ++i) {
        addLine(network, corner[i], corner[(i + 1) % 4], Role::Boundary);
    }
    return network;
}

/// A square of side 10 with a round hole, and a line inside.
CurveNetwork washer()
{
    CurveNetwork network = squareOfSide10();
    const PointId start = network.addPoint({1, 2});
    addLine(network, start, network.addPoint({9, 1.5}), Role::Constraint);
    NetworkCurve circle;
    circle.geometry = makeCircleArc({5, 6}, 2.0, 0.0, 2.0 * std::numbers::pi);
    circle.start = network.addPoint(circle.geometry->point(circle.geometry->first()));
    circle.end = circle.start;
    circle.operand = OperandId(0U);
    network.curves.push_back(circle);
    return network;
}

MeshResult meshed(const MeshOptions& options, int threads = 1)
{
    Execution execution;
    execution.setThreads(threads);
    return meshNetwork(washer(), options, execution);
}

/// A square of side 10 with pairs of lines inside, so far apart.
MeshResult meshedWithSlits(std::initializer_list<double> widths, double narrowShare)
{
    CurveNetwork network = squareOfSide10();
    double y = 5.0;
    for (const double width : widths) {
        for (const double side : {y, y + width}) {
            const PointId start = network.addPoint({3, side});
            addLine(network, start, network.addPoint({7, side}), Role::Constraint);
        }
        y += 2.0;
    }
    MeshOptions options;
    options.size = 0.5;
    options.narrowShare = narrowShare;
    Execution execution;
    return meshNetwork(network, options, execution);
}

/// The number behind the words in the text; NaN without them.
double numberAfter(const std::string& words, const std::string& text)
{
    const std::size_t at = text.find(words);
    return at == std::string::npos ? std::nan("") : std::strtod(&text[at + words.size()], nullptr);
}

} // namespace

TEST(Count, FindsTheSize)
{
    for (const std::size_t count : {300U, 5000U, 40000U}) {
        MeshOptions options;
        options.count = count;
        const MeshResult made = meshed(options);
        const auto triangles = static_cast<double>(made.mesh.triangles.size());
        EXPECT_NEAR(triangles / static_cast<double>(count), 1.0, 0.05);
        EXPECT_EQ(made.report.count.target, count);
        EXPECT_TRUE(made.report.unreached.empty());
        // The size in the report makes the same mesh.
        MeshOptions again;
        again.size = made.report.count.size;
        EXPECT_EQ(meshed(again).mesh.nodes, made.mesh.nodes);
    }
}

TEST(Count, LocalSizesStayAndTheSizeMakesUpForThem)
{
    MeshOptions options;
    options.count = 6000;
    options.sizes.points.push_back({{8, 8}, {0.02}});
    const MeshResult made = meshed(options);
    EXPECT_NEAR(static_cast<double>(made.mesh.triangles.size()), 6000.0, 300.0);
    double nearest = 1e9;
    for (const Vec2 p : made.mesh.nodes) {
        if (!(p == Vec2 {8, 8})) {
            nearest = std::min(nearest, distance(p, {8, 8}));
        }
    }
    EXPECT_LT(nearest, 0.05);
}

TEST(Count, WhatCannotBeReachedIsListed)
{
    MeshOptions options;
    options.count = 4; // the circle alone needs more
    const MeshResult made = meshed(options);
    ASSERT_FALSE(made.report.unreached.empty());
    const Unreached& item = made.report.unreached.back();
    EXPECT_EQ(item.what, "count");
    EXPECT_EQ(item.target, 4.0);
    EXPECT_EQ(item.value, static_cast<double>(made.mesh.triangles.size()));
}

TEST(Count, NoSizeBelowTheLeastIsTried)
{
    MeshOptions options;
    options.count = 100000;
    options.minSize = 0.5;
    const MeshResult made = meshed(options);
    EXPECT_EQ(made.report.count.size, 0.5);
    ASSERT_FALSE(made.report.unreached.empty());
    EXPECT_EQ(made.report.unreached.back().what, "count");
    EXPECT_GT(made.mesh.triangles.size(), 500U);
}

TEST(Count, ExcludesASize)
{
    MeshOptions options;
    options.count = 100;
    options.size = 1.0;
    EXPECT_THROW(meshed(options), Error);
}

TEST(Count, ProgressNeverFallsOverItsRuns)
{
    MeshOptions options;
    options.count = 6000;
    options.sizes.points.push_back({{8, 8}, {0.02}});
    std::vector<double> fractions;
    Execution execution;
    execution.setProgress([&](double fraction, const char*) { fractions.push_back(fraction); });
    const MeshResult made = meshNetwork(washer(), options, execution);
    EXPECT_GT(made.report.count.runs, 1);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LE(fractions.back(), 1.0);
}

TEST(FrozenBoundary, StraightCurvesStayWhole)
{
    MeshOptions options;
    options.size = 0.4;
    options.freezeBoundary = true;
    const MeshResult made = meshed(options);
    std::size_t straight = 0;
    for (std::size_t e = 0; e < made.mesh.edges.size(); ++e) {
        const CurveId curve = made.mesh.edgeCurves[made.mesh.edgeCurveStart[e]];
        straight += curve.index() < 5 ? 1 : 0;
    }
    EXPECT_EQ(straight, 5U); // four sides and the line
    EXPECT_EQ(std::count(made.mesh.nodeOrigin.begin(), made.mesh.nodeOrigin.end(),
                         VertexOrigin::SegmentSplit),
              0);
    // The inside is filled all the same, and what is bad beside long edges is told.
    EXPECT_GT(made.mesh.triangles.size(), 400U);
    EXPECT_FALSE(made.report.unreached.empty());
}

TEST(FrozenBoundary, LargeAreasOfGoodTrianglesAreListed)
{
    CurveNetwork network;
    network.operands.push_back({"triangle"});
    const PointId corner[3] = {network.addPoint({0, 0}), network.addPoint({1, 0}),
                               network.addPoint({0.5, 0.8})};
    for (int i = 0; i < 3; ++i) {
        addLine(network, corner[i], corner[(i + 1) % 3], Role::Boundary);
    }
    MeshOptions options;
    options.size = 2.0;
    options.maxArea = 0.3;
    options.freezeBoundary = true;
    Execution execution;
    const MeshResult made = meshNetwork(network, options, execution);
    ASSERT_EQ(made.mesh.triangles.size(), 1U);
    ASSERT_EQ(made.report.unreached.size(), 1U);
    EXPECT_EQ(made.report.unreached[0].what, "max_area");
    EXPECT_NEAR(made.report.unreached[0].value, 0.4, 1e-12);
}

TEST(NarrowGaps, ThatTakeMostOfTheTrianglesAreTold)
{
    const MeshResult coarse = meshedWithSlits({0.002}, 0.0);
    EXPECT_TRUE(coarse.report.messages.empty());
    EXPECT_FALSE(coarse.report.unreached.empty());
    const MeshResult fine = meshedWithSlits({0.002}, 40.0);
    EXPECT_TRUE(fine.report.unreached.empty());
    EXPECT_GT(fine.mesh.triangles.size(), 10 * coarse.mesh.triangles.size());
    ASSERT_EQ(fine.report.messages.size(), 1U);
    const std::string& text = fine.report.messages[0];
    EXPECT_NE(text.find("most of the triangles; the narrowest is 0.002 wide at"), std::string::npos)
        << text;
    EXPECT_NE(text.find(", 5.001)"), std::string::npos) << text;
    const double x = numberAfter("wide at (", text);
    EXPECT_GE(x, 3.0);
    EXPECT_LE(x, 7.0);
    EXPECT_NE(text.find("narrow gaps = 0"), std::string::npos) << text;
    const MeshResult plain = meshedWithSlits({}, 40.0);
    EXPECT_TRUE(plain.report.messages.empty());
    // Both sides of the slit are divided alike, which must not divide them ever further.
    EXPECT_LT(coarse.mesh.triangles.size(), 2 * plain.mesh.triangles.size());
}

TEST(NarrowGaps, ThatAreLeftAreToldWithTheShareTheyNeed)
{
    const MeshResult left = meshedWithSlits({0.002, 0.001}, 1.0);
    ASSERT_EQ(left.report.messages.size(), 1U);
    const std::string& text = left.report.messages[0];
    EXPECT_NE(text.find("left coarse, with small angles; the narrowest is 0.001 wide at"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find(", 7.0005)"), std::string::npos) << text;
    EXPECT_NE(text.find("divide them finely"), std::string::npos) << text;
    const double share = numberAfter("narrow gaps = ", text);
    ASSERT_GT(share, 1.0);
    const MeshResult followed = meshedWithSlits({0.002, 0.001}, share);
    ASSERT_EQ(followed.report.messages.size(), 1U);
    EXPECT_NE(followed.report.messages[0].find("most of the triangles"), std::string::npos);
    EXPECT_TRUE(followed.report.unreached.empty());
    // A smaller share leaves the narrower one.
    const MeshResult half = meshedWithSlits({0.002, 0.001}, 0.9 * share);
    ASSERT_EQ(half.report.messages.size(), 2U);
    EXPECT_NE(half.report.messages[0].find("0.002 wide"), std::string::npos);
    EXPECT_NE(half.report.messages[1].find("0.001 wide"), std::string::npos);
}

/// In a fan of lines of different lengths the pieces beside one gap open the next: followed to the
/// end it took more than a million triangles where the estimate was some ten thousand.
TEST(NarrowGaps, ThatTakeFarMoreThanEstimatedAreLeft)
{
    CurveNetwork network = squareOfSide10();
    const PointId tip = network.addPoint({5, 5});
    for (int i = 0; i < 30; ++i) {
        const double length = 2.0 - 0.04 * (7 * i % 30);
        const double angle = 4.3 + 1e-5 * i;
        addLine(network, tip,
                network.addPoint({5 + length * std::cos(angle), 5 + length * std::sin(angle)}),
                Role::Constraint);
    }
    Execution execution;
    const MeshResult result = meshNetwork(network, MeshOptions(), execution);
    EXPECT_LT(result.mesh.triangles.size(), 30000U);
    ASSERT_FALSE(result.report.messages.empty());
    const std::string& text = result.report.messages.back();
    EXPECT_NE(text.find("are left coarse"), std::string::npos) << text;
    // The estimate was wrong, so that no share is named.
    EXPECT_EQ(text.find("narrow gaps = "), std::string::npos) << text;
    EXPECT_FALSE(result.report.unreached.empty());
}

TEST(NarrowGaps, ThatTakeTooMuchAreToldWithoutAShare)
{
    const MeshResult one = meshedWithSlits({1e-9}, 40.0);
    ASSERT_EQ(one.report.messages.size(), 1U);
    EXPECT_NE(one.report.messages[0].find("takes more than 500000 triangles"), std::string::npos);
    const MeshResult two = meshedWithSlits({0.002, 1e-9}, 1.0);
    ASSERT_EQ(two.report.messages.size(), 1U);
    EXPECT_NE(two.report.messages[0].find("divide 1 of 2 finely"), std::string::npos)
        << two.report.messages[0];
}

TEST(Threads, TheMeshIsTheSameForAnyNumber)
{
    for (const double size : {0.02, 0.0}) {
        MeshOptions options;
        options.size = size;
        if (size == 0.0) {
            options.sizes.points.push_back({{8, 8}, {0.002}});
            options.growth = 0.02;
        }
        const MeshResult one = meshed(options, 1);
        for (const int threads : {2, 3, 7}) {
            const MeshResult many = meshed(options, threads);
            EXPECT_EQ(one.mesh.nodes, many.mesh.nodes);
            EXPECT_EQ(one.mesh.triangles, many.mesh.triangles);
            EXPECT_EQ(one.mesh.triangleRegion, many.mesh.triangleRegion);
            EXPECT_EQ(one.mesh.edges, many.mesh.edges);
            EXPECT_EQ(one.report.area, many.report.area);
            EXPECT_EQ(one.report.quality.meanQuality, many.report.quality.meanQuality);
        }
    }
}

/// Refinement took their distances for unbounded and put nothing between them.
TEST(EmbeddedPoints, NeedlesBetweenThemAreMended)
{
    CurveNetwork network = washer();
    for (const Vec2 p : {Vec2 {1.3, 3.8}, Vec2 {1.3, 3.5}, Vec2 {1.7, 4.2}, Vec2 {2.1, 3.0}}) {
        network.embedded.push_back({network.addPoint(p), OperandId(0U), ""});
    }
    MeshOptions options;
    options.size = 3.0;
    Execution execution;
    const MeshResult made = meshNetwork(network, options, execution);
    EXPECT_TRUE(made.report.unreached.empty());
    EXPECT_GE(made.report.quality.minAngle, 30.0);
}

/// A part of what the benchmark "domains" meshes.
TEST(RandomDomains, AreValidAndGood)
{
    testing::RandomDomainTally tally;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        tally.add(seed, 0.03);
    }
    EXPECT_EQ(tally.domains, 60U);
    EXPECT_EQ(tally.broken, 0U);
    EXPECT_EQ(tally.hidden, 0U);
    EXPECT_LE(tally.below, 1U);
    EXPECT_GE(tally.blunt, 10U);
    EXPECT_EQ(tally.bluntGood, tally.blunt);
}

} // namespace tessera
