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

/// Numbers of points in the order of what they are: of the input, ends of overlaps, crossings.
struct MadePoints
{
    std::size_t inputCount;
    std::size_t firstCrossing;
};

/// Which of the points that were made where curves meet become one. One within the weld tolerance of
/// a point of the input, by the rule of clusters above, becomes that point; ends of overlaps within
/// it of each other become one. Crossings stay where they are, on their curves, unless they are
/// closer to each other than the rounding tolerance: then they are one crossing of many curves, at
/// the middlemost place (nearest to the medians of both coordinates), since those of almost
/// parallel curves are the worst known. Moves those representatives in points. O(n log n).
WeldResult weldMadePoints(std::span<Vec2> points, const MadePoints& made, double tolerance,
                          double rounding, const Execution& execution);

} // namespace tessera
