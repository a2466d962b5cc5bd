// SPDX-License-Identifier: MIT
#include "recovery_case.h"

#include "base/error.h"

#include <random>
#include <set>

namespace tessera::test
{
namespace
{

class BothStrategies: public testing::TestWithParam<RecoveryStrategy>
{
protected:
    Recovered recover(const RawPslg& raw) { return recoverAndVerify(raw, GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Recover, BothStrategies,
                         testing::Values(RecoveryStrategy::Cavity, RecoveryStrategy::Steiner),
                         [](const auto& info) {
                             return info.param == RecoveryStrategy::Cavity ? "Cavity" : "Steiner";
                         });

TEST_P(BothStrategies, crossOfTwo)
{
    RawPslg raw;
    raw.addSegment({0, 0}, {2, 2});
    raw.addSegment({0, 2}, {2, 0});
    const Recovered r = recover(raw);
    EXPECT_EQ(r.result.report.crossings, 1U);
    EXPECT_EQ(r.result.triangulation.points.back(), (Vec2 {1, 1}));
    EXPECT_EQ(r.result.constraints.subsegments.size(), 4U);
    EXPECT_EQ(r.result.constraints.chainOf(ConstraintId(0U)).size(), 3U);
}

TEST_P(BothStrategies, concurrentCrossingsGiveOneVertex)
{
    RawPslg raw;
    for (int i = 0; i < 7; ++i) {
        const double x = 3 * i - 9;
        raw.addSegment({x + 0.5, 7}, {-x + 0.5, -7});
    }
    raw.addSegment({-3, 0}, {10, 0});
    const Recovered r = recover(raw);
    EXPECT_EQ(r.result.report.crossings, 1U);
    EXPECT_EQ(r.result.triangulation.points.back(), (Vec2 {0.5, 0}));
}

/// Through (1/3, 1/3), which is no double, and through the origin: quick for any number of them.
TEST_P(BothStrategies, thousandsOfConcurrentCrossingsGiveOneVertex)
{
    RawPslg thirds;
    for (int i = -1000; i <= 1000; ++i) {
        const Vec2 a {1.0 * i, 1500.0 - std::abs(i)};
        thirds.addSegment(a, {1.0 - 2.0 * a.x, 1.0 - 2.0 * a.y});
    }
    EXPECT_EQ(recover(thirds).result.report.crossings, 1U);
    RawPslg diameters;
    for (int i = 0; i < 4000; ++i) {
        const Vec2 p {std::cos(0.0007 * i), std::sin(0.0007 * i)};
        diameters.addSegment(p, {-p.x, -p.y});
    }
    const Recovered r = recover(diameters);
    EXPECT_EQ(r.result.report.crossings, 1U);
    EXPECT_EQ(r.result.triangulation.points.back(), (Vec2 {0, 0}));
}

TEST_P(BothStrategies, touchIsNoCrossing)
{
    RawPslg raw;
    raw.addSegment({0, 0}, {3, 1});
    raw.addSegment({1.5, 0.5}, {1, 4});
    raw.addSegment({2, -4}, {1.5, 0.5});
    const Recovered r = recover(raw);
    EXPECT_EQ(r.result.report.crossings, 0U);
    EXPECT_EQ(r.result.report.touches, 1U);
}

TEST_P(BothStrategies, overlapsDuplicatesAndZeroLength)
{
    RawPslg raw;
    raw.addSegment({0, 0}, {4, 0});
    raw.addSegment({2, 0}, {6, 0});
    raw.addSegment({6, 0}, {3, 0});
    raw.addSegment({4, 0}, {0, 0});
    raw.addSegment({1, 1}, {1, 1});
    raw.addSegment({0, -1}, {6, 2});
    const Recovered r = recover(raw);
    EXPECT_EQ(r.result.report.crossings, 0U); // (2, 0) is an end point
    const auto chain = r.result.constraints.chainOf(ConstraintId(4U));
    ASSERT_EQ(chain.size(), 1U);
    EXPECT_EQ(r.result.triangulation.points[chain[0]], (Vec2 {1, 1}));
    // 0-2 (twice), 2-3 (3 times), 3-4 (4 times), 4-6 (twice)
    EXPECT_EQ(r.result.report.overlaps, 4U);
    EXPECT_EQ(r.result.constraints.subsegments.size(), 6U);
    for (const Subsegment& s : r.result.constraints.subsegments) {
        for (const ConstraintUse& use : r.result.constraints.usesOf(s)) {
            const ConstraintEnds ends = r.ends[use.constraint.index()];
            const auto& points = r.result.triangulation.points;
            EXPECT_EQ(use.forward, (points[ends.a].x < points[ends.b].x)
                                       == (points[s.a].x < points[s.b].x));
        }
    }
}

TEST_P(BothStrategies, collinearPointsHaveNoTriangles)
{
    RawPslg raw;
    raw.addSegment({0, 0}, {4, 4});
    raw.addSegment({3, 3}, {1, 1});
    raw.addSegment({2, 2}, {2, 2});
    const Recovered r = recover(raw);
    EXPECT_TRUE(r.result.triangulation.triangles.empty());
    EXPECT_EQ(r.result.constraints.chainOf(ConstraintId(0U)).size(), 5U);
    EXPECT_EQ(r.result.constraints.chainOf(ConstraintId(1U)).size(), 3U);
    EXPECT_EQ(r.result.report.touches, 4U);
    EXPECT_EQ(r.result.report.overlaps, 2U);
}

TEST_P(BothStrategies, fewPoints)
{
    EXPECT_TRUE(recover({}).result.constraints.subsegments.empty());
    RawPslg one;
    one.addPoint({1, 2});
    one.segments.emplace_back(0, 0);
    EXPECT_EQ(recover(one).result.constraints.chainOf(ConstraintId(0U)).size(), 1U);
    RawPslg two;
    two.addSegment({0, 0}, {1, 0});
    EXPECT_EQ(recover(two).result.constraints.subsegments.size(), 1U);
}

TEST_P(BothStrategies, spikeAndStar)
{
    RawPslg raw;
    raw.addSegment({0, 0}, {10, 0});
    raw.addSegment({10, 0}, {5, 0});
    raw.addSegment({5, 0}, {5, 7});
    const std::uint32_t center = raw.addPoint({5, 3});
    for (int i = 0; i < 24; ++i) {
        const std::uint32_t tip
            = raw.addPoint({5 + 9 * std::cos(0.26 * i), 3 + 9 * std::sin(0.26 * i)});
        raw.segments.emplace_back(center, tip);
    }
    recover(raw);
}

TEST(Recover, refusesUnknownVertex)
{
    Execution execution;
    const std::vector<Vec2> points {{0, 0}, {1, 0}, {0, 1}};
    const std::vector<ConstraintEnds> ends {{1, 2}, {3, 4}};
    try {
        recoverBoundaries(triangulate(points, execution).triangulation, ends,
                          RecoveryStrategy::Cavity, execution);
        FAIL();
    }
    catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::InvalidInput);
        EXPECT_EQ(error.places().at(0).curve, 1U);
    }
}

TEST(Recover, cancels)
{
    RawPslg raw;
    raw.addSegment({0, 0}, {2, 2});
    raw.addSegment({0, 2}, {2, 0});
    Execution execution;
    Triangulation mesh = triangulate(raw.points, execution).triangulation;
    execution.cancel();
    EXPECT_THROW(recoverBoundaries(mesh, std::vector<ConstraintEnds> {{1, 2}, {3, 4}},
                                   RecoveryStrategy::Cavity, execution),
                 Error);
}

/// Follows the Steiner points through the observer.
struct Counter: RecoveryObserver
{
    void steinerInserted(const Triangulation& t, std::uint32_t vertex) override
    {
        EXPECT_EQ(joined(verify(t, false)), "");
        EXPECT_TRUE(present.insert(vertex).second);
    }
    void steinerRemoved(const Triangulation& t, std::uint32_t vertex) override
    {
        EXPECT_EQ(joined(verify(t, false)), "");
        EXPECT_EQ(present.erase(vertex), 1U);
    }
    std::set<std::uint32_t> present;
};

TEST(Recover, steinerPointsComeAndGo)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    RawPslg raw;
    for (int i = 0; i < 60; ++i) {
        raw.addPoint({uniform(random), uniform(random)});
    }
    raw.addSegment({-1, 0.4}, {2, 0.6});
    raw.addSegment({0.3, -1}, {0.6, 2});
    Counter counter;
    const Recovered r = recoverRaw(raw, RecoveryStrategy::Steiner, &counter);
    expectValid(r);
    EXPECT_EQ(counter.present.size(), 1U);
    EXPECT_EQ(r.result.report.crossings, 1U);
    EXPECT_GT(r.result.report.steinerRemoved, 10U);
}

} // namespace
} // namespace tessera::test
