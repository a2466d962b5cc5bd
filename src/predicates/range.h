// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <span>

namespace tessera
{

/// Greatest and smallest allowed magnitude of a coordinate that is not zero, and the greatest
/// allowed ratio between two of one input.
constexpr double kMaxMagnitude = 1e150;
constexpr double kMinMagnitude = 1e-150;
constexpr double kMaxSpan = 1e60;

/// Throws Error(InvalidInput) at the first point with a coordinate that is not finite or whose
/// magnitude is outside the limits above; places[0] has the point. O(n).
void checkRange(std::span<const Vec2> points);

} // namespace tessera
