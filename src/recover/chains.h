// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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
/// One node for each incidence (segment, vertex). The nodes of a segment form a list from a to b,
/// the nodes at a vertex another. Two vertices joined by consecutive nodes of a segment are, or are
/// about to be, joined by a mesh edge; several segments may use one edge. Knows no positions and no
/// half-edges: flips and new triangles leave it alone.
///
///     segment s:  a -- v -- w -- b        node.previous, node.next
///                      |
///                 other segments at v     node.nextAtVertex
class Chains
{
public:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    struct Node
    {
        std::uint32_t vertex;
        std::uint32_t segment;
        std::uint32_t previous;
        std::uint32_t next;
        std::uint32_t nextAtVertex;
    };

    /// An edge's piece of one segment, seen from the edge's first vertex.
    struct Use
    {
        std::uint32_t segment;
        std::uint32_t before; ///< the piece's first node on the way from the segment's a to its b
        bool forward;         ///< before is at the edge's first vertex
    };

    Chains(std::size_t segmentCount, std::size_t vertexCount)
        : first_(segmentCount, kNone)
        , last_(segmentCount, kNone)
        , atVertex_(vertexCount, kNone)
    {}

    const Node& node(std::uint32_t n) const { return nodes_[n]; }
    std::uint32_t first(std::uint32_t segment) const { return first_[segment]; }
    std::uint32_t last(std::uint32_t segment) const { return last_[segment]; }
    std::size_t nodeCount() const { return nodes_.size(); }

    /// Adds the vertex at the segment's end.
    void append(std::uint32_t segment, std::uint32_t vertex);
    /// Adds the vertex after the given node, which is not its segment's last.
    void insertAfter(std::uint32_t n, std::uint32_t vertex);

    /// Calls f(Use) for every segment that runs along the edge u, v. Costs as much as the shorter
    /// of the two vertices' lists.
    template<class F>
    void forEachUse(std::uint32_t u, std::uint32_t v, F&& f) const
    {
        const bool fromU = shorterList(u, v);
        const std::uint32_t here = fromU ? u : v;
        const std::uint32_t there = fromU ? v : u;
        for (std::uint32_t n = head(here); n != kNone; n = nodes_[n].nextAtVertex) {
            const Node& node = nodes_[n];
            if (node.next != kNone && nodes_[node.next].vertex == there) {
                f(Use {node.segment, n, fromU});
            }
            if (node.previous != kNone && nodes_[node.previous].vertex == there) {
                f(Use {node.segment, node.previous, !fromU});
            }
        }
    }
    /// Calls f(segment) for every segment through the vertex until it returns true.
    template<class F>
    bool anyAt(std::uint32_t vertex, F&& f) const
    {
        for (std::uint32_t n = head(vertex); n != kNone; n = nodes_[n].nextAtVertex) {
            if (f(nodes_[n].segment)) {
                return true;
            }
        }
        return false;
    }
    bool used(std::uint32_t u, std::uint32_t v) const
    {
        bool any = false;
        forEachUse(u, v, [&](const Use&) { any = true; });
        return any;
    }

    /// Gives a vertex another number that no node has.
    void renameVertex(std::uint32_t from, std::uint32_t to);

private:
    std::uint32_t head(std::uint32_t vertex) const
    {
        return vertex < atVertex_.size() ? atVertex_[vertex] : kNone;
    }
    std::uint32_t addNode(std::uint32_t segment, std::uint32_t vertex, std::uint32_t previous,
                          std::uint32_t next);
    bool shorterList(std::uint32_t u, std::uint32_t v) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> last_;
    std::vector<std::uint32_t> atVertex_;
};

} // namespace tessera
