// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/mesh_editor.h"
#include "refine/vertex_sizes.h"

namespace tessera
{

/// Fills the kept regions with interior points, advancing from the constrained edges. Returns the
/// number of points.
std::size_t placeFrontal(MeshEditor& editor, VertexSizes& sizes, Execution& execution);

} // namespace tessera
