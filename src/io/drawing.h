// SPDX-License-Identifier: MIT
#pragma once

#include "io/canvas.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// Triangles to draw, each with a class (its region, say).
struct DrawnTriangles
{
    static constexpr std::uint32_t kNone = 0xffffffffU;

    std::span<const Vec2> points;
    std::vector<std::array<std::uint32_t, 3>> corners;
    std::vector<std::uint32_t> classOf; ///< by triangle, from 0
    /// Order 2: the mid nodes opposite the corners; empty otherwise.
    std::span<const std::array<std::uint32_t, 3>> middles;
};

/// An edge to draw; middle is kNone for a straight one. left and right are the classes of the
/// triangles beside it, kNone where there is none.
struct DrawnEdge
{
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t middle = DrawnTriangles::kNone;
    std::uint32_t left = DrawnTriangles::kNone;
    std::uint32_t right = DrawnTriangles::kNone;
};

/// The sides of the triangles, each once, ordered by their nodes. O(n log n).
std::vector<DrawnEdge> sidesOf(const DrawnTriangles& triangles);

/// Fills all triangles of each class as one area, so that no seams show.
void fillClasses(Canvas& canvas, std::span<const Vec2> points, std::span<const DrawnEdge> sides,
                 std::span<const Color> colorOfClass);

/// A color for each class, different from those of the classes beside it.
std::vector<Color> chooseColors(std::span<const DrawnEdge> sides, std::size_t classes);

/// Draws edges in long strokes, those outside the view left out. Width is in pixels, less for
/// edges shorter than fullLength pixels, so that fine parts do not turn black.
struct Pen
{
    Color color;
    double width = 1.0;
    double fullLength = 10.0;
    double leastWidth = 0.1;
};
void strokeEdges(Canvas& canvas, std::span<const Vec2> points, std::span<const DrawnEdge> edges,
                 const Pen& pen);

} // namespace tessera
