// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <array>
#include <span>

namespace tessera
{

struct InscribedCircle
{
    Vec2 center;
    double radius = 0.0;
    /// No larger circle than the one that was asked for fits. False if that is not certain.
    bool isWithin = false;
};

/// The largest circle inside a part of the plane that is given by its triangles and its border
/// edges, and whether all that fit have a radius of at most limit (but for 1e-9 of it). The radius
/// is at most 0.1 % too small, for all but intricate parts; of more than ten thousand edges only the
/// mean width is looked at (radius = area / perimeter). Empty input: radius 0.
InscribedCircle largestCircleIn(std::span<const std::array<Vec2, 3>> triangles,
                                std::span<const std::array<Vec2, 2>> border, double limit = 0.0);

} // namespace tessera
