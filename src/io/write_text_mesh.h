// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "mesh/mesh.h"

#include <string>

namespace tessera
{

/// The mesh in Gmsh's MSH 4.1 format, ASCII, numbered from 1, z = 0. Every group is a physical
/// group of its name; elements are classified on one entity for each combination of groups, so
/// that groups may share elements. Nodes of node groups are points.
std::string formatMsh(const Mesh& mesh);

/// The mesh as an Abaqus and CalculiX input deck, numbered from 1, z = 0: shell elements S3 or S6
/// in the set Eall, nodes in the set Nall, an ELSET for each triangle group, an NSET for each edge
/// and node group. Set names keep letters, digits, '_' and '-' of the group's name and differ even
/// if case is ignored. Coordinates have at most 20 characters, as CalculiX reads no more.
std::string formatInp(const Mesh& mesh);

/// The mesh's corner nodes and its edges on constraints in Triangle's .poly format, with a point in
/// every hole and the attributes of the regions. A segment's marker is its first curve's; if no
/// curve has a marker, or without a network, 1 on the outline and 2 inside.
std::string formatPoly(const Mesh& mesh, const CurveNetwork* network);

} // namespace tessera
