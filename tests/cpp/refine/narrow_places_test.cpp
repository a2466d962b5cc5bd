// SPDX-License-Identifier: MIT

#include "refine/narrow_places.h"

#include "refine/acute_arms.h"
#include "refine/domains.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tessera
{
namespace
{

using test::Domain;

constexpr double kSize = 0.1; ///< gaps below 0.0018 are narrow

/// A triangulation of the unit square with lines in it.
class Square
{
public:
    explicit Square(const std::vector<std::pair<Vec2, Vec2>>& lines)
    {
        domain_.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, nullptr);
        for (const auto& [a, b] : lines) {
            domain_.addLine(a, b, nullptr);
        }
        mesh_ = domain_.build();
    }

    WorkingMesh& mesh() { return mesh_; }
    std::vector<NarrowPlace> places(const MeshEditor& editor) const
    {
        const std::vector<double> sizes(mesh_.triangulation.points.size(), kSize);
        return findNarrowPlaces(editor, sizes, sizes, 30.0);
    }

private:
    Domain domain_;
    WorkingMesh mesh_;
};

TEST(NarrowPlaces, ThoseBetweenTheArmsOfACornerComeLast)
{
    Square square({{{0.2, 0.2}, {0.8, 0.2}},
                   {{0.2, 0.2003}, {0.8, 0.2003}},
                   {{0.2, 0.7}, {0.4, 0.7}},
                   {{0.2, 0.7}, {0.3, 0.7001}},
                   {{0.3, 0.7001}, {0.4, 0.7002}}});
    const MeshEditor editor(square.mesh());
    const std::vector<NarrowPlace> places = square.places(editor);
    ASSERT_EQ(places.size(), 2U);
    EXPECT_FALSE(places[0].isBetweenArms);
    EXPECT_NEAR(places[0].middle.y, 0.20015, 1e-6);
    EXPECT_TRUE(places[1].isBetweenArms);
    EXPECT_NEAR(places[1].middle.y, 0.7, 2e-4);
    EXPECT_LT(places[1].cost, places[0].cost);
}

TEST(NarrowPlaces, ThoseThatCostTooMuchDoNotKeepOthersFromBeingFollowed)
{
    std::vector<NarrowPlace> places(4);
    const double costs[] = {100.0, 900.0, 50.0, 300.0};
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i].cost = costs[i];
        places[i].isBetweenArms = i >= 2;
    }
    const NarrowChoice choice = chooseNarrowPlaces(places, 200.0, 1.0, Triangulation());
    EXPECT_EQ(choice.followed, 2U);
    EXPECT_EQ(choice.places[0].cost, 100.0);
    EXPECT_EQ(choice.places[1].cost, 50.0);
    EXPECT_EQ(choice.places.size(), 4U);
}

TEST(NarrowPlaces, OfAWedgeThatCostsTooMuchTheWidePartIsFollowed)
{
    // Pieces of 0.1 on both arms of a corner of 0.001 rad.
    std::vector<std::pair<Vec2, Vec2>> arms;
    for (int i = 1; i < 8; ++i) {
        const double from = 0.1 * i;
        const double to = 0.1 * (i + 1);
        arms.push_back({{from, 0.5}, {to, 0.5}});
        arms.push_back({{from, 0.5 + 0.001 * (from - 0.1)}, {to, 0.5 + 0.001 * (to - 0.1)}});
    }
    Square square(arms);
    const MeshEditor editor(square.mesh());
    std::vector<NarrowPlace> places = square.places(editor);
    ASSERT_EQ(places.size(), 1U);
    const double whole = places[0].cost;
    const NarrowChoice choice
        = chooseNarrowPlaces(places, 0.5 * whole, 1.0, editor.triangulation());
    ASSERT_EQ(choice.places.size(), 2U);
    EXPECT_EQ(choice.followed, 1U);
    const NarrowPlace& wide = choice.places[0];
    const NarrowPlace& rest = choice.places[1];
    EXPECT_LE(wide.cost, 0.5 * whole);
    EXPECT_GT(wide.width, rest.width);
    EXPECT_GT(wide.middle.x, rest.middle.x);
    EXPECT_EQ(wide.triangles.size() + rest.triangles.size(), places[0].triangles.size());
    EXPECT_NEAR(wide.cost + rest.cost, whole, 1e-9 * whole);
}

/// Lines that would meet outside are the sides of a gap that good angles can fill.
TEST(NarrowPlaces, ACornerOutsideTheKeptTrianglesDoesNotCount)
{
    for (const bool keepAll : {true, false}) {
        Square square({{{0.2, 0.5}, {0.8, 0.5}},
                       {{0.2, 0.5}, {0.8, 0.5015}},
                       {{0.5, 0.3}, {0.5, 0.5}},
                       {{0.5, 0.50075}, {0.5, 0.7}},
                       {{0.5, 0.5}, {0.5, 0.50075}}});
        WorkingMesh& mesh = square.mesh();
        const Triangulation& t = mesh.triangulation;
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            bool isLeft = true;
            for (const std::uint32_t v : t.triangles[i].v) {
                isLeft = isLeft && t.points[v].x <= 0.5;
            }
            if (isLeft && !keepAll) {
                mesh.regionOfTriangle[i] = WorkingMesh::kOutside;
            }
        }
        const MeshEditor editor(mesh);
        const std::vector<NarrowPlace> places = square.places(editor);
        ASSERT_FALSE(places.empty());
        for (const NarrowPlace& place : places) {
            EXPECT_EQ(place.isBetweenArms, keepAll);
        }
    }
}

TEST(NarrowPlaces, AnArmEndsWhereItBends)
{
    for (const double bend : {0.25, 0.6}) {
        // A corner at x = 0.2 whose upper arm goes on less steeply from the bend.
        Square square({{{0.2, 0.5}, {0.8, 0.5}},
                       {{0.2, 0.5}, {bend, 0.5 + 0.002 * (bend - 0.2)}},
                       {{bend, 0.5 + 0.002 * (bend - 0.2)}, {0.8, 0.5011}}});
        const MeshEditor editor(square.mesh());
        const Triangulation& t = editor.triangulation();
        const auto vertexAt = [&](Vec2 p) {
            return static_cast<std::uint32_t>(
                std::find(t.points.begin() + 1, t.points.end(), p) - t.points.begin());
        };
        const HalfEdge base = t.findEdge(vertexAt({0.2, 0.5}), vertexAt({0.8, 0.5}));
        ASSERT_EQ(t.points[t.apex(base)].x, bend);
        EXPECT_EQ(AcuteArms(editor).areAround(base), bend > 0.5);
    }
}

TEST(AcuteArms, ConcernTrianglesNearTheirCornerAndBetweenThem)
{
    // A needle from x = 0.2 whose arms are in two pieces, and a small square.
    Square square({{{0.2, 0.5}, {0.5, 0.5}},
                   {{0.5, 0.5}, {0.8, 0.5}},
                   {{0.2, 0.5}, {0.4, 0.502}},
                   {{0.4, 0.502}, {0.8, 0.506}},
                   {{0.90, 0.90}, {0.91, 0.90}},
                   {{0.91, 0.90}, {0.91, 0.91}},
                   {{0.91, 0.91}, {0.90, 0.91}},
                   {{0.90, 0.91}, {0.90, 0.90}}});
    const MeshEditor editor(square.mesh());
    const Triangulation& t = editor.triangulation();
    const AcuteArms arms(editor);
    const auto at = [&](Vec2 p) {
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            const auto& v = t.triangles[i].v;
            bool isInside = t.isFinite(i);
            for (std::uint32_t k = 0; isInside && k < 3; ++k) {
                const Vec2 a = t.points[v[k]];
                isInside = cross(t.points[v[(k + 1) % 3]] - a, p - a) > 0.0;
            }
            if (isInside) {
                return i;
            }
        }
        ADD_FAILURE();
        return 0U;
    };
    EXPECT_TRUE(arms.concern(at({0.25, 0.5001}))); // at the corner
    EXPECT_TRUE(arms.concern(at({0.7, 0.5045})));  // its three corners on the arms
    EXPECT_TRUE(arms.concern(at({0.25, 0.6})));    // outside, but beside the corner
    EXPECT_FALSE(arms.concern(at({0.902, 0.907})));
}

TEST(NarrowPlaces, WiderOnesBesideThoseThatAreFollowedAreFollowedToo)
{
    for (const double upper : {0.0016, 0.0001}) {
        // A long gap above the middle line, a short one of 0.0004 below.
        Square square({{{0.2, 0.5}, {0.8, 0.5}},
                       {{0.2, 0.5 + upper}, {0.8, 0.5 + upper}},
                       {{0.49, 0.4996}, {0.51, 0.4996}}});
        const MeshEditor editor(square.mesh());
        const std::vector<NarrowPlace> places = square.places(editor);
        ASSERT_EQ(places.size(), 2U);
        ASSERT_LT(places[0].middle.y, 0.5);
        const auto followed = trianglesToFollow({places, 1, 1000.0}, editor);
        const std::size_t own = places[0].triangles.size();
        ASSERT_GE(followed.size(), own);
        EXPECT_EQ(followed.size() > own, upper > 0.0004);
        for (std::size_t i = own; i < followed.size(); ++i) {
            EXPECT_EQ(std::count(places[1].triangles.begin(), places[1].triangles.end(),
                                 followed[i].triangle),
                      1);
            EXPECT_NEAR(followed[i].width, 0.0004, 1e-9);
        }
    }
}

TEST(NarrowPlaces, AcuteCornersBesideThoseThatAreFollowedAreFollowedToo)
{
    // One triangle between two arms above the middle line.
    Square square({{{0.2, 0.5}, {0.8, 0.5}},
                   {{0.2, 0.5}, {0.8, 0.53}},
                   {{0.49, 0.4996}, {0.51, 0.4996}}});
    const MeshEditor editor(square.mesh());
    const std::vector<NarrowPlace> places = square.places(editor);
    ASSERT_EQ(places.size(), 1U);
    const std::size_t own = places[0].triangles.size();
    const auto followed = trianglesToFollow({places, 1, 1000.0}, editor);
    ASSERT_EQ(followed.size(), own + 1);
    EXPECT_NEAR(followed.back().width, 0.0004, 1e-9);
    EXPECT_EQ(trianglesToFollow({places, 0, 1000.0}, editor).size(), 0U);
}

} // namespace
} // namespace tessera
