// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tessera
{

/// Numbers for regions that follow from where they are, and not from how they are triangulated:
/// by their least corner (by x, then y), and regions with the same one counter-clockwise around it.
/// regionOfTriangle: below `count`, or kNoRegion. By region: its new number; region 0, the outer
/// one, keeps its own. O(triangles + regions log regions).
std::vector<std::uint32_t> orderOfRegions(const Triangulation& triangulation,
                                          const std::vector<std::uint32_t>& regionOfTriangle,
                                          std::size_t count);

inline constexpr std::uint32_t kNoRegion = 0xffffffffU;

} // namespace tessera
