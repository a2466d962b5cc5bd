// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "base/vec2.h"
#include "recover/chains.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// Segments routed over a fixed grid so that they meet at vertices only.
struct SnapResult
{
    std::vector<Vec2> points;             ///< different pixel centers, those of input points first
    std::size_t inputCount = 0;           ///< how many of the points are those of input points
    std::vector<std::uint32_t> pointOf;   ///< by input point: its index in points
    Chains chains;                        ///< its vertices are indices in points
    double pixel = 0.0;                   ///< side of the grid's squares
    double maxDisplacement = 0.0;         ///< of an input point or a crossing
};

/// Snap rounding of the segments between the given points ([0] unused, as in a Triangulation), not
/// all equal; see the head of snap_rounding.cpp. Total. Segments have different ends.
SnapResult snapRound(std::span<const Vec2> points, std::span<const Segment> segments,
                     Execution& execution);

} // namespace tessera
