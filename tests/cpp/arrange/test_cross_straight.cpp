// SPDX-License-Identifier: MIT
#include "arrange/arrange.h"
#include "curve/arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tessera
{

namespace
{

PointId addLine(CurveNetwork& network, Vec2 a, Vec2 b, Role role = Role::Boundary)
{
    const PointId start = network.addPoint(a);
    const PointId end = network.addPoint(b);
    network.curves.push_back({nullptr, start, end, OperandId(0U), role, 0,
                              static_cast<std::uint32_t>(network.curves.size())});
    return start;
}

CurveNetwork arranged(const CurveNetwork& network, ArrangeReport& report)
{
    ArrangeOptions options;
    options.crossStraight = true;
    Execution execution;
    return arrange(network, options, report, execution);
}

} // namespace

TEST(CrossStraight, PiecesRunFromEndToEndThroughCrossings)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(0.0, 1.0);
    CurveNetwork network;
    network.operands.push_back({"lines"});
    for (int i = 0; i < 60; ++i) {
        addLine(network, {u(random), u(random)}, {u(random), u(random)});
        network.curveNames.push_back("line" + std::to_string(i));
    }
    ArrangeReport report;
    const CurveNetwork result = arranged(network, report);

    // Brute force: pairs whose ends lie on opposite sides of each other's line.
    const auto side = [](Vec2 a, Vec2 b, Vec2 p) { return cross(b - a, p - a) > 0.0; };
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < network.curves.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2 a = network.points[network.curves[i].start.index()];
            const Vec2 b = network.points[network.curves[i].end.index()];
            const Vec2 c = network.points[network.curves[j].start.index()];
            const Vec2 d = network.points[network.curves[j].end.index()];
            crossings += side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b) ? 1 : 0;
        }
    }
    EXPECT_EQ(report.crossed.crossings, crossings);
    EXPECT_EQ(result.points.size(), network.points.size() + crossings);
    EXPECT_EQ(report.firstCrossing, network.points.size());
    EXPECT_EQ(result.curves.size(), network.curves.size() + 2 * crossings);
    EXPECT_EQ(result.curveNames.size(), result.curves.size());

    // The pieces of a curve follow each other from its start to its end.
    std::size_t piece = 0;
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        PointId at = network.curves[c].start;
        double length = 0.0;
        for (; piece < result.curves.size() && report.parent[piece].index() == c; ++piece) {
            EXPECT_EQ(result.curves[piece].start, at);
            EXPECT_EQ(result.curveNames[piece], network.curveNames[c]);
            EXPECT_EQ(result.curves[piece].source, c);
            const PointId to = result.curves[piece].end;
            length += distance(result.points[at.index()], result.points[to.index()]);
            at = to;
        }
        EXPECT_EQ(at, network.curves[c].end);
        const Vec2 a = network.points[network.curves[c].start.index()];
        EXPECT_NEAR(length, distance(a, network.points[at.index()]), 1e-14);
    }
    EXPECT_EQ(piece, result.curves.size());
}

TEST(CrossStraight, TouchesAndOverlapsSplitBoth)
{
    CurveNetwork network;
    network.operands.push_back({"lines"});
    addLine(network, {0, 0}, {4, 0});
    addLine(network, {1, 0}, {6, 0});  // overlaps from 1 to 4
    addLine(network, {2, 0}, {2, 3});  // touches both
    ArrangeReport report;
    const CurveNetwork result = arranged(network, report);
    EXPECT_EQ(report.crossed.crossings, 0U);
    EXPECT_EQ(result.points.size(), network.points.size());
    // 0-1, 1-2, 2-4; 1-2, 2-4, 4-6; and the third as it is.
    EXPECT_EQ(result.curves.size(), 7U);
}

TEST(CrossStraight, CurvesOnAGeometryAreCrossedWithoutBeingAsked)
{
    CurveNetwork network;
    network.operands.push_back({"mixed"});
    const auto circle = makeCircleArc({0, 0}, 1.0, 0.0, 2.0 * std::numbers::pi);
    const PointId start = network.addPoint(circle->point(0.0));
    network.curves.push_back({circle, start, start, OperandId(0U), Role::Boundary, 0, 0});
    addLine(network, {-2, 0.5}, {2, 0.5});
    ArrangeReport report;
    addLine(network, {-2, 3}, {2, 3});
    addLine(network, {0, 2}, {0, 4});
    Execution execution;
    const CurveNetwork result = arrange(network, {}, report, execution);
    // The circle in three, its line in three, the other two lines whole.
    EXPECT_EQ(result.curves.size(), 8U);
    EXPECT_EQ(report.crossed.crossings, 2U);
    EXPECT_EQ(arranged(network, report).curves.size(), 10U);
    EXPECT_EQ(report.crossed.crossings, 3U);
}

TEST(CrossStraight, ManyLinesThroughOnePlaceHaveOneCrossingWithinTheTolerance)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> u(0.0, 1.0);
    CurveNetwork network;
    network.operands.push_back({"star"});
    const Vec2 center {1.2345, 0.777};
    for (int i = 0; i < 300; ++i) {
        const double angle = 0.5 + 0.5 * u(random);
        const Vec2 way {std::cos(angle), std::sin(angle)};
        addLine(network, center - (3 + 5 * u(random)) * way, center + (3 + 5 * u(random)) * way);
    }
    ArrangeReport report;
    Execution execution;
    const CurveNetwork result =
        arrange(network, {.weld = 1e-7, .crossStraight = true}, report, execution);
    EXPECT_EQ(report.crossed.crossings, 1U);
    EXPECT_EQ(result.points.size(), network.points.size() + 1);
    EXPECT_EQ(result.curves.size(), 2 * network.curves.size());
    EXPECT_LE(distance(result.points.back(), center), 1e-12);
    // Without a tolerance, what rounding has separated stays so.
    EXPECT_GT(arranged(network, report).points.size(), network.points.size() + 1);
}

} // namespace tessera
