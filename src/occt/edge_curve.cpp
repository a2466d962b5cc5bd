// SPDX-License-Identifier: MIT
#include "occt/edge_curve.h"

#include <BRep_Tool.hxx>
#include <GeomAPI.hxx>
#include <GeomConvert.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>

namespace tessera
{
namespace
{

/// A jump of the derivative below this part of its length is no corner.
constexpr double kCornerTolerance = 1e-7;
constexpr int kMostSamples = 4096;

/// What a trimmed curve trims; Bezier curves as the B-splines that they are.
Handle(Geom_Curve) basisOf(Handle(Geom_Curve) curve)
{
    while (!curve.IsNull() && curve->IsKind(STANDARD_TYPE(Geom_TrimmedCurve))) {
        curve = Handle(Geom_TrimmedCurve)::DownCast(curve)->BasisCurve();
    }
    if (!curve.IsNull() && curve->IsKind(STANDARD_TYPE(Geom_BezierCurve))) {
        return GeomConvert::CurveToBSplineCurve(curve);
    }
    return curve;
}

/// The curve of an edge that is given only by its image in a plane.
EdgeCurve fromPlane(const TopoDS_Edge& edge)
{
    EdgeCurve result;
    for (int i = 1;; ++i) {
        Handle(Geom2d_Curve) image;
        Handle(Geom_Surface) surface;
        TopLoc_Location location;
        BRep_Tool::CurveOnSurface(edge, image, surface, location, result.first, result.last, i);
        if (image.IsNull()) {
            return result;
        }
        const auto plane = Handle(Geom_Plane)::DownCast(surface);
        if (!plane.IsNull()) {
            result.curve = basisOf(GeomAPI::To3d(image, plane->Pln()));
            if (!location.IsIdentity()) {
                result.curve = Handle(Geom_Curve)::DownCast(
                    result.curve->Transformed(location.Transformation()));
            }
            return result;
        }
    }
}

int sampleCount(const Handle(Geom_Curve)& curve)
{
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve); !spline.IsNull()) {
        return (spline->NbKnots() - 1) * 2 * (spline->Degree() + 1);
    }
    return 12;
}

bool hasCorner(const Geom_BSplineCurve& spline, int knot)
{
    if (spline.Multiplicity(knot) < spline.Degree()) {
        return false;
    }
    gp_Pnt point;
    gp_Vec before;
    gp_Vec after;
    spline.LocalD1(spline.Knot(knot), knot - 1, knot, point, before);
    spline.LocalD1(spline.Knot(knot), knot, knot + 1, point, after);
    return (after - before).Magnitude()
        > kCornerTolerance * std::max(before.Magnitude(), after.Magnitude());
}

/// A copy of the spline over exactly [first, last], not periodic.
Handle(Geom_BSplineCurve) segmentOf(const Handle(Geom_BSplineCurve)& spline, double first,
                                    double last)
{
    const auto copy = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    if (copy->IsPeriodic()) {
        // Segment() distorts a periodic spline of which all is taken, and an edge's range may differ
        // from the period by rounding.
        const double period = copy->LastParameter() - copy->FirstParameter();
        const double tolerance = 1e-9 * period;
        if (std::abs(first - copy->FirstParameter()) <= tolerance
            && std::abs(last - copy->LastParameter()) <= tolerance) {
            copy->SetNotPeriodic();
            copy->Segment(copy->FirstParameter(), copy->LastParameter()); // knots at the ends
            return copy;
        }
    }
    if (copy->IsPeriodic() || first != copy->FirstParameter() || last != copy->LastParameter()) {
        copy->Segment(first, last);
    }
    if (copy->IsPeriodic()) {
        copy->SetNotPeriodic();
    }
    return copy;
}

} // namespace

bool EdgeCurve::isLine() const
{
    if (curve->IsKind(STANDARD_TYPE(Geom_Line))) {
        return true;
    }
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
    return !spline.IsNull() && spline->NbPoles() == 2 && !spline->IsPeriodic();
}

EdgeCurve curveOf(const TopoDS_Edge& edge)
{
    EdgeCurve result;
    TopLoc_Location location;
    result.curve = basisOf(BRep_Tool::Curve(edge, location, result.first, result.last));
    if (result.curve.IsNull()) {
        return fromPlane(edge);
    }
    if (!location.IsIdentity()) {
        const gp_Trsf& placement = location.Transformation();
        result.first = result.curve->TransformedParameter(result.first, placement);
        result.last = result.curve->TransformedParameter(result.last, placement);
        result.curve = Handle(Geom_Curve)::DownCast(result.curve->Transformed(placement));
    }
    return result;
}

std::vector<gp_Pnt> pointsAlong(const EdgeCurve& edge)
{
    const int count = edge.isLine() ? 1 : std::min(sampleCount(edge.curve), kMostSamples);
    std::vector<gp_Pnt> points;
    points.reserve(static_cast<std::size_t>(count) + 1);
    for (int i = 0; i <= count; ++i) {
        const double s = static_cast<double>(i) / count;
        points.push_back(edge.curve->Value((1.0 - s) * edge.first + s * edge.last));
    }
    return points;
}

std::vector<EdgeCurve> smoothPieces(const EdgeCurve& edge)
{
    auto spline = Handle(Geom_BSplineCurve)::DownCast(edge.curve);
    if (spline.IsNull()) {
        return {edge};
    }
    bool mayHaveCorners = spline->IsPeriodic();
    for (int i = 2; i < spline->NbKnots(); ++i) {
        mayHaveCorners |= spline->Multiplicity(i) >= spline->Degree();
    }
    if (!mayHaveCorners) {
        return {edge};
    }
    spline = segmentOf(spline, edge.first, edge.last);
    std::vector<double> cuts {spline->FirstParameter()};
    for (int i = 2; i < spline->NbKnots(); ++i) {
        if (hasCorner(*spline, i)) {
            cuts.push_back(spline->Knot(i));
        }
    }
    cuts.push_back(spline->LastParameter());
    std::vector<EdgeCurve> pieces;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Handle(Geom_Curve) piece = segmentOf(spline, cuts[i], cuts[i + 1]);
        pieces.push_back(EdgeCurve {piece, piece->FirstParameter(), piece->LastParameter()});
    }
    return pieces;
}

} // namespace tessera
