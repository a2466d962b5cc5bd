// SPDX-License-Identifier: MIT
#pragma once

#include "base/grow.h"
#include "base/vec2.h"
#include "delaunay/topology.h"

#include <span>
#include <vector>

namespace tessera
{

/// Topology plus positions. Invariants (verify() proves them): every finite triangle is
/// strictly counter-clockwise (exact), twins are mutual, ghost triangles close the convex hull.
/// When all points are collinear (or fewer than three) there are no triangles at all.
struct Triangulation: Topology
{
    std::vector<Vec2> points;              ///< by vertex; [kInfinite] is unused
    std::vector<std::uint32_t> incident;   ///< by vertex: a half-edge out of it, kDead if none
    std::vector<std::uint32_t> freeList;   ///< dead triangle slots

    std::size_t vertexCount() const { return points.empty() ? 0 : points.size() - 1; }

    /// A slot for a new triangle: a dead one, or one more. What it holds is undefined.
    std::uint32_t takeTriangle()
    {
        if (!freeList.empty()) {
            const std::uint32_t slot = freeList.back();
            freeList.pop_back();
            return slot;
        }
        makeRoom(triangles);
        triangles.push_back({});
        return static_cast<std::uint32_t>(triangles.size() - 1);
    }

    /// Calls f(half-edge) for every edge out of v, counter-clockwise once around.
    template<class F>
    void forEachAround(std::uint32_t v, F&& f) const
    {
        const HalfEdge first = incident[v];
        if (first == kDead) {
            return;
        }
        HalfEdge h = first;
        do {
            const HalfEdge following = nextAround(h);
            f(h);
            h = following;
        } while (h != first);
    }
    /// The half-edge from a to b, kDead if the two are not joined by an edge.
    HalfEdge findEdge(std::uint32_t a, std::uint32_t b) const
    {
        const HalfEdge first = a < incident.size() ? incident[a] : kDead;
        if (first == kDead) {
            return kDead;
        }
        HalfEdge h = first;
        do {
            if (destination(h) == b) {
                return h;
            }
            h = nextAround(h);
        } while (h != first);
        return kDead;
    }
};

} // namespace tessera
