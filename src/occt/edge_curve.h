// SPDX-License-Identifier: MIT
#pragma once

#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Pnt.hxx>

#include <vector>

namespace tessera
{

/// The 3D curve of an edge, its placement applied; a null curve if the edge has none.
struct EdgeCurve
{
    Handle(Geom_Curve) curve;
    double first = 0.0;
    double last = 0.0;

    bool isLine() const;
};

/// Also finds the curve of an edge that has only a curve on a plane. Trimmed curves are replaced by
/// what they trim, Bezier curves by the same B-spline. Throws Standard_Failure on data that
/// OpenCASCADE cannot use.
EdgeCurve curveOf(const TopoDS_Edge& edge);

/// Points that show how far the edge goes: its ends, and between them enough to see every bend of
/// it. Bounded: at most a few thousand.
std::vector<gp_Pnt> pointsAlong(const EdgeCurve& edge);

/// The curve cut where its direction jumps (knots of full multiplicity of a B-spline, vertices of
/// a polyline) or turns back (cusps), so that every piece is smooth. A B-spline whose control points
/// lie on a line becomes straight lines, from turn to turn. Most curves are one piece. No piece is a
/// periodic B-spline.
std::vector<EdgeCurve> smoothPieces(const EdgeCurve& edge);

} // namespace tessera
