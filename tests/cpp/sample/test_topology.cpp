// SPDX-License-Identifier: MIT
// The pieces have the topology of the curves: what crosses, what encloses what, how many faces.
#include "delaunay/delaunay.h"
#include "recover/recover.h"
#include "sample/random_networks.h"
#include "sample/sample.h"
#include "sizing/uniform_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>
#include <set>
#include <tuple>

namespace tessera
{
namespace
{

using namespace test;

/// Bounded faces of a plane graph by Euler's formula.
class FaceCount
{
public:
    explicit FaceCount(std::size_t points)
        : parent_(points)
        , used_(points, 0)
    {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    void add(std::uint32_t a, std::uint32_t b)
    {
        used_[a] = used_[b] = 1;
        parent_[find(a)] = find(b);
        ++edges_;
    }
    std::size_t bounded()
    {
        std::size_t vertices = 0;
        std::set<std::uint32_t> components;
        for (std::uint32_t v = 0; v < parent_.size(); ++v) {
            if (used_[v] != 0) {
                ++vertices;
                components.insert(find(v));
            }
        }
        return edges_ + components.size() - vertices;
    }

private:
    std::uint32_t find(std::uint32_t v)
    {
        while (parent_[v] != v) {
            v = parent_[v] = parent_[parent_[v]];
        }
        return v;
    }
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> used_;
    std::size_t edges_ = 0;
};

/// Of the curves themselves; pieces that coincide count once.
std::size_t facesOf(const CurveNetwork& network)
{
    FaceCount count(network.points.size());
    std::set<std::tuple<std::uint32_t, std::uint32_t, double, double>> seen;
    for (const NetworkCurve& curve : network.curves) {
        Vec2 middle = midpoint(network.points[curve.start.index()],
                               network.points[curve.end.index()]);
        if (curve.geometry) {
            middle = curve.geometry->point(
                0.5 * (curve.geometry->first() + curve.geometry->last()));
        }
        const auto [a, b] = std::minmax(curve.start.value, curve.end.value);
        if (seen.insert({a, b, middle.x, middle.y}).second) {
            count.add(a, b);
        }
    }
    return count.bounded();
}

/// Of the triangulated pieces, which may not make vertices of their own.
std::size_t facesOfPieces(const Pslg& pslg)
{
    Execution execution;
    DelaunayResult delaunay = triangulate(pslg.points, execution);
    std::vector<ConstraintEnds> ends;
    for (const PslgSegment& s : pslg.segments) {
        ends.push_back({delaunay.vertexOfPoint[s.a.index()], delaunay.vertexOfPoint[s.b.index()]});
    }
    const RecoveryResult result = recoverBoundaries(std::move(delaunay.triangulation), ends,
                                                    RecoveryStrategy::Cavity, execution);
    EXPECT_EQ(result.report.crossings, 0U);
    EXPECT_EQ(result.report.touches, 0U);
    FaceCount count(result.triangulation.points.size());
    for (const Subsegment& s : result.constraints.subsegments) {
        count.add(s.a, s.b);
    }
    return count.bounded();
}

/// Returns the number of pieces.
std::size_t expectSameTopology(const CurveNetwork& network, double size, const char* what)
{
    Execution execution;
    const Pslg pslg = sample(network, UniformSize(size), {}, execution);
    EXPECT_EQ(facesOfPieces(pslg), facesOf(network)) << what << ", size " << size;
    return pslg.segments.size();
}

TEST(Topology, RandomNetworksAtAnySize)
{
    std::mt19937 random(21);
    for (int round = 0; round < 25; ++round) {
        const CurveNetwork network = arranged(randomCurves(random, 15));
        for (const double size : {0.05, 0.4, 3.0, 50.0}) {
            expectSameTopology(network, size, "random curves");
        }
    }
}

TEST(Topology, ThinGapsBetweenConcentricCircles)
{
    std::mt19937 random(22);
    std::uniform_real_distribution<double> uniform(0.0, 6.0);
    for (const double gap : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
        CurveNetwork network;
        for (int ring = 0; ring < 4; ++ring) {
            addCircle(network, {1, 2}, 3.0 + gap * ring, uniform(random));
        }
        const std::size_t pieces = expectSameTopology(arranged(network), 4.0, "rings");
        std::printf("4 rings %.0e apart, radius 3: %zu pieces\n", gap, pieces);
        // A sagitta of a quarter of the gap asks for pi / sqrt(gap / 2 / 3) pieces a ring; no more
        // than a few times that.
        EXPECT_LT(static_cast<double>(pieces), 60.0 + 4 * 4 * 3.15 / std::sqrt(gap / 6));
    }
}

TEST(Topology, EccentricCirclesThatNearlyTouch)
{
    for (const double gap : {1e-2, 1e-4, 1e-6}) {
        CurveNetwork inner;
        addCircle(inner, {0, 0}, 2.0, 0.3);
        addCircle(inner, {0.5, 0}, 1.5 - gap, 1.1);
        expectSameTopology(arranged(inner), 3.0, "inside");
        CurveNetwork outer;
        addCircle(outer, {0, 0}, 2.0, 0.3);
        addCircle(outer, {5.0 + gap, 0}, 3.0, 1.1);
        expectSameTopology(arranged(outer), 3.0, "outside");
    }
}

TEST(Topology, LinesAlongArcs)
{
    for (const double gap : {1e-2, 1e-4, 1e-6}) {
        for (const double side : {-1.0, 1.0}) {
            CurveNetwork network;
            addCircle(network, {0, 0}, 2.0, 0.3);
            const double y = 2.0 + side * gap;
            addLine(network, {-3, y}, {3, y});
            expectSameTopology(arranged(network), 3.0, "line");
        }
    }
}

TEST(Topology, SmallShapesBesideLargeArcs)
{
    std::mt19937 random(23);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int round = 0; round < 20; ++round) {
        CurveNetwork network;
        addCircle(network, {0, 0}, 5.0, 6 * uniform(random));
        for (int i = 0; i < 12; ++i) {
            // Between the arc and its chords, on either side.
            const double angle = 6.28 * uniform(random);
            const double radius = 0.002 + 0.05 * uniform(random);
            const double way = 5.0 + (uniform(random) < 0.5 ? -1.0 : 1.0)
                    * (radius + 1e-3 + 0.3 * uniform(random));
            addCircle(network, {way * std::cos(angle), way * std::sin(angle)}, radius,
                      6 * uniform(random));
        }
        expectSameTopology(arranged(network), 8.0, "small circles");
    }
}

TEST(Topology, EllipsesOneInTheOther)
{
    CurveNetwork network;
    for (int i = 0; i < 6; ++i) {
        const double shrink = 1.0 - 0.004 * i;
        addCurve(network, makeEllipseArc({3, 1}, 4 * shrink, 1 * shrink, 0.4, i, i + 6.283185307179586),
                 true);
    }
    expectSameTopology(arranged(network), 5.0, "ellipses");
    expectSameTopology(arranged(network), 0.3, "ellipses");
}

} // namespace
} // namespace tessera
