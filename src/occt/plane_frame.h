// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <array>

namespace tessera
{

/// A right-handed orthonormal frame whose x-y plane holds the curves; lengths in the shape's unit.
struct PlaneFrame
{
    std::array<double, 3> origin {0.0, 0.0, 0.0};
    std::array<double, 3> x {1.0, 0.0, 0.0};
    std::array<double, 3> y {0.0, 1.0, 0.0};
    std::array<double, 3> z {0.0, 0.0, 1.0};

    constexpr std::array<double, 3> toSpace(Vec2 p) const
    {
        return {origin[0] + p.x * x[0] + p.y * y[0], origin[1] + p.x * x[1] + p.y * y[1],
                origin[2] + p.x * x[2] + p.y * y[2]};
    }
    /// 4 x 4, row by row; maps (x, y, 0, 1) of the plane to space.
    constexpr std::array<double, 16> matrix() const
    {
        return {x[0], y[0], z[0], origin[0], x[1], y[1], z[1], origin[1],
                x[2], y[2], z[2], origin[2], 0.0,  0.0,  0.0,  1.0};
    }
    friend constexpr bool operator==(const PlaneFrame&, const PlaneFrame&) = default;
};

} // namespace tessera
