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
};

/// Improves the triangles of the kept regions (paper, Algorithm 1, step 5) by swaps, smoothing and
/// collapses. Never inverts a triangle (exact), never moves a vertex off its curve, never lowers
/// the smallest angle of what it touches.
OptimizeReport optimize(WorkingMesh& mesh, const SizeField& size, double minAngle,
                        Execution& execution);

} // namespace tessera
