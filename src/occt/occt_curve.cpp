// SPDX-License-Identifier: MIT
#include "occt/occt_curve.h"

#include "base/error.h"
#include "curve/arc.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Ellipse.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <string>

namespace tessera
{
namespace
{

template<class Evaluate>
Vec2 evaluated(Evaluate&& evaluate)
{
    try {
        return evaluate();
    }
    catch (const Standard_Failure& failure) {
        throw Error(ErrorKind::InvalidInput,
                    std::string("A curve cannot be evaluated (") + failure.GetMessageString()
                        + "); redraw or repair it.");
    }
}

} // namespace

OcctCurve::OcctCurve(const EdgeCurve& edge, bool reversed, const PlaneProjection& projection)
    : edge_(edge)
    , reversed_(reversed)
    , projection_(projection)
    , spans_(spanBounds(edge.curve))
{}

/// The second derivative of a B-spline of degree p is one of degree p - 2, and on each span lies in
/// the convex hull of the p - 1 control points that act there.
std::vector<OcctCurve::SpanBound> OcctCurve::spanBounds(const Handle(Geom_Curve)& curve)
{
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
    if (spline.IsNull() || spline->IsRational() || spline->IsPeriodic() || spline->Degree() < 2) {
        return {};
    }
    const int degree = spline->Degree();
    const int poles = spline->NbPoles();
    TColStd_Array1OfReal knots(1, poles + degree + 1);
    spline->KnotSequence(knots);
    const auto slope = [&](int order, const gp_Vec& from, const gp_Vec& to, int first) {
        const double width = knots(first + degree + 1) - knots(first + order);
        return width > 0.0 ? (to - from) * ((degree - order + 1) / width) : gp_Vec();
    };
    std::vector<gp_Vec> control;
    for (int i = 1; i <= poles; ++i) {
        control.emplace_back(spline->Pole(i).XYZ());
    }
    for (int order = 1; order <= 2; ++order) {
        for (int i = 1; i <= poles - order; ++i) {
            const auto k = static_cast<std::size_t>(i);
            control[k - 1] = slope(order, control[k - 1], control[k], i);
        }
    }
    std::vector<SpanBound> spans;
    for (int k = degree + 1; k <= poles; ++k) {
        if (knots(k + 1) > knots(k)) {
            double bound = 0.0;
            for (int i = k - degree; i <= k - 2; ++i) {
                bound = std::max(bound, control[static_cast<std::size_t>(i) - 1].Magnitude());
            }
            spans.push_back({knots(k + 1), bound});
        }
    }
    return spans;
}

double OcctCurve::secondDerivativeBound(double a, double b) const
{
    if (spans_.empty()) {
        return Curve::secondDerivativeBound(a, b);
    }
    const double low = std::min(parameter(a), parameter(b));
    const double high = std::max(parameter(a), parameter(b));
    auto span = std::upper_bound(spans_.begin(), spans_.end() - 1, low,
                                 [](double t, const SpanBound& s) { return t < s.end; });
    double bound = span->bound;
    while (span + 1 != spans_.end() && span->end < high) {
        ++span;
        bound = std::max(bound, span->bound);
    }
    return bound;
}

double OcctCurve::parameter(double t) const
{
    if (!reversed_) {
        return t;
    }
    if (t == edge_.first) {
        return edge_.last;
    }
    return t == edge_.last ? edge_.first : edge_.first + edge_.last - t;
}

Vec2 OcctCurve::point(double t) const
{
    return evaluated([&] {
        gp_Pnt point;
        edge_.curve->D0(parameter(t), point);
        return projection_.point(point);
    });
}

Vec2 OcctCurve::derivative(double t) const
{
    return evaluated([&] {
        gp_Pnt point;
        gp_Vec first;
        edge_.curve->D1(parameter(t), point, first);
        return projection_.vector(reversed_ ? first.Reversed() : first);
    });
}

Vec2 OcctCurve::secondDerivative(double t) const
{
    return evaluated([&] {
        gp_Pnt point;
        gp_Vec first;
        gp_Vec second;
        edge_.curve->D2(parameter(t), point, first, second);
        return projection_.vector(second);
    });
}

std::shared_ptr<const Curve> makeCurve(const EdgeCurve& piece, bool reversed,
                                       const PlaneProjection& projection)
{
    if (piece.isLine()) {
        return nullptr;
    }
    double major = 0.0;
    double minor = 0.0;
    if (const auto circle = Handle(Geom_Circle)::DownCast(piece.curve); !circle.IsNull()) {
        major = minor = circle->Radius();
    }
    else if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(piece.curve); !ellipse.IsNull()) {
        major = ellipse->MajorRadius();
        minor = ellipse->MinorRadius();
    }
    if (!(minor > 0.0)) {
        return std::make_shared<OcctCurve>(piece, reversed, projection);
    }
    const gp_Ax2 axes = Handle(Geom_Conic)::DownCast(piece.curve)->Position();
    const Vec2 u = major * projection.vector(axes.XDirection());
    const Vec2 v = minor * projection.vector(axes.YDirection());
    const Vec2 center = projection.point(axes.Location());
    // Backwards: the parameter's sign turned over, and with it the second axis.
    return reversed
        ? std::make_shared<EllipseArc>(center, u, -1.0 * v, -piece.last, -piece.first)
        : std::make_shared<EllipseArc>(center, u, v, piece.first, piece.last);
}

} // namespace tessera
