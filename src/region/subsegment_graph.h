// SPDX-License-Identifier: MIT
#pragma once

#include "recover/recover.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// A subsegment in a direction: forward runs from its a to its b.
struct DirectedSubsegment
{
    std::uint32_t subsegment;
    bool forward;
};

/// The subsegments as a planar graph: the mesh edge of each, and how they turn around their
/// vertices. Any subset of them can be traced without looking at the other edges of the mesh.
/// Building: one pass over the triangles; the order around the vertices is found when the first
/// contour is asked for, in O(triangles around the vertices of subsegments).
class SubsegmentGraph
{
public:
    explicit SubsegmentGraph(const RecoveryResult& recovered);

    /// The half-edge from a to b; Topology::kDead if there are no triangles.
    HalfEdge halfEdge(std::uint32_t subsegment) const { return halfEdge_[subsegment]; }

    /// The outer contour of every connected part of a set of subsegments (no repetitions),
    /// counter-clockwise around it: the outside is on the right. An edge with the outside on both
    /// sides occurs in both directions. O(n log n).
    std::vector<std::vector<DirectedSubsegment>>
    outerContours(std::span<const std::uint32_t> subset) const;

    /// The closed loops that a balanced set of directed subsegments forms with its inside on the
    /// left, turning at each vertex through the outside. O(n log n).
    std::vector<std::vector<DirectedSubsegment>>
    loopsAroundOutside(std::span<const DirectedSubsegment> borders) const;

    std::uint32_t startOf(DirectedSubsegment s) const;
    std::uint32_t endOf(DirectedSubsegment s) const;

private:
    friend class SubsetTracer;

    void findHalfEdges();
    void rankAroundVertices() const;

    const RecoveryResult& recovered_;
    std::vector<std::uint32_t> firstAt_; ///< by vertex: the first subsegment with that a, one more
    std::vector<HalfEdge> halfEdge_;
    /// Place of each end in the counter-clockwise order around its vertex. It starts so that the
    /// neighbors lexicographically greater than the vertex come in one run, by angle.
    mutable std::vector<std::uint32_t> rankAtA_;
    mutable std::vector<std::uint32_t> rankAtB_;
};

} // namespace tessera
