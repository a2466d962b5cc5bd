// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "io/raw_mesh.h"
#include "mesh/mesh.h"

#include <filesystem>
#include <string>

namespace tessera
{

/// The extensions that writeMesh() knows, as a sentence may list them: ".vtu, .vtk, ... or .png".
std::string meshExtensions();
bool isMeshExtension(const std::string& extension);

/// Writes the mesh in the format of the path's extension. The file appears whole or not at all.
/// network, if there is one, gives the markers of a .poly. Throws Error(Unwritable), also for an
/// extension that is not known.
void writeMesh(const Mesh& mesh, const std::filesystem::path& path,
               const CurveNetwork* network = nullptr);

/// Reads a mesh to be checked from a .vtu, .msh or .inp file. Throws Error(Unreadable).
RawMesh readMesh(const std::filesystem::path& path);

} // namespace tessera
