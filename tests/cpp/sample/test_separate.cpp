// SPDX-License-Identifier: MIT
#include "arrange/arrange.h"
#include "curve/arc.h"
#include "curve/polyline.h"
#include "predicates/predicates.h"
#include "sample/sample.h"
#include "sizing/uniform_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

constexpr double kTurn = 2 * std::numbers::pi;

void addCircle(CurveNetwork& network, Vec2 center, double radius, double seam)
{
    network.operands.resize(1);
    const auto geometry = makeCircleArc(center, radius, seam, seam + kTurn);
    const PointId p = network.addPoint(geometry->point(seam));
    network.curves.push_back({geometry, p, p, OperandId(0U)});
}

Pslg sampled(const CurveNetwork& network, double size)
{
    Execution execution;
    ArrangeReport report;
    return sample(arrange(network, {}, report, execution), UniformSize(size),
                  {.piecesPerTurn = 8}, execution);
}

/// Pairs of segments that have more in common than an end.
std::size_t countCrossings(const Pslg& pslg)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
        const Vec2 a = pslg.points[pslg.segments[i].a.index()];
        const Vec2 b = pslg.points[pslg.segments[i].b.index()];
        for (std::size_t j = i + 1; j < pslg.segments.size(); ++j) {
            const Vec2 c = pslg.points[pslg.segments[j].a.index()];
            const Vec2 d = pslg.points[pslg.segments[j].b.index()];
            if (a == c || a == d || b == c || b == d) {
                continue;
            }
            count += orient2d(a, b, c) * orient2d(a, b, d) <= 0
                    && orient2d(c, d, a) * orient2d(c, d, b) <= 0
                ? 1
                : 0;
        }
    }
    return count;
}

/// Twice the area that the pieces of each curve enclose.
std::vector<double> areas(const Pslg& pslg, std::size_t curves)
{
    std::vector<double> result(curves, 0.0);
    for (const PslgSegment& s : pslg.segments) {
        result[s.curve.index()] +=
            cross(pslg.points[s.a.index()], pslg.points[s.b.index()]);
    }
    return result;
}

TEST(Separate, ConcentricCirclesInAThinGap)
{
    for (const double gap : {1e-2, 1e-3, 1e-4}) {
        CurveNetwork network;
        addCircle(network, {0, 0}, 1.0, 0.0);
        addCircle(network, {0, 0}, 1.0 + gap, 0.3);
        addCircle(network, {0, 0}, 1.0 + 2 * gap, 0.1);
        const Pslg pslg = sampled(network, 0.7);
        EXPECT_EQ(countCrossings(pslg), 0U) << gap;
        const std::vector<double> enclosed = areas(pslg, 3);
        EXPECT_LT(enclosed[0], enclosed[1]);
        EXPECT_LT(enclosed[1], enclosed[2]);
        // No more than the gap needs: pieces with a sagitta of about a quarter of it.
        EXPECT_LT(pslg.segments.size(), 60 / std::sqrt(gap));
    }
}

TEST(Separate, ASmallLoopBetweenChordAndArcIsBroughtInside)
{
    CurveNetwork network;
    addCircle(network, {0, 0}, 1.0, 0.0);
    const double middle = kTurn / 16;
    const Vec2 center = 0.97 * Vec2 {std::cos(middle), std::sin(middle)};
    addCircle(network, center, 0.01, 0.0);
    const Pslg pslg = sampled(network, 10.0);
    EXPECT_EQ(countCrossings(pslg), 0U);
    // The big circle's pieces near the small one pass outside of it.
    for (const PslgSegment& s : pslg.segments) {
        const Vec2 a = pslg.points[s.a.index()];
        const Vec2 b = pslg.points[s.b.index()];
        if (s.curve == CurveId(0U)) {
            EXPECT_GT(cross(b - a, center - a), 0.0);
        }
    }
    EXPECT_LT(pslg.segments.size(), 8U + 8U + 8U);
}

TEST(Separate, AnEmbeddedPointBetweenChordAndArc)
{
    CurveNetwork network;
    addCircle(network, {0, 0}, 1.0, 0.0);
    const double middle = kTurn / 16;
    const Vec2 p = 0.99 * Vec2 {std::cos(middle), std::sin(middle)};
    network.embedded.push_back({network.addPoint(p), OperandId(0U), "pin"});
    const Pslg pslg = sampled(network, 10.0);
    for (const PslgSegment& s : pslg.segments) {
        const Vec2 a = pslg.points[s.a.index()];
        EXPECT_GT(cross(pslg.points[s.b.index()] - a, p - a), 0.0);
    }
}

TEST(Separate, RandomCrossingCirclesHaveTheTopologyOfTheCircles)
{
    std::mt19937 random(41);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int round = 0; round < 20; ++round) {
        CurveNetwork network;
        for (int i = 0; i < 12; ++i) {
            addCircle(network, {uniform(random), uniform(random)}, 0.1 + 0.4 * uniform(random),
                      6 * uniform(random));
        }
        EXPECT_EQ(countCrossings(sampled(network, 5.0)), 0U);
        EXPECT_EQ(countCrossings(sampled(network, 0.1)), 0U);
    }
}

TEST(Separate, LensesAndTangentCircles)
{
    CurveNetwork network;
    addCircle(network, {0, 0}, 1.0, 0.5);
    addCircle(network, {0.5, 0}, 0.5, 0.2);
    addCircle(network, {0.25, 0}, 0.75, 3.2);
    addCircle(network, {2.0 - 1e-4, 0}, 1.0, 0.9);
    EXPECT_EQ(countCrossings(sampled(network, 0.9)), 0U);
}

TEST(Separate, CurvesThatRunOnEachOtherUnsharedEndSoon)
{
    // Not arranged: the same circle with two geometries.
    CurveNetwork network;
    addCircle(network, {0, 0}, 1.0, 0.0);
    addCircle(network, {0, 0}, 1.0, 0.1);
    Execution execution;
    const Pslg pslg = sample(network, UniformSize(0.5), {}, execution);
    EXPECT_LT(pslg.segments.size(), 50000U);
}

/// Area between the polygons of the first curve and the second.
double areaBetween(const Pslg& pslg)
{
    double sum[2] = {0.0, 0.0};
    for (const PslgSegment& s : pslg.segments) {
        sum[s.curve.index()] +=
            0.5 * cross(pslg.points[s.a.index()], pslg.points[s.b.index()]);
    }
    return std::abs(sum[0]) - std::abs(sum[1]);
}

Pslg sampledRing(double gap, double shift, double seam = 2.0)
{
    CurveNetwork network;
    addCircle(network, {0, 0}, 1.0, 0.3);
    addCircle(network, {shift, 0}, 1.0 - gap, seam);
    Execution execution;
    ArrangeReport report;
    return sample(arrange(network, {}, report, execution), UniformSize(0.1), {.gapShare = 0.1},
                  execution);
}

TEST(FollowGaps, AreasOfThinRings)
{
    for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5}) {
        for (const double shift : {0.0, 0.5 * gap, 0.999 * gap}) {
            const Pslg pslg = sampledRing(gap, shift);
            const double area = kTurn / 2 * gap * (2.0 - gap);
            EXPECT_NEAR(areaBetween(pslg), area, 0.05 * area) << gap << " " << shift;
            EXPECT_TRUE(pslg.messages.empty());
            EXPECT_LT(pslg.segments.size(), 60.0 / std::sqrt(gap) + 300.0);
        }
    }
}

TEST(FollowGaps, CirclesMuchLargerThanTheSizeToo)
{
    for (const double gap : {1e-4, 2e-6}) {
        CurveNetwork network;
        addCircle(network, {0, 0}, 10.0, 0.3);
        addCircle(network, {0, 0}, 10.0 - gap, 2.0);
        Execution execution;
        const Pslg pslg = sample(network, UniformSize(2.0), {.gapShare = 0.1}, execution);
        const double area = kTurn / 2 * gap * (20.0 - gap);
        EXPECT_NEAR(areaBetween(pslg), area, 0.01 * area) << gap;
        EXPECT_TRUE(pslg.messages.empty());
        EXPECT_LT(pslg.segments.size(), 120.0 / std::sqrt(gap));
    }
}

TEST(FollowGaps, TooNarrowOnesAreTold)
{
    const Pslg pslg = sampledRing(1e-8, 0.0, 0.3);
    EXPECT_LT(pslg.segments.size(), 1000U);
    EXPECT_FALSE(pslg.coarseGaps.empty());
    ASSERT_EQ(pslg.messages.size(), 1U);
    EXPECT_NE(pslg.messages[0].find("too narrow"), std::string::npos);
    EXPECT_NE(pslg.messages[0].find("more than 100000 pieces"), std::string::npos);
    const Pslg crossing = sampledRing(1e-9, 0.0);
    ASSERT_EQ(crossing.messages.size(), 1U);
    EXPECT_NE(crossing.messages[0].find("their pieces cross"), std::string::npos);
}

TEST(FollowGaps, CirclesThatTouchOrCrossAreNotCutForEver)
{
    for (const double radius : {0.5, 0.9, 0.99}) {
        CurveNetwork network;
        addCircle(network, {0, 0}, 1.0, 0.0);
        addCircle(network, {1.0 - radius, 0}, radius, 0.0);
        addCircle(network, {1.5, 0.2}, radius, 0.0);
        Execution execution;
        ArrangeReport report;
        const Pslg pslg = sample(arrange(network, {}, report, execution), UniformSize(0.3),
                                 {.gapShare = 0.1}, execution);
        EXPECT_TRUE(pslg.messages.empty());
        EXPECT_LT(pslg.segments.size(), 1000U) << radius;
    }
}

} // namespace
} // namespace tessera
