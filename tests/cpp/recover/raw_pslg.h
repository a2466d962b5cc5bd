// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace tessera::test
{

/// Points and segments as a file has them: point numbers from 0, everything may cross.
struct RawPslg
{
    std::vector<Vec2> points;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> segments;

    std::uint32_t addPoint(Vec2 p)
    {
        points.push_back(p);
        return static_cast<std::uint32_t>(points.size() - 1);
    }
    void addSegment(Vec2 a, Vec2 b)
    {
        const std::uint32_t i = addPoint(a);
        segments.emplace_back(i, addPoint(b));
    }
};

} // namespace tessera::test
