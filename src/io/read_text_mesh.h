// SPDX-License-Identifier: MIT
#pragma once

#include "io/raw_mesh.h"

#include <string>
#include <string_view>

namespace tessera
{

/// Parses Gmsh's MSH format, ASCII, version 2.2 or 4.1: nodes and line, triangle and quadrangle
/// elements of order 1 and 2. Throws Error(Unreadable) with file and line.
RawMesh parseMsh(std::string_view text, const std::string& name);

/// Parses the nodes and the shell, plane, axisymmetric, membrane, beam and truss elements with up
/// to 8 nodes of an Abaqus or CalculiX input deck. Throws Error(Unreadable) with file and line, also
/// where a node or element set names what does not exist.
RawMesh parseInp(std::string_view text, const std::string& name);

} // namespace tessera
