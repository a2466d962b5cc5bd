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
#include <gp.hxx>
#include <gp_Dir.hxx>
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
/// Control points that are this part of their distances and coordinates off a line lie on it.
constexpr double kStraightTolerance = 1e-14;
/// Where a spline is slower than this part of its greatest speed, it stands still.
constexpr double kCuspSpeed = 1e-8;

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

std::vector<EdgeCurve> segmentsBetween(const Handle(Geom_BSplineCurve)& spline,
                                       const std::vector<double>& cuts)
{
    std::vector<EdgeCurve> pieces;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Handle(Geom_Curve) piece = segmentOf(spline, cuts[i], cuts[i + 1]);
        pieces.push_back(EdgeCurve {piece, piece->FirstParameter(), piece->LastParameter()});
    }
    return pieces;
}

/// Cut at knots where the direction jumps.
std::vector<EdgeCurve> cutAtCorners(const EdgeCurve& edge)
{
    auto spline = Handle(Geom_BSplineCurve)::DownCast(edge.curve);
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
    return segmentsBetween(spline, cuts);
}

/// Parameters of a spline, close enough to show each of its bends.
std::vector<double> densely(const Geom_BSplineCurve& spline)
{
    const int perSpan = 8 * (spline.Degree() + 1);
    std::vector<double> result;
    for (int k = 1; k < spline.NbKnots(); ++k) {
        for (int i = 0; i < perSpan; ++i) {
            const double share = static_cast<double>(i) / perSpan;
            result.push_back((1.0 - share) * spline.Knot(k) + share * spline.Knot(k + 1));
        }
    }
    result.push_back(spline.LastParameter());
    return result;
}

/// The direction of the line on which all control points lie, up to rounding; zero if none.
gp_Vec lineThroughPoles(const Geom_BSplineCurve& spline)
{
    const gp_Pnt start = spline.Pole(1);
    gp_Vec farthest;
    double greatest = 0.0;
    for (int i = 1; i <= spline.NbPoles(); ++i) {
        const gp_Vec way(start, spline.Pole(i));
        farthest = way.SquareMagnitude() > farthest.SquareMagnitude() ? way : farthest;
        greatest = std::max(greatest, spline.Pole(i).XYZ().Modulus());
    }
    const double reach = farthest.Magnitude();
    if (!(reach > 0.0)) {
        return {};
    }
    const gp_Vec direction = farthest / reach;
    for (int i = 2; i <= spline.NbPoles(); ++i) {
        const gp_Vec way(start, spline.Pole(i));
        if (way.Crossed(direction).Magnitude() > kStraightTolerance * (reach + greatest)) {
            return {};
        }
    }
    return direction;
}

/// Between two parameters where the curve runs forth and back: where it turns.
double turnBetween(const Geom_Curve& curve, const gp_Vec& direction, double a, double b)
{
    const auto speed = [&](double t) { return curve.DN(t, 1).Dot(direction); };
    const bool forth = speed(a) > 0.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (a + b);
        ((speed(middle) > 0.0) == forth ? a : b) = middle;
    }
    return 0.5 * (a + b);
}

/// A spline on a line as straight pieces, from each turn to the next; none if it is no such spline.
std::vector<EdgeCurve> straightPieces(const EdgeCurve& edge)
{
    const auto whole = Handle(Geom_BSplineCurve)::DownCast(edge.curve);
    if (lineThroughPoles(*whole).Magnitude() == 0.0) {
        return {};
    }
    const Handle(Geom_BSplineCurve) spline = segmentOf(whole, edge.first, edge.last);
    const gp_Vec direction = lineThroughPoles(*spline);
    std::vector<gp_Pnt> stops {spline->StartPoint()};
    double before = spline->FirstParameter();
    double speedBefore = 0.0;
    for (const double t : densely(*spline)) {
        const double speed = spline->DN(t, 1).Dot(direction);
        if (speed * speedBefore < 0.0) {
            stops.push_back(spline->Value(turnBetween(*spline, direction, before, t)));
        }
        if (speed != 0.0) {
            before = t;
            speedBefore = speed;
        }
    }
    stops.push_back(spline->EndPoint());
    std::vector<EdgeCurve> pieces;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const double length = stops[i].Distance(stops[i + 1]);
        if (length > gp::Resolution()) {
            const gp_Dir way(gp_Vec(stops[i], stops[i + 1]));
            pieces.push_back({new Geom_Line(stops[i], way), 0.0, length});
        }
    }
    return pieces;
}

/// Cut where a spline stands still and turns back: what comes after is another curve, which may run
/// along the first one.
std::vector<EdgeCurve> cutAtCusps(const EdgeCurve& edge)
{
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(edge.curve);
    const std::vector<double> places = densely(*spline);
    std::vector<double> speeds;
    for (const double t : places) {
        speeds.push_back(spline->DN(t, 1).Magnitude());
    }
    const double greatest = *std::max_element(speeds.begin(), speeds.end());
    std::vector<double> cuts {edge.first};
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        if (speeds[i] > 0.3 * greatest || speeds[i] > speeds[i - 1] || speeds[i] > speeds[i + 1]) {
            continue;
        }
        double a = places[i - 1];
        double b = places[i + 1];
        const gp_Vec wayIn = spline->DN(a, 1);
        const gp_Vec wayOut = spline->DN(b, 1);
        for (int step = 0; step < 120; ++step) {
            const double left = a + (b - a) / 3.0;
            const double right = b - (b - a) / 3.0;
            if (spline->DN(left, 1).SquareMagnitude() < spline->DN(right, 1).SquareMagnitude()) {
                b = right;
            }
            else {
                a = left;
            }
        }
        const double t = 0.5 * (a + b);
        if (spline->DN(t, 1).Magnitude() <= kCuspSpeed * greatest && wayIn.Dot(wayOut) < 0.0
            && t > cuts.back() && t < edge.last) {
            cuts.push_back(t);
        }
    }
    if (cuts.size() == 1) {
        return {edge};
    }
    cuts.push_back(edge.last);
    return segmentsBetween(spline, cuts);
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
    if (edge.isLine() || !edge.curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve))) {
        return {edge};
    }
    std::vector<EdgeCurve> result;
    for (const EdgeCurve& piece : cutAtCorners(edge)) {
        std::vector<EdgeCurve> further = straightPieces(piece);
        if (further.empty()) {
            further = cutAtCusps(piece);
        }
        result.insert(result.end(), further.begin(), further.end());
    }
    return result;
}

} // namespace tessera
