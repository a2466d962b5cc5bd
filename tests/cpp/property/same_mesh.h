// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace tessera::test
{

/// Edges by the positions of their ends, so that vertex numbers do not matter.
class EdgeSet
{
public:
    using Key = std::pair<std::pair<double, double>, std::pair<double, double>>;

    /// select(half-edge): whether to take the edge.
    template<class Select>
    EdgeSet(const Triangulation& mesh, Select&& select)
    {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (std::uint32_t i = 0; i < 3 && mesh.isFinite(t); ++i) {
                const HalfEdge edge = Topology::halfEdge(t, i);
                if (select(edge)) {
                    keys_.push_back(key(mesh, edge));
                }
            }
        }
        std::sort(keys_.begin(), keys_.end());
        keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    }
    bool contains(const EdgeSet& other) const
    {
        return std::includes(keys_.begin(), keys_.end(), other.keys_.begin(), other.keys_.end());
    }
    friend bool operator==(const EdgeSet&, const EdgeSet&) = default;

private:
    static Key key(const Triangulation& mesh, HalfEdge edge)
    {
        const Vec2 a = mesh.points[mesh.origin(edge)];
        const Vec2 b = mesh.points[mesh.destination(edge)];
        return std::minmax(std::pair(a.x, a.y), std::pair(b.x, b.y));
    }
    std::vector<Key> keys_;
};

/// An edge of every constrained Delaunay triangulation: constrained, on the hull, or with the
/// opposite vertices strictly outside the circles.
inline bool isCertain(const Triangulation& mesh, HalfEdge edge)
{
    const HalfEdge twin = mesh.twin(edge);
    return mesh.isConstrained(edge) || mesh.isGhost(Topology::triangleOf(twin))
        || incircle(mesh.points[mesh.apex(edge)], mesh.points[mesh.origin(edge)],
                    mesh.points[mesh.destination(edge)], mesh.points[mesh.apex(twin)])
        < 0;
}

/// Empty if both are the same constrained Delaunay triangulation up to cocircular ties; otherwise
/// what differs.
inline std::string meshDifference(const Triangulation& a, const Triangulation& b)
{
    if (a.points.size() != b.points.size()) {
        return std::to_string(a.points.size()) + " and " + std::to_string(b.points.size())
            + " points";
    }
    const auto any = [](HalfEdge) { return true; };
    const auto constrained = [](const Triangulation& mesh) {
        return [&](HalfEdge e) { return mesh.isConstrained(e); };
    };
    const auto certain
        = [](const Triangulation& mesh) { return [&](HalfEdge e) { return isCertain(mesh, e); }; };
    if (EdgeSet(a, constrained(a)) != EdgeSet(b, constrained(b))) {
        return "different constrained edges";
    }
    if (!EdgeSet(a, any).contains(EdgeSet(b, certain(b)))
        || !EdgeSet(b, any).contains(EdgeSet(a, certain(a)))) {
        return "an edge that is no cocircular tie is in one only";
    }
    return {};
}

} // namespace tessera::test
