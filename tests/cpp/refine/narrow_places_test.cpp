// SPDX-License-Identifier: MIT

#include "refine/narrow_places.h"

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
    const NarrowChoice choice = chooseNarrowPlaces(places, 200.0, 1.0);
    EXPECT_EQ(choice.followed, 2U);
    EXPECT_EQ(choice.places[0].cost, 100.0);
    EXPECT_EQ(choice.places[1].cost, 50.0);
    EXPECT_EQ(choice.places.size(), 4U);
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

TEST(NarrowPlaces, WiderOnesBesideThoseThatAreFollowedAreFollowedToo)
{
    for (const double upper : {0.0016, 0.0001}) {
        // A long gap above the middle line, a short one of 0.0004 below.
        Square square({{{0.2, 0.5}, {0.8, 0.5}},
                       {{0.2, 0.5 + upper}, {0.8, 0.5 + upper}},
                       {{0.49, 0.4996}, {0.51, 0.4996}}});
        const MeshEditor editor(square.mesh());
        std::vector<NarrowPlace> places = square.places(editor);
        ASSERT_EQ(places.size(), 2U);
        EXPECT_LT(places[0].middle.y, 0.5);
        const NarrowChoice choice {places, 1, 1000.0};
        const std::vector<std::uint32_t> beside = besideFollowed(choice, editor);
        EXPECT_EQ(beside.empty(), upper < 0.0004);
        for (const std::uint32_t triangle : beside) {
            EXPECT_EQ(std::count(places[1].triangles.begin(), places[1].triangles.end(), triangle),
                      1);
        }
    }
}

} // namespace
} // namespace tessera
