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
