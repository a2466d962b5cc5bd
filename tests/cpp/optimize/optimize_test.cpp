// SPDX-License-Identifier: MIT

#include "optimize/optimize.h"

#include "delaunay/delaunay.h"
#include "refine/domains.h"

#include <gtest/gtest.h>

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

Optimized optimizeDomain(const Domain& domain, const SizeField& size)
{
    Optimized r {domain, domain.build(), {}, {}, {}, {}};
    r.mesh = r.original;
    Execution execution;
    RefineOptions options;
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
