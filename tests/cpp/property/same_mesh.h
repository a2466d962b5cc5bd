// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace tessera::test
{

/// The vertices in the order of their positions, so that their numbers do not matter.
class VertexOrder
{
public:
    explicit VertexOrder(const Triangulation& mesh)
        : sorted_(mesh.vertexCount())
        , rank_(mesh.points.size())
    {
        std::iota(sorted_.begin(), sorted_.end(), 1U);
        std::sort(sorted_.begin(), sorted_.end(), [&mesh](std::uint32_t u, std::uint32_t v) {
            const Vec2 p = mesh.points[u];
            const Vec2 q = mesh.points[v];
            return p.x != q.x ? p.x < q.x : p.y < q.y;
        });
        for (std::uint32_t i = 0; i < sorted_.size(); ++i) {
            rank_[sorted_[i]] = i;
        }
    }
    /// The vertex at a place in the order.
    std::uint32_t operator[](std::size_t place) const { return sorted_[place]; }
    /// The same for the edge in all triangulations of these positions, seen from either side.
    std::uint64_t keyOf(const Triangulation& mesh, HalfEdge edge) const
    {
        const std::uint64_t u = rank_[mesh.origin(edge)];
        const std::uint64_t v = rank_[mesh.destination(edge)];
        return std::min(u, v) << 32 | std::max(u, v);
    }

private:
    std::vector<std::uint32_t> sorted_;
    std::vector<std::uint32_t> rank_;
};

/// The edges of a triangulation by the positions of their ends.
struct EdgeSets
{
    std::vector<std::uint64_t> all;
    std::vector<std::uint64_t> constrained;
    /// Those of every constrained Delaunay triangulation: constrained, on the hull, or with the
    /// opposite vertices strictly outside the circles.
    std::vector<std::uint64_t> certain;

    EdgeSets(const Triangulation& mesh, const VertexOrder& order)
    {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (std::uint32_t i = 0; i < 3 && mesh.isFinite(t); ++i) {
                add(mesh, Topology::halfEdge(t, i), order);
            }
        }
        for (auto* keys : {&all, &constrained, &certain}) {
            std::sort(keys->begin(), keys->end());
        }
    }

private:
    void add(const Triangulation& mesh, HalfEdge edge, const VertexOrder& order)
    {
        const HalfEdge twin = mesh.twin(edge);
        const bool onHull = mesh.isGhost(Topology::triangleOf(twin));
        if (!onHull && twin < edge) {
            return; // seen from the other side
        }
        const std::uint64_t key = order.keyOf(mesh, edge);
        all.push_back(key);
        if (mesh.isConstrained(edge)) {
            constrained.push_back(key);
        }
        if (mesh.isConstrained(edge) || onHull
            || incircle(mesh.points[mesh.apex(edge)], mesh.points[mesh.origin(edge)],
                        mesh.points[mesh.destination(edge)], mesh.points[mesh.apex(twin)])
                < 0) {
            certain.push_back(key);
        }
    }
};

/// Empty if both are the same constrained Delaunay triangulation up to cocircular ties; otherwise
/// what differs.
inline std::string meshDifference(const Triangulation& a, const Triangulation& b)
{
    if (a.points.size() != b.points.size()) {
        return std::to_string(a.points.size()) + " and " + std::to_string(b.points.size())
            + " points";
    }
    const VertexOrder orderA(a);
    const VertexOrder orderB(b);
    for (std::size_t i = 0; i < a.vertexCount(); ++i) {
        if (!(a.points[orderA[i]] == b.points[orderB[i]])) {
            return "different positions";
        }
    }
    const EdgeSets ofA(a, orderA);
    const EdgeSets ofB(b, orderB);
    if (ofA.constrained != ofB.constrained) {
        return "different constrained edges";
    }
    const auto contains = [](const auto& edges, const auto& others) {
        return std::includes(edges.begin(), edges.end(), others.begin(), others.end());
    };
    if (!contains(ofA.all, ofB.certain) || !contains(ofB.all, ofA.certain)) {
        return "an edge that is no cocircular tie is in one only";
    }
    return {};
}

} // namespace tessera::test
