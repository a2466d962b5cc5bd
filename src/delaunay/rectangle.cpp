// SPDX-License-Identifier: MIT

// The paper's initial triangulated rectangle (Algorithm 1, step 1). The kernel works with its
// corners at infinity; here they come back.

#include "delaunay/delaunay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera
{

InitialRectangle makeInitialRectangle(const Box2& box)
{
    const Box2 domain = box.empty() ? Box2 {{0.0, 0.0}, {0.0, 0.0}} : box;
    const double larger
        = std::max(domain.max.x - domain.min.x, domain.max.y - domain.min.y);
    const double magnitude = std::max({std::fabs(domain.min.x), std::fabs(domain.min.y),
                                       std::fabs(domain.max.x), std::fabs(domain.max.y)});
    // A box that is a point, or so small that the margin would be lost in rounding, still needs
    // corners strictly outside.
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    double margin = std::max(0.5 * larger, 4.0 * kEpsilon * magnitude);
    if (margin == 0.0) {
        margin = 1.0;
    }
    const Box2 outer = domain.grown(margin);
    return {{outer.min, {outer.max.x, outer.min.y}, outer.max, {outer.min.x, outer.max.y}},
            {{0, 1, 2}, {0, 2, 3}}};
}

std::array<std::uint32_t, 4> completeToRectangle(Triangulation& t,
                                                 const InitialRectangle& rectangle)
{
    // Hull edges count as constrained while the corners go in: so nothing inside changes.
    struct HullEdge
    {
        std::uint32_t a;
        std::uint32_t b;
    };
    std::vector<HullEdge> closed;
    for (std::uint32_t triangle = 0; triangle < t.triangles.size(); ++triangle) {
        for (std::uint32_t i = 0; i < 3 && !t.isDead(triangle); ++i) {
            const HalfEdge h = Topology::halfEdge(triangle, i);
            if (t.apex(h) == Topology::kInfinite && !t.isConstrained(h)) {
                t.setConstrained(h, true);
                closed.push_back({t.origin(h), t.destination(h)});
            }
        }
    }
    std::array<std::uint32_t, 4> corners {};
    for (std::size_t i = 0; i < 4; ++i) {
        const HalfEdge hint = t.incident.empty() ? Topology::kDead : t.incident[0];
        corners[i] = insertPoint(t, rectangle.corner[i], hint);
    }
    for (const HullEdge& edge : closed) {
        t.setConstrained(t.findEdge(edge.a, edge.b), false);
    }
    return corners;
}

} // namespace tessera
