// SPDX-License-Identifier: MIT
#pragma once

#include "predicates/predicates.h"
#include "recover/recovery_case.h"

#include <algorithm>
#include <set>
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

/// The same constrained Delaunay triangulation, up to cocircular ties.
inline void expectSameMesh(const Triangulation& a, const Triangulation& b)
{
    EXPECT_EQ(a.points.size(), b.points.size());
    const auto any = [](HalfEdge) { return true; };
    const auto constrained = [](const Triangulation& mesh) {
        return [&](HalfEdge e) { return mesh.isConstrained(e); };
    };
    const auto certain
        = [](const Triangulation& mesh) { return [&](HalfEdge e) { return isCertain(mesh, e); }; };
    EXPECT_TRUE(EdgeSet(a, constrained(a)) == EdgeSet(b, constrained(b)));
    EXPECT_TRUE(EdgeSet(a, any).contains(EdgeSet(b, certain(b))));
    EXPECT_TRUE(EdgeSet(b, any).contains(EdgeSet(a, certain(a))));
}

} // namespace tessera::test
