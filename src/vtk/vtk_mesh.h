// SPDX-License-Identifier: MIT
#pragma once

#include "io/raw_mesh.h"
#include "mesh/mesh.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tessera
{

/// Writes the mesh as a VTK unstructured grid: .vtu with raw appended data, which FreeCAD reads
/// fastest, or .vtk (legacy, binary), by extension. Points are Float64, z = 0. Triangles (VTK types
/// 5 or 22) come first, then the edges on constraints (3 or 21). Throws Error(Unwritable).
///
/// Point data: origin (VertexOrigin as a number). Cell data: region and group (of the first group
/// that has the cell), curve (first curve of an edge); -1 where there is none. Field data, for
/// groups that share cells: group_names, group_kinds (0 triangles, 1 edges, 2 nodes), and the
/// members of group g: group_members[group_offsets[g] .. group_offsets[g + 1]), cell ids for
/// triangles and edges, point ids for nodes.
void writeVtk(const Mesh& mesh, const std::filesystem::path& path);

/// Parses the lines, triangles and quadrangles of order 1 and 2 of a .vtu file in any of its
/// encodings. Numbers of nodes and cells are VTK's, from 0. name is used in messages. Whatever the
/// text has in it, this ends with a mesh or throws Error(Unreadable).
RawMesh parseVtu(std::string_view text, const std::string& name);

/// A mesh with a number at each node.
struct NodalField
{
    RawMesh mesh;
    std::vector<double> values; ///< by node; any number
};

/// The same with the point data of the given name, one number a point; Error(Unreadable) also if
/// there is none.
NodalField parseVtu(std::string_view text, const std::string& name, const std::string& array);

} // namespace tessera
