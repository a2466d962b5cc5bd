// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "curve/arc.h"
#include "curve/curve_tools.h"
#include "curve/curve_views.h"
#include "curve/polyline.h"
#include "sample/sample.h"
#include "sample/size_integral.h"
#include "sizing/graded_size.h"
#include "sizing/make_size_field.h"
#include "sizing/uniform_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

constexpr double kPi = std::numbers::pi;

CurveNetwork networkOf(std::shared_ptr<const Curve> geometry, bool closed)
{
    CurveNetwork network;
    network.operands.resize(1);
    const PointId start = network.addPoint(geometry->point(geometry->first()));
    const PointId end = closed ? start : network.addPoint(geometry->point(geometry->last()));
    network.curves.push_back({std::move(geometry), start, end, OperandId(0U)});
    return network;
}

CurveNetwork lineNetwork(Vec2 a, Vec2 b)
{
    CurveNetwork network;
    network.operands.resize(1);
    const std::vector<Vec2> ends {a, b};
    addPolyline(network, ends, false, OperandId(0U), Role::Boundary);
    return network;
}

Pslg sampleWith(const CurveNetwork& network, const SizeField& size, SampleOptions options = {})
{
    Execution execution;
    return sample(network, size, options, execution);
}

std::vector<Vec2> chain(const Pslg& pslg)
{
    std::vector<Vec2> points {pslg.points[pslg.segments.front().a.index()]};
    for (const PslgSegment& segment : pslg.segments) {
        EXPECT_EQ(pslg.points[segment.a.index()], points.back());
        points.push_back(pslg.points[segment.b.index()]);
    }
    return points;
}

/// Brute-force integral of ds/h along a curve between two parameters.
double integralOf(const Curve& curve, const SizeField& size, double a, double b)
{
    double sum = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const double t = a + (b - a) * (i + 0.5) / 2000;
        sum += length(curve.derivative(t)) * (b - a) / 2000 / size.size(curve.point(t));
    }
    return sum;
}

TEST(PieceCount, SharesStayWithinTheirBounds)
{
    for (double x = 0.701; x < 50.0; x += 0.001) {
        const double share = x / static_cast<double>(pieceCount(x));
        EXPECT_GE(share, 0.7) << x;
        EXPECT_LE(share, 1.4) << x;
    }
    EXPECT_EQ(pieceCount(0.0), 1U);
    EXPECT_EQ(pieceCount(1.4), 1U);
    EXPECT_EQ(pieceCount(1.41), 2U);
    EXPECT_EQ(pieceCount(1000.0), 1000U);
}

TEST(Sample, StraightLineInEqualParts)
{
    const Pslg pslg = sampleWith(lineNetwork({0, 0}, {3, 4}), UniformSize(1.0));
    const std::vector<Vec2> points = chain(pslg);
    ASSERT_EQ(points.size(), 6U);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        EXPECT_NEAR(distance(points[i], points[i + 1]), 1.0, 1e-14);
    }
    EXPECT_EQ(pslg.segments[0].curve, CurveId(0U));
}

TEST(Sample, StraightSegmentsStayWholeWhenAsked)
{
    const SampleOptions whole {.straightSegments = false};
    EXPECT_EQ(sampleWith(lineNetwork({0, 0}, {3, 4}), UniformSize(1.0), whole).segments.size(),
              1U);
    // A polyline as one curve: its corners stay points, its sides stay whole.
    const auto corners = std::make_shared<PolylineCurve>(
        std::vector<Vec2> {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}});
    const CurveNetwork square = networkOf(corners, true);
    EXPECT_EQ(sampleWith(square, UniformSize(1.0), whole).segments.size(), 4U);
    EXPECT_EQ(sampleWith(square, UniformSize(1.0)).segments.size(), 40U);
    EXPECT_EQ(sampleWith(square, UniformSize(100.0)).segments.size(), 4U);
    const CurveNetwork circle = networkOf(makeCircleArc({0, 0}, 1, 0, 2 * kPi), true);
    EXPECT_EQ(sampleWith(circle, UniformSize(0.1), whole).segments.size(), 63U);
}

TEST(Sample, CirclePointsAreEquallySpacedAndOnTheCircle)
{
    const CurveNetwork network = networkOf(makeCircleArc({5, 7}, 2, 0.3, 0.3 + 2 * kPi), true);
    for (const double h : {0.01, 0.1, 0.5, 1.0, 1.57}) {
        const Pslg pslg = sampleWith(network, UniformSize(h), {.piecesPerTurn = 8});
        const std::vector<Vec2> points = chain(pslg);
        EXPECT_EQ(points.size() - 1, pieceCount(4 * kPi / h));
        const double expected = distance(points[0], points[1]);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            EXPECT_NEAR(distance(points[i], {5, 7}), 2.0, 1e-14);
            EXPECT_NEAR(distance(points[i], points[i + 1]), expected, 1e-9);
        }
        for (const PslgSegment& s : pslg.segments) {
            EXPECT_LT(s.ta, s.tb);
            EXPECT_LT(distance(network.curves[0].geometry->point(s.tb),
                               pslg.points[s.b.index()]),
                      1e-14);
        }
    }
}

TEST(Sample, SmallCircleKeepsItsShape)
{
    const CurveNetwork network = networkOf(makeCircleArc({0, 0}, 0.01, 0, 2 * kPi), true);
    EXPECT_EQ(sampleWith(network, UniformSize(100.0)).segments.size(), 20U);
    EXPECT_EQ(sampleWith(network, UniformSize(100.0), {.piecesPerTurn = 3}).segments.size(), 3U);
    EXPECT_EQ(sampleWith(network, UniformSize(100.0), {.piecesPerTurn = 50}).segments.size(), 50U);
    const CurveNetwork arc = networkOf(makeCircleArc({0, 0}, 0.01, 0, 50 * kPi / 180), false);
    EXPECT_EQ(sampleWith(arc, UniformSize(100.0)).segments.size(), 3U);
}

TEST(Sample, ChordErrorIsKept)
{
    const CurveNetwork network = networkOf(makeEllipseArc({0, 0}, 5, 1, 0.3, 0, 2 * kPi), true);
    for (const double error : {1e-2, 1e-3, 1e-4}) {
        const Pslg pslg = sampleWith(network, UniformSize(100.0), {.chordError = error});
        const Curve& curve = *network.curves[0].geometry;
        double greatest = 0.0;
        for (const PslgSegment& s : pslg.segments) {
            const Vec2 a = pslg.points[s.a.index()];
            const Vec2 chord = pslg.points[s.b.index()] - a;
            for (int i = 1; i < 20; ++i) {
                const Vec2 p = curve.point(s.ta + (s.tb - s.ta) * i / 20) - a;
                greatest = std::max(greatest, std::abs(cross(chord, p)) / length(chord));
            }
        }
        EXPECT_LE(greatest, 1.05 * error);
        EXPECT_GE(greatest, 0.3 * error);
    }
}

TEST(Sample, LeastNumbersOfPieces)
{
    // A lens of two flat arcs over one chord: without a middle point all three would coincide.
    const double angle = 0.2;
    const auto upper = makeCircleArc({0, 0}, 1, kPi / 2 + angle, kPi / 2 - angle);
    CurveNetwork network = networkOf(upper, false);
    const NetworkCurve first = network.curves[0];
    network.curves.push_back({nullptr, first.end, first.start, OperandId(0U)});
    const SampleOptions coarse {.piecesPerTurn = 8};
    const Pslg pslg = sampleWith(network, UniformSize(10.0), coarse);
    EXPECT_EQ(pslg.segments.size(), 3U);
    network.curves.pop_back();
    EXPECT_EQ(sampleWith(network, UniformSize(10.0), coarse).segments.size(), 1U);
}

TEST(Sample, ZeroLengthCurvesAreDroppedAndTold)
{
    CurveNetwork network = lineNetwork({1, 1}, {1, 1});
    const PointId p = network.addPoint({4, 4});
    network.curves.push_back({nullptr, p, p, OperandId(0U)});
    network.curves.push_back({nullptr, PointId(0U), p, OperandId(0U), Role::Ignored});
    const Pslg pslg = sampleWith(network, UniformSize(1.0));
    EXPECT_TRUE(pslg.segments.empty());
    EXPECT_EQ(pslg.points.size(), 3U);
    ASSERT_EQ(pslg.messages.size(), 1U);
    EXPECT_NE(pslg.messages[0].find("2 curves of zero length"), std::string::npos);
    EXPECT_NE(pslg.messages[0].find("(1, 1)"), std::string::npos);
}

class GradedSample: public ::testing::Test
{
protected:
    GradedSample()
    {
        std::mt19937 random(4);
        std::uniform_real_distribution<double> uniform(-6.0, 6.0);
        for (int i = 0; i < 30; ++i) {
            const Vec2 p {uniform(random), uniform(random)};
            sources_.push_back({p, p, 0.02 + 0.01 * i});
        }
        const Execution execution;
        field_ = std::make_unique<GradedSize>(Box2 {{-6, -6}, {6, 6}}, sources_,
                                              GradedSize::Options {.maxSize = 1.0}, execution);
    }

    std::vector<SizeSource> sources_;
    std::unique_ptr<GradedSize> field_;
};

TEST_F(GradedSample, EveryPieceHasTheSameShareOfTheIntegral)
{
    const std::vector<std::shared_ptr<const Curve>> curves {
        makeEllipseArc({0, 0}, 5, 2, 0.4, 0.1, 6.0), makeCircleArc({1, 0}, 4, 2.0, -2.0),
        makeCircleArc({0, 1}, 1, 0, 2 * kPi)};
    for (const auto& curve : curves) {
        const Pslg pslg = sampleWith(networkOf(curve, false), *field_, {.piecesPerTurn = 3});
        const double total = integralOf(*curve, *field_, curve->first(), curve->last());
        EXPECT_EQ(pslg.segments.size(), pieceCount(total));
        for (const PslgSegment& s : pslg.segments) {
            const double share = integralOf(*curve, *field_, s.ta, s.tb);
            EXPECT_NEAR(share, total / static_cast<double>(pslg.segments.size()), 5e-3);
        }
    }
}

TEST_F(GradedSample, ReversedCurvesGetTheSamePoints)
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(-5.0, 5.0);
    for (int i = 0; i < 50; ++i) {
        const Vec2 a {uniform(random), uniform(random)};
        const Vec2 b {uniform(random), uniform(random)};
        std::vector<Vec2> there = chain(sampleWith(lineNetwork(a, b), *field_));
        const std::vector<Vec2> back = chain(sampleWith(lineNetwork(b, a), *field_));
        std::reverse(there.begin(), there.end());
        EXPECT_EQ(there, back);
    }
    for (int i = 0; i < 50; ++i) {
        const double from = uniform(random);
        const double to = from + 0.6 * uniform(random) + 3.1;
        const Vec2 center {0.1 * uniform(random), 0.1 * uniform(random)};
        const auto arc = makeEllipseArc(center, 4, 2, 0.7, from, to);
        const auto opposite = makeEllipseArc(center, 4, 2, 0.7, to, from);
        std::vector<Vec2> there = chain(sampleWith(networkOf(arc, false), *field_));
        const std::vector<Vec2> back = chain(sampleWith(networkOf(opposite, false), *field_));
        const std::vector<Vec2> same = chain(sampleWith(
            networkOf(std::make_shared<ReversedCurve>(arc), false), *field_));
        std::reverse(there.begin(), there.end());
        ASSERT_EQ(there.size(), back.size());
        for (std::size_t k = 0; k < there.size(); ++k) {
            EXPECT_LT(distance(there[k], back[k]), 1e-9);
        }
        // The ends are network points; between them the geometry is the same object.
        ASSERT_EQ(there.size(), same.size());
        EXPECT_TRUE(std::equal(there.begin() + 1, there.end() - 1, same.begin() + 1));
    }
}

TEST_F(GradedSample, NeighborsDifferByNoMoreThanTheFieldGrows)
{
    const auto curve = makeEllipseArc({0, 0}, 5, 2, 0.4, 0, 6.2);
    const std::vector<Vec2> points
        = chain(sampleWith(networkOf(curve, false), *field_, {.piecesPerTurn = 8}));
    double greatest = 1.0;
    for (std::size_t i = 2; i < points.size(); ++i) {
        const double ratio =
            distance(points[i], points[i - 1]) / distance(points[i - 1], points[i - 2]);
        greatest = std::max({greatest, ratio, 1 / ratio});
    }
    EXPECT_LE(greatest, 1.0 + 2.0 * 0.3);
}

TEST_F(GradedSample, AFineSpotOnALongLineIsNotMissed)
{
    const std::vector<SizeSource> spot {{{0.123, 0}, {0.123, 0}, 1e-5}};
    const Execution execution;
    const GradedSize field({{-100, -100}, {100, 100}}, spot, {.maxSize = 50}, execution);
    const std::vector<Vec2> points = chain(sampleWith(lineNetwork({-100, 0}, {100, 0}), field));
    double shortest = 1.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        shortest = std::min(shortest, distance(points[i], points[i - 1]));
    }
    EXPECT_LT(shortest, 1.5e-5);
}

TEST(Sample, CornersInsideACurveBecomePoints)
{
    const auto zigzag = std::make_shared<PolylineCurve>(
        std::vector<Vec2> {{0, 0}, {1.3, 0.2}, {2.9, -0.3}, {4.0, 0.0}});
    const std::vector<Vec2> points = chain(sampleWith(networkOf(zigzag, false), UniformSize(0.5)));
    for (const Vec2 corner : {Vec2 {1.3, 0.2}, Vec2 {2.9, -0.3}}) {
        EXPECT_NE(std::find(points.begin(), points.end(), corner), points.end());
    }
}

/// Gives the wrong size somewhere.
class BadSize final: public SizeField
{
public:
    explicit BadSize(double bad)
        : bad_(bad)
    {}
    double size(Vec2 p) const override { return p.x > 2.0 ? bad_ : 1.0; }
    double gradientBound() const override { return 0.3; }

private:
    double bad_;
};

TEST(Sample, RefusesWhatCannotBeSampled)
{
    const CurveNetwork network = lineNetwork({0, 0}, {10, 0});
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        try {
            sampleWith(network, BadSize(bad));
            FAIL() << "accepted a size of " << bad;
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::InvalidOption);
            EXPECT_EQ(error.places().size(), 1U);
        }
    }
    for (const auto& curve : {lineNetwork({0, 0}, {10, 0}),
                              networkOf(makeCircleArc({0, 0}, 1, 0, 1), false)}) {
        try {
            sampleWith(curve, UniformSize(1e-12));
            FAIL() << "sampled into 1e12 pieces";
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::TooLarge);
        }
    }
    EXPECT_THROW(sampleWith(network, UniformSize(1), {.piecesPerTurn = 2}), Error);
    EXPECT_THROW(sampleWith(network, UniformSize(1), {.chordError = -1}), Error);
}

} // namespace
} // namespace tessera
