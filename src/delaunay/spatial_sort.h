// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "base/vec2.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// Sorts points for insertion: a biased randomized insertion order (N. Amenta, S. Choi, G. Rote,
/// "Incremental constructions con BRIO", SoCG 2003), each round along a Hilbert curve, so that
/// consecutive points are close. Fills `sorted` (as many) with the points in that order and returns
/// the index that each had. Deterministic. Finite points in the given bounding box; O(n).
std::vector<std::uint32_t> sortForInsertion(std::span<const Vec2> points, const Box2& box,
                                            std::span<Vec2> sorted);

} // namespace tessera
