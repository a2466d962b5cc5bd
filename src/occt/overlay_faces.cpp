// SPDX-License-Identifier: MIT
//
// The topology is known: vertices are those of the triangulation, edges the pieces of the arranged
// curves, wires the loops of the polygons. It is written down with BRep_Builder; nothing is searched
// or sewn. A piece of a curved curve is one edge although its polygon has many sides; all its sides
// follow each other in a loop, because it meets other curves at its ends only.
#include "occt/overlay_faces.h"

#include "curve/arc.h"
#include "curve/curve_views.h"
#include "io/atomic_file.h"
#include "occt/occt_curve.h"
#include "occt/silence.h"
#include "recover/constraint_map.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Elips.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace tessera
{

namespace
{

/// A curve of OpenCASCADE in space whose parameter is sign * t + shift.
struct SpaceCurve
{
    Handle(Geom_Curve) curve;
    double sign = 1.0;
    double shift = 0.0;
};

gp_Pnt pointIn(const PlaneFrame& frame, Vec2 p)
{
    const auto at = frame.toSpace(p);
    return {at[0], at[1], at[2]};
}

gp_Dir directionIn(const PlaneFrame& frame, Vec2 d)
{
    return {d.x * frame.x[0] + d.y * frame.y[0], d.x * frame.x[1] + d.y * frame.y[1],
            d.x * frame.x[2] + d.y * frame.y[2]};
}

/// The principal axes of the ellipse center + cos(t) u + sin(t) v lie at t = phi and a quarter turn
/// on, where tan(2 phi) = 2 u.v / (u^2 - v^2).
SpaceCurve ellipse(const EllipseArc& arc, const PlaneFrame& frame)
{
    const Vec2 u = arc.u();
    const Vec2 v = arc.v();
    const double phi = 0.5 * std::atan2(2.0 * dot(u, v), squaredLength(u) - squaredLength(v));
    const Vec2 major = std::cos(phi) * u + std::sin(phi) * v;
    const Vec2 minor = -std::sin(phi) * u + std::cos(phi) * v;
    const gp_Dir normal(frame.z[0], frame.z[1], frame.z[2]);
    const gp_Ax2 axes(pointIn(frame, arc.center()),
                      cross(u, v) > 0.0 ? normal : normal.Reversed(), directionIn(frame, major));
    const double a = length(major);
    const double b = length(minor);
    if (a - b <= 1e-12 * a) {
        return {new Geom_Circle(axes, a), 1.0, -phi};
    }
    return {new Geom_Ellipse(axes, a, b), 1.0, -phi};
}

/// None for a straight curve and for those without a counterpart.
std::optional<SpaceCurve> spaceCurve(const Curve* curve, const PlaneFrame& frame)
{
    if (const auto* trimmed = dynamic_cast<const TrimmedCurve*>(curve)) {
        return spaceCurve(trimmed->base().get(), frame);
    }
    if (const auto* reversed = dynamic_cast<const ReversedCurve*>(curve)) {
        auto base = spaceCurve(reversed->base().get(), frame);
        if (base) {
            base->shift += base->sign * (reversed->first() + reversed->last());
            base->sign = -base->sign;
        }
        return base;
    }
    if (const auto* arc = dynamic_cast<const EllipseArc*>(curve)) {
        return ellipse(*arc, frame);
    }
    if (const auto* cad = dynamic_cast<const OcctCurve*>(curve)) {
        const EdgeCurve& edge = cad->edge();
        return cad->reversed() ? SpaceCurve {edge.curve, -1.0, edge.first + edge.last}
                               : SpaceCurve {edge.curve, 1.0, 0.0};
    }
    return std::nullopt;
}

class FaceBuilder
{
public:
    FaceBuilder(const OverlayResult& result, const PlaneFrame& frame)
        : result_(result)
        , frame_(frame)
        , vertices_(result.recovered.triangulation.points.size())
        , curveEdges_(result.network().curves.size())
        , spaceCurves_(curveEdges_.size())
    {
        for (std::size_t c = 0; c < spaceCurves_.size(); ++c) {
            spaceCurves_[c] = spaceCurve(result.network().curves[c].geometry.get(), frame);
        }
    }

    TopoDS_Compound build()
    {
        const gp_Ax3 axes(pointIn(frame_, {}), gp_Dir(frame_.z[0], frame_.z[1], frame_.z[2]),
                          gp_Dir(frame_.x[0], frame_.x[1], frame_.x[2]));
        const Handle(Geom_Plane) plane = new Geom_Plane(axes);
        TopoDS_Compound compound;
        builder_.MakeCompound(compound);
        for (std::size_t p = 0; p < result_.polygons.size(); ++p) {
            TopoDS_Face face;
            builder_.MakeFace(face, plane, Precision::Confusion());
            for (std::size_t i = 0; i < result_.polygons.loopCount(p); ++i) {
                builder_.Add(face, wireOf(result_.polygons.loop(p, i)));
            }
            builder_.Add(compound, face);
        }
        return compound;
    }

private:
    /// A side of a loop: on a curved piece, or straight (no curve).
    struct Side
    {
        std::optional<CurveId> curve;
        bool along = true; ///< runs as the arranged curve does
    };

    Side sideOf(std::uint32_t a, std::uint32_t b) const
    {
        const auto& constraints = result_.recovered.constraints;
        for (const ConstraintUse& use : constraints.usesOf(*findSubsegment(constraints, a, b))) {
            const CurveId curve = result_.pslg.segments[use.constraint.index()].curve;
            if (spaceCurves_[curve.index()]) {
                return {curve, (a < b) == use.forward};
            }
        }
        return {};
    }

    const TopoDS_Vertex& vertex(std::uint32_t v)
    {
        if (vertices_[v].IsNull()) {
            builder_.MakeVertex(vertices_[v], pointIn(frame_, result_.point(v)),
                                Precision::Confusion());
        }
        return vertices_[v];
    }

    TopoDS_Edge straightEdge(std::uint32_t a, std::uint32_t b)
    {
        TopoDS_Edge& edge = lineEdges_[std::minmax(a, b)];
        if (edge.IsNull()) {
            const auto [low, high] = std::minmax(a, b);
            const gp_Pnt from = pointIn(frame_, result_.point(low));
            const gp_Pnt to = pointIn(frame_, result_.point(high));
            const Handle(Geom_Line) line = new Geom_Line(from, gp_Dir(gp_Vec(from, to)));
            makeEdge(edge, line, 0.0, from.Distance(to), low, high);
        }
        return TopoDS::Edge(edge.Oriented(a < b ? TopAbs_FORWARD : TopAbs_REVERSED));
    }

    /// The whole piece, from vertex a to vertex b, which are its ends.
    TopoDS_Edge curvedEdge(CurveId curve, bool along, std::uint32_t a, std::uint32_t b)
    {
        TopoDS_Edge& edge = curveEdges_[curve.index()];
        const SpaceCurve& space = *spaceCurves_[curve.index()];
        const bool forward = along == (space.sign > 0.0);
        if (edge.IsNull()) {
            const Curve& geometry = *result_.network().curves[curve.index()].geometry;
            const double t0 = space.sign * geometry.first() + space.shift;
            const double t1 = space.sign * geometry.last() + space.shift;
            makeEdge(edge, space.curve, std::min(t0, t1), std::max(t0, t1), forward ? a : b,
                     forward ? b : a);
        }
        return TopoDS::Edge(edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
    }

    void makeEdge(TopoDS_Edge& edge, const Handle(Geom_Curve)& curve, double first, double last,
                  std::uint32_t from, std::uint32_t to)
    {
        builder_.MakeEdge(edge, curve, Precision::Confusion());
        builder_.Add(edge, vertex(from).Oriented(TopAbs_FORWARD));
        builder_.Add(edge, vertex(to).Oriented(TopAbs_REVERSED));
        builder_.Range(edge, first, last);
    }

    /// Whether a piece ends at the vertex between two sides.
    static bool isBreak(const Side& before, const Side& after, bool isNetworkPoint)
    {
        return !before.curve || !after.curve || *before.curve != *after.curve || isNetworkPoint;
    }

    TopoDS_Wire wireOf(std::span<const std::uint32_t> loop)
    {
        const std::size_t count = loop.size();
        std::vector<Side> sides;
        for (std::size_t k = 0; k < count; ++k) {
            sides.push_back(sideOf(loop[k], loop[(k + 1) % count]));
        }
        const auto breaksAt = [&](std::size_t k) {
            return isBreak(sides[(k + count - 1) % count], sides[k],
                           result_.origin[loop[k]] != VertexOrigin::CurveSample);
        };
        std::size_t first = 0;
        while (first + 1 < count && !breaksAt(first)) {
            ++first;
        }
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (std::size_t done = 0; done < count;) {
            const std::size_t begin = (first + done) % count;
            std::size_t length = 1;
            while (done + length < count && !breaksAt((begin + length) % count)) {
                ++length;
            }
            const std::uint32_t a = loop[begin];
            const std::uint32_t b = loop[(begin + length) % count];
            const Side& side = sides[begin];
            builder_.Add(wire, side.curve ? curvedEdge(*side.curve, side.along, a, b)
                                          : straightEdge(a, b));
            done += length;
        }
        wire.Closed(true);
        return wire;
    }

    const OverlayResult& result_;
    PlaneFrame frame_;
    BRep_Builder builder_;
    std::vector<TopoDS_Vertex> vertices_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, TopoDS_Edge> lineEdges_;
    std::vector<TopoDS_Edge> curveEdges_;
    std::vector<std::optional<SpaceCurve>> spaceCurves_;
};

} // namespace

TopoDS_Compound facesOf(const OverlayResult& result, const PlaneFrame& frame)
{
    return FaceBuilder(result, frame).build();
}

void writeFaces(const OverlayResult& result, const PlaneFrame& frame,
                const std::filesystem::path& path)
{
    writeShape(facesOf(result, frame), path);
}

std::string brepOf(const TopoDS_Shape& shape)
{
    std::ostringstream text;
    BRepTools::Write(shape, text);
    return text.str();
}

void writeShape(const TopoDS_Shape& shape, const std::filesystem::path& path)
{
    const Silence silence;
    AtomicFile file(path);
    const std::string name = file.temporary().string();
    bool written = false;
    if (name.ends_with(".brep") || name.ends_with(".brp")) {
        written = BRepTools::Write(shape, name.c_str());
    }
    else {
        STEPControl_Writer writer;
        written = writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone
            && writer.Write(name.c_str()) == IFSelect_RetDone;
    }
    if (!written) {
        throw Error(ErrorKind::Unwritable, path.string() + ": the faces could not be written.");
    }
    file.commit();
}

} // namespace tessera
