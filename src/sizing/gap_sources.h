// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "sizing/graded_size.h"

#include <functional>
#include <vector>

namespace tessera
{

struct GapOptions
{
    double elements = 1.0; ///< across each gap; > 0
    double minSize = 0.0;  ///< no source is smaller; 0: a thousandth of the size in place
    /// Whether a place is to be meshed: gaps elsewhere do not count. Null: everywhere.
    std::function<bool(Vec2)> inside {};
};

/// Where two curves (or two parts of one) face each other so closely that the size of base does not
/// give the elements across: a source from one to the other. Facing: the line across meets both
/// within 45 degrees of their normals. Corners are no gaps: within one size of a point where the two
/// curves meet, nothing counts.
std::vector<SizeSource> gapSources(const CurveNetwork& network, const SizeField& base,
                                   const GapOptions& options, const Execution& execution);

} // namespace tessera
