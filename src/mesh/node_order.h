// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/refine.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// In what order a mesh's triangles and nodes are written.
struct MeshOrder
{
    std::vector<std::uint32_t> triangles;    ///< slots of the kept ones
    std::vector<std::uint32_t> nodeOfVertex; ///< numbers from 0; kNoNode where nothing is kept
    std::uint32_t nodes = 0;
    static constexpr std::uint32_t kNoNode = 0xffffffffU;
};

/// Triangles that share nodes near each other, and near numbers for the nodes of a triangle, so that
/// who reads the mesh finds in the cache what he needs, and matrices have a small bandwidth.
/// Lattices are in order as they are; other meshes are ordered breadth first from triangle to
/// neighbor (E. Cuthill, J. McKee, "Reducing the bandwidth of sparse symmetric matrices", 1969).
/// Deterministic, the same for any number of threads. O(n).
MeshOrder orderMesh(const WorkingMesh& mesh, const Execution& execution);

} // namespace tessera
