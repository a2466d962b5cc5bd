// SPDX-License-Identifier: MIT
#include "delaunay/start.h"

#include "predicates/predicates.h"

#include <utility>

namespace tessera
{

void startTriangles(Triangulation& t, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    if (orient2d(t.points[a], t.points[b], t.points[c]) < 0) {
        std::swap(b, c);
    }
    constexpr std::uint32_t inf = Topology::kInfinite;
    t.triangles = {{{a, b, c}, {}}, {{inf, c, b}, {}}, {{inf, a, c}, {}}, {{inf, b, a}, {}}};
    t.freeList.clear();
    for (std::uint32_t i = 0; i < 3; ++i) {
        // Ghost 1 + i lies beyond side i; its side 2 meets side 1 of the next one around infinity.
        t.join(Topology::halfEdge(0, i), Topology::halfEdge(1 + i, 0));
        t.join(Topology::halfEdge(1 + i, 1), Topology::halfEdge(1 + Topology::prev3(i), 2));
    }
    t.incident[a] = Topology::halfEdge(0, 2);
    t.incident[b] = Topology::halfEdge(0, 0);
    t.incident[c] = Topology::halfEdge(0, 1);
    t.incident[inf] = Topology::halfEdge(1, 2);
}

std::uint32_t appendVertex(Triangulation& t, Vec2 p)
{
    if (t.points.empty()) {
        t.points.push_back({});
        t.incident.push_back(Topology::kDead);
    }
    makeRoom(t.points);
    makeRoom(t.incident);
    t.points.push_back(p);
    t.incident.push_back(Topology::kDead);
    return static_cast<std::uint32_t>(t.points.size() - 1);
}

} // namespace tessera
