// SPDX-License-Identifier: MIT
#pragma once

#include "occt/plane_frame.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

#include <optional>
#include <span>
#include <string>

namespace tessera
{

/// The unit normal about which the face's outer wire runs counter-clockwise when the face is
/// explored FORWARD; none if its surface is not a plane within the tolerance.
std::optional<gp_Dir> planeNormal(const TopoDS_Face& face, double tolerance);

/// How far the face's surface, within the face's bounds, leaves its own best plane; and what kind
/// of surface it is, in words.
double curvedBy(const TopoDS_Face& face);
std::string surfaceKind(const TopoDS_Face& face);

/// The plane to mesh in. All points at one height: the global axes at that height. Else the axes of
/// the first face (its normal up); without faces those of the plane through the points that lie
/// farthest apart, with the normal's greatest component positive and x along the global x if that
/// is possible. points must not be empty; a plane that they do not determine is chosen upright.
PlaneFrame planeOf(const TopoDS_Face* firstFace, std::span<const gp_Pnt> points, double tolerance);

} // namespace tessera
