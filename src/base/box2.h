// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <algorithm>
#include <limits>

namespace tessera
{

/// Axis-parallel box; empty (min > max) until a point is added.
struct Box2
{
    Vec2 min {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec2 max {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    constexpr bool empty() const { return !(min.x <= max.x && min.y <= max.y); }
    constexpr void add(Vec2 p)
    {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    constexpr void add(const Box2& other)
    {
        if (!other.empty()) {
            add(other.min);
            add(other.max);
        }
    }
    constexpr Box2 grown(double margin) const
    {
        return {{min.x - margin, min.y - margin}, {max.x + margin, max.y + margin}};
    }
    constexpr bool contains(Vec2 p) const
    {
        return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y;
    }
    constexpr bool overlaps(const Box2& o) const
    {
        return min.x <= o.max.x && o.min.x <= max.x && min.y <= o.max.y && o.min.y <= max.y;
    }
    constexpr Vec2 center() const { return midpoint(min, max); }
    /// Length of the diagonal; 0 for an empty box.
    double diagonal() const { return empty() ? 0.0 : distance(min, max); }
};

} // namespace tessera
