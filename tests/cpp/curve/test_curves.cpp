// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "curve/arc.h"
#include "curve/chord_area.h"
#include "curve/curve_jet.h"
#include "curve/curve_tools.h"
#include "curve/curve_views.h"
#include "curve/line.h"
#include "curve/polyline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

constexpr double kPi = std::numbers::pi;

/// y = x^3 over [-1, 1]: a curve that does not override the bound on its second derivative.
class Cubic final: public Curve
{
public:
    double first() const override { return -1.0; }
    double last() const override { return 1.0; }
    Vec2 point(double t) const override { return {t, t * t * t}; }
    Vec2 derivative(double t) const override { return {1.0, 3.0 * t * t}; }
    Vec2 secondDerivative(double t) const override { return {0.0, 6.0 * t}; }
};

/// Counts how often its derivative is asked for.
class CountingCurve final: public Curve
{
public:
    explicit CountingCurve(std::shared_ptr<const Curve> curve)
        : curve_(std::move(curve))
    {}
    double first() const override { return curve_->first(); }
    double last() const override { return curve_->last(); }
    Vec2 point(double t) const override
    {
        ++calls;
        return curve_->point(t);
    }
    Vec2 derivative(double t) const override
    {
        ++calls;
        return curve_->derivative(t);
    }
    Vec2 secondDerivative(double t) const override { return curve_->secondDerivative(t); }

    mutable std::size_t calls = 0;

private:
    std::shared_ptr<const Curve> curve_;
};

/// Derivatives against central differences.
void expectDerivativesMatch(const Curve& curve, double scale)
{
    const double step = 1e-4 * (curve.last() - curve.first());
    for (int i = 1; i < 20; ++i) {
        const double t = curve.first() + (curve.last() - curve.first()) * i / 20.0;
        const Vec2 before = curve.point(t - step);
        const Vec2 after = curve.point(t + step);
        const Vec2 here = curve.point(t);
        const Vec2 d = (0.5 / step) * (after - before);
        const Vec2 dd = (1.0 / (step * step)) * (after + before - 2.0 * here);
        EXPECT_LT(distance(d, curve.derivative(t)), 1e-6 * scale) << t;
        EXPECT_LT(distance(dd, curve.secondDerivative(t)), 1e-5 * scale) << t;
    }
}

TEST(EllipseArc, DerivativesMatchDifferences)
{
    expectDerivativesMatch(*makeEllipseArc({1, 2}, 3, 1, 0.4, 0.1, 5.0), 10.0);
    expectDerivativesMatch(*makeEllipseArc({1, 2}, 3, 1, 0.4, 5.0, 0.1), 10.0);
}

TEST(EllipseArc, ClockwiseArcRunsThroughTheSamePointsBackwards)
{
    const auto forward = makeCircleArc({1, 2}, 3, 0.3, 2.0);
    const auto backward = makeCircleArc({1, 2}, 3, 2.0, 0.3);
    for (int i = 0; i <= 10; ++i) {
        const double s = i / 10.0;
        const double t = forward->first() + s * (forward->last() - forward->first());
        const double u = backward->last() - s * (backward->last() - backward->first());
        EXPECT_LT(distance(forward->point(t), backward->point(u)), 1e-14);
    }
    EXPECT_GT(cross(forward->u(), forward->v()), 0.0);
    EXPECT_LT(cross(backward->u(), backward->v()), 0.0);
}

TEST(EllipseArc, RefusesWhatIsNoArc)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(makeCircleArc({0, 0}, 0.0, 0, 1), Error);
    EXPECT_THROW(makeCircleArc({0, 0}, -1.0, 0, 1), Error);
    EXPECT_THROW(makeCircleArc({0, 0}, 1.0, 1, 1), Error);
    EXPECT_THROW(makeCircleArc({nan, 0}, 1.0, 0, 1), Error);
    EXPECT_THROW(makeCircleArc({0, 0}, nan, 0, 1), Error);
    EXPECT_THROW(EllipseArc({0, 0}, {1, 0}, {0, 1}, 1.0, 0.0), Error);
}

TEST(ArcLength, CircleAndLine)
{
    EXPECT_NEAR(arcLength(*makeCircleArc({5, 5}, 2, 0.5, 2.5)), 4.0, 1e-13);
    EXPECT_NEAR(arcLength(*makeCircleArc({5, 5}, 2, 0, 2 * kPi)), 4 * kPi, 1e-12);
    EXPECT_NEAR(arcLength(LineCurve({1, 1}, {4, 5})), 5.0, 1e-15);
}

TEST(ArcLength, EllipseMatchesTheCompleteEllipticIntegral)
{
    for (const double b : {0.9, 0.5, 0.1, 0.01}) {
        const double expected = 4.0 * std::comp_ellint_2(std::sqrt(1.0 - b * b));
        const double computed = arcLength(*makeEllipseArc({0, 0}, 1, b, 0.7, 0, 2 * kPi));
        EXPECT_NEAR(computed, expected, 2e-12 * expected) << b;
    }
}

TEST(ArcLength, PolylineSumsItsPieces)
{
    const PolylineCurve polyline({{0, 0}, {3, 4}, {3, 10}, {-5, 10}});
    EXPECT_DOUBLE_EQ(arcLength(polyline), 19.0);
    EXPECT_EQ(polyline.breaks(), (std::vector<double> {1.0, 2.0}));
    EXPECT_EQ(polyline.point(0.0), (Vec2 {0, 0}));
    EXPECT_EQ(polyline.point(1.0), (Vec2 {3, 4}));
    EXPECT_EQ(polyline.point(2.5), (Vec2 {-1, 10}));
    EXPECT_EQ(polyline.point(3.0), (Vec2 {-5, 10}));
    EXPECT_THROW(PolylineCurve({{0, 0}}), Error);
    EXPECT_EQ(PolylineCurve({{0, 0}, {3, 4}, {3, 4}, {5, 4}}).last(), 2.0);
    EXPECT_EQ(arcLength(PolylineCurve({{3, 4}, {3, 4}, {3, 4}})), 0.0);
}

TEST(CurveTools, LengthIsNotLookedForBelowRounding)
{
    // Beside the end of a flat ellipse, where the speed is the least: the speed's rounding is far
    // above the precision that the length of other arcs has.
    const double end = 0.25 * kPi;
    const CountingCurve arc(std::make_shared<EllipseArc>(Vec2 {}, Vec2 {1.0, 1.0}, Vec2 {1.0, 1.0},
                                                         end, end + 6e-10));
    const double length = arcLength(arc);
    EXPECT_LT(arc.calls, 10000U);
    EXPECT_NEAR(length, 0.5 * 2.0 * 6e-10 * 6e-10, 1e-3 * length); // half of the acceleration
}

TEST(CurveTools, BoundsAreNotLookedForBelowRounding)
{
    // The end of a flat ellipse at the origin, which the rounding of its center hides.
    const double end = 0.25 * kPi;
    const Vec2 axis {1.0, 1.0};
    const Vec2 center = EllipseArc({}, axis, axis, 0.0, 1.0).point(end);
    const CountingCurve arc(
        std::make_shared<EllipseArc>(Vec2 {} - center, axis, axis, end, end + 1e-9));
    const Box2 box = curveBounds(arc);
    EXPECT_LT(arc.calls, 10000U);
    EXPECT_TRUE(box.contains(arc.point(end)));
    EXPECT_TRUE(box.contains(arc.point(end + 1e-9)));
    EXPECT_LE(box.diagonal(), 1e-14);
}

TEST(Turning, IntegratesToTheAngleOfTheArc)
{
    const auto arc = makeEllipseArc({0, 0}, 3, 1, 0.2, 0.0, kPi);
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) {
        sum += gaussLegendre([&arc](double t) { return turningRate(*arc, t); }, kPi * i / 200,
                             kPi * (i + 1) / 200);
    }
    EXPECT_NEAR(sum, kPi, 1e-10);
}

/// The greatest distance between curve and chord, found by brute force.
double measuredSagitta(const Curve& curve, double a, double b)
{
    const Vec2 p = curve.point(a);
    const Vec2 q = curve.point(b);
    const Vec2 chord = q - p;
    double greatest = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const Vec2 r = curve.point(a + (b - a) * i / 1000.0) - p;
        const double s = std::clamp(dot(r, chord) / squaredLength(chord), 0.0, 1.0);
        greatest = std::max(greatest, distance(r, s * chord));
    }
    return greatest;
}

TEST(Sagitta, BoundHoldsAndIsTight)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const Cubic cubic;
    for (int i = 0; i < 200; ++i) {
        const auto arc = makeEllipseArc({uniform(random), 0}, 1 + uniform(random),
                                        0.2 + uniform(random), 6 * uniform(random), 0, 6);
        const double a = 3 * uniform(random);
        const double b = a + 0.01 + uniform(random);
        EXPECT_LE(measuredSagitta(*arc, a, b), sagittaBound(*arc, a, b));
        const double c = -1 + 1.8 * uniform(random);
        const double d = c + (1 - c) * (0.05 + 0.95 * uniform(random));
        EXPECT_LE(measuredSagitta(cubic, c, d), sagittaBound(cubic, c, d));
    }
    const auto circle = makeCircleArc({0, 0}, 1, 0, 1);
    EXPECT_LT(sagittaBound(*circle, 0, 0.2), 1.01 * measuredSagitta(*circle, 0, 0.2));
}

TEST(Bounds, HoldEverySampleAndAreTight)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < 100; ++i) {
        const double start = 6 * uniform(random);
        const auto arc = makeEllipseArc({uniform(random), 5 * uniform(random)},
                                        0.1 + uniform(random), 0.1 + uniform(random),
                                        uniform(random), start, start + 0.1 + 6 * uniform(random));
        const Box2 box = curveBounds(*arc);
        Box2 samples;
        for (int k = 0; k <= 4000; ++k) {
            samples.add(arc->point(arc->first() + (arc->last() - arc->first()) * k / 4000.0));
        }
        EXPECT_TRUE(box.contains(samples.min) && box.contains(samples.max));
        EXPECT_TRUE(samples.grown(3e-6 * samples.diagonal()).contains(box.min));
        EXPECT_TRUE(samples.grown(3e-6 * samples.diagonal()).contains(box.max));
    }
}

TEST(Bounds, NetworkIgnoresIgnoredCurvesAndSeesBulges)
{
    CurveNetwork network;
    network.operands.resize(1);
    const PointId p = network.addPoint({2, 0});
    network.curves.push_back({makeCircleArc({0, 0}, 2, 0, 2 * kPi), p, p, OperandId(0U)});
    const PointId q = network.addPoint({100, 0});
    network.curves.push_back({nullptr, p, q, OperandId(0U), Role::Ignored});
    const Box2 box = networkBounds(network);
    EXPECT_NEAR(box.min.x, -2.0, 1e-5);
    EXPECT_NEAR(box.max.y, 2.0, 1e-5);
    EXPECT_NEAR(box.max.x, 2.0, 1e-5);
    network.embedded.push_back({q, OperandId(0U), ""});
    EXPECT_EQ(networkBounds(network).max.x, 100.0);
}

TEST(CurveViews, TrimAndReverse)
{
    const auto polyline =
        std::make_shared<PolylineCurve>(std::vector<Vec2> {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const auto trimmed = std::make_shared<TrimmedCurve>(polyline, 0.5, 2.0);
    EXPECT_EQ(trimmed->breaks(), (std::vector<double> {1.0}));
    EXPECT_EQ(TrimmedCurve(trimmed, 0.75, 1.5).base(), polyline);
    const ReversedCurve reversed(trimmed);
    EXPECT_EQ(reversed.point(reversed.first()), trimmed->point(2.0));
    EXPECT_EQ(reversed.point(reversed.last()), trimmed->point(0.5));
    EXPECT_EQ(reversed.breaks(), (std::vector<double> {1.5}));
    EXPECT_EQ(reversed.derivative(0.75), (Vec2 {0, -1}));
    expectDerivativesMatch(ReversedCurve(makeEllipseArc({0, 0}, 2, 1, 0.3, 0.2, 3.0)), 10.0);
}

TEST(ChordArea, LiesBetweenAPieceAndItsChord)
{
    const auto arc = makeCircleArc({3.0, -2.0}, 2.0, 0.5, 4.0);
    const double segment = 0.5 * 4.0 * (3.5 - std::sin(3.5));
    EXPECT_NEAR(chordArea(*arc, arc->first(), arc->last()), segment, 1e-14);
    EXPECT_NEAR(chordArea(*arc, arc->last(), arc->first()), -segment, 1e-14);
    const ReversedCurve reversed(arc);
    EXPECT_NEAR(chordArea(reversed, reversed.first(), reversed.last()), -segment, 1e-14);
    const TrimmedCurve trimmed(arc, arc->first() + 1.0, arc->first() + 2.0);
    EXPECT_NEAR(chordArea(trimmed, trimmed.first(), trimmed.last()),
                0.5 * 4.0 * (1.0 - std::sin(1.0)), 1e-14);

    const Cubic cubic; // the diagonal is above y = x^3 from 0 to 1, below it from -1 to 0
    EXPECT_NEAR(chordArea(cubic, 0.0, 1.0), 0.25, 1e-14);
    EXPECT_NEAR(chordArea(cubic, 1.0, 0.0), -0.25, 1e-14);
    EXPECT_NEAR(chordArea(cubic, -1.0, 1.0), 0.0, 1e-14);

    EXPECT_NEAR(chordArea(LineCurve({1.0, 2.0}, {3.0, -1.0}), 0.0, 1.0), 0.0, 1e-15);
    const PolylineCurve corners({{0.0, 0.0}, {2.0, -1.0}, {3.0, 1.0}, {1.0, 4.0}});
    EXPECT_NEAR(chordArea(corners, corners.first(), corners.last()), 0.5 * (5.0 + 11.0), 1e-13);
}

TEST(JetEvaluator, GivesWhatTheCurveGives)
{
    const std::shared_ptr<const Curve> arc = makeEllipseArc({1, 2}, 3.0, 0.5, 0.7, 0.2, 5.0);
    const std::shared_ptr<const Curve> trimmed = std::make_shared<TrimmedCurve>(arc, 1.0, 2.0);
    const ReversedCurve reversed(trimmed);
    const LineCurve line({1, 2}, {5, 7});
    for (const Curve* curve : {arc.get(), trimmed.get(), static_cast<const Curve*>(&reversed),
                               static_cast<const Curve*>(&line)}) {
        const JetEvaluator jet(*curve);
        for (const double share : {0.0, 0.3, 1.0}) {
            const double t = curve->first() + share * (curve->last() - curve->first());
            EXPECT_EQ(jet(t).point, curve->point(t));
            EXPECT_EQ(jet(t).derivative, curve->derivative(t));
            EXPECT_EQ(jet(t).secondDerivative, curve->secondDerivative(t));
        }
    }
}

} // namespace
} // namespace tessera
