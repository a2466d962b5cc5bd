// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "base/vec2.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// Which points become one.
struct WeldResult
{
    /// By point: the lowest-numbered point of its cluster; itself if it is in none or not wanted.
    std::vector<std::uint32_t> representative;
    /// The lowest-numbered point of each chain that is too long to be merged.
    std::vector<std::uint32_t> chainsLeft;
};

/// Clusters: points linked by steps of at most tolerance. A cluster at most twice the tolerance
/// across is merged, a longer one (a chain) is left as it is. Takes the points p with wanted[p].
/// Depends on the positions and their order only. Precondition: finite points, tolerance >= 0.
WeldResult weldPoints(std::span<const Vec2> points, std::span<const std::uint8_t> wanted,
                      double tolerance, const Execution& execution);

} // namespace tessera
