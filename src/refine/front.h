// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/mesh_editor.h"
#include "refine/vertex_sizes.h"

namespace tessera
{

/// Fills the kept regions with interior points, advancing from the constrained edges. The triangles
/// in the slots [firstGood, endGood) are accepted unseen. Returns the number of points.
std::size_t placeFrontal(MeshEditor& editor, VertexSizes& sizes, std::uint32_t firstGood,
                         std::uint32_t endGood, Execution& execution);

} // namespace tessera
