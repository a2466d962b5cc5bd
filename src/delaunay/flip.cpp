// SPDX-License-Identifier: MIT

// Edge flips and Lawson's algorithm (C. L. Lawson, "Software for C1 surface interpolation", 1977).
//
// Guarantee: legalize() ends, because each flip of an edge that is not locally Delaunay lowers the
// lifted surface strictly and there are finitely many triangulations; ties are left alone. All
// decisions are exact. An edge that fails the in-circle test always has a strictly convex
// quadrilateral, so no flip turns a triangle over.
// Cost: constant per flip; at most quadratic in all, in practice a few flips per suspect.

#include "delaunay/delaunay.h"
#include "predicates/predicates.h"

namespace tessera
{
namespace
{

/// Both sides finite, not constrained, and the opposite vertex strictly inside the circle.
bool mustFlip(const Triangulation& t, HalfEdge edge)
{
    if (t.isConstrained(edge)) {
        return false;
    }
    const HalfEdge twin = t.twin(edge);
    if (t.isGhost(Topology::triangleOf(edge)) || t.isGhost(Topology::triangleOf(twin))) {
        return false;
    }
    return incircle(t.points[t.apex(edge)], t.points[t.origin(edge)],
                    t.points[t.destination(edge)], t.points[t.apex(twin)])
        > 0;
}

} // namespace

//          c                          c
//        /   \                      / | \          .
//       a --> b   edge             a  |  b         The diagonal a b becomes d c: the triangle
//        \   /                      \ | /          of `edge` keeps c and a, the other d and b.
//          d                          d
HalfEdge flip(Triangulation& t, HalfEdge edge)
{
    const HalfEdge twin = t.twin(edge);
    const std::uint32_t left = Topology::triangleOf(edge);
    const std::uint32_t right = Topology::triangleOf(twin);
    const std::uint32_t i = Topology::sideOf(edge);
    const std::uint32_t j = Topology::sideOf(twin);
    const std::uint32_t a = t.origin(edge);
    const std::uint32_t b = t.destination(edge);
    const std::uint32_t c = t.apex(edge);
    const std::uint32_t d = t.apex(twin);
    const HalfEdge bc = Topology::next(edge);
    const HalfEdge ad = Topology::next(twin);
    const HalfEdge bcOuter = t.twin(bc);
    const HalfEdge adOuter = t.twin(ad);
    const bool bcConstrained = t.isConstrained(bc);
    const bool adConstrained = t.isConstrained(ad);

    t.triangles[left].v[Topology::prev3(i)] = d;
    t.triangles[right].v[Topology::prev3(j)] = c;
    t.join(edge, adOuter, adConstrained);
    t.join(twin, bcOuter, bcConstrained);
    t.join(bc, ad); // the slots of the sides opposite a and b now hold the new diagonal
    t.incident[a] = edge;
    t.incident[b] = twin;
    return bc;
}

void legalize(Triangulation& t, std::vector<HalfEdge>& suspects,
              std::vector<std::uint32_t>* changed)
{
    // A flip moves two of the four outer edges to other handles; all four are checked again, so
    // that a handle waiting in the list may come to name another edge, never lose one.
    while (!suspects.empty()) {
        const HalfEdge edge = suspects.back();
        suspects.pop_back();
        if (t.isDead(Topology::triangleOf(edge)) || !mustFlip(t, edge)) {
            continue;
        }
        const HalfEdge diagonal = flip(t, edge);
        const HalfEdge twin = t.twin(diagonal);
        if (changed != nullptr) {
            changed->insert(changed->end(), {t.origin(diagonal), t.apex(diagonal),
                                             t.destination(diagonal), t.apex(twin)});
        }
        suspects.push_back(Topology::next(diagonal));
        suspects.push_back(Topology::prev(diagonal));
        suspects.push_back(Topology::next(twin));
        suspects.push_back(Topology::prev(twin));
    }
}

} // namespace tessera
