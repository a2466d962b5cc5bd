// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/mesh_editor.h"
#include "refine/vertex_sizes.h"

#include <cstdint>
#include <vector>

namespace tessera
{

struct FrontResult
{
    std::size_t points = 0;
    std::vector<std::uint32_t> open; ///< kept triangles that are larger than their size
};

/// Fills the kept regions with interior points, advancing from the constrained edges. The triangles
/// in the slots [firstGood, endGood) are accepted unseen.
FrontResult placeFrontal(MeshEditor& editor, VertexSizes& sizes, std::uint32_t firstGood,
                         std::uint32_t endGood, Execution& execution);

} // namespace tessera
