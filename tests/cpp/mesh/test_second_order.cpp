// SPDX-License-Identifier: MIT
#include "mesh/second_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tessera
{

namespace
{

/// Jacobian determinant of a 6-node triangle at barycentric (l0, l1, l2), from the shape functions'
/// derivatives: independent of the Bézier form that the product uses.
double jacobianAt(const Vec2 c[3], const Vec2 m[3], double l1, double l2)
{
    const double l0 = 1.0 - l1 - l2;
    // N0 = l0 (2 l0 - 1), N1, N2 alike; mid opposite 0: 4 l1 l2, opposite 1: 4 l2 l0, 2: 4 l0 l1.
    const double du[6] = {1 - 4 * l0, 4 * l1 - 1, 0, 4 * l2, -4 * l2, 4 * (l0 - l1)};
    const double dv[6] = {1 - 4 * l0, 0, 4 * l2 - 1, 4 * l1, 4 * (l0 - l2), -4 * l1};
    Vec2 u;
    Vec2 v;
    for (int i = 0; i < 3; ++i) {
        u = u + du[i] * c[i] + du[3 + i] * m[i];
        v = v + dv[i] * c[i] + dv[3 + i] * m[i];
    }
    return cross(u, v);
}

} // namespace

TEST(SecondOrder, BoundIsBelowTheJacobianEverywhere)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shift(-0.25, 0.25);
    int positive = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec2 c[3] = {{0, 0}, {1, shift(random)}, {shift(random), 1}};
        Vec2 m[3];
        for (int i = 0; i < 3; ++i) {
            m[i] = midpoint(c[(i + 1) % 3], c[(i + 2) % 3]) + Vec2 {shift(random), shift(random)};
        }
        const double bound = jacobianLowerBound(c, m);
        positive += bound > 0.0 ? 1 : 0;
        double lowest = INFINITY;
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; i + j <= 20; ++j) {
                lowest = std::min(lowest, jacobianAt(c, m, i / 20.0, j / 20.0));
            }
        }
        ASSERT_LE(bound, lowest + 1e-12) << trial;
    }
    EXPECT_GT(positive, 100);
    EXPECT_LT(positive, 1900);
}

TEST(SecondOrder, StraightTriangleGivesTwiceItsArea)
{
    const Vec2 c[3] = {{0, 0}, {3, 0}, {1, 2}};
    const Vec2 m[3] = {midpoint(c[1], c[2]), midpoint(c[2], c[0]), midpoint(c[0], c[1])};
    EXPECT_DOUBLE_EQ(jacobianLowerBound(c, m), 6.0);
}

TEST(SecondOrder, MidNodesAreSharedAndLieOnTheCurve)
{
    Mesh mesh;
    mesh.nodes = {{-1, 0}, {1, 0}, {0, 1}, {0, -1}};
    mesh.nodeOrigin.assign(4, VertexOrigin::Input);
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
    mesh.triangleRegion = {0, 0};
    mesh.regions = {{2.0, 0.0, {}}};
    mesh.edges = {{1, 2}};
    const Vec2 onCircle {std::sqrt(0.5), std::sqrt(0.5)};
    const auto moved = makeSecondOrder(mesh, {onCircle});
    EXPECT_TRUE(moved.empty());
    EXPECT_EQ(mesh.nodes.size(), 4U + 5U);
    EXPECT_EQ(mesh.nodes[mesh.edgeMidNodes[0]], onCircle);
    EXPECT_EQ(mesh.triangleMidNodes[0][0], mesh.edgeMidNodes[0]);
    EXPECT_EQ(mesh.triangleMidNodes[0][2], mesh.triangleMidNodes[1][2]);
    EXPECT_EQ(mesh.nodes[mesh.triangleMidNodes[0][2]], (Vec2 {0, 0}));
    // The parabola's part beyond the chord of length sqrt(2): 2/3 x chord x height.
    EXPECT_NEAR(mesh.regions[0].area, 2.0 + 2.0 / 3.0 * (std::sqrt(2.0) - 1.0), 1e-12);
}

TEST(SecondOrder, FoldingMidNodeIsStraightened)
{
    Mesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {0.5, 0.1}};
    mesh.nodeOrigin.assign(3, VertexOrigin::Input);
    mesh.triangles = {{0, 1, 2}};
    mesh.triangleRegion = {0};
    mesh.regions = {{0.05, 0.0, {}}};
    mesh.edges = {{0, 1}};
    // The curve bulges through the opposite corner.
    const auto moved = makeSecondOrder(mesh, {{0.5, 0.2}});
    EXPECT_EQ(moved, std::vector<std::uint32_t> {0});
    Vec2 corner[3];
    Vec2 middle[3];
    for (int i = 0; i < 3; ++i) {
        corner[i] = mesh.nodes[mesh.triangles[0][i]];
        middle[i] = mesh.nodes[mesh.triangleMidNodes[0][i]];
    }
    EXPECT_GT(jacobianLowerBound(corner, middle), 0.0);
}

} // namespace tessera
