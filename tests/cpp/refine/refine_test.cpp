// SPDX-License-Identifier: MIT

#include "refine/refine.h"

#include "delaunay/delaunay.h"
#include "refine/domains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tessera
{
namespace
{

using test::checkWorkingMesh;
using test::Domain;
using test::Figures;
using test::measure;
using test::SegmentSize;
using test::UniformSize;

struct Refined
{
    Domain domain; ///< owns the curves
    WorkingMesh original;
    WorkingMesh mesh;
    RefineReport report;
    Figures figures;
};

Refined refineDomain(const Domain& domain, const SizeField& size, RefineOptions options = {})
{
    Refined r {domain, domain.build(), {}, {}, {}};
    r.mesh = r.original;
    Execution execution;
    r.report = refine(r.mesh, size, options, execution);
    r.figures = measure(r.mesh, size);
    return r;
}

void expectValid(const Refined& r)
{
    EXPECT_EQ(verify(r.mesh.triangulation), std::vector<std::string> {});
    EXPECT_EQ(checkWorkingMesh(r.mesh, r.original), std::vector<std::string> {});
}

TEST(Refine, SquareHasNominalNumberOfGoodTriangles)
{
    const UniformSize size(0.05);
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
    const Refined r = refineDomain(d, size);
    expectValid(r);
    EXPECT_NEAR(r.figures.area, 1.0, 1e-13);
    EXPECT_NEAR(static_cast<double>(r.figures.triangles), 924.0, 120.0);
    EXPECT_GE(r.figures.minAngle, 30.0);
    EXPECT_GE(r.figures.meanQuality, 0.95);
    EXPECT_TRUE(r.report.unreached.empty());
    EXPECT_EQ(r.report.segmentSplits, 0U);
}

TEST(Refine, PlateMeetsAnglesAndSizes)
{
    const UniformSize size(0.02);
    const Refined r = refineDomain(Domain::plate(size), size);
    expectValid(r);
    EXPECT_GE(r.figures.minAngle, 30.0);
    EXPECT_GE(r.figures.meanQuality, 0.95);
    EXPECT_GE(r.figures.p05, 0.7);
    EXPECT_LE(r.figures.p95, 1.4);
    EXPECT_TRUE(r.report.unreached.empty());
}

TEST(Refine, GradedPlateMeetsAnglesAndSizes)
{
    const SegmentSize size({0.1, 0.45}, {0.3, 0.52}, 0.002, 0.1, 1.0);
    const Refined r = refineDomain(Domain::plate(size), size);
    expectValid(r);
    EXPECT_GE(r.figures.minAngle, 29.999);
    EXPECT_GE(r.figures.p05, 0.5);
    EXPECT_LE(r.figures.p95, 1.4);
}

TEST(Refine, ConstraintSplitsLieOnTheirCurve)
{
    // A coarse circle in a fine field: every piece is split, on the circle.
    const UniformSize size(0.02);
    Domain d;
    d.addPolygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, &size);
    d.addCircle({0, 0}, 0.5, 12);
    const Refined r = refineDomain(d, size);
    expectValid(r);
    EXPECT_GE(r.report.segmentSplits, 12U);
    EXPECT_NEAR(r.figures.area, 4.0 - M_PI * 0.25, 1e-3);
    EXPECT_GE(r.figures.minAngle, 29.999);
}

TEST(Refine, ConvexArcGrowsOverTheHull)
{
    const UniformSize size(0.05);
    Domain d;
    d.addCircle({0, 0}, 1.0, 8);
    const Refined r = refineDomain(d, size);
    expectValid(r);
    EXPECT_GE(r.report.segmentSplits, 8U);
    EXPECT_NEAR(r.figures.area, M_PI, 0.01);
    EXPECT_GE(r.figures.minAngle, 29.999);
}

TEST(Refine, FrozenBoundaryStays)
{
    const UniformSize size(0.05);
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
    d.addCircle({0.5, 0.5}, 0.2, 8);
    RefineOptions options;
    options.freezeBoundary = true;
    const Refined r = refineDomain(d, size, options);
    expectValid(r);
    EXPECT_EQ(r.report.segmentSplits, 0U);
    EXPECT_EQ(r.mesh.edges.size(), r.original.edges.size());
}

TEST(Refine, FrozenBoundaryLeavesNoAnglesToOptimization)
{
    const SegmentSize size({0.1, 0.45}, {0.3, 0.52}, 0.002, 0.4, 1.0);
    const Domain d = Domain::plate(size);
    RefineOptions options;
    options.freezeBoundary = true;
    const Refined last = refineDomain(d, size, options);
    options.optimizeFollows = true;
    const Refined first = refineDomain(d, size, options);
    EXPECT_EQ(first.mesh.triangulation.points, last.mesh.triangulation.points);
}

TEST(Refine, SizesReachBesideFrozenLongEdges)
{
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, nullptr);
    d.addLine({0.1, 0.96}, {0.9, 0.96}, nullptr);
    RefineOptions options;
    options.freezeBoundary = true;
    const SegmentSize size({0.5, 0.5}, {0.5, 0.5}, 0.01, 0.3, 0.05);
    const Refined graded = refineDomain(d, size, options);
    expectValid(graded);
    EXPECT_GE(graded.figures.triangles, 0.5 * estimateTriangles(graded.original, size));
    EXPECT_LE(graded.figures.p95, 4.0);
    options.maxArea = 0.001;
    const UniformSize none(10.0);
    const Refined bounded = refineDomain(d, none, options);
    expectValid(bounded);
    EXPECT_GE(bounded.figures.triangles, 1000U);
}

TEST(Refine, SmallInputAnglesEndAndAreListed)
{
    for (const double degrees : {40.0, 20.0, 5.0, 1.0, 0.01}) {
        const UniformSize size(0.1);
        const double angle = degrees * M_PI / 180.0;
        Domain d;
        d.addPolygon({{0, 0}, {1, 0}, {std::cos(angle), std::sin(angle)}}, &size);
        const Refined r = refineDomain(d, size);
        expectValid(r);
        EXPECT_NEAR(r.figures.area, 0.5 * std::sin(angle), 1e-12);
        std::size_t below = 0;
        for (const Unreached& u : r.report.unreached) {
            below += u.what == "min_angle" ? 1 : 0;
            EXPECT_LT(u.value, 30.0);
        }
        EXPECT_EQ(below == 0, r.figures.minAngle >= 30.0) << degrees;
        EXPECT_LE(r.figures.triangles, 20000U) << degrees;
    }
}

TEST(Refine, ThinGapEnds)
{
    for (const double gap : {1e-2, 1e-4, 1e-8, 1e-14}) {
        const UniformSize size(0.1);
        Domain d;
        d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
        d.addLine({0.2, 0.5}, {0.8, 0.5}, &size);
        d.addLine({0.21, 0.5 + gap}, {0.79, 0.5 + gap}, &size);
        const Refined r = refineDomain(d, size);
        expectValid(r);
        EXPECT_NEAR(r.figures.area, 1.0, 1e-12);
        EXPECT_LE(r.figures.triangles, 200000U) << gap;
    }
}

TEST(Refine, FlatTrianglesEnd)
{
    // Points beside each other on both long sides round into the same column.
    for (const double height : {1e-17, 1e-16, 3e-16, 1e-13, 1e-9, 1e-4}) {
        const UniformSize size(0.025);
        Domain d;
        d.addPolygon({{0, 0}, {1, 0}, {0.5, height}}, &size);
        const Refined r = refineDomain(d, size);
        expectValid(r);
        EXPECT_LE(r.figures.triangles, 12000U) << height;
    }
}

TEST(Refine, MoreTrianglesThanAllowedAreRefused)
{
    const UniformSize size(0.025);
    RefineOptions options;
    options.maxTriangles = 1000.0;
    Domain flat; // the gap divides its sides far below the size
    flat.addPolygon({{0, 0}, {1, 0}, {0.5, 1e-3}}, &size);
    Domain square;
    square.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
    for (const Domain& d : {flat, square}) {
        try {
            refineDomain(d, size, options);
            ADD_FAILURE() << "no error";
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::TooLarge);
            EXPECT_NE(std::string(error.what()).find("1e+03 triangles"), std::string::npos);
        }
    }
}

TEST(Refine, EstimateCountsAreaLimits)
{
    const UniformSize size(0.1);
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
    for (const double area : {1e-3, 1e-4, 3e-5}) {
        RefineOptions everywhere;
        everywhere.maxArea = area;
        RefineOptions inRegion;
        inRegion.regionMaxArea = {area};
        for (const RefineOptions& options : {everywhere, inRegion}) {
            const double estimate = estimateTriangles(d.build(), size, options);
            const auto made
                = static_cast<double>(refineDomain(d, size, options).figures.triangles);
            EXPECT_NEAR(estimate / made, 1.0, 0.4) << area;
        }
    }
}

TEST(Refine, HopelessGapIsNotDivided)
{
    const UniformSize size(0.1);
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
    for (int i = 0; i < 4; ++i) {
        d.addLine({0.2 + 0.01 * i, 0.5 + 1e-9 * i}, {0.8, 0.5 + 1e-9 * i}, &size);
    }
    const Refined r = refineDomain(d, size);
    expectValid(r);
    EXPECT_LE(r.figures.triangles, 8000U);
    EXPECT_LE(r.report.unreached.size(), 1300U);
}

/// Triangles below 25 degrees with all corners farther from the point than the distance.
std::size_t countBadBeyond(double reach, Vec2 corner, const WorkingMesh& mesh)
{
    std::size_t bad = 0;
    const Triangulation& t = mesh.triangulation;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (!t.isFinite(i) || mesh.regionOfTriangle[i] == WorkingMesh::kOutside) {
            continue;
        }
        const auto& v = t.triangles[i].v;
        bool isNear = false;
        double smallest = 180.0;
        for (int k = 0; k < 3; ++k) {
            const Vec2 p = t.points[v[k]];
            const Vec2 a = t.points[v[(k + 1) % 3]] - p;
            const Vec2 b = t.points[v[(k + 2) % 3]] - p;
            isNear = isNear || distance(p, corner) <= reach;
            smallest = std::min(smallest, std::atan2(cross(a, b), dot(a, b)) * 180.0 / M_PI);
        }
        bad += !isNear && smallest < 25.0 ? 1U : 0U;
    }
    return bad;
}

Domain squareWithNeedle(double angle, const SizeField* size)
{
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, size);
    d.addLine({0.3, 0.5}, {0.7, 0.5}, size);
    d.addLine({0.3, 0.5}, {0.7, 0.5 + 0.4 * angle}, size);
    return d;
}

TEST(Refine, NarrowWedgeIsFollowedToItsCornerIfTheShareSuffices)
{
    const UniformSize size(0.02);
    const Domain d = squareWithNeedle(0.005, &size);
    RefineOptions none;
    none.narrowShare = 0.0;
    const Refined left = refineDomain(d, size, none);
    const Refined followed = refineDomain(d, size);
    expectValid(left);
    expectValid(followed);
    // The first edges at the corner are as long as the size.
    EXPECT_GT(countBadBeyond(0.025, {0.3, 0.5}, left.mesh), 0U);
    EXPECT_EQ(countBadBeyond(0.025, {0.3, 0.5}, followed.mesh), 0U);
    EXPECT_GT(followed.figures.triangles, left.figures.triangles);
    EXPECT_LE(followed.figures.triangles, 4 * left.figures.triangles);
}

TEST(Refine, AGapIsFollowedWhereTheSizeMakesItHopeless)
{
    const SegmentSize size({0, 0}, {0, 1}, 0.02, 0.3, 10.0);
    // Where the size is small these are wide enough as they are.
    for (const double width : {0.002, 0.003, 0.004}) {
        Domain d;
        d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
        d.addLine({0.1, 0.5}, {0.9, 0.5}, nullptr);
        for (double x = 0.1; x < 0.8;) {
            const double next = x + 0.8 * size.size({x, 0.5});
            d.addLine({x, 0.5 + width}, {next, 0.5 + width}, nullptr);
            x = next;
        }
        const Refined r = refineDomain(d, size);
        expectValid(r);
        EXPECT_GE(r.figures.minAngle, 30.0 - 1e-9) << width;
    }
}

/// On the boundary beside an edge far shorter than the size, pieces are about as short as it is.
TEST(Refine, ACornerWithAShortEdgeIsNoGap)
{
    const UniformSize size(0.1);
    RefineOptions options;
    options.optimizeFollows = true;
    for (const double degrees : {89.0, 75.0, 65.0}) {
        for (const double stub : {1e-3, 1e-5, 1e-8}) {
            Domain d;
            d.addPolygon({{0.45, 0}, {0.5, 0}, {0.6, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, nullptr);
            const double angle = degrees * M_PI / 180.0;
            d.addLine({0.5, 0}, stub * Vec2 {std::cos(angle), std::sin(angle)} + Vec2 {0.5, 0},
                      nullptr);
            const Refined r = refineDomain(d, size, options);
            expectValid(r);
            for (const ConstrainedEdge& edge : r.mesh.edges) {
                const Vec2 a = r.mesh.triangulation.points[edge.a];
                const Vec2 b = r.mesh.triangulation.points[edge.b];
                if (a == Vec2 {0.5, 0} || b == Vec2 {0.5, 0}) {
                    EXPECT_LE(distance(a, b), 2.0 * stub) << degrees << " degrees";
                }
            }
            EXPECT_LE(r.figures.triangles, 2000U) << degrees << " degrees, " << stub;
        }
    }
}

/// Short pieces for the last bad triangles would only make more of them in there.
TEST(Refine, ADoubleLineThatIsLeftStaysCoarse)
{
    const UniformSize size(0.035);
    for (const double width : {1e-9, 1e-7, 1e-5}) {
        Domain d;
        d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
        d.addLine({0.1, 0.5}, {0.9, 0.53}, &size);
        d.addLine({0.1, 0.5 + width}, {0.9, 0.53 + width}, &size);
        RefineOptions options;
        options.narrowShare = 0.0;
        const Refined coarse = refineDomain(d, size, options);
        const Refined left = refineDomain(d, size);
        expectValid(left);
        EXPECT_LE(left.figures.triangles, 3 * coarse.figures.triangles) << width;
        EXPECT_LE(left.report.unreached.size(), 3 * coarse.report.unreached.size()) << width;
    }
}

/// Between the arms small angles stay; beyond the bend pieces far below the size make them good, but
/// do not open the gap before it, which would take up to 200,000 triangles.
TEST(Refine, BeyondTheBendOfANeedleAnglesAreGood)
{
    const UniformSize size(0.3);
    for (const double bend : {1.0, 4.0}) {
        for (const double opening : {1.0, 3.0, 10.0}) {
            for (const double width : {2e-5, 2e-4}) {
                const double end = width + (10.0 - bend) * std::tan(opening * M_PI / 180.0);
                Domain d;
                d.addPolygon({{-1, -4}, {11, -4}, {11, 4}, {-1, 4}}, &size);
                d.addLine({0, 0}, {10, 0}, &size);
                d.addLine({0, 0}, {bend, width}, &size);
                d.addLine({bend, width}, {10, end}, &size);
                const Refined r = refineDomain(d, size);
                expectValid(r);
                EXPECT_EQ(countBadBeyond(bend + width, {0, 0}, r.mesh), 0U)
                    << bend << ": " << opening << " degrees, " << width << " wide";
                EXPECT_LE(r.figures.triangles, 30000U)
                    << bend << ": " << opening << " degrees, " << width << " wide";
            }
        }
    }
}

TEST(Refine, NarrowWedgeIsLeftIfItCostsTooMuch)
{
    const UniformSize size(0.02);
    const Domain d = squareWithNeedle(1e-6, &size);
    RefineOptions none;
    none.narrowShare = 0.0;
    const Refined left = refineDomain(d, size, none);
    const Refined tried = refineDomain(d, size);
    expectValid(tried);
    EXPECT_LE(tried.figures.triangles, 1.2 * static_cast<double>(left.figures.triangles));
    EXPECT_FALSE(tried.report.unreached.empty());
}

TEST(Refine, APointVeryNearALineIsFollowed)
{
    const UniformSize size(0.05);
    for (const double gap : {1e-5, 1e-8, 1e-11}) {
        Domain d;
        d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
        d.addLine({0.2, 0.5}, {0.8, 0.5}, &size);
        d.addLine({0.5, 0.5 + gap}, {0.5, 0.9}, &size);
        const Refined r = refineDomain(d, size);
        expectValid(r);
        EXPECT_GE(r.figures.minAngle, 30.0 - 1e-9) << gap;
        EXPECT_LE(r.figures.triangles, 9000U) << gap;
    }
}

TEST(Refine, AShortEdgeIsFeltNearbyOnly)
{
    const UniformSize size(10.0);
    Domain d;
    d.addPolygon({{0, 1e-4}, {1e-4, 0}, {1000, 0}, {1000, 10}, {0, 10}}, &size);
    const Refined r = refineDomain(d, size);
    expectValid(r);
    EXPECT_GE(r.figures.minAngle, 30.0);
    EXPECT_LE(r.figures.triangles, 1500U);
}

TEST(Refine, ManyLinesThroughOnePoint)
{
    const UniformSize size(0.1);
    Domain d;
    d.addPolygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, &size);
    for (int i = 0; i < 40; ++i) {
        const double angle = M_PI * i / 20.0;
        d.addLine({0, 0}, {0.7 * std::cos(angle), 0.7 * std::sin(angle)}, &size);
    }
    const Refined r = refineDomain(d, size);
    expectValid(r);
    EXPECT_NEAR(r.figures.area, 4.0, 1e-12);
    EXPECT_GE(r.figures.minAngle, 1.0);
}

TEST(Refine, AreaLimitHolds)
{
    const UniformSize size(0.5);
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
    RefineOptions options;
    options.maxArea = 0.001;
    const Refined r = refineDomain(d, size, options);
    expectValid(r);
    EXPECT_TRUE(r.report.unreached.empty());
    EXPECT_GE(r.figures.triangles, 1000U);
    EXPECT_LE(r.figures.triangles, 4000U);
}

TEST(Refine, HullOfPointsWithoutConstraints)
{
    Domain d;
    for (const Vec2 p : {Vec2 {0, 0}, Vec2 {3, 0.1}, Vec2 {2.9, 2}, Vec2 {0.3, 2.2}, Vec2 {1, 1}}) {
        d.points.push_back(p);
    }
    const UniformSize size(0.1);
    Refined r {d, d.build(), {}, {}, {}};
    for (std::uint32_t i = 0; i < r.original.triangulation.triangles.size(); ++i) {
        if (r.original.triangulation.isFinite(i)) {
            r.original.regionOfTriangle[i] = 0;
        }
    }
    r.mesh = r.original;
    Execution execution;
    r.report = refine(r.mesh, size, {}, execution);
    r.figures = measure(r.mesh, size);
    EXPECT_EQ(verify(r.mesh.triangulation), std::vector<std::string> {});
    EXPECT_TRUE(r.mesh.edges.empty());
    EXPECT_NEAR(r.figures.area, measure(r.original, size).area, 1e-12);
    EXPECT_GE(r.figures.minAngle, 30.0);
    EXPECT_GE(r.figures.p05, 0.7);
}

TEST(Refine, RandomDomains)
{
    for (unsigned seed = 0; seed < 150; ++seed) {
        const UniformSize size(0.03);
        const Domain d = Domain::randomStar(seed, size);
        const Refined r = refineDomain(d, size);
        SCOPED_TRACE(seed);
        expectValid(r);
        std::size_t below = 0;
        for (const Unreached& u : r.report.unreached) {
            below += u.what == "min_angle" ? 1 : 0;
        }
        EXPECT_LE(below, 60U);
        EXPECT_GE(r.figures.minAngle, 3.0);
        EXPECT_GE(r.figures.meanQuality, 0.9);
        EXPECT_LE(r.figures.p95, 1.45);
    }
}

TEST(Refine, SameInputSameBytes)
{
    const UniformSize size(0.03);
    const Domain d = Domain::randomStar(7, size);
    const Refined a = refineDomain(d, size);
    const Refined b = refineDomain(d, size);
    EXPECT_EQ(a.mesh.triangulation.points, b.mesh.triangulation.points);
    ASSERT_EQ(a.mesh.triangulation.triangles.size(), b.mesh.triangulation.triangles.size());
    for (std::size_t i = 0; i < a.mesh.triangulation.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            ASSERT_EQ(a.mesh.triangulation.triangles[i].v[k],
                      b.mesh.triangulation.triangles[i].v[k]);
        }
    }
}

TEST(Refine, RefusesAnglesOutOfRange)
{
    const UniformSize size(0.5);
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &size);
    WorkingMesh mesh = d.build();
    Execution execution;
    for (const double angle : {-1.0, 33.5, std::nan("")}) {
        RefineOptions options;
        options.minAngle = angle;
        EXPECT_THROW(refine(mesh, size, options, execution), Error);
    }
}

TEST(Refine, CancelLeavesByException)
{
    const UniformSize size(0.001);
    WorkingMesh mesh = Domain::plate(size).build();
    Execution execution;
    execution.cancel();
    EXPECT_THROW(refine(mesh, size, {}, execution), Error);
}

TEST(EstimateTriangles, MatchesWhatIsMade)
{
    const UniformSize uniform(0.03);
    const SegmentSize graded({0.1, 0.45}, {0.3, 0.52}, 0.004, 0.1, 1.0);
    for (const SizeField* size : {static_cast<const SizeField*>(&uniform),
                                  static_cast<const SizeField*>(&graded)}) {
        const Domain d = Domain::plate(*size);
        const double estimate = estimateTriangles(d.build(), *size);
        const Refined r = refineDomain(d, *size);
        EXPECT_NEAR(estimate / static_cast<double>(r.figures.triangles), 1.0, 0.25);
    }
}

TEST(EstimateTriangles, StopsAtHugeNumbers)
{
    const UniformSize coarse(0.5);
    const UniformSize tiny(1e-200);
    Domain d;
    d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, &coarse);
    EXPECT_EQ(estimateTriangles(d.build(), tiny), 1e12);
    const SegmentSize steep({0, 0}, {1, 1}, 1e-12, 1.0, 1.0);
    EXPECT_GE(estimateTriangles(d.build(), steep), 1e11);
}

} // namespace
} // namespace tessera
