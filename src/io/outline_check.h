// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tessera
{

/// A side of the outline: the mesh lies to the left of a -> b.
using OutlineSide = std::array<std::uint32_t, 2>;

/// What is wrong with an outline.
struct OutlineProblem
{
    enum class Kind
    {
        Hanging,  ///< node lies on side[0], whose element does not have it
        Crossing, ///< side[0] and side[1] cross, overlap, or one ends on the other
        Covered,  ///< the mesh covers the plane beside side[0] more than once, or its outside
    };
    Kind kind;
    std::uint32_t node = 0;
    std::array<std::size_t, 2> side {}; ///< indices into the sides
};

/// Nodes that hang on a side: those of a chain of outline sides that leads back from the side's
/// end to its start along it, all exactly on it, as near as rounding puts them, or nearer than the
/// given part of the side's length. O(n log n).
std::vector<OutlineProblem> findHangingNodes(std::span<const Vec2> points,
                                             std::span<const OutlineSide> sides, double part = 0.0);

/// Sweeps over the outline and finds its first crossing, or, if nothing crosses, all sides with a
/// wrong covering: what lies left of each must be covered once, what lies right of it not at all.
/// Where all elements are counter-clockwise and every inner side is used once in each direction,
/// this proves that no elements overlap, since the number of elements over a point is the winding
/// number of the outline. Exact. O(n log n).
std::vector<OutlineProblem> sweepOutline(std::span<const Vec2> points,
                                         std::span<const OutlineSide> sides);

} // namespace tessera
