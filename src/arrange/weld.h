// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "base/vec2.h"

#include <cstddef>
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

/// Puts the representative of each cluster of made points, from firstMade on, where its middlemost
/// member is (nearest to the medians of both coordinates): of many crossings that are one up to
/// rounding, those of almost parallel curves are the worst known. Clusters with a point of the
/// input keep its place. O(n log n).
void centerClusters(std::span<Vec2> points, std::span<const std::uint32_t> representative,
                    std::size_t firstMade);

} // namespace tessera
