// SPDX-License-Identifier: MIT
// Equal supporting curves of different kinds and parametrizations.
#include "arranged_edges.h"

#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BezierCurve.hxx>
#include <gp.hxx>
#include <gp_Trsf.hxx>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace tessera;
using namespace tessera::test;

namespace
{

constexpr double kSize = 10.0;

/// A conic, or a line, written as a B-spline in one of OpenCASCADE's ways.
struct Writing
{
    const char* name;
    Convert_ParameterisationType way;
    int degree;       ///< raised to at least this
    int furtherKnots; ///< put in
    bool reversed;
};

constexpr Writing kWritings[] = {
    {"half angle", Convert_TgtThetaOver2, 0, 0, false},
    {"half angle, backwards", Convert_TgtThetaOver2, 0, 0, true},
    {"half angle, degree 5", Convert_TgtThetaOver2, 5, 0, false},
    {"half angle, 7 knots more", Convert_TgtThetaOver2, 0, 7, false},
    {"almost by angle", Convert_QuasiAngular, 0, 0, false},
    {"almost by angle, degree 8, 3 knots more, backwards", Convert_QuasiAngular, 8, 3, true},
    {"continuous", Convert_RationalC1, 0, 0, false},
};

Handle(Geom_Curve) written(const Handle(Geom_Curve)& curve, const Writing& writing)
{
    const Handle(Geom_BSplineCurve) spline
        = GeomConvert::CurveToBSplineCurve(curve, writing.way);
    if (writing.degree > spline->Degree()) {
        spline->IncreaseDegree(writing.degree);
    }
    const double first = spline->FirstParameter();
    const double width = spline->LastParameter() - first;
    for (int i = 1; i <= writing.furtherKnots; ++i) {
        spline->InsertKnot(first + width * i / (writing.furtherKnots + 1.3));
    }
    if (writing.reversed) {
        spline->Reverse();
    }
    return Handle(Geom_Curve)(spline);
}

Handle(Geom_Curve) part(const Handle(Geom_Curve)& curve, double from, double to)
{
    const double first = curve->FirstParameter();
    const double width = curve->LastParameter() - first;
    return new Geom_TrimmedCurve(curve, first + from * width, first + to * width);
}

Handle(Geom_Curve) moved(const Handle(Geom_Curve)& curve, double scale, double away)
{
    gp_Trsf far;
    far.SetTranslation(gp_Vec(away * scale, 0.7 * away * scale, 0.0));
    gp_Trsf larger;
    larger.SetScale(gp_Pnt(), scale);
    return Handle(Geom_Curve)::DownCast(curve->Transformed(far * larger));
}

constexpr EdgeKind kConics[] = {EdgeKind::Line, EdgeKind::CircleArc, EdgeKind::EllipseArc,
                                EdgeKind::Parabola, EdgeKind::Hyperbola};

/// What two curves over one supporting curve become.
struct Expected
{
    const char* name;
    double low[2];
    double high[2];
    std::size_t pieces;
};

constexpr Expected kExpected[] = {
    {"the same part", {0.0, 1.0}, {0.0, 1.0}, 2},
    {"overlapping parts", {0.0, 0.7}, {0.3, 1.0}, 4},
    {"a part of the whole", {0.0, 1.0}, {0.2, 0.6}, 4},
    {"parts with a common end", {0.0, 0.5}, {0.0, 1.0}, 3},
};

} // namespace

TEST(Overlaps, ConicsAndTheirSplinesShareAPiece)
{
    constexpr double kScales[] = {1e-3, 1.0, 1e5};
    unsigned seed = 0;
    for (const EdgeKind kind : kConics) {
        for (const Writing& writing : kWritings) {
            for (const Expected& expected : kExpected) {
                const double scale = kScales[++seed % 3];
                const double away = seed % 2 == 0 ? 1000.0 : 0.0;
                const Handle(Geom_Curve) whole
                    = moved(RandomEdges(seed, kSize).make(kind), scale, away);
                for (const double weld : {0.0, 2e-7 * scale * kSize}) {
                    if (kind == EdgeKind::Line && weld == 0.0) {
                        continue; // decided exactly, and no rounded line lies on another one
                    }
                    SCOPED_TRACE(std::string(nameOf(kind)) + " " + std::to_string(seed) + ", "
                                 + writing.name + ", " + expected.name);
                    const Crossed crossed = arranged(
                        {part(whole, expected.low[0], expected.low[1]),
                         written(part(whole, expected.high[0], expected.high[1]), writing)},
                        weld);
                    EXPECT_EQ(crossed.network.curves.size(), expected.pieces);
                    EXPECT_EQ(sharedPieces(crossed), 1U);
                }
            }
        }
    }
}

TEST(Overlaps, WholeEllipsesAndTheirSplines)
{
    for (const Handle(Geom_Curve)& closed : closedConics()) {
        for (const Writing& writing : kWritings) {
            for (const double seam : {0.0, 1.0, 3.1}) {
                const Handle(Geom_Curve) turned
                    = new Geom_TrimmedCurve(closed, seam, seam + 2.0 * std::numbers::pi);
                for (const double weld : {0.0, 2e-6}) {
                    SCOPED_TRACE(std::string(writing.name) + ", seam at " + std::to_string(seam));
                    const Crossed crossed = arranged({closed, written(turned, writing)}, weld);
                    const std::size_t pieces = sharedPieces(crossed);
                    EXPECT_GE(pieces, 1U);
                    EXPECT_LE(pieces, 3U); // a spline of full multiplicity may be two curves
                    EXPECT_EQ(crossed.network.curves.size(), 2 * pieces);
                    EXPECT_TRUE(crossed.report.messages.empty());
                }
            }
        }
    }
}

namespace
{

/// A spline through points of another curve: within 1e-6 of it, but not it.
Handle(Geom_Curve) through(const Handle(Geom_Curve)& curve, int count)
{
    TColgp_Array1OfPnt points(1, count);
    const double first = curve->FirstParameter();
    const double step = (curve->LastParameter() - first) / (count - 1);
    for (int i = 1; i <= count; ++i) {
        points.SetValue(i, curve->Value(first + step * (i - 1)));
    }
    const GeomAPI_PointsToBSpline spline(points, 5, 8, GeomAbs_C2, 1e-7);
    return Handle(Geom_Curve)(spline.Curve());
}

double greatestDistance(const Handle(Geom_Curve)& from, const Handle(Geom_Curve)& to)
{
    double greatest = 0.0;
    for (int i = 0; i <= 500; ++i) {
        const double share = i / 500.0;
        const gp_Pnt p = from->Value((1.0 - share) * from->FirstParameter()
                                     + share * from->LastParameter());
        greatest = std::max(greatest, GeomAPI_ProjectPointOnCurve(p, to).LowerDistance());
    }
    return greatest;
}

} // namespace

TEST(Overlaps, SplinesThatApproximateACurveWithinTheWeldToleranceAreThatCurve)
{
    const Handle(Geom_Curve) circle
        = new Geom_Circle(gp_Ax2(gp_Pnt(1, 2, 0), gp_Dir(0, 0, 1), gp_Dir(1, 1, 0)), 3.0);
    for (const double turn : {0.4, 2.0, 6.0}) {
        const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(circle, 0.3, 0.3 + turn);
        const Handle(Geom_Curve) spline = through(arc, 40);
        const double apart = greatestDistance(spline, arc);
        ASSERT_LE(apart, 1e-6);
        for (const bool whole : {false, true}) {
            SCOPED_TRACE(std::to_string(turn) + (whole ? " of the whole" : ""));
            const Crossed crossed = arranged({whole ? circle : arc, spline}, 2e-6);
            const std::size_t shared = sharedPieces(crossed);
            // The circle's seam, on the spline if that runs past it, cuts both.
            EXPECT_EQ(shared, whole && turn > 5.9 ? 2U : 1U);
            EXPECT_EQ(crossed.network.curves.size(), shared * 2 + (whole ? (turn > 5.9 ? 1U : 2U) : 0U));
            EXPECT_LE(crossed.report.greatestGap, 1.1 * apart + 1e-9);
        }
        if (apart > 1e-8) {
            // Finer than they are apart: they cross, and each keeps its shape.
            EXPECT_EQ(sharedPieces(arranged({arc, spline}, 0.01 * apart)), 0U);
        }
    }
}

TEST(Overlaps, RingsThinnerThanTheToleranceStayRings)
{
    const auto circle = [](double radius) {
        return Handle(Geom_Curve)(new Geom_Circle(gp::XOY(), radius));
    };
    const Crossed crossed = arranged({circle(3.0), circle(3.0 + 1e-6)}, 2e-6);
    EXPECT_EQ(crossed.network.curves.size(), 2U);
    EXPECT_EQ(sharedPieces(crossed), 0U);
}

namespace
{

Handle(Geom_Curve) bezier(const std::vector<gp_Pnt>& poles)
{
    TColgp_Array1OfPnt points(1, static_cast<int>(poles.size()));
    for (std::size_t i = 0; i < poles.size(); ++i) {
        points.SetValue(static_cast<int>(i) + 1, poles[i]);
    }
    return Handle(Geom_Curve)(new Geom_BezierCurve(points));
}

double lengthOf(const CurveNetwork& network)
{
    double sum = 0.0;
    for (const NetworkCurve& curve : network.curves) {
        sum += curveLength(network, curve);
    }
    return sum;
}

} // namespace

TEST(Overlaps, SplinesThatRunForthAndBackOnALine)
{
    const std::vector<std::vector<double>> cases {
        {0, 1, 5, 8}, {0, 10, 0}, {0, 10, -6, 4}, {0, 1, 1, 0, 0, 1}, {0, 3, 3, 3, -4}};
    for (const std::vector<double>& places : cases) {
        for (const gp_Vec& way : {gp_Vec(1, 0, 0), gp_Vec(0.8, 0.6, 0), gp_Vec(1, 1.0 / 3.0, 0)}) {
            std::vector<gp_Pnt> poles;
            for (const double along : places) {
                poles.push_back(gp_Pnt(3, 1, 0).Translated(along * way));
            }
            const Handle(Geom_Curve) curve = bezier(poles);
            // By fine subdivision: how far it runs in all, and where it has been.
            double run = 0.0;
            double low = 0.0;
            double high = 0.0;
            gp_Pnt before = curve->Value(0.0);
            for (int i = 1; i <= 20000; ++i) {
                const gp_Pnt p = curve->Value(i / 20000.0);
                run += p.Distance(before);
                before = p;
                const double s = gp_Vec(poles.front(), p).Dot(way) / way.Magnitude();
                low = std::min(low, s);
                high = std::max(high, s);
            }
            const Crossed crossed = arranged({curve}, 2e-6);
            EXPECT_NEAR(lengthOf(crossed.network), run, 1e-6);
            double extent = 0.0;
            for (const NetworkCurve& piece : crossed.network.curves) {
                EXPECT_EQ(piece.geometry, nullptr);
                const Vec2 p = crossed.network.points[piece.end.index()];
                extent = std::max(extent, distance(p, crossed.network.points[0]));
            }
            EXPECT_NEAR(extent, std::max(high, -low), 1e-6);
        }
    }
}

TEST(Overlaps, ASplineThatTurnsBackOnItselfAtACusp)
{
    // (t^2, t^4) for t from -1 to 0.7: along a parabola to its top and back.
    const double a = -1.0;
    const double b = 0.7;
    std::vector<gp_Pnt> poles;
    for (int i = 0; i <= 4; ++i) {
        // The blossom of t^2 of degree 4, and that of t^4, at i times b and the rest a.
        const double bs = i;
        const double as = 4 - i;
        const double pairs = as * (as - 1) / 2 * a * a + as * bs * a * b + bs * (bs - 1) / 2 * b * b;
        poles.emplace_back(3.0 * pairs / 6.0, 3.0 * std::pow(a, as) * std::pow(b, bs), 0.0);
    }
    const Handle(Geom_Curve) curve = bezier(poles);
    ASSERT_NEAR(curve->Value(0.5).X(), 3.0 * 0.15 * 0.15, 1e-12);
    for (const double weld : {0.0, 2e-6}) {
        const Crossed crossed = arranged({curve}, weld);
        ASSERT_EQ(crossed.network.points.size(), 3U);
        ASSERT_EQ(crossed.network.curves.size(), 3U);
        const auto& curves = crossed.network.curves;
        EXPECT_EQ(curves[1].start, curves[2].end == curves[1].start ? curves[2].end
                                                                    : curves[2].start);
        EXPECT_LE(greatestResidual(crossed), 1e-12 * 3);
    }
}

TEST(Overlaps, SplinesThatAreEqualOnTheirFirstSpans)
{
    // Two cubic splines with the same control points up to the sixth: equal on three spans.
    const auto spline = [](double last) {
        TColgp_Array1OfPnt poles(1, 8);
        const double y[] = {0, 1, -1, 2, 0, 1, last, 3};
        for (int i = 0; i < 8; ++i) {
            poles.SetValue(i + 1, {1.0 * i, last == 0.0 ? 0.0 : y[i], 0.0});
        }
        TColStd_Array1OfReal knots(1, 6);
        TColStd_Array1OfInteger multiplicities(1, 6);
        for (int i = 1; i <= 6; ++i) {
            knots.SetValue(i, i);
            multiplicities.SetValue(i, i == 1 || i == 6 ? 4 : 1);
        }
        return Handle(Geom_Curve)(new Geom_BSplineCurve(poles, knots, multiplicities, 3));
    };
    for (const double weld : {0.0, 2e-6}) {
        const Crossed crossed = arranged({spline(-2.0), spline(4.0)}, weld);
        
        EXPECT_EQ(sharedPieces(crossed), 1U);
    }
}
