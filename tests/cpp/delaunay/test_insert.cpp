// SPDX-License-Identifier: MIT
#include "delaunay/delaunay.h"

#include "point_sets.h"
#include "predicates/predicates.h"

#include <gtest/gtest.h>

#include <random>

namespace tessera
{
namespace
{

Triangulation build(const std::vector<Vec2>& points)
{
    Execution execution;
    return triangulate(points, execution).triangulation;
}

void expectValid(const Triangulation& t, bool delaunay = true)
{
    for (const std::string& problem : verify(t, delaunay)) {
        ADD_FAILURE() << problem;
    }
}

HalfEdge anyEdge(const Triangulation& t)
{
    return t.triangles.empty() ? 0 : t.incident[1];
}

TEST(Locate, EveryKindOfPlace)
{
    const Triangulation t = build({{0, 0}, {4, 0}, {0, 4}, {4, 4}, {1, 2}});
    for (HalfEdge hint = 0; hint < 4 * t.triangles.size(); hint += 4) {
        const Location inside = locate(t, {1.0, 1.0}, hint);
        EXPECT_EQ(inside.kind, Location::Kind::Triangle);
        EXPECT_TRUE(t.isFinite(Topology::triangleOf(inside.edge)));
        const Location vertex = locate(t, {1, 2}, hint);
        EXPECT_EQ(vertex.kind, Location::Kind::Vertex);
        EXPECT_EQ(t.points[t.origin(vertex.edge)], (Vec2 {1, 2}));
        const Location edge = locate(t, {3, 0}, hint);
        EXPECT_EQ(edge.kind, Location::Kind::Edge);
        EXPECT_EQ(t.points[t.origin(edge.edge)].y, 0.0);
        EXPECT_EQ(t.points[t.destination(edge.edge)].y, 0.0);
        const Location outside = locate(t, {5, 1}, hint);
        EXPECT_EQ(outside.kind, Location::Kind::Triangle);
        EXPECT_TRUE(t.isGhost(Topology::triangleOf(outside.edge)));
    }
}

TEST(Insert, PointByPointFromNothing)
{
    for (const test::PointSet& set : test::hardPointSets(300)) {
        SCOPED_TRACE(set.name);
        Triangulation t;
        for (const Vec2 p : set.points) {
            const std::uint32_t vertex = insertPoint(t, p, anyEdge(t));
            ASSERT_EQ(t.points[vertex], p);
        }
        expectValid(t);
        EXPECT_EQ(t.vertexCount(), build(set.points).vertexCount());
        EXPECT_TRUE(t.freeList.empty());
    }
}

TEST(Insert, ConstrainedEdgesHide)
{
    // The long edge 2 - 3 is not Delaunay with the points below; p above must not reach across.
    Triangulation t = build({{-10, 0}, {10, 0}, {0, 9}, {0, -1}});
    const std::uint32_t left = locate(t, {-10, 0}, anyEdge(t)).edge;
    const std::uint32_t a = t.origin(left);
    const std::uint32_t b = t.origin(locate(t, {10, 0}, anyEdge(t)).edge);
    HalfEdge edge = t.findEdge(a, b);
    if (edge == Topology::kDead) {
        const std::uint32_t c = t.origin(locate(t, {0, 9}, anyEdge(t)).edge);
        const std::uint32_t d = t.origin(locate(t, {0, -1}, anyEdge(t)).edge);
        edge = flip(t, t.findEdge(c, d));
    }
    t.setConstrained(edge, true);
    const std::uint32_t p = insertPoint(t, {0.5, 0.5}, anyEdge(t));
    expectValid(t);
    edge = t.findEdge(a, b);
    ASSERT_NE(edge, Topology::kDead);
    EXPECT_TRUE(t.isConstrained(edge));
    const std::uint32_t q = insertPoint(t, {1, 0}, t.incident[p]);
    expectValid(t);
    EXPECT_EQ(t.findEdge(a, b), Topology::kDead);
    for (const std::uint32_t end : {a, b}) {
        const HalfEdge half = t.findEdge(q, end);
        ASSERT_NE(half, Topology::kDead);
        EXPECT_TRUE(t.isConstrained(half));
        EXPECT_TRUE(t.isConstrained(t.twin(half)));
    }
    EXPECT_NE(t.findEdge(q, p), Topology::kDead);
}

TEST(Legalize, RestoresDelaunayAfterRandomFlips)
{
    Triangulation t = build(test::uniformPoints(500, 9));
    std::mt19937 random(3);
    std::vector<HalfEdge> suspects;
    for (int i = 0; i < 5000; ++i) {
        const HalfEdge edge = Topology::halfEdge(
            static_cast<std::uint32_t>(random() % t.triangles.size()), random() % 3);
        const HalfEdge twin = t.twin(edge);
        if (t.isGhost(Topology::triangleOf(edge)) || t.isGhost(Topology::triangleOf(twin))) {
            continue;
        }
        const Vec2 c = t.points[t.apex(edge)];
        const Vec2 d = t.points[t.apex(twin)];
        if (orient2d(d, t.points[t.destination(edge)], c) > 0
            && orient2d(c, t.points[t.origin(edge)], d) > 0) {
            flip(t, edge);
        }
    }
    expectValid(t, false);
    EXPECT_FALSE(verify(t).empty());
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            suspects.push_back(Topology::halfEdge(i, k));
        }
    }
    legalize(t, suspects);
    expectValid(t);
}

TEST(Rectangle, LeavesTheInsideAsItIs)
{
    for (const test::PointSet& set : test::hardPointSets(300)) {
        SCOPED_TRACE(set.name);
        Triangulation t = build(set.points);
        const Triangulation before = t;
        Box2 box;
        for (const Vec2 p : set.points) {
            box.add(p);
        }
        const InitialRectangle rectangle = makeInitialRectangle(box);
        const auto corners = completeToRectangle(t, rectangle);
        expectValid(t, false);
        for (int i = 0; i < 4; ++i) {
            EXPECT_EQ(t.points[corners[i]], rectangle.corner[i]);
        }
        for (std::uint32_t i = 0; i < before.triangles.size(); ++i) {
            if (before.isFinite(i)) {
                const auto& v = before.triangles[i].v;
                const HalfEdge h = t.findEdge(v[1], v[2]);
                ASSERT_NE(h, Topology::kDead);
                EXPECT_EQ(t.apex(h), v[0]);
                EXPECT_FALSE(t.isConstrained(h));
            }
        }
    }
}

TEST(Verify, FindsWhatIsWrong)
{
    const Triangulation good = build(test::uniformPoints(50, 2));
    Triangulation t = good;
    std::swap(t.triangles[5].v[0], t.triangles[5].v[1]);
    EXPECT_FALSE(verify(t).empty());
    t = good;
    t.triangles[7].link[1] ^= Topology::kConstrainedBit;
    EXPECT_FALSE(verify(t).empty());
    t = good;
    t.points[9] = t.points[9] + Vec2 {3.0, 0.0};
    EXPECT_FALSE(verify(t).empty());
    t = good;
    t.incident[4] = t.incident[5];
    EXPECT_FALSE(verify(t).empty());
    t = good;
    t.freeList.push_back(3);
    EXPECT_FALSE(verify(t).empty());
}

} // namespace
} // namespace tessera
