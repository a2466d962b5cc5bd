// SPDX-License-Identifier: MIT

// Exact point location by a remembering stochastic walk (O. Devillers, S. Pion, M. Teillaud,
// "Walking in a Triangulation", IJFCS 13, 2002): from the hint's triangle cross any edge that has p
// strictly on its far side, never back over the one just crossed, in a random order of the edges.
//
// It ends: in a Delaunay triangulation no walk can cycle, whatever the order; in a constrained one
// a cycle is left with probability 1. The walk is cut after as many steps as there are triangles;
// then all triangles are tried in turn, which finds p because they and the ghosts cover the plane.
// Cost: about the square root of the number of triangles between hint and p.

#include "delaunay/delaunay.h"
#include "delaunay/place.h"
#include "predicates/predicates.h"

namespace tessera
{
namespace
{

int signOf(const Triangulation& t, HalfEdge edge, Vec2 p)
{
    return orient2d(t.points[t.origin(edge)], t.points[t.destination(edge)], p);
}

/// A finite triangle contains p, or p is strictly beyond a hull edge.
Location scan(const Triangulation& t, Vec2 p)
{
    Location outside {Location::Kind::Triangle, 0};
    for (std::uint32_t triangle = 0; triangle < t.triangles.size(); ++triangle) {
        if (!t.isFinite(triangle)) {
            continue;
        }
        int sign[3] = {};
        bool inside = true;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const HalfEdge edge = Topology::halfEdge(triangle, i);
            sign[i] = signOf(t, edge, p);
            if (sign[i] < 0) {
                inside = false;
                if (t.apex(t.twin(edge)) == Topology::kInfinite) {
                    outside.edge = t.twin(edge);
                }
            }
        }
        if (inside) {
            return placeInTriangle(triangle, sign);
        }
    }
    return outside;
}

} // namespace

Location locate(const Triangulation& t, Vec2 p, HalfEdge hint)
{
    std::uint32_t triangle = Topology::triangleOf(hint);
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (t.triangles[triangle].v[i] == Topology::kInfinite) {
            triangle = Topology::triangleOf(t.twin(Topology::halfEdge(triangle, i)));
            break;
        }
    }
    std::uint32_t random = hint;
    std::uint32_t entry = 3;
    for (std::size_t step = 0; step <= t.triangles.size(); ++step) {
        random = random * 1664525U + 1013904223U;
        int sign[3] = {1, 1, 1};
        HalfEdge exit = Topology::kDead;
        std::uint32_t i = (random >> 16) % 3U;
        for (int k = 0; k < 3; ++k, i = Topology::next3(i)) {
            if (i == entry) {
                continue; // crossed from its far side: p is strictly on this one
            }
            const HalfEdge edge = Topology::halfEdge(triangle, i);
            sign[i] = signOf(t, edge, p);
            if (sign[i] < 0) {
                exit = edge;
                break;
            }
        }
        if (exit == Topology::kDead) {
            return placeInTriangle(triangle, sign);
        }
        const HalfEdge other = t.twin(exit);
        if (t.apex(other) == Topology::kInfinite) {
            return {Location::Kind::Triangle, other};
        }
        triangle = Topology::triangleOf(other);
        entry = Topology::sideOf(other);
    }
    return scan(t, p);
}

} // namespace tessera
