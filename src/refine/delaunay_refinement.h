// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/mesh_editor.h"
#include "refine/refine.h"
#include "sizing/size_field.h"

#include <cstdint>
#include <span>

namespace tessera
{

/// Delaunay refinement of the candidates and of what it makes of them: first of triangles that are
/// too large for the size field or an area limit, then of those with an angle below
/// options.minAngle. Adds to report.interiorPoints and report.segmentSplits. The editor may not be used
/// afterwards: the last attempts are taken back in its mesh if they did not help.
void refineDelaunay(MeshEditor& editor, const SizeField& size, const RefineOptions& options,
                    std::span<const std::uint32_t> candidates, RefineReport& report,
                    Execution& execution);

} // namespace tessera
