// SPDX-License-Identifier: MIT
#include "curve/arc.h"
#include "mesh/quality.h"
#include "pipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace tessera
{

namespace
{

using std::numbers::pi;

/// Adds a closed polygon as boundary curves of one operand.
void addPolygon(CurveNetwork& network, std::vector<Vec2> corners, std::uint32_t operand = 0,
                Role role = Role::Boundary)
{
    std::vector<PointId> ids;
    for (const Vec2 p : corners) {
        ids.push_back(network.addPoint(p));
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
        network.curves.push_back({nullptr, ids[i], ids[(i + 1) % ids.size()], OperandId(operand),
                                  role, 0, static_cast<std::uint32_t>(i)});
    }
}

void addCircle(CurveNetwork& network, Vec2 center, double radius, std::uint32_t operand = 0)
{
    const auto circle = makeCircleArc(center, radius, 0.0, 2.0 * pi);
    const PointId start = network.addPoint(circle->point(circle->first()));
    network.curves.push_back({circle, start, start, OperandId(operand), Role::Boundary, 0, 0});
}

CurveNetwork withOperands(std::size_t count)
{
    CurveNetwork network;
    for (std::size_t i = 0; i < count; ++i) {
        network.operands.push_back({"Part" + std::to_string(i + 1)});
    }
    return network;
}

/// Independent of the topology inside: every edge is used once or twice, in opposite directions;
/// those used once are exactly the outline edges; every triangle is counter-clockwise.
void expectConforming(const Mesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> used;
    for (const auto& t : mesh.triangles) {
        const Vec2 a = mesh.nodes[t[0]];
        ASSERT_GT(cross(mesh.nodes[t[1]] - a, mesh.nodes[t[2]] - a), 0.0);
        for (int i = 0; i < 3; ++i) {
            ASSERT_EQ(++used[std::pair(t[i], t[(i + 1) % 3])], 1);
        }
    }
    std::size_t once = 0;
    for (const auto& [edge, count] : used) {
        once += used.count({edge.second, edge.first}) == 0 ? 1 : 0;
    }
    std::size_t outline = 0;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        if (mesh.edgeIsOutline[e] != 0) {
            ++outline;
            ASSERT_EQ(used.count({mesh.edges[e][0], mesh.edges[e][1]}), 1U);
        }
    }
    EXPECT_EQ(once, outline);
}

MeshResult meshed(const CurveNetwork& network, MeshOptions options = {})
{
    Execution execution;
    return meshNetwork(network, options, execution);
}

ErrorKind kindOfError(const CurveNetwork& network, MeshOptions options = {})
{
    try {
        meshed(network, options);
    }
    catch (const Error& error) {
        EXPECT_GT(std::string(error.what()).size(), 10U);
        return error.kind();
    }
    ADD_FAILURE() << "no error";
    return ErrorKind::Cancelled;
}

} // namespace

TEST(Pipeline, SquareWithHole)
{
    CurveNetwork network = withOperands(1);
    addPolygon(network, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    addPolygon(network, {{4, 4}, {6, 4}, {6, 6}, {4, 6}});
    const MeshResult result = meshed(network, {.size = 1.0});
    expectConforming(result.mesh);
    EXPECT_NEAR(result.report.area, 96.0, 1e-10);
    EXPECT_EQ(result.report.regions, 1U);
    EXPECT_EQ(result.report.recovery.crossings, 0U);
    EXPECT_GE(result.report.quality.minAngle, 30.0);
    EXPECT_GT(result.report.quality.meanQuality, 0.9);
}

TEST(Pipeline, CrossingCirclesFillWhatTheyCover)
{
    CurveNetwork network = withOperands(2);
    addCircle(network, {0, 0}, 1.0, 0);
    addCircle(network, {1, 0}, 1.0, 1);
    const MeshResult result = meshed(network, {.size = 0.05});
    expectConforming(result.mesh);
    EXPECT_EQ(result.report.regions, 3U);
    const double lens = 2.0 * pi / 3.0 - std::sqrt(3.0) / 2.0;
    EXPECT_NEAR(result.report.area, 2.0 * pi - lens, 5e-3);
    EXPECT_EQ(result.report.recovery.crossings, 2U);
}

TEST(Pipeline, SelfIntersectingPolygonIsEvenOdd)
{
    // A bow tie: two triangles that meet in the crossing.
    CurveNetwork network = withOperands(1);
    addPolygon(network, {{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    const MeshResult result = meshed(network, {.size = 0.2});
    expectConforming(result.mesh);
    EXPECT_NEAR(result.report.area, 2.0, 1e-10);
    EXPECT_EQ(result.report.regions, 2U);
}

TEST(Pipeline, ConstraintsAreKeptAndDoNotSeparate)
{
    CurveNetwork network = withOperands(1);
    addPolygon(network, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    addPolygon(network, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, 0, Role::Constraint);
    const PointId a = network.addPoint({-1, 2});
    const PointId b = network.addPoint({5, 2.5});
    network.curves.push_back({nullptr, a, b, OperandId(0U), Role::Constraint, 7, 99});
    const MeshResult result = meshed(network, {.size = 0.5});
    expectConforming(result.mesh);
    EXPECT_NEAR(result.report.area, 16.0, 1e-10);
    EXPECT_EQ(result.report.regions, 1U);
    EXPECT_EQ(result.report.recovery.crossings, 4U);
    // The edges of the crossing line inside add up to its length inside the square.
    double inside = 0.0;
    for (std::size_t e = 0; e < result.mesh.edges.size(); ++e) {
        for (std::uint32_t i = result.mesh.edgeCurveStart[e];
             i < result.mesh.edgeCurveStart[e + 1]; ++i) {
            if (network.curves[result.mesh.edgeCurves[i].index()].marker == 7) {
                inside += distance(result.mesh.nodes[result.mesh.edges[e][0]],
                                   result.mesh.nodes[result.mesh.edges[e][1]]);
            }
        }
    }
    EXPECT_NEAR(inside, 4.0 * std::hypot(1.0, 0.5 / 6.0), 1e-9);
}

TEST(Pipeline, SecondOrderNodesLieOnTheCircle)
{
    CurveNetwork network = withOperands(1);
    addCircle(network, {3, -2}, 5.0);
    const MeshResult result = meshed(network, {.size = 1.0, .order = 2});
    ASSERT_EQ(result.mesh.order(), 2);
    for (const std::uint32_t node : result.mesh.edgeMidNodes) {
        EXPECT_NEAR(distance(result.mesh.nodes[node], {3, -2}), 5.0, 1e-12);
    }
    EXPECT_EQ(result.mesh.nodes.size(), result.mesh.nodeOrigin.size());
    EXPECT_NEAR(result.report.area, 25.0 * pi, 1e-2); // the chords alone lack 0.5
}

TEST(Pipeline, SameBytesOnEveryRun)
{
    CurveNetwork network = withOperands(2);
    addCircle(network, {0, 0}, 1.0, 0);
    addPolygon(network, {{0, 0}, {2, 0}, {2, 1.5}, {0.2, 1.7}}, 1);
    const MeshResult first = meshed(network, {.size = 0.05});
    for (int run = 0; run < 19; ++run) {
        const MeshResult again = meshed(network, {.size = 0.05});
        EXPECT_EQ(first.mesh.nodes, again.mesh.nodes);
        EXPECT_EQ(first.mesh.triangles, again.mesh.triangles);
        EXPECT_EQ(first.mesh.edges, again.mesh.edges);
    }
}

TEST(Pipeline, RefusesWhatHasNoInside)
{
    EXPECT_EQ(kindOfError(withOperands(1)), ErrorKind::NoInside);

    CurveNetwork open = withOperands(1);
    const PointId a = open.addPoint({0, 0});
    const PointId b = open.addPoint({1, 0});
    const PointId c = open.addPoint({1, 1});
    open.curves.push_back({nullptr, a, b, OperandId(0U), Role::Constraint, 0, 0});
    open.curves.push_back({nullptr, b, c, OperandId(0U), Role::Constraint, 0, 1});
    EXPECT_EQ(kindOfError(open), ErrorKind::NoInside);

    CurveNetwork flat = withOperands(1);
    addPolygon(flat, {{0, 0}, {1, 0}, {3, 0}});
    EXPECT_EQ(kindOfError(flat), ErrorKind::NoInside);
}

TEST(Pipeline, RefusesBadOptions)
{
    CurveNetwork network = withOperands(1);
    addPolygon(network, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(kindOfError(network, {.size = -1.0}), ErrorKind::InvalidOption);
    EXPECT_EQ(kindOfError(network, {.size = nan}), ErrorKind::InvalidOption);
    EXPECT_EQ(kindOfError(network, {.growth = 0.0}), ErrorKind::InvalidOption);
    EXPECT_EQ(kindOfError(network, {.minAngle = 40.0}), ErrorKind::InvalidOption);
    EXPECT_EQ(kindOfError(network, {.order = 3}), ErrorKind::InvalidOption);
    for (const double share : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(kindOfError(network, {.narrowShare = share}), ErrorKind::InvalidOption);
    }
    for (const double size : {1e-4, 1e-9, 1e-300}) {
        EXPECT_EQ(kindOfError(network, {.size = size, .memoryLimit = 1e9}), ErrorKind::TooLarge);
    }
    addPolygon(network, {{0, 0}, {1, nan}, {1, 1}});
    EXPECT_EQ(kindOfError(network), ErrorKind::InvalidInput);
}

TEST(Pipeline, IgnoredCurvesAreNoneForTheMemoryEither)
{
    CurveNetwork network = withOperands(1);
    addPolygon(network, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    MeshOptions options {.size = 1.0, .memoryLimit = 1e9};
    options.sizes.points.push_back({{0, 0}, {0.1}});
    const MeshResult without = meshed(network, options);
    addPolygon(network, {{20, 0}, {30, 0}, {30, 10}}, 0, Role::Ignored);
    EXPECT_EQ(meshed(network, options).mesh.nodes, without.mesh.nodes);
}

TEST(Pipeline, CancelAndTimeLimit)
{
    CurveNetwork network = withOperands(1);
    addPolygon(network, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(meshNetwork(network, {.size = 1.0}, cancelled), Error);

    Execution late;
    late.setTimeLimit(0.0);
    EXPECT_THROW(meshNetwork(network, {.size = 0.01}, late), Error);
}

TEST(Pipeline, ProgressNeverFalls)
{
    CurveNetwork network = withOperands(1);
    addPolygon(network, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    Execution execution;
    double last = 0.0;
    int calls = 0;
    execution.setProgress([&](double fraction, const char* stage) {
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1.0);
        EXPECT_NE(stage, nullptr);
        last = fraction;
        ++calls;
    });
    meshNetwork(network, {.size = 0.2}, execution);
    EXPECT_GE(calls, 8);
}

} // namespace tessera
