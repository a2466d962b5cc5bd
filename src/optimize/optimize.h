// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/refine.h"
#include "sizing/size_field.h"

namespace tessera
{

struct OptimizeReport
{
    std::size_t flips = 0;
    std::size_t moves = 0;
    std::size_t collapses = 0;
    int rounds = 0;
    std::size_t interiorPoints = 0; ///< put in by Delaunay refinement where moving did not help
    std::size_t segmentSplits = 0;
    std::vector<Unreached> unreached;
};

/// Improves the triangles of the kept regions (paper, Algorithm 1, step 5) by swaps, smoothing and
/// merging, then by Delaunay refinement what is still below options.minAngle. Never inverts a
/// triangle (exact), never moves a vertex off its curve, never lowers the smallest angle of what it
/// moves, nor the mean quality where the boundary is frozen. Ends for any input.
OptimizeReport optimize(WorkingMesh& mesh, const SizeField& size, const RefineOptions& options,
                        Execution& execution);

/// The same with the default options.
OptimizeReport optimize(WorkingMesh& mesh, const SizeField& size, double minAngle,
                        Execution& execution);

} // namespace tessera
