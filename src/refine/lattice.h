// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/lattice_runs.h"
#include "refine/mesh_editor.h"
#include "refine/vertex_sizes.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// What has been put into the mesh straight from a lattice.
struct LatticePatch
{
    std::size_t points = 0;
    std::uint32_t firstTriangle = 0; ///< its triangles' slots are firstTriangle .. endTriangle - 1
    std::uint32_t endTriangle = 0;
    /// The half-edges of its triangles on its rim. Until releaseRim() they are constrained.
    std::vector<HalfEdge> rim;
};

/// Makes triangles of all lattice triangles whose three points are in the runs, and joins them to
/// the triangulation along their rim. Nothing happens if there are none. Precondition: the runs keep
/// a clearance of at least 0.75 h (see findLatticeRuns), points of other lattices included.
LatticePatch insertLattice(MeshEditor& editor, VertexSizes& sizes, const HexLattice& lattice,
                           std::vector<LatticeRun> runs, Execution& execution);

/// Makes the rim's edges ordinary ones.
void releaseRim(MeshEditor& editor, const LatticePatch& patch);

} // namespace tessera
