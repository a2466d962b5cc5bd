// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "io/role_lists.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tessera
{

/// Reads a planar straight-line graph in Triangle's .poly format as one operand named after the
/// file. Points may be numbered from 0 or from 1 (or any first number), must be consecutive, and
/// may stand in a .node file of the same stem (0 points in the .poly). Attributes of points are
/// read over. NetworkCurve::source is the segment's number, marker its marker. Points that no
/// segment uses are embedded, as are points with a marker, which name node groups "PointMarker7".
/// A missing marker is 0. The hole section must be there, so that a file cut off after its segments
/// is not taken for a domain without holes; the region section may be missing.
///
/// Roles are those of the lists by marker, the others the default ones (assignPolyRoles). Throws
/// Error(Unreadable) with file and line.
CurveNetwork readPoly(const std::filesystem::path& path, const RoleLists& roles = {});

/// The same from text; name is used in messages and for the operand. nodePath is the .node file to
/// read if the text has no points; empty: there is none.
CurveNetwork parsePoly(std::string_view text, const std::string& name,
                       const std::filesystem::path& nodePath = {}, const RoleLists& roles = {});

} // namespace tessera
