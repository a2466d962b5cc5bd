// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "base/vec2.h"

#include <cstdint>
#include <span>

namespace tessera
{

/// The plane divided into squares, closed to the lower left and open to the upper right, centered
/// at the multiples of a power of two. Centers and corners are doubles; all tests are exact.
class PixelGrid
{
public:
    /// Pixels of about the larger of 2^-44 of the box's size and the last place of its greatest
    /// coordinate. The box is not a point.
    explicit PixelGrid(const Box2& box);

    /// Side of a pixel.
    double side() const { return side_; }

    /// Center of the pixel that contains p.
    Vec2 centerOf(Vec2 p) const;
    /// Center of the pixel that contains the crossing of the lines ab and cd, not parallel.
    Vec2 centerOfCrossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2 roundedCrossing) const;
    /// Whether the closed segment ab, a != b, meets the pixel.
    bool meets(Vec2 a, Vec2 b, Vec2 center) const;
    /// Order in which the segment ab runs through two pixels that it meets: < 0, 0, > 0.
    static int compareAlong(Vec2 a, Vec2 b, Vec2 center1, Vec2 center2);

private:
    double centerOf(double coordinate) const;

    double side_;
};

} // namespace tessera
