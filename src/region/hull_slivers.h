// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "recover/recover.h"
#include "sample/pslg.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// Triangles along the convex hull that only rounding has made: samples of a slanted straight curve
/// and places where curves meet are beside the curve by some units in the last place, and where
/// such a curve lies on the hull, triangles as flat as that lie between it and the hull.
///
/// Only triangles with such a made point at a corner are listed, so that the triangles of points
/// that were given are all within the hull; and only so many that every vertex and every constraint
/// still has a triangle that is not. The exception are straight curves all of whose given points
/// lie on one line: there, every triangle is listed. O(triangles).
std::vector<std::uint32_t> findHullSlivers(const RecoveryResult& recovered,
                                           const CurveNetwork& network, const Pslg& pslg);

} // namespace tessera
