// SPDX-License-Identifier: MIT
#include "mesh/quality.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tessera
{

namespace
{

class Uniform: public SizeField
{
public:
    explicit Uniform(double h)
        : h_(h)
    {}
    double size(Vec2) const override { return h_; }
    double uniformSize() const override { return h_; }
    double gradientBound() const override { return 0.0; }

private:
    double h_;
};

/// The unit square as two triangles.
Mesh square()
{
    Mesh mesh;
    mesh.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.triangleRegion = {0, 0};
    mesh.regions = {{1.0, 0.0, {}}};
    mesh.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    mesh.edgeIsOutline = {1, 1, 1, 1};
    mesh.edgeCurveStart = {0, 0, 0, 0, 0};
    return mesh;
}

} // namespace

TEST(Quality, EquilateralIsOneDegenerateIsZero)
{
    const double h = std::sqrt(3.0) / 2.0;
    EXPECT_NEAR(triangleQuality({0, 0}, {1, 0}, {0.5, h}), 1.0, 1e-15);
    EXPECT_NEAR(triangleQuality({0, 0}, {0.5, h}, {1, 0}), -1.0, 1e-15);
    EXPECT_EQ(triangleQuality({0, 0}, {1, 0}, {2, 0}), 0.0);
    EXPECT_EQ(triangleQuality({1, 1}, {1, 1}, {1, 1}), 0.0);
}

TEST(Quality, AnglesAddUp)
{
    const AngleRange right = triangleAngles({0, 0}, {3, 0}, {0, 4});
    EXPECT_NEAR(right.largest, 90.0, 1e-12);
    EXPECT_NEAR(right.smallest, std::atan2(3.0, 4.0) * 180.0 / M_PI, 1e-12);
}

TEST(Quality, SquareReport)
{
    const Mesh mesh = square();
    const Uniform size(0.5);
    const QualityReport report = measureQuality(mesh, &size);
    EXPECT_NEAR(report.minAngle, 45.0, 1e-12);
    EXPECT_NEAR(report.maxAngle, 90.0, 1e-12);
    EXPECT_NEAR(report.minQuality, std::sqrt(3.0) / 2.0, 1e-12);
    EXPECT_NEAR(report.meanQuality, report.minQuality, 1e-12);
    // Five edges, each once: four sides of length 2 h and the diagonal.
    EXPECT_NEAR(report.sizeConformity.min, 2.0, 1e-12);
    EXPECT_NEAR(report.sizeConformity.median, 2.0, 1e-12);
    EXPECT_NEAR(report.sizeConformity.max, 2.0 * std::sqrt(2.0), 1e-12);
}

TEST(Quality, EmptyMeshIsAllZero)
{
    const QualityReport report = measureQuality(Mesh {}, nullptr);
    EXPECT_EQ(report.minAngle, 0.0);
    EXPECT_EQ(report.meanQuality, 0.0);
}

} // namespace tessera
