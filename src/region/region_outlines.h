// SPDX-License-Identifier: MIT
#pragma once

#include "region/region.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// A connected set of triangles of one label, by its borders: simple closed loops of vertices, the
/// first counter-clockwise around everything, the others clockwise around the holes. Loops touch
/// each other at vertices at most, and never cut the inside apart: a valid polygon by the rules of
/// OGC Simple Features.
struct RegionOutline
{
    std::uint32_t label;
    std::vector<std::vector<std::uint32_t>> loops;
};

/// Label of the regions that no outline is wanted of.
inline constexpr std::uint32_t kNoLabel = 0xffffffffU;

/// The outlines of every connected set of triangles whose regions have the same label. One label
/// for all selected regions gives their union, a label per region the cells. By label, then by the
/// lowest triangle. O(triangles) plus the turns around vertices where one outline passes twice.
std::vector<RegionOutline> regionOutlines(const RecoveryResult& recovered, const RegionMap& map,
                                          std::span<const std::uint32_t> labelOfRegion);

} // namespace tessera
