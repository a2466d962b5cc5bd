// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"
#include "refine/mesh_editor.h"
#include "refine/vertex_sizes.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// A hexagonal lattice of spacing h: point (i, j) lies at origin + ((i + j/2) h, j sqrt(3)/2 h), and
/// (i, j), (i + 1, j), (i, j + 1) make an upright triangle.
struct HexLattice
{
    Vec2 origin;
    double h;

    double rowHeight() const { return 0.86602540378443865 * h; }
    Vec2 point(std::int64_t i, std::int64_t j) const
    {
        return {origin.x + (static_cast<double>(i) + 0.5 * static_cast<double>(j)) * h,
                origin.y + static_cast<double>(j) * rowHeight()};
    }
};

/// Consecutive lattice points (first, row) .. (last, row), all usable.
struct LatticeRun
{
    std::int64_t row;
    std::int64_t first;
    std::int64_t last;
    std::uint32_t region = 0; ///< of the WorkingMesh
    std::uint32_t base = 0;   ///< number of its first point among the points of all runs
};

/// The points of the lattice inside kept regions that keep their distance from every vertex and
/// constrained edge: clearance × h, and more where the size there is below h, so that sizes can grow
/// in between. Ordered by row, then by first. The boundary may have any shape and extent: the cost
/// is O(n log n) for the n rows that the surroundings of all constrained edges meet.
std::vector<LatticeRun> findLatticeRuns(const MeshEditor& editor, const VertexSizes& sizes,
                                        const HexLattice& lattice, double clearance);

} // namespace tessera
