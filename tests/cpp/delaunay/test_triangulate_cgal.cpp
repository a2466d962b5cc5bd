// SPDX-License-Identifier: MIT

// CGAL's exact Delaunay triangulation as an independent oracle: inside the convex hull the
// triangles are the same up to cocircular ties, so the rectangle leaves no trace.

#include "delaunay/delaunay.h"

#include "point_sets.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace tessera
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalDelaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Corners = std::array<std::pair<double, double>, 3>;

/// The corners from the least on, counter-clockwise.
Corners normalized(Corners corners)
{
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

Kernel::Point_2 toCgal(const std::pair<double, double>& p)
{
    return {p.first, p.second};
}

std::set<Corners> oursOf(const Triangulation& t)
{
    std::set<Corners> triangles;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (t.isFinite(i)) {
            Corners corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2 p = t.points[t.triangles[i].v[k]];
                corners[k] = {p.x, p.y};
            }
            triangles.insert(normalized(corners));
        }
    }
    return triangles;
}

std::set<Corners> cgalsOf(const CgalDelaunay& t)
{
    std::set<Corners> triangles;
    for (auto face = t.finite_faces_begin(); face != t.finite_faces_end(); ++face) {
        Corners corners;
        for (int k = 0; k < 3; ++k) {
            corners[static_cast<std::size_t>(k)]
                = {face->vertex(k)->point().x(), face->vertex(k)->point().y()};
        }
        triangles.insert(normalized(corners));
    }
    return triangles;
}

/// A triangle is no tie when the circle through it has no further point on it: by CGAL's predicate,
/// the apexes of its three neighbors are strictly outside.
bool isUnique(const CgalDelaunay& t, const CgalDelaunay::Face_handle& face)
{
    for (int k = 0; k < 3; ++k) {
        const auto neighbor = face->neighbor(k);
        if (!t.is_infinite(neighbor)
            && t.side_of_oriented_circle(face, t.mirror_vertex(face, k)->point())
                == CGAL::ON_ORIENTED_BOUNDARY) {
            return false;
        }
    }
    return true;
}

/// CGAL's predicates are exact without overflow and underflow only; scaling by 2^+-300 is not
/// theirs.
bool fitsCgal(const std::vector<Vec2>& points)
{
    return std::all_of(points.begin(), points.end(), [](Vec2 p) {
        const auto fits = [](double x) {
            return x == 0.0 || (std::fabs(x) > 1e-60 && std::fabs(x) < 1e60);
        };
        return fits(p.x) && fits(p.y);
    });
}

void compare(const std::vector<Vec2>& points, bool expectTies)
{
    Execution execution;
    const Triangulation ours = triangulate(points, execution).triangulation;
    std::vector<Kernel::Point_2> cgalPoints;
    for (const Vec2 p : points) {
        cgalPoints.emplace_back(p.x, p.y);
    }
    const CgalDelaunay theirs(cgalPoints.begin(), cgalPoints.end());
    EXPECT_EQ(ours.vertexCount(), theirs.number_of_vertices());
    const std::set<Corners> ourTriangles = oursOf(ours);
    const std::set<Corners> theirTriangles = cgalsOf(theirs);
    // Equally many triangles on the same vertices: the same convex hull, collinear points included.
    ASSERT_EQ(ourTriangles.size(), theirTriangles.size());

    // Ours are empty of all points by CGAL's test on each edge; with the same count both tile the
    // hull, so every triangle that is no tie must be in both.
    for (const Corners& c : ourTriangles) {
        ASSERT_EQ(CGAL::orientation(toCgal(c[0]), toCgal(c[1]), toCgal(c[2])), CGAL::LEFT_TURN);
    }
    std::size_t unique = 0;
    for (auto face = theirs.finite_faces_begin(); face != theirs.finite_faces_end(); ++face) {
        if (isUnique(theirs, face)) {
            ++unique;
            Corners c;
            for (int k = 0; k < 3; ++k) {
                c[static_cast<std::size_t>(k)]
                    = {face->vertex(k)->point().x(), face->vertex(k)->point().y()};
            }
            ASSERT_TRUE(ourTriangles.contains(normalized(c)));
        }
    }
    if (!expectTies) {
        EXPECT_EQ(unique, ourTriangles.size());
    }
    for (std::uint32_t i = 0; i < ours.triangles.size(); ++i) {
        for (std::uint32_t k = 0; k < 3 && ours.isFinite(i); ++k) {
            const HalfEdge edge = Topology::halfEdge(i, k);
            const HalfEdge twin = ours.twin(edge);
            if (ours.isGhost(Topology::triangleOf(twin))) {
                continue;
            }
            const auto point = [&](std::uint32_t v) {
                return Kernel::Point_2(ours.points[v].x, ours.points[v].y);
            };
            ASSERT_NE(CGAL::side_of_oriented_circle(
                          point(ours.apex(edge)), point(ours.origin(edge)),
                          point(ours.destination(edge)), point(ours.apex(twin))),
                      CGAL::ON_POSITIVE_SIDE);
        }
    }
}

TEST(TriangulateAgainstCgal, HardSets)
{
    int compared = 0;
    for (const test::PointSet& set : test::hardPointSets(3000)) {
        SCOPED_TRACE(set.name);
        if (fitsCgal(set.points)) {
            ++compared;
            compare(set.points, true);
        }
    }
    EXPECT_GE(compared, 11);
}

TEST(TriangulateAgainstCgal, WithoutTiesEveryTriangleIsTheSame)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        compare(test::uniformPoints(2000, seed), false);
    }
    compare(test::uniformPoints(100000, 77), false);
}

TEST(TriangulateAgainstCgal, ManySmallIntegerSets)
{
    std::mt19937_64 random(9);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE(i);
        std::vector<Vec2> points(3 + random() % 12);
        const std::uint64_t range = 2 + random() % 6;
        for (Vec2& p : points) {
            p = {static_cast<double>(random() % range), static_cast<double>(random() % range)};
        }
        compare(points, true);
        if (HasFatalFailure()) {
            return;
        }
    }
}

} // namespace
} // namespace tessera
