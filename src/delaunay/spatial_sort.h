// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// Order in which to insert points: a biased randomized insertion order (N. Amenta, S. Choi,
/// G. Rote, "Incremental constructions con BRIO", SoCG 2003), each round along a Hilbert curve, so
/// that consecutive points are close. Deterministic. Finite points; O(n).
std::vector<std::uint32_t> insertionOrder(std::span<const Vec2> points);

} // namespace tessera
