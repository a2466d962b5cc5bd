// SPDX-License-Identifier: MIT
// Every two kinds of curves where they almost touch, touch and overlap.
#include "arranged_edges.h"

#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <gp_Trsf.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

using namespace tessera;
using namespace tessera::test;

namespace
{

constexpr double kSize = 10.0;
constexpr double kBentCurvature = 0.35;
constexpr double kFlatCurvature = 0.15;
constexpr EdgeKind kOpenKinds[] = {EdgeKind::Line,      EdgeKind::CircleArc, EdgeKind::EllipseArc,
                                   EdgeKind::Parabola,  EdgeKind::Hyperbola, EdgeKind::Spline,
                                   EdgeKind::RationalSpline};

/// Symmetric about the y axis, its top at the origin; about a parabola, or an arc of an ellipse if
/// rational. Not symmetric in its parameters.
Handle(Geom_Curve) splineWithTop(double curvature, bool rational)
{
    TColgp_Array1OfPnt poles(1, 4);
    TColStd_Array1OfReal weights(1, 4);
    const double x[] = {-4.0, -1.3, 1.3, 4.0};
    for (int i = 0; i < 4; ++i) {
        const bool inner = i == 1 || i == 2;
        poles.SetValue(i + 1, {x[i], (inner ? 8.0 / 3.0 : -8.0) * curvature, 0.0});
        weights.SetValue(i + 1, rational && inner ? 0.9 : 1.0);
    }
    TColStd_Array1OfReal knots(1, 2);
    TColStd_Array1OfInteger multiplicities(1, 2);
    for (int i = 1; i <= 2; ++i) {
        knots.SetValue(i, i);
        multiplicities.SetValue(i, 4);
    }
    const Handle(Geom_BSplineCurve) spline
        = new Geom_BSplineCurve(poles, weights, knots, multiplicities, 3);
    const gp_Pnt top = spline->Value(1.5);
    spline->Translate(gp_Vec(top, gp_Pnt()));
    spline->InsertKnot(1.3);
    return Handle(Geom_Curve)(spline);
}

/// A curve that has its top at the origin, with about the given curvature there.
Handle(Geom_Curve) curveWithTop(EdgeKind kind, double curvature)
{
    const double r = 1.0 / curvature;
    const gp_Dir up(0, 0, 1);
    const gp_Dir down(0, -1, 0);
    switch (kind) {
        case EdgeKind::Line:
            return new Geom_TrimmedCurve(new Geom_Line(gp_Pnt(-4.5, 0, 0), gp_Dir(1, 0, 0)), 0.0,
                                         8.7);
        case EdgeKind::CircleArc:
            return new Geom_TrimmedCurve(
                new Geom_Circle(gp_Ax2(gp_Pnt(0, -r, 0), up, down), r), 2.0, 4.4);
        case EdgeKind::EllipseArc:
            return new Geom_TrimmedCurve(
                new Geom_Ellipse(gp_Ax2(gp_Pnt(0, -r / 4, 0), up, gp_Dir(1, 0, 0)), r / 2, r / 4),
                0.3, 2.7);
        case EdgeKind::Parabola:
            return new Geom_TrimmedCurve(
                new Geom_Parabola(gp_Ax2(gp_Pnt(), up, down), 0.5 * r), -4.0, 3.5);
        case EdgeKind::Hyperbola:
            return new Geom_TrimmedCurve(
                new Geom_Hyperbola(gp_Ax2(gp_Pnt(0, r, 0), up, down), r, r), -1.0, 1.1);
        default:
            return splineWithTop(curvature, kind == EdgeKind::RationalSpline);
    }
}

/// Turned by an odd angle and moved, so that nothing lies along the axes.
Handle(Geom_Curve) placed(const Handle(Geom_Curve)& curve, double height, bool mirrored)
{
    gp_Trsf mirror;
    if (mirrored) {
        mirror.SetMirror(gp_Ax1(gp_Pnt(), gp_Dir(1, 0, 0)));
    }
    gp_Trsf raise;
    raise.SetTranslation(gp_Vec(0, height, 0));
    gp_Trsf turn;
    turn.SetRotation(gp::OZ(), 0.7);
    return Handle(Geom_Curve)::DownCast(curve->Transformed(turn * raise * mirror));
}

double curvatureAtTop(EdgeKind kind, double curvature)
{
    const Handle(Geom_Curve) curve = curveWithTop(kind, curvature);
    const GeomAPI_ProjectPointOnCurve top(gp_Pnt(), curve);
    gp_Pnt point;
    gp_Vec d1;
    gp_Vec d2;
    curve->D2(top.LowerDistanceParameter(), point, d1, d2);
    return d1.Crossed(d2).Magnitude() / std::pow(d1.Magnitude(), 3);
}

/// A sharply bent curve whose top passes a flatter one's by depth; on the same side or against it.
struct Approach
{
    Handle(Geom_Curve) bent;
    Handle(Geom_Curve) flat;
    double relativeCurvature;
};

Approach approach(EdgeKind bent, EdgeKind flat, double depth, bool against)
{
    const double other = curvatureAtTop(flat, kFlatCurvature);
    return {placed(curveWithTop(bent, kBentCurvature), depth, false),
            placed(curveWithTop(flat, kFlatCurvature), 0.0, against),
            curvatureAtTop(bent, kBentCurvature) + (against ? other : -other)};
}

template<class F>
void forEachApproach(double depth, F&& f)
{
    for (const EdgeKind bent : kOpenKinds) {
        for (const EdgeKind flat : kOpenKinds) {
            for (const bool against : {false, true}) {
                if (bent != EdgeKind::Line) {
                    const std::string name = std::string(nameOf(bent)) + " and " + nameOf(flat)
                        + (against ? " from outside" : " from inside");
                    const Approach a = approach(bent, flat, depth, against);
                    for (const double weld : {0.0, 2e-6}) {
                        SCOPED_TRACE(name + ", depth " + std::to_string(depth) + ", weld "
                                     + std::to_string(weld));
                        f(a, weld);
                    }
                }
            }
        }
    }
}

} // namespace

TEST(Lenses, OfEveryDepthHaveTwoCrossingsOnBothCurves)
{
    double residual = 0.0;
    for (int exponent = 2; exponent <= 9; ++exponent) {
        const double depth = kSize * std::pow(10.0, -exponent);
        forEachApproach(depth, [&](const Approach& a, double weld) {
            const Crossed crossed = arranged({a.bent, a.flat}, weld);
            const std::vector<Vec2> points = meetings(crossed);
            ASSERT_EQ(points.size(), 2U);
            residual = std::max(residual, greatestResidual(crossed));
            const double apart = distance(points[0], points[1]);
            EXPECT_NEAR(apart, 2.0 * std::sqrt(2.0 * depth / a.relativeCurvature),
                        (exponent == 2 ? 0.4 : 0.05) * apart);
        });
    }
    std::printf("lenses: greatest residual %.3g\n", residual);
    EXPECT_LE(residual, 1e-12 * kSize);
}

TEST(Lenses, TangenciesAreOnePointOfBothCurves)
{
    double residual = 0.0;
    double miss = 0.0;
    forEachApproach(0.0, [&](const Approach& a, double weld) {
        const Crossed crossed = arranged({a.bent, a.flat}, weld);
        const std::vector<Vec2> points = meetings(crossed);
        ASSERT_EQ(points.size(), 1U);
        residual = std::max(residual, greatestResidual(crossed));
        miss = std::max(miss, length(points[0]));
    });
    std::printf("tangencies: greatest residual %.3g, distance from the true place %.3g\n",
                residual, miss);
    EXPECT_LE(residual, 1e-12 * kSize);
    EXPECT_LE(miss, 1e-6 * kSize);
}

TEST(Lenses, GapsStayOpen)
{
    for (int exponent = 2; exponent <= 9; ++exponent) {
        forEachApproach(-kSize * std::pow(10.0, -exponent), [&](const Approach& a, double weld) {
            EXPECT_EQ(meetings(arranged({a.bent, a.flat}, weld)).size(), 0U);
        });
    }
}

namespace
{

/// Two parts of one curve, from 0 to 0.7 of it and from 0.3 to its end.
std::vector<Handle(Geom_Curve)> overlappingParts(const Handle(Geom_Curve)& whole, bool opposed)
{
    const double first = whole->FirstParameter();
    const double width = whole->LastParameter() - first;
    const Handle(Geom_Curve) low = new Geom_TrimmedCurve(whole, first, first + 0.7 * width);
    Handle(Geom_Curve) high
        = new Geom_TrimmedCurve(whole, first + 0.3 * width, first + width);
    if (opposed) {
        high = high->Reversed();
    }
    return {low, high};
}

} // namespace

TEST(Overlaps, PartsOfOneCurveOfEveryKindShareAPiece)
{
    for (const EdgeKind kind : kOpenKinds) {
        for (unsigned seed = 0; seed < 10; ++seed) {
            for (const bool opposed : {false, true}) {
                for (const double weld : {0.0, 2e-6}) {
                    if (kind == EdgeKind::Line && weld == 0.0) {
                        continue; // decided exactly, and no rounded line lies on another one
                    }
                    SCOPED_TRACE(std::string(nameOf(kind)) + " " + std::to_string(seed)
                                 + (opposed ? " opposed" : "") + " weld " + std::to_string(weld));
                    // A curve that crosses itself has more pieces; take one that does not.
                    const Handle(Geom_Curve) whole = kind == EdgeKind::Spline
                            || kind == EdgeKind::RationalSpline
                        ? placed(curveWithTop(kind, 0.05 + 0.05 * seed), 1.0, false)
                        : RandomEdges(seed, kSize).make(kind);
                    const Crossed crossed = arranged(overlappingParts(whole, opposed), weld);
                    EXPECT_EQ(crossed.network.curves.size(), 4U);
                    EXPECT_EQ(crossed.network.points.size(), 4U);
                    EXPECT_EQ(sharedPieces(crossed, 1e-14 * kSize), 1U);
                    EXPECT_LE(greatestResidual(crossed), 1e-12 * 3 * kSize);
                }
            }
        }
    }
}

TEST(Overlaps, ASplineOnItselfWithMoreKnotsAndAHigherDegree)
{
    for (const bool rational : {false, true}) {
        const Handle(Geom_Curve) plain = splineWithTop(0.3, rational);
        const auto richer = Handle(Geom_BSplineCurve)::DownCast(plain->Copy());
        richer->IncreaseDegree(5);
        richer->InsertKnot(1.62);
        const Crossed crossed = arranged({plain, Handle(Geom_Curve)(richer)}, 0.0);
        EXPECT_EQ(crossed.network.curves.size(), 2U);
        EXPECT_EQ(sharedPieces(crossed, 1e-14 * kSize), 1U);
    }
}

TEST(Overlaps, ClosedCurvesOnThemselvesWithOtherSeams)
{
    for (const Handle(Geom_Curve)& closed : closedConics()) {
        for (const bool opposed : {false, true}) {
            Handle(Geom_Curve) other = new Geom_TrimmedCurve(closed, 1.0, 1.0 + 2 * std::numbers::pi);
            if (opposed) {
                other = other->Reversed();
            }
            const Crossed crossed = arranged({closed, other}, 0.0);
            EXPECT_EQ(crossed.network.curves.size(), 4U);
            EXPECT_EQ(sharedPieces(crossed, 1e-14 * kSize), 2U);
        }
    }
}
