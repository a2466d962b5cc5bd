// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tessera
{

/// A straight piece to recover: two different vertices. Constraints with the same ends share one.
struct Segment
{
    std::uint32_t a;
    std::uint32_t b;
};

/// Through which vertices each segment runs, while that still changes.
///
/// One node for each incidence (segment, vertex). The nodes of a segment form a list from a to b.
/// Two vertices joined by consecutive nodes of a segment are, or are about to be, joined by a mesh
/// edge; several segments may use one edge. Knows no positions and no half-edges: flips and new
/// triangles leave it alone.
///
///     segment s:  a -- v -- w -- b        previous, next
///                      |
///                 other segments at v
///
/// The first two nodes of a vertex are in its cell and are numbered 2 v and 2 v + 1, so that most
/// neighbors are known without looking further; a list has those beyond.
class Chains
{
public:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    /// An edge's piece of one segment, seen from the edge's first vertex.
    struct Use
    {
        std::uint32_t segment;
        std::uint32_t before; ///< the piece's first node on the way from the segment's a to its b
        bool forward;         ///< before is at the edge's first vertex
    };

    Chains() = default;
    Chains(std::size_t segmentCount, std::size_t vertexCount)
        : first_(segmentCount, kNone)
        , last_(segmentCount, kNone)
        , cells_(vertexCount)
    {}

    std::size_t segmentCount() const { return first_.size(); }
    std::size_t vertexCount() const { return cells_.size(); }
    std::size_t nodeCount() const { return nodeCount_; }

    std::uint32_t first(std::uint32_t segment) const { return first_[segment]; }
    std::uint32_t next(std::uint32_t n) const { return links(n).next; }
    std::uint32_t vertexOf(std::uint32_t n) const { return isFar(n) ? far(n).vertex : n >> 1; }

    /// Adds the vertex at the segment's end.
    void append(std::uint32_t segment, std::uint32_t vertex);
    /// Adds the vertex after the given node, which is not its segment's last.
    void insertAfter(std::uint32_t n, std::uint32_t vertex);

    /// How many nodes are at the vertex.
    std::uint32_t degree(std::uint32_t vertex) const
    {
        return vertex < cells_.size() ? cells_[vertex].count : 0;
    }
    /// Calls f(node, segment, previous node, next node) for every node at the vertex; f must not
    /// add nodes.
    template<class F>
    void forEachAt(std::uint32_t vertex, F&& f) const
    {
        if (vertex >= cells_.size()) {
            return;
        }
        const Cell& cell = cells_[vertex];
        for (std::uint32_t k = 0; k < cell.count && k < kNear; ++k) {
            f(kNear * vertex + k, cell.near[k].segment, cell.near[k].previous, cell.near[k].next);
        }
        for (std::uint32_t n = cell.firstFar; n != kNone; n = far(n).nextAtVertex) {
            const Links& l = far(n).links;
            f(n, l.segment, l.previous, l.next);
        }
    }
    /// Calls f(Use) for every segment that runs along the edge u, v; f must not add nodes. Costs as
    /// much as the number of segments at the vertex with fewer.
    template<class F>
    void forEachUse(std::uint32_t u, std::uint32_t v, F&& f) const
    {
        const bool fromU = degree(u) <= kNear || degree(u) <= degree(v);
        const std::uint32_t there = fromU ? v : u;
        forEachAt(fromU ? u : v, [&](std::uint32_t n, std::uint32_t segment,
                                     std::uint32_t previous, std::uint32_t next) {
            if (next != kNone && vertexOf(next) == there) {
                f(Use {segment, n, fromU});
            }
            if (previous != kNone && vertexOf(previous) == there) {
                f(Use {segment, previous, !fromU});
            }
        });
    }
    /// Calls f(segment) for every segment through the vertex until one returns true.
    template<class F>
    bool anyAt(std::uint32_t vertex, F&& f) const
    {
        bool any = false;
        forEachAt(vertex, [&](std::uint32_t, std::uint32_t segment, std::uint32_t, std::uint32_t) {
            any = any || f(segment);
        });
        return any;
    }
    bool used(std::uint32_t u, std::uint32_t v) const
    {
        bool any = false;
        forEachUse(u, v, [&](const Use&) { any = true; });
        return any;
    }
    /// Calls f(vertex) for the vertices of a segment, from its a to its b.
    template<class F>
    void forEachVertex(std::uint32_t segment, F&& f) const
    {
        for (std::uint32_t n = first_[segment]; n != kNone; n = next(n)) {
            f(vertexOf(n));
        }
    }
    /// How many vertices each segment has.
    std::vector<std::uint32_t> lengths() const;

    /// Gives every vertex the number newName[vertex], below vertexCount; all are different.
    void renameVertices(std::span<const std::uint32_t> newName, std::size_t vertexCount);

private:
    static constexpr std::uint32_t kNear = 2;
    static constexpr std::uint32_t kFarBit = 0x80000000U;

    struct Links
    {
        std::uint32_t segment;
        std::uint32_t previous;
        std::uint32_t next;
    };
    struct alignas(32) Cell
    {
        Links near[kNear];
        std::uint32_t firstFar = kNone;
        std::uint32_t count = 0;
    };
    struct FarNode
    {
        Links links;
        std::uint32_t vertex;
        std::uint32_t nextAtVertex;
    };

    static bool isFar(std::uint32_t n) { return (n & kFarBit) != 0; }
    const FarNode& far(std::uint32_t n) const { return far_[n & ~kFarBit]; }
    const Links& links(std::uint32_t n) const
    {
        return isFar(n) ? far(n).links : cells_[n >> 1].near[n & 1U];
    }
    Links& links(std::uint32_t n) { return const_cast<Links&>(std::as_const(*this).links(n)); }
    std::uint32_t addNode(std::uint32_t vertex, const Links& links);

    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> last_;
    std::vector<Cell> cells_;
    std::vector<FarNode> far_;
    std::size_t nodeCount_ = 0;
};

} // namespace tessera
