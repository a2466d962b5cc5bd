// SPDX-License-Identifier: MIT
#include "recover/pixel_grid.h"

#include "predicates/crossing.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <cmath>

namespace tessera
{

PixelGrid::PixelGrid(const Box2& box)
{
    // Coordinates are at most 2^51 pixels, so that centers and corners have at most 53 bits.
    const double size = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
    const double greatest = std::max({std::fabs(box.min.x), std::fabs(box.min.y),
                                      std::fabs(box.max.x), std::fabs(box.max.y)});
    const double least = std::max(size * 0x1p-44, greatest * 0x1p-51);
    side_ = std::ldexp(1.0, std::ilogb(least) + 1);
}

double PixelGrid::centerOf(double coordinate) const
{
    const double inPixels = coordinate / side_;
    const double whole = std::floor(inPixels);
    return (inPixels - whole >= 0.5 ? whole + 1.0 : whole) * side_;
}

Vec2 PixelGrid::centerOf(Vec2 p) const
{
    return {centerOf(p.x), centerOf(p.y)};
}

Vec2 PixelGrid::centerOfCrossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2 p) const
{
    // Rounding is monotone: unless the rounded crossing is exactly on a pixel's lower border, it is
    // in the same pixel as the true one.
    Vec2 center = centerOf(p);
    if (p.x == center.x - 0.5 * side_ && compareCrossing(a, b, c, d, Axis::X, p.x) < 0) {
        center.x -= side_;
    }
    if (p.y == center.y - 0.5 * side_ && compareCrossing(a, b, c, d, Axis::Y, p.y) < 0) {
        center.y -= side_;
    }
    return center;
}

bool PixelGrid::meets(Vec2 a, Vec2 b, Vec2 center) const
{
    const double half = 0.5 * side_;
    const Vec2 low {center.x - half, center.y - half};
    const Vec2 high {center.x + half, center.y + half};
    if (std::max(a.x, b.x) < low.x || std::min(a.x, b.x) >= high.x || std::max(a.y, b.y) < low.y
        || std::min(a.y, b.y) >= high.y) {
        return false;
    }
    if (a.x == b.x || a.y == b.y) {
        return true;
    }
    // The line separates two opposite corners or passes beside the pixel. The upper right, upper
    // left and lower right corners do not belong to it: a line just through one of those misses it.
    if (a.x > b.x) {
        std::swap(a, b);
    }
    return a.y < b.y
        ? orient2d(a, b, {low.x, high.y}) > 0 && orient2d(a, b, {high.x, low.y}) < 0
        : orient2d(a, b, high) > 0 && orient2d(a, b, low) <= 0;
}

int PixelGrid::compareAlong(Vec2 a, Vec2 b, Vec2 center1, Vec2 center2)
{
    // The segment runs through each pixel once and never backward in x or y.
    const auto compare = [](double from, double to, double v1, double v2) {
        return v1 == v2 ? 0 : ((v1 < v2) == (from < to) ? -1 : 1);
    };
    const int x = compare(a.x, b.x, center1.x, center2.x);
    return x != 0 ? x : compare(a.y, b.y, center1.y, center2.y);
}

} // namespace tessera
