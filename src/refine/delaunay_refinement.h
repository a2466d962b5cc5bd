// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/mesh_editor.h"
#include "refine/refine.h"
#include "sizing/size_field.h"

namespace tessera
{

/// Delaunay refinement of what the placement of interior points left: triangles that are too large
/// for the size field or an area limit, then triangles with an angle below options.minAngle.
/// Adds to report.interiorPoints and report.segmentSplits.
void refineDelaunay(MeshEditor& editor, const SizeField& size, const RefineOptions& options,
                    RefineReport& report, Execution& execution);

} // namespace tessera
