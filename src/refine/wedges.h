// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"

#include <cmath>
#include <numbers>

namespace tessera
{

/// Calls wedge(arm, next arm, angle) for the constrained edges at v, counter-clockwise, where all
/// triangles between the two are kept. Angles in radians, 0 .. 2 pi.
template<class IsKept, class F>
void forEachWedge(const Triangulation& t, std::uint32_t v, IsKept&& isKept, F&& wedge)
{
    const HalfEdge first = t.incident[v];
    if (first == Topology::kDead) {
        return;
    }
    HalfEdge start = first;
    while (!t.isConstrained(start)) {
        start = t.nextAround(start);
        if (start == first) {
            return;
        }
    }
    const auto direction = [&](HalfEdge h) { return t.points[t.destination(h)] - t.points[v]; };
    HalfEdge arm = start;
    HalfEdge h = start;
    bool kept = true;
    do {
        kept = kept && isKept(Topology::triangleOf(h));
        h = t.nextAround(h);
        if (t.isConstrained(h)) {
            if (kept) {
                const Vec2 u = direction(arm);
                const Vec2 w = direction(h);
                const double angle = arm == h ? 0.0 : std::atan2(cross(u, w), dot(u, w));
                wedge(arm, h, angle > 0.0 ? angle : angle + 2.0 * std::numbers::pi);
            }
            arm = h;
            kept = true;
        }
    } while (h != start);
}

/// The greatest angle between constrained edges at which refinement treats their apex as acute.
inline constexpr double kAcuteWedge = std::numbers::pi / 3.0 - 1e-9;

} // namespace tessera
