// SPDX-License-Identifier: MIT
#include "mesh/quality.h"

#include "mesh/select.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

/// Many random triangles without common nodes.
Mesh scattered(std::uint32_t count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    Mesh mesh;
    for (std::uint32_t t = 0; t < count; ++t) {
        const std::uint32_t first = 3 * t;
        for (int i = 0; i < 3; ++i) {
            mesh.nodes.push_back({uniform(random), uniform(random)});
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
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

TEST(Quality, HistogramsAndWorstAgreeWithEachTriangle)
{
    const Mesh mesh = scattered(100000);
    const QualityReport report = measureQuality(mesh, nullptr);
    std::array<std::size_t, QualityReport::kAngleBins> angles {};
    std::array<std::size_t, QualityReport::kQualityBins> qualities {};
    std::vector<double> smallest;
    double largest = 0.0;
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        const Vec2 a = mesh.nodes[t[0]];
        const Vec2 b = mesh.nodes[t[1]];
        const Vec2 c = mesh.nodes[t[2]];
        const AngleRange range = triangleAngles(a, b, c);
        const double q = triangleQuality(a, b, c);
        ++angles[static_cast<std::size_t>(range.smallest / 5.0)];
        ++qualities[static_cast<std::size_t>(std::max(q, 0.0) * 20.0)];
        smallest.push_back(range.smallest);
        largest = std::max(largest, range.largest);
        sum += q;
    }
    EXPECT_EQ(report.angleHistogram, angles);
    EXPECT_EQ(report.qualityHistogram, qualities);
    EXPECT_NEAR(report.meanQuality, sum / 1e5, 1e-12);
    EXPECT_NEAR(report.maxAngle, largest, 1e-9);
    std::vector<double> sorted = smallest;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_NEAR(report.angleP01, sorted[999], 1e-6 * sorted[999]);
    ASSERT_EQ(report.worst.size(), QualityReport::kWorst);
    for (std::size_t i = 0; i < report.worst.size(); ++i) {
        EXPECT_NEAR(report.worst[i].angle, sorted[i], 1e-12);
        EXPECT_EQ(report.worst[i].angle, smallest[report.worst[i].triangle]);
    }
    EXPECT_EQ(report.minAngle, report.worst.front().angle);
}

TEST(Quality, TheSameForAnyNumberOfThreads)
{
    const Mesh mesh = scattered(100000);
    const Uniform size(0.5);
    const QualityReport one = measureQuality(mesh, &size);
    for (const int threads : {2, 3, 8}) {
        Execution execution;
        execution.setThreads(threads);
        const QualityReport many = measureQuality(mesh, &size, execution);
        EXPECT_EQ(one.meanQuality, many.meanQuality);
        EXPECT_EQ(one.angleP01, many.angleP01);
        EXPECT_EQ(one.angleHistogram, many.angleHistogram);
        EXPECT_EQ(one.sizeConformity.p05, many.sizeConformity.p05);
        EXPECT_EQ(one.sizeConformity.max, many.sizeConformity.max);
        EXPECT_EQ(one.worst.back().triangle, many.worst.back().triangle);
    }
}

TEST(Quality, PercentilesAreThoseOfTheSortedValues)
{
    std::mt19937 random(3);
    std::uniform_int_distribution<int> exponent(-40, 40);
    std::uniform_real_distribution<float> uniform(1.0F, 2.0F);
    for (const bool alike : {false, true}) {
        ValuePieces values(5);
        std::vector<float> all;
        for (int i = 0; i < 5000; ++i) {
            const float value = alike && i % 7 != 0
                ? 1.0F
                : std::ldexp(uniform(random), alike ? 0 : exponent(random));
            values[static_cast<std::size_t>(i % 4)].push_back(value);
            all.push_back(value);
        }
        std::sort(all.begin(), all.end());
        const double fractions[] = {0.0, 0.05, 0.5, 0.95, 1.0};
        Execution execution;
        execution.setThreads(2);
        const std::vector<float> found = percentiles(values, fractions, execution);
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i], all[static_cast<std::size_t>(fractions[i] * 4999.0)]);
        }
    }
}

TEST(Quality, EmptyMeshIsAllZero)
{
    const QualityReport report = measureQuality(Mesh {}, nullptr);
    EXPECT_EQ(report.minAngle, 0.0);
    EXPECT_EQ(report.meanQuality, 0.0);
}

} // namespace tessera
