// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"
#include "region/region.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// Part of the triangles that no outline is wanted of.
inline constexpr std::uint32_t kNoPart = 0xffffffffU;

/// Connected sets of triangles by their borders, a polygon for each: simple closed loops of
/// vertices, the first counter-clockwise around everything, the others clockwise around the holes.
/// Loops touch each other at vertices at most, and never cut the inside apart: valid polygons by the
/// rules of OGC Simple Features.
struct Polygons
{
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> loopStart {0};    ///< into vertices
    std::vector<std::uint32_t> polygonStart {0}; ///< into the loops

    std::size_t size() const { return polygonStart.size() - 1; }
    std::size_t loopCount(std::size_t polygon) const
    {
        return polygonStart[polygon + 1] - polygonStart[polygon];
    }
    std::span<const std::uint32_t> loop(std::size_t polygon, std::size_t i) const
    {
        const std::size_t l = polygonStart[polygon] + i;
        return {vertices.data() + loopStart[l], loopStart[l + 1] - loopStart[l]};
    }
};

/// The outlines of the parts 0 .. partCount - 1. Precondition: each part's triangles are finite and
/// hang together by edges. O(triangles), plus a turn around each vertex where a part has several
/// corners.
Polygons partOutlines(const Triangulation& triangulation,
                      std::span<const std::uint32_t> partOfTriangle, std::size_t partCount);

} // namespace tessera
