// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tessera
{

/// Where an odd number of an operand's curves end: there an outline is open.
struct FreeEnd
{
    std::uint32_t point;
    std::uint32_t curve;
};

/// The free ends of an arranged network's curves that are meshed; of those with wanted[curve] only,
/// if it is not empty. O(curves log curves).
std::vector<FreeEnd> findFreeEnds(const CurveNetwork& network, std::span<const std::uint8_t> wanted);

/// The two closest to each other; none if there are fewer than two. O(n log n) unless most are
/// about equally far apart.
std::optional<std::pair<FreeEnd, FreeEnd>> closestPair(std::vector<FreeEnd> ends,
                                                       const CurveNetwork& network);

/// "(0, 0) of Sketch_Geometry0 and (0, 0.1) of Sketch_Geometry3, 0.1 apart".
std::string describePair(const std::pair<FreeEnd, FreeEnd>& pair, const CurveNetwork& network);

} // namespace tessera
