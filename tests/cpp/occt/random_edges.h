// SPDX-License-Identifier: MIT
// Random planar edges of every kind that a sketch can hold.
#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tessera::test
{

enum class EdgeKind
{
    Line,
    CircleArc,
    EllipseArc,
    Parabola,
    Hyperbola,
    Spline,
    RationalSpline,
    PeriodicSpline,
};

inline constexpr EdgeKind kEdgeKinds[] = {
    EdgeKind::Line,      EdgeKind::CircleArc, EdgeKind::EllipseArc,     EdgeKind::Parabola,
    EdgeKind::Hyperbola, EdgeKind::Spline,    EdgeKind::RationalSpline, EdgeKind::PeriodicSpline};

inline const char* nameOf(EdgeKind kind)
{
    constexpr const char* kNames[] = {"line",      "arc",    "ellipse",  "parabola",
                                      "hyperbola", "spline", "rational", "periodic"};
    return kNames[static_cast<int>(kind)];
}

/// Makes curves that run about through a square of the given size.
class RandomEdges
{
public:
    RandomEdges(unsigned seed, double size, gp_Pnt corner = {})
        : random_(seed)
        , size_(size)
        , corner_(corner)
    {}

    Handle(Geom_Curve) make(EdgeKind kind)
    {
        switch (kind) {
            case EdgeKind::Line: {
                const gp_Pnt p = somewhere();
                const gp_Vec way(p, somewhere());
                return new Geom_TrimmedCurve(new Geom_Line(p, gp_Dir(way)), 0.0, way.Magnitude());
            }
            case EdgeKind::CircleArc:
                return arc(new Geom_Circle(axes(somewhere()), size_ * between(0.1, 0.45)));
            case EdgeKind::EllipseArc: {
                const double major = size_ * between(0.15, 0.5);
                return arc(new Geom_Ellipse(axes(somewhere()), major, major * between(0.15, 0.9)));
            }
            case EdgeKind::Parabola: {
                const double focal = size_ * between(0.02, 0.2);
                const double reach = std::sqrt(4.0 * focal * size_ * between(0.3, 0.8));
                return new Geom_TrimmedCurve(new Geom_Parabola(axes(somewhere()), focal), -reach,
                                             reach * between(0.2, 1.0));
            }
            case EdgeKind::Hyperbola: {
                const gp_Ax2 at = axes(somewhere());
                const double major = size_ * between(0.05, 0.3);
                const double minor = size_ * between(0.05, 0.3);
                return new Geom_TrimmedCurve(new Geom_Hyperbola(at, major, minor),
                                             -between(0.5, 1.5), between(0.5, 1.5));
            }
            case EdgeKind::Spline:
                return spline(7, 3, false);
            case EdgeKind::RationalSpline:
                return spline(6, 3, true);
            case EdgeKind::PeriodicSpline:
                return periodicSpline(6);
        }
        return {};
    }

    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

private:
    gp_Pnt somewhere()
    {
        const double x = corner_.X() + size_ * between(0.0, 1.0);
        return {x, corner_.Y() + size_ * between(0.0, 1.0), 0.0};
    }
    gp_Ax2 axes(const gp_Pnt& at)
    {
        const double angle = between(0.0, 2.0 * std::numbers::pi);
        const gp_Dir up(0.0, 0.0, between(0.0, 1.0) < 0.5 ? 1.0 : -1.0);
        return {at, up, gp_Dir(std::cos(angle), std::sin(angle), 0.0)};
    }
    Handle(Geom_Curve) arc(const Handle(Geom_Curve)& whole)
    {
        const double from = between(0.0, 6.0);
        return new Geom_TrimmedCurve(whole, from, from + between(0.5, 6.0));
    }
    Handle(Geom_Curve) spline(int poles, int degree, bool rational)
    {
        TColgp_Array1OfPnt points(1, poles);
        TColStd_Array1OfReal weights(1, poles);
        for (int i = 1; i <= poles; ++i) {
            points.SetValue(i, somewhere());
            weights.SetValue(i, rational ? between(0.3, 3.0) : 1.0);
        }
        const int knotCount = poles - degree + 1;
        TColStd_Array1OfReal knots(1, knotCount);
        TColStd_Array1OfInteger multiplicities(1, knotCount);
        for (int i = 1; i <= knotCount; ++i) {
            knots.SetValue(i, i - 1 + (i > 1 && i < knotCount ? between(-0.3, 0.3) : 0.0));
            multiplicities.SetValue(i, i == 1 || i == knotCount ? degree + 1 : 1);
        }
        return new Geom_BSplineCurve(points, weights, knots, multiplicities, degree);
    }
    Handle(Geom_Curve) periodicSpline(int poles)
    {
        TColgp_Array1OfPnt points(1, poles);
        TColStd_Array1OfReal knots(1, poles + 1);
        TColStd_Array1OfInteger multiplicities(1, poles + 1);
        for (int i = 1; i <= poles + 1; ++i) {
            if (i <= poles) {
                points.SetValue(i, somewhere());
            }
            knots.SetValue(i, i);
            multiplicities.SetValue(i, 1);
        }
        return new Geom_BSplineCurve(points, knots, multiplicities, 3, Standard_True);
    }

    std::mt19937 random_;
    double size_;
    gp_Pnt corner_;
};

inline TopoDS_Compound edgesOf(const std::vector<Handle(Geom_Curve)>& curves)
{
    TopoDS_Compound result;
    BRep_Builder builder;
    builder.MakeCompound(result);
    for (const Handle(Geom_Curve)& curve : curves) {
        builder.Add(result, BRepBuilderAPI_MakeEdge(curve).Edge());
    }
    return result;
}

} // namespace tessera::test
