// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "io/role_lists.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tessera
{

/// Reads well-known text: POLYGON, MULTIPOLYGON, LINESTRING, LINEARRING, MULTILINESTRING, POINT,
/// MULTIPOINT and GEOMETRYCOLLECTION, in any case and spacing, EMPTY anywhere, an SRID=...; before
/// it. Every geometry starts on a line of its own, may run on over the following lines, and is one
/// operand named "Line<n>" after the line it starts on; empty lines and lines that start with # are
/// passed over. z and m coordinates are dropped. Rings are boundaries, lines constraints, points
/// embedded, if the lists say nothing else by line number. NetworkCurve::source is the line number,
/// the curves' groups are "Line<n>_Edges", the points' "Line<n>_Points".
///
/// A ring must be closed; a repeated point is taken once. Throws Error(Unreadable) with file and
/// line, also for the curved and spatial geometry types.
CurveNetwork readWkt(const std::filesystem::path& path, const RoleLists& roles = {});

/// The same from text; name is used in messages.
CurveNetwork parseWkt(std::string_view text, const std::string& name, const RoleLists& roles = {});

} // namespace tessera
