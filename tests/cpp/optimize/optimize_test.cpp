// SPDX-License-Identifier: MIT

#include "optimize/optimize.h"

#include "delaunay/delaunay.h"
#include "refine/domains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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

struct Optimized
{
    Domain domain; ///< owns the curves
    WorkingMesh original;
    WorkingMesh mesh;
    Figures before;
    Figures after;
    OptimizeReport report;
};

Optimized optimizeDomain(const Domain& domain, const SizeField& size, RefineOptions options = {})
{
    Optimized r {domain, domain.build(), {}, {}, {}, {}};
    r.mesh = r.original;
    Execution execution;
    options.optimizeFollows = true;
    refine(r.mesh, size, options, execution);
    r.before = measure(r.mesh, size);
    r.report = optimize(r.mesh, size, options, execution);
    r.after = measure(r.mesh, size);
    return r;
}

void expectValid(const Optimized& r)
{
    EXPECT_EQ(verify(r.mesh.triangulation, false), std::vector<std::string> {});
    EXPECT_EQ(checkWorkingMesh(r.mesh, r.original), std::vector<std::string> {});
    // Split arcs change the area.
    EXPECT_NEAR(r.before.area, r.after.area, r.report.segmentSplits == 0 ? 1e-13 : 1e-3);
    EXPECT_GE(r.after.minAngle, r.before.minAngle - 1e-9);
}

TEST(Optimize, UniformPlate)
{
    const UniformSize size(0.01);
    const Optimized r = optimizeDomain(Domain::plate(size), size);
    expectValid(r);
    EXPECT_GE(r.after.minAngle, 32.0);
    EXPECT_GE(r.after.angleP01, r.before.angleP01);
    EXPECT_GE(r.after.meanQuality, 0.985);
}

TEST(Optimize, GradedPlate)
{
    const SegmentSize size({0.1, 0.45}, {0.3, 0.52}, 0.002, 0.05, 1.0);
    const Optimized r = optimizeDomain(Domain::plate(size), size);
    expectValid(r);
    EXPECT_GE(r.after.minAngle, 32.0);
    EXPECT_GE(r.after.meanQuality, 0.97);
    EXPECT_GE(r.after.p05, 0.7);
    EXPECT_LE(r.after.p95, 1.4);
}

TEST(Optimize, RandomDomains)
{
    for (unsigned seed = 0; seed < 150; ++seed) {
        const UniformSize size(0.03);
        const Optimized r = optimizeDomain(Domain::randomStar(seed, size), size);
        SCOPED_TRACE(seed);
        expectValid(r);
        EXPECT_GE(r.after.meanQuality, 0.97);
        EXPECT_LE(r.after.p95, 1.4);
        EXPECT_EQ(r.report.unreached.empty(), r.after.minAngle >= 30.0);
        EXPECT_LE(r.report.unreached.size(), 12U);
    }
}

TEST(Optimize, PowersOfTwoChangeNothing)
{
    const auto make = [](double scale) {
        const UniformSize size(0.1 * scale);
        Domain d;
        d.addPolygon({{0, 0}, {scale, 0}, {scale, scale}, {0, scale}}, &size);
        d.addPolygon({{0.3 * scale, 0.3 * scale}, {0.7 * scale, 0.4 * scale},
                      {0.4 * scale, 0.41 * scale}},
                     &size);
        return optimizeDomain(d, size);
    };
    const Optimized expected = make(1.0);
    ASSERT_GE(expected.after.triangles, 200U);
    for (const int power : {-460, -200, -30, 30, 200, 460}) {
        const Optimized r = make(std::ldexp(1.0, power));
        ASSERT_EQ(r.mesh.triangulation.points.size(), expected.mesh.triangulation.points.size());
        for (std::size_t v = 1; v < r.mesh.triangulation.points.size(); ++v) {
            const Vec2 p = expected.mesh.triangulation.points[v];
            ASSERT_EQ(r.mesh.triangulation.points[v],
                      (Vec2 {std::ldexp(p.x, power), std::ldexp(p.y, power)}));
        }
    }
}

/// Long sides beside sizes or gaps far below their length.
std::vector<Domain> coarseOutlines()
{
    const std::vector<std::vector<Vec2>> outlines {
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
        {{0, 0}, {1, 0}, {0.9, 0.1}},
        {{0, 0}, {1, 0}, {1, 0.06}, {0.05, 0.07}, {0.05, 1}, {0, 1}},
        {{0, 0}, {1, 0}, {1, 0.7}, {0.9, 0.7}, {0.9, 0.1}, {0.6, 0.1}, {0.6, 0.9}, {0.5, 0.8},
         {0.5, 0.1}, {0, 0.1}},
        {{0, 0}, {1, -0.1}, {1.3, 0.5}, {0.8, 1.1}, {0.1, 0.9}},
    };
    std::vector<Domain> domains;
    for (const std::vector<Vec2>& outline : outlines) {
        domains.emplace_back().addPolygon(outline, nullptr);
    }
    domains.back().addCircle({0.6, 0.5}, 0.02, 24);
    domains.push_back(domains.front());
    domains.back().addLine({0.1, 0.3}, {0.9, 0.302}, nullptr);
    domains.back().addLine({0.2, 0.31}, {0.8, 0.305}, nullptr);
    return domains;
}

/// Of areas above a limit of 0.001.
double largestArea(const WorkingMesh& mesh)
{
    RefineOptions options;
    options.maxArea = 0.001;
    double largest = 0.0;
    for (const Unreached& miss : findUnreached(mesh, options, Execution())) {
        largest = miss.what == "max_area" ? std::max(largest, miss.value) : largest;
    }
    return largest;
}

TEST(Optimize, QualityNeverFallsBesideAFrozenBoundary)
{
    RefineOptions options;
    options.freezeBoundary = true;
    for (const Domain& domain : coarseOutlines()) {
        for (const double h : {0.2, 0.1, 0.03, 0.012}) {
            SCOPED_TRACE(testing::Message() << domain.points.size() << " points, size " << h);
            const UniformSize size(h);
            options.maxArea = h == 0.2 ? 0.001 : 0.0;
            WorkingMesh refined = domain.build();
            Execution execution;
            refine(refined, size, options, execution);
            const Figures plain = measure(refined, size);
            const Optimized r = optimizeDomain(domain, size, options);
            expectValid(r);
            EXPECT_EQ(r.report.segmentSplits, 0U);
            EXPECT_GE(r.after.meanQuality, plain.meanQuality);
            EXPECT_GE(r.after.minAngle, plain.minAngle - 1e-9);
            if (options.maxArea > 0.0) {
                EXPECT_LE(largestArea(r.mesh), largestArea(refined) * (1.0 + 1e-12));
            }
            // Sizes are not given up for it.
            EXPECT_GE(r.after.triangles, plain.triangles * 3 / 4);
            EXPECT_EQ(r.report.unreached.empty(), r.after.minAngle >= 30.0);
        }
    }
}

TEST(Optimize, SizesLargerThanTheDomain)
{
    for (const double h : {1.0, 100.0, 1e300, std::numeric_limits<double>::infinity()}) {
        const UniformSize size(h);
        Domain d;
        d.addPolygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, nullptr);
        const Optimized r = optimizeDomain(d, size);
        expectValid(r);
        EXPECT_LE(r.after.triangles, 8U);
    }
}

TEST(Optimize, SameInputSameBytes)
{
    const UniformSize size(0.03);
    const Domain d = Domain::randomStar(7, size);
    const Optimized a = optimizeDomain(d, size);
    const Optimized b = optimizeDomain(d, size);
    EXPECT_EQ(a.mesh.triangulation.points, b.mesh.triangulation.points);
}

} // namespace
} // namespace tessera
