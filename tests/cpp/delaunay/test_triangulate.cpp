// SPDX-License-Identifier: MIT
#include "delaunay/delaunay.h"

#include "point_sets.h"
#include "predicates/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace tessera
{
namespace
{

DelaunayResult build(const std::vector<Vec2>& points)
{
    Execution execution;
    return triangulate(points, execution);
}

void expectValid(const Triangulation& t, bool delaunay = true)
{
    for (const std::string& problem : verify(t, delaunay)) {
        ADD_FAILURE() << problem;
    }
}

std::size_t finiteTriangles(const Triangulation& t)
{
    std::size_t n = 0;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        n += t.isFinite(i) ? 1 : 0;
    }
    return n;
}

TEST(Triangulate, FewPoints)
{
    EXPECT_EQ(build({}).triangulation.vertexCount(), 0U);
    const DelaunayResult one = build({{3, 4}});
    EXPECT_EQ(one.triangulation.vertexCount(), 1U);
    EXPECT_EQ(one.vertexOfPoint[0], 1U);
    EXPECT_TRUE(one.triangulation.triangles.empty());
    expectValid(one.triangulation);
    const DelaunayResult two = build({{3, 4}, {5, 6}});
    EXPECT_TRUE(two.triangulation.triangles.empty());
    expectValid(two.triangulation);
    const DelaunayResult three = build({{0, 0}, {0, 1}, {1, 0}});
    EXPECT_EQ(finiteTriangles(three.triangulation), 1U);
    expectValid(three.triangulation);
}

TEST(Triangulate, CollinearPointsHaveNoTriangles)
{
    const DelaunayResult r = build({{3, 3}, {1, 1}, {2, 2}, {1, 1}, {-7, -7}});
    EXPECT_TRUE(r.triangulation.triangles.empty());
    EXPECT_EQ(r.triangulation.vertexCount(), 4U);
    EXPECT_EQ(r.duplicates, 1U);
    EXPECT_EQ(r.vertexOfPoint[1], r.vertexOfPoint[3]);
    expectValid(r.triangulation);
}

TEST(Triangulate, AllPointsEqual)
{
    const DelaunayResult r = build(std::vector<Vec2>(1000, Vec2 {0.1, 0.2}));
    EXPECT_EQ(r.triangulation.vertexCount(), 1U);
    EXPECT_EQ(r.duplicates, 999U);
    expectValid(r.triangulation);
}

TEST(Triangulate, EveryHardSetIsValidAndCountsDuplicates)
{
    for (const test::PointSet& set : test::hardPointSets(2000)) {
        SCOPED_TRACE(set.name);
        const DelaunayResult r = build(set.points);
        expectValid(r.triangulation);
        std::set<std::pair<double, double>> distinct;
        for (std::size_t i = 0; i < set.points.size(); ++i) {
            distinct.insert({set.points[i].x, set.points[i].y});
            EXPECT_EQ(r.triangulation.points[r.vertexOfPoint[i]], set.points[i]);
        }
        EXPECT_EQ(r.triangulation.vertexCount(), distinct.size());
        EXPECT_EQ(r.duplicates, set.points.size() - distinct.size());
        for (std::size_t v = 1; v < r.triangulation.points.size(); ++v) {
            EXPECT_NE(r.triangulation.incident[v], Topology::kDead);
        }
    }
}

TEST(Triangulate, ManyPointsOnACircle)
{
    expectValid(build(test::circlePoints(100000)).triangulation);
}

TEST(Triangulate, EmptyCirclesByBruteForce)
{
    for (const test::PointSet& set : test::hardPointSets(40)) {
        SCOPED_TRACE(set.name);
        const Triangulation t = build(set.points).triangulation;
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            if (!t.isFinite(i)) {
                continue;
            }
            const auto& v = t.triangles[i].v;
            for (std::size_t p = 1; p < t.points.size(); ++p) {
                EXPECT_LE(incircle(t.points[v[0]], t.points[v[1]], t.points[v[2]], t.points[p]), 0);
            }
        }
    }
}

TEST(Triangulate, SameBytesEveryTime)
{
    const std::vector<Vec2> points = test::clusterPoints(5000, 7, 3);
    const DelaunayResult a = build(points);
    const DelaunayResult b = build(points);
    ASSERT_EQ(a.triangulation.triangles.size(), b.triangulation.triangles.size());
    for (std::size_t i = 0; i < a.triangulation.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            ASSERT_EQ(a.triangulation.triangles[i].v[k], b.triangulation.triangles[i].v[k]);
            ASSERT_EQ(a.triangulation.triangles[i].link[k], b.triangulation.triangles[i].link[k]);
        }
    }
    EXPECT_EQ(a.vertexOfPoint, b.vertexOfPoint);
}

TEST(Triangulate, ScalingByAPowerOfTwoChangesNothingElse)
{
    const std::vector<Vec2> points = test::clusterPoints(3000, 9, 8);
    const DelaunayResult a = build(points);
    for (const double scale : {0x1p300, 0x1p-300, 0x1p30, 0x1p-30, 0x1p480}) {
        SCOPED_TRACE(scale);
        const DelaunayResult b = build(test::transformed(points, scale, {}));
        EXPECT_EQ(a.vertexOfPoint, b.vertexOfPoint);
        for (std::size_t i = 0; i < a.triangulation.triangles.size(); ++i) {
            for (int k = 0; k < 3; ++k) {
                ASSERT_EQ(a.triangulation.triangles[i].v[k], b.triangulation.triangles[i].v[k]);
            }
        }
        for (std::size_t v = 1; v < a.triangulation.points.size(); ++v) {
            ASSERT_EQ(scale * a.triangulation.points[v], b.triangulation.points[v]);
        }
    }
}

TEST(Triangulate, RefusesWhatIsOutOfRangeWithItsIndex)
{
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {inf, -inf, nan, 1e151, -1e300, 1e-151, 1e-70}) {
        Execution execution;
        const std::vector<Vec2> points {{0, 0}, {1, 0}, {1, bad}, {0, 1}};
        try {
            triangulate(points, execution);
            ADD_FAILURE() << bad << " was accepted";
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::InvalidInput);
            ASSERT_EQ(error.places().size(), 1U);
            EXPECT_EQ(error.places()[0].position.x, 1.0);
            const std::string named = std::isfinite(bad) ? "The point (1, " : "Point 2, counted";
            EXPECT_EQ(std::string(error.what()).substr(0, named.size()), named);
        }
    }
}

TEST(Triangulate, CanBeCancelled)
{
    Execution execution;
    execution.cancel();
    EXPECT_THROW(triangulate(test::uniformPoints(10000, 1), execution), Error);
}

} // namespace
} // namespace tessera
