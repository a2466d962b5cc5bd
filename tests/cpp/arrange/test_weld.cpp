// SPDX-License-Identifier: MIT
#include "arrange/arrange.h"
#include "arrange/weld.h"
#include "curve/arc.h"
#include "curve/polyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

WeldResult weldAll(const std::vector<Vec2>& points, double tolerance)
{
    const Execution execution;
    return weldPoints(points, std::vector<std::uint8_t>(points.size(), 1), tolerance, execution);
}

/// The definition, by brute force.
std::vector<std::uint32_t> bruteForce(const std::vector<Vec2>& points, double tolerance)
{
    const auto n = static_cast<std::uint32_t>(points.size());
    std::vector<std::uint32_t> label(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        label[i] = i;
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (std::uint32_t i = 0; i < n; ++i) {
            for (std::uint32_t j = 0; j < n; ++j) {
                if (distance(points[i], points[j]) <= tolerance && label[j] < label[i]) {
                    label[i] = label[j];
                    changed = true;
                }
            }
        }
    }
    std::vector<std::uint32_t> result = label;
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            if (label[i] == label[j] && distance(points[i], points[j]) > 2 * tolerance) {
                for (std::uint32_t k = 0; k < n; ++k) {
                    if (label[k] == label[i]) {
                        result[k] = static_cast<std::uint32_t>(
                            std::find(points.begin(), points.end(), points[k]) - points.begin());
                    }
                }
            }
        }
    }
    return result;
}

TEST(Weld, AgreesWithBruteForceOnRandomPoints)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < 5 + random() % 60; ++i) {
            if (i > 0 && random() % 3 == 0) {
                const Vec2 near = points[random() % points.size()];
                points.push_back(near + Vec2 {0.02 * uniform(random), 0.02 * uniform(random)});
            }
            else if (i > 0 && random() % 5 == 0) {
                points.push_back(points[random() % points.size()]);
            }
            else {
                points.push_back({uniform(random), uniform(random)});
            }
        }
        for (const double tolerance : {0.001, 0.02, 0.1, 0.5, 5.0}) {
            EXPECT_EQ(weldAll(points, tolerance).representative, bruteForce(points, tolerance));
        }
    }
}

TEST(Weld, LongChainsStayAndAreReported)
{
    std::vector<Vec2> points;
    for (int i = 0; i < 10; ++i) {
        points.push_back({0.9 * i, 0.0});
    }
    points.push_back({100.0, 0.0});
    points.push_back({100.5, 0.0});
    points.push_back(points[3]);
    const WeldResult result = weldAll(points, 1.0);
    EXPECT_EQ(result.chainsLeft, std::vector<std::uint32_t> {0});
    for (std::uint32_t i = 0; i < 10; ++i) {
        EXPECT_EQ(result.representative[i], i);
    }
    EXPECT_EQ(result.representative[11], 10U);
    EXPECT_EQ(result.representative[12], 3U);
}

TEST(Weld, ToleranceFarBelowTheCoordinates)
{
    const double next = std::nextafter(1e20, 1e300);
    const WeldResult result = weldAll({{1e20, 0}, {next, 0}, {1e20, 0}}, 1e-5);
    EXPECT_EQ(result.representative, (std::vector<std::uint32_t> {0, 1, 0}));
}

TEST(Weld, ManyEqualPointsAndManyInOneCellAreFast)
{
    std::vector<Vec2> points(200000, Vec2 {1, 2});
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform(0.0, 1e-3);
    for (int i = 0; i < 100000; ++i) {
        points.push_back({1e6 + uniform(random), uniform(random)});
    }
    for (int i = 0; i < 300; ++i) {
        for (int j = 0; j < 300; ++j) {
            points.push_back({1e3 * i, 1e3 * j});
        }
    }
    const auto begin = std::chrono::steady_clock::now();
    const WeldResult result = weldAll(points, 1e-2);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(result.representative[199999], 0U);
    EXPECT_EQ(result.representative[299999], 200000U);
    EXPECT_EQ(result.representative[389999], 389999U);
    EXPECT_LT(seconds.count(), 20.0);
}

/// Two straight sides and an arc, whose ends miss each other by gap.
CurveNetwork almostClosed(double gap)
{
    CurveNetwork network;
    network.operands.resize(1);
    network.addPoint({50, 50});
    const std::vector<Vec2> sides {{1, 0}, {0, 0}, {0, 1}};
    addPolyline(network, sides, false, OperandId(0U), Role::Chain);
    const PointId start = network.addPoint({1 + gap, 0});
    const PointId end = network.addPoint({0, 1 + gap});
    network.curves.push_back({makeCircleArc({0, 0}, 1 + gap, 0, std::numbers::pi / 2), start, end,
                              OperandId(0U), Role::Chain});
    return network;
}

TEST(Arrange, ClosesGapsWithinTheToleranceAndSettlesChains)
{
    const CurveNetwork network = almostClosed(1e-3);
    ArrangeReport report;
    Execution execution;
    const CurveNetwork closed = arrange(network, {.weld = 2e-3}, report, execution);
    EXPECT_EQ(report.welded, 2U);
    ASSERT_EQ(report.messages.size(), 1U);
    EXPECT_EQ(closed.points.size(), 3U);
    EXPECT_EQ(report.pointOf[0], PointId());
    EXPECT_EQ(closed.points[0], (Vec2 {1, 0}));
    for (const NetworkCurve& curve : closed.curves) {
        EXPECT_EQ(curve.role, Role::Boundary);
    }
    EXPECT_EQ(closed.curves[2].start, closed.curves[0].start);

    const CurveNetwork open = arrange(network, {.weld = 0.5e-3}, report, execution);
    EXPECT_EQ(report.welded, 0U);
    EXPECT_TRUE(report.messages.empty());
    for (const NetworkCurve& curve : open.curves) {
        EXPECT_EQ(curve.role, Role::Constraint);
    }
}

TEST(Arrange, RowsOfEndsAreLeftAsTheyAre)
{
    // Parallel lines nearer to each other than the tolerance, their ends in step and out of step.
    for (const double step : {0.0, 0.03}) {
        CurveNetwork network;
        network.operands.resize(1);
        for (int i = 0; i < 8; ++i) {
            const PointId start = network.addPoint({0.09 * i, i % 2 == 0 ? 0.0 : step});
            const PointId end = network.addPoint({0.09 * i, 4.0});
            network.curves.push_back({nullptr, start, end, OperandId(0U), Role::Constraint});
        }
        ArrangeReport report;
        Execution execution;
        const CurveNetwork arranged = arrange(network, {.weld = 0.1}, report, execution);
        EXPECT_EQ(report.chainsLeft.size(), 2U);
        EXPECT_EQ(report.welded, 0U);
        EXPECT_EQ(arranged.points, network.points);
        EXPECT_EQ(arranged.curves.size(), network.curves.size());
        EXPECT_EQ(report.messages.size(), 1U);
    }
}

TEST(Arrange, WithoutToleranceEqualPointsOfStraightCurvesStayTwo)
{
    CurveNetwork network = almostClosed(0.0);
    ArrangeReport report;
    Execution execution;
    EXPECT_EQ(arrange(network, {}, report, execution).points.size(), 3U);
    network.curves[2].geometry = nullptr;
    EXPECT_EQ(arrange(network, {}, report, execution).points.size(), 5U);
    EXPECT_EQ(arrange(network, {.weld = 1e-9}, report, execution).points.size(), 3U);
    EXPECT_EQ(report.welded, 0U);
}

TEST(Arrange, TellsWhatALargeToleranceDoes)
{
    CurveNetwork network; // a plate 100 x 60 and a line whose end is 20 from its lower edge
    network.operands.resize(1);
    std::vector<PointId> corners;
    for (const Vec2 p : {Vec2 {0, 0}, Vec2 {100, 0}, Vec2 {100, 60}, Vec2 {0, 60}}) {
        corners.push_back(network.addPoint(p));
    }
    for (std::size_t i = 0; i < 4; ++i) {
        network.curves.push_back({nullptr, corners[i], corners[(i + 1) % 4], OperandId(0U)});
    }
    const PointId low = network.addPoint({50, 20});
    const PointId high = network.addPoint({50, 28});
    network.curves.push_back({nullptr, low, high, OperandId(0U), Role::Constraint});

    ArrangeReport report;
    Execution execution;
    arrange(network, {.weld = 5.0}, report, execution);
    EXPECT_EQ(report.welded, 0U);
    EXPECT_TRUE(report.messages.empty());

    arrange(network, {.weld = 22.0}, report, execution);
    EXPECT_EQ(report.welded, 2U); // the ends to each other, and that point to the edge
    EXPECT_EQ(report.weldedOnto, 1U);
    EXPECT_EQ(report.swallowed, 1U);
    EXPECT_DOUBLE_EQ(report.greatestBend, 20.0);
    ASSERT_EQ(report.messages.size(), 2U);
    EXPECT_EQ(report.messages[0], "1 end point was joined to another one within the weld tolerance "
                                  "22. 1 curve no longer than that vanished; choose a smaller "
                                  "tolerance.");
    EXPECT_EQ(report.messages[1], "1 end point was joined to the inside of a curve within the weld "
                                  "tolerance 22, which moves ends or bends curves by up to 20.");
}

TEST(Arrange, KeepsEmbeddedPointsAndDropsThoseOfIgnoredCurves)
{
    CurveNetwork network = almostClosed(0.0);
    network.embedded.push_back({PointId(0U), OperandId(0U), "load"});
    network.curves[2].role = Role::Ignored;
    ArrangeReport report;
    Execution execution;
    const CurveNetwork result = arrange(network, {}, report, execution);
    EXPECT_EQ(result.points.size(), 4U);
    EXPECT_EQ(result.embedded[0].point, PointId(0U));
    EXPECT_EQ(result.curves.size(), network.curves.size());
}

TEST(Arrange, CollapsesWhatIsShorterThanTheTolerance)
{
    CurveNetwork network;
    network.operands.resize(1);
    const PointId a = network.addPoint({1, 0});
    const PointId b = network.addPoint({1, 1e-4});
    network.curves.push_back({makeCircleArc({0, 0}, 1, 0, 1e-4), a, b, OperandId(0U)});
    network.curves.push_back(
        {makeCircleArc({0, 0}, 1, 1e-4, 2 * std::numbers::pi), b, a, OperandId(0U)});
    ArrangeReport report;
    Execution execution;
    const CurveNetwork result = arrange(network, {.weld = 1e-3}, report, execution);
    EXPECT_EQ(result.curves[0].geometry, nullptr);
    EXPECT_NE(result.curves[1].geometry, nullptr);
    EXPECT_EQ(result.curves[1].start, result.curves[1].end);
}

TEST(Arrange, TheFreeEndOfALineMovesOntoTheCurveAndTheCurveStays)
{
    for (const bool embedded : {false, true}) {
        CurveNetwork network;
        network.operands.resize(1);
        const Vec2 corners[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
        for (const Vec2 corner : corners) {
            network.addPoint(corner);
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            network.curves.push_back({nullptr, PointId(i), PointId((i + 1) % 4), OperandId(0U)});
        }
        const PointId inside = network.addPoint({2, 1});
        const PointId end = network.addPoint({2, 0.05});
        network.curves.push_back({nullptr, inside, end, OperandId(0U), Role::Constraint});
        if (embedded) {
            network.embedded.push_back({end, OperandId(0U), "node"});
        }
        ArrangeReport report;
        Execution execution;
        const CurveNetwork result = arrange(network, {.weld = 0.1}, report, execution);
        EXPECT_EQ(result.curves.size(), 6U);
        // An embedded point is a node where it was drawn: there the outline gives way.
        EXPECT_EQ(result.points[report.pointOf[end.index()].index()],
                  (Vec2 {2, embedded ? 0.05 : 0.0}));
        EXPECT_EQ(report.weldedOnto, 1U);
        EXPECT_NEAR(report.greatestBend, 0.05, 1e-15);
    }
}

TEST(Arrange, RoundingIsWeldedInSilence)
{
    // An arc and a line whose common ends differ in the last places, far from the origin.
    for (const double scale : {1e-3, 1.0, 1e9}) {
        CurveNetwork network;
        network.operands.resize(1);
        const double r = scale / 3.0;
        const Vec2 center {0.7 * scale, 0.1 * scale};
        const auto arc = makeCircleArc(center, r, 0.3, 2.9);
        const auto near = [scale](Vec2 p, int ulps) {
            return Vec2 {p.x + ulps * 2e-16 * scale, p.y - ulps * 2e-16 * scale};
        };
        const PointId a = network.addPoint(arc->point(0.3));
        const PointId b = network.addPoint(arc->point(2.9));
        network.curves.push_back({arc, a, b, OperandId(0U)});
        const PointId c = network.addPoint(near(network.points[1], 3));
        const PointId d = network.addPoint(near(network.points[0], -5));
        network.curves.push_back({nullptr, c, d, OperandId(0U)});
        for (const double weld : {0.0, 1e-7 * scale}) {
            ArrangeReport report;
            Execution execution;
            const CurveNetwork result = arrange(network, {.weld = weld}, report, execution);
            EXPECT_EQ(result.points.size(), 2U);
            EXPECT_EQ(report.welded, 0U);
            EXPECT_TRUE(report.messages.empty()) << report.messages.front();
        }
    }
}

TEST(Arrange, SeamsOfClosedCurvesAreNoEnds)
{
    const auto circles = [](double gap) {
        CurveNetwork network;
        network.operands.resize(1);
        const double turn = 2 * std::numbers::pi;
        const PointId a = network.addPoint({1, 0});
        network.curves.push_back({makeCircleArc({0, 0}, 1, 0, turn), a, a, OperandId(0U)});
        // One inside whose seam is beside the first one's, one outside whose seam is beside it.
        const PointId b = network.addPoint({1 - gap, 0});
        network.curves.push_back({makeCircleArc({0, 0}, 1 - gap, 0, turn), b, b, OperandId(0U)});
        const PointId c = network.addPoint({0, 1 + gap});
        network.curves.push_back({makeCircleArc({0, 3 + gap}, 2, -0.25 * turn, 0.75 * turn), c, c,
                                  OperandId(0U)});
        ArrangeReport report;
        Execution execution;
        const CurveNetwork result = arrange(network, {.weld = 1e-3}, report, execution);
        EXPECT_TRUE(report.messages.empty());
        EXPECT_EQ(report.welded, 0U);
        return result;
    };
    const CurveNetwork apart = circles(1e-5);
    EXPECT_EQ(apart.points.size(), 3U);
    EXPECT_EQ(apart.curves.size(), 3U);
    // Where they touch they share the point: here the third one's seam is on the first one.
    const CurveNetwork touching = circles(0.0);
    EXPECT_EQ(touching.points.size(), 2U);
    EXPECT_EQ(touching.curves.size(), 5U);
}

TEST(Arrange, RefusesBadInput)
{
    ArrangeReport report;
    Execution execution;
    const CurveNetwork network = almostClosed(0.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(arrange(network, {.weld = -1}, report, execution), Error);
    EXPECT_THROW(arrange(network, {.weld = nan}, report, execution), Error);
    CurveNetwork broken = network;
    broken.points[1].x = nan;
    EXPECT_THROW(arrange(broken, {}, report, execution), Error);
}

} // namespace
} // namespace tessera
