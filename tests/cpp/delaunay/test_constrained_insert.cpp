// SPDX-License-Identifier: MIT

// Insertion beside constraints: random mixed sequences, each state proven, and an independent check
// that every triangle is constrained Delaunay by visibility, not only edge by edge.

#include "delaunay/delaunay.h"

#include "point_sets.h"
#include "predicates/predicates.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace tessera
{
namespace
{

using Ends = std::pair<std::uint32_t, std::uint32_t>;

void expectValid(const Triangulation& t)
{
    for (const std::string& problem : verify(t)) {
        ADD_FAILURE() << problem;
    }
}

/// Constrains random Delaunay edges: the triangulation is then constrained Delaunay by definition.
void constrainSome(Triangulation& t, std::mt19937_64& random, std::uint32_t oneIn)
{
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        for (std::uint32_t k = 0; k < 3 && t.isFinite(i); ++k) {
            if (random() % oneIn == 0) {
                t.setConstrained(Topology::halfEdge(i, k), true);
            }
        }
    }
}

std::set<Ends> constrainedEdges(const Triangulation& t)
{
    std::set<Ends> edges;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        for (std::uint32_t k = 0; k < 3 && !t.isDead(i); ++k) {
            const HalfEdge h = Topology::halfEdge(i, k);
            if (t.isConstrained(h)) {
                edges.insert(std::minmax(t.origin(h), t.destination(h)));
            }
        }
    }
    return edges;
}

bool cross(const Triangulation& t, const Ends& s, Vec2 p, Vec2 q)
{
    const Vec2 a = t.points[s.first];
    const Vec2 b = t.points[s.second];
    return orient2d(a, b, p) * orient2d(a, b, q) < 0 && orient2d(p, q, a) * orient2d(p, q, b) < 0;
}

/// No vertex strictly inside a circle sees all three corners past the constraints.
void expectNoVisibleVertexInside(const Triangulation& t, const std::set<Ends>& constraints)
{
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (!t.isFinite(i)) {
            continue;
        }
        const auto& v = t.triangles[i].v;
        for (std::uint32_t p = 1; p < t.points.size(); ++p) {
            if (incircle(t.points[v[0]], t.points[v[1]], t.points[v[2]], t.points[p]) <= 0) {
                continue;
            }
            bool hidden = false;
            for (const Ends& s : constraints) {
                for (std::uint32_t k = 0; k < 3; ++k) {
                    hidden = hidden || cross(t, s, t.points[p], t.points[v[k]]);
                }
            }
            EXPECT_TRUE(hidden) << "vertex " << p << " in the circle of triangle " << i;
        }
    }
}

TEST(ConstrainedInsert, KeepsConstraintsAndTheDelaunayProperty)
{
    std::mt19937_64 random(31);
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        Execution execution;
        Triangulation t
            = triangulate(round % 2 == 0 ? test::uniformPoints(25, random())
                                         : test::gridPoints(5, 0.25),
                          execution)
                  .triangulation;
        constrainSome(t, random, 6);
        std::set<Ends> expected = constrainedEdges(t);
        for (int i = 0; i < 40; ++i) {
            const Vec2 p {std::ldexp(static_cast<double>(random() % 40), -4) - 0.5,
                          std::ldexp(static_cast<double>(random() % 40), -4) - 0.5};
            const Location where = locate(t, p, t.incident[1]);
            const bool splits
                = where.kind == Location::Kind::Edge && t.isConstrained(where.edge);
            const std::uint32_t a = t.origin(where.edge);
            const std::uint32_t b = t.destination(where.edge);
            const std::uint32_t vertex = insertPointAt(t, p, where);
            if (splits) {
                expected.erase(std::minmax(a, b));
                expected.insert(std::minmax(a, vertex));
                expected.insert(std::minmax(vertex, b));
            }
            expectValid(t);
            ASSERT_EQ(constrainedEdges(t), expected);
        }
        expectNoVisibleVertexInside(t, expected);
        if (HasFailure()) {
            return;
        }
    }
}

TEST(ConstrainedInsert, SplitsOfEveryConstrainedEdgeIncludingTheHull)
{
    for (const double scale : {1.0, 0x1p300, 0x1p-300}) {
        SCOPED_TRACE(scale);
        Execution execution;
        Triangulation t
            = triangulate(test::transformed(test::gridPoints(4, 1.0), scale, {}), execution)
                  .triangulation;
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            for (std::uint32_t k = 0; k < 3 && t.isFinite(i); ++k) {
                t.setConstrained(Topology::halfEdge(i, k), true);
            }
        }
        const std::set<Ends> edges = constrainedEdges(t);
        for (const auto& [a, b] : edges) {
            const Vec2 p = midpoint(t.points[a], t.points[b]);
            const std::uint32_t vertex = insertPoint(t, p, t.incident[a]);
            EXPECT_EQ(t.findEdge(a, b), Topology::kDead);
            for (const std::uint32_t end : {a, b}) {
                const HalfEdge half = t.findEdge(vertex, end);
                ASSERT_NE(half, Topology::kDead);
                EXPECT_TRUE(t.isConstrained(half));
            }
        }
        EXPECT_EQ(constrainedEdges(t).size(), 2 * edges.size());
        expectValid(t);
    }
}

TEST(ConstrainedInsert, ACavityOfManyTrianglesNeedsNoDeepRecursion)
{
    // The center of a circle of points conflicts with every triangle.
    Execution execution;
    std::vector<Vec2> points = test::circlePoints(20000, 1e6);
    Triangulation t = triangulate(points, execution).triangulation;
    const std::uint32_t center = insertPoint(t, {0.25, 0.125}, t.incident[1]);
    std::size_t degree = 0;
    t.forEachAround(center, [&](HalfEdge) { ++degree; });
    EXPECT_GT(degree, 15000U);
    expectValid(t);
}

} // namespace
} // namespace tessera
