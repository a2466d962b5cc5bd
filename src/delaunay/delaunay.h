// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "base/execution.h"
#include "delaunay/triangulation.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// The paper's initial triangulated rectangle (Algorithm 1, step 1; Fig. 2a): four corners around
/// the whole domain and the two triangles between them. The kernel inserts points with these
/// corners moved to infinity, where they merge into Topology::kInfinite, so that they leave no
/// trace: inside the convex hull the triangles are those of the Delaunay triangulation of the
/// points alone. completeToRectangle() brings the finite corners back, for pictures and for the
/// area outside.
struct InitialRectangle
{
    Vec2 corner[4];               ///< counter-clockwise from the lower left
    std::uint32_t triangle[2][3]; ///< indices into corner
};

/// A rectangle around box with a margin of half its larger side on every side.
InitialRectangle makeInitialRectangle(const Box2& box);

struct DelaunayResult
{
    Triangulation triangulation;
    /// Vertex of each input point; equal points share one.
    std::vector<std::uint32_t> vertexOfPoint;
    /// Number of input points that coincide with an earlier one.
    std::size_t duplicates = 0;
};

/// Delaunay triangulation of any finite points, by Bowyer–Watson insertion in a biased randomized
/// (BRIO) + Hilbert order. Vertices are numbered along that order, from 1. Exact and
/// deterministic. Throws Error(InvalidInput) for a coordinate that is not finite or out of range
/// (see predicates/range.h).
DelaunayResult triangulate(std::span<const Vec2> points, Execution& execution);

/// Adds the rectangle's corners as vertices and triangulates the ring between them and the convex
/// hull, leaving every triangle inside the hull as it is. Returns the four vertices. Precondition:
/// the hull lies strictly inside the rectangle.
std::array<std::uint32_t, 4> completeToRectangle(Triangulation& triangulation,
                                                 const InitialRectangle& rectangle);

/// Where a point is in a triangulation.
struct Location
{
    enum class Kind
    {
        Triangle, ///< strictly inside triangleOf(edge); a ghost: strictly outside that hull edge
        Edge,     ///< strictly inside edge
        Vertex,   ///< at origin(edge)
    };
    Kind kind;
    HalfEdge edge;
};

/// Exact location by a walk from the hint (a half-edge of any live triangle); always ends.
/// Precondition: there are triangles.
Location locate(const Triangulation& triangulation, Vec2 p, HalfEdge hint);

/// Inserts p where it is, with a conflict region that never reaches across a constrained edge
/// (Bowyer–Watson on the visible part: the result is constrained Delaunay if it was before). A
/// point on a constrained edge splits it; both halves stay constrained. Returns the vertex, which
/// is an existing one if p equals it. No allocation but the growth of the arrays; slots are reused.
/// The hint is not read when there are no triangles; then each insertion costs O(n).
std::uint32_t insertPoint(Triangulation& triangulation, Vec2 p, HalfEdge hint);
std::uint32_t insertPointAt(Triangulation& triangulation, Vec2 p, const Location& where);

/// Replaces the edge by the other diagonal of its two triangles. Precondition: not constrained,
/// both triangles finite or the flip valid for the hull. Returns the new diagonal.
HalfEdge flip(Triangulation& triangulation, HalfEdge edge);

/// Lawson: flips edges that are not locally (constrained) Delaunay until all around the given
/// half-edges are. Exact; ties stay as they are. Appends the four corners around each flip to
/// changed, if given.
void legalize(Triangulation& triangulation, std::vector<HalfEdge>& suspects,
              std::vector<std::uint32_t>* changed = nullptr);

/// Every violated invariant as a sentence; empty when the triangulation is valid. Checks links,
/// orientation, Euler's formula, the convex hull and, if asked, the exact (constrained) Delaunay
/// property. A vertex whose incident is kDead counts as removed if no triangle has it. O(n).
std::vector<std::string> verify(const Triangulation& triangulation, bool checkDelaunay = true);

} // namespace tessera
