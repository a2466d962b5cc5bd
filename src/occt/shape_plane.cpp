// SPDX-License-Identifier: MIT
#include "occt/shape_plane.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_Surface.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tessera
{
namespace
{

std::array<double, 3> coordinates(const gp_XYZ& v)
{
    return {v.X(), v.Y(), v.Z()};
}

/// z x x is computed, so that the frame is right-handed to rounding.
PlaneFrame makeFrame(const gp_Pnt& origin, const gp_Dir& x, const gp_Dir& z)
{
    return {coordinates(origin.XYZ()), coordinates(x.XYZ()), coordinates(z.Crossed(x).XYZ()),
            coordinates(z.XYZ())};
}

std::optional<gp_Pln> planeOfSurface(const TopoDS_Face& face, double tolerance)
{
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface.IsNull()) {
        return std::nullopt;
    }
    const GeomAdaptor_Surface adaptor(surface);
    if (adaptor.GetType() == GeomAbs_Plane) {
        return adaptor.Plane();
    }
    const GeomLib_IsPlanarSurface planar(surface, tolerance);
    if (!planar.IsPlanar()) {
        return std::nullopt;
    }
    return planar.Plan();
}

/// The parametric normal of the surface in the middle of the face.
gp_Vec parametricNormal(const TopoDS_Face& face)
{
    double u1 = 0;
    double u2 = 0;
    double v1 = 0;
    double v2 = 0;
    BRepTools::UVBounds(face, u1, u2, v1, v2);
    gp_Pnt point;
    gp_Vec du;
    gp_Vec dv;
    BRep_Tool::Surface(face)->D1(0.5 * (u1 + u2), 0.5 * (v1 + v2), point, du, dv);
    return du.Crossed(dv);
}

const gp_Pnt& farthest(std::span<const gp_Pnt> points, const auto& measure)
{
    return *std::max_element(points.begin(), points.end(), [&](const gp_Pnt& a, const gp_Pnt& b) {
        return measure(a) < measure(b);
    });
}

/// Normal of the plane through three points far apart; of a vertical plane or the horizontal one
/// if all points are on one line.
gp_Dir normalThrough(std::span<const gp_Pnt> points)
{
    const gp_Pnt& a = points.front();
    const gp_Pnt& b = farthest(points, [&](const gp_Pnt& p) { return a.SquareDistance(p); });
    const gp_Vec along(a, b);
    const auto area = [&](const gp_Pnt& p) {
        return along.Crossed(gp_Vec(a, p)).SquareMagnitude();
    };
    const gp_Pnt& c = farthest(points, area);
    const double length = along.Magnitude();
    if (length > 0.0 && std::sqrt(area(c)) > 1e-9 * length * length) {
        gp_Vec normal = along.Crossed(gp_Vec(a, c));
        const double greatest = std::max({normal.X(), normal.Y(), normal.Z()});
        const double least = std::min({normal.X(), normal.Y(), normal.Z()});
        return greatest >= -least ? gp_Dir(normal) : gp_Dir(normal.Reversed());
    }
    const gp_Vec horizontal = along.Crossed(gp::DZ());
    const bool upright = length == 0.0 || horizontal.Magnitude() <= 1e-9 * length;
    return upright ? gp_Dir(0.0, -1.0, 0.0) : gp_Dir(horizontal);
}

gp_Dir xAcross(const gp_Dir& z)
{
    const gp_Dir& hint = std::abs(z.X()) < 0.9 ? gp::DX() : gp::DY();
    return z.Crossed(hint).Crossed(z);
}

double deviation(std::span<const gp_Pnt> points, const gp_Dir& normal)
{
    double low = 0.0;
    double high = 0.0;
    for (const gp_Pnt& p : points) {
        const double height = gp_Vec(points.front(), p).Dot(normal);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    return high - low;
}

} // namespace

std::optional<gp_Dir> planeNormal(const TopoDS_Face& face, double tolerance)
{
    const std::optional<gp_Pln> plane = planeOfSurface(face, tolerance);
    if (!plane) {
        return std::nullopt;
    }
    const gp_Dir normal = plane->Axis().Direction();
    return gp_Vec(normal).Dot(parametricNormal(face)) < 0.0 ? normal.Reversed() : normal;
}

double curvedBy(const TopoDS_Face& face)
{
    constexpr int kSteps = 16;
    double u1 = 0;
    double u2 = 0;
    double v1 = 0;
    double v2 = 0;
    BRepTools::UVBounds(face, u1, u2, v1, v2);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    std::vector<gp_Pnt> points;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            points.push_back(surface->Value(u1 + (u2 - u1) * i / kSteps,
                                            v1 + (v2 - v1) * j / kSteps));
        }
    }
    return deviation(points, normalThrough(points));
}

std::string surfaceKind(const TopoDS_Face& face)
{
    switch (GeomAdaptor_Surface(BRep_Tool::Surface(face)).GetType()) {
        case GeomAbs_Plane:
            return "planar";
        case GeomAbs_Cylinder:
            return "cylindrical";
        case GeomAbs_Cone:
            return "conical";
        case GeomAbs_Sphere:
            return "spherical";
        case GeomAbs_Torus:
            return "toroidal";
        default:
            return "curved";
    }
}

PlaneFrame planeOf(const TopoDS_Face* firstFace, std::span<const gp_Pnt> points, double tolerance)
{
    if (deviation(points, gp::DZ()) <= tolerance) {
        return {.origin = {0.0, 0.0, points.front().Z()}};
    }
    const std::optional<gp_Pln> plane
        = firstFace ? planeOfSurface(*firstFace, tolerance) : std::nullopt;
    if (plane) {
        gp_Dir z = *planeNormal(*firstFace, tolerance);
        if (firstFace->Orientation() == TopAbs_REVERSED) {
            z.Reverse();
        }
        return makeFrame(plane->Location(), plane->XAxis().Direction(), z);
    }
    const gp_Dir z = normalThrough(points);
    const double height = gp_Vec(points.front().XYZ()).Dot(z);
    return makeFrame(gp_Pnt(z.XYZ() * height), xAcross(z), z);
}

} // namespace tessera
