// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/overlay.h"

#include <cstddef>

namespace tessera
{

/// Area of a polygon of the result, bounded by the true curves instead of their chords. To rounding
/// where pieces of curves end at the polygon's vertices: always, unless recovery had to split a
/// chord. O(edges log subsegments).
double trueArea(const OverlayResult& result, std::size_t polygon);

} // namespace tessera
