// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/delaunay.h"

namespace tessera
{

/// Where a point is in a closed triangle, from its orientation to each side: all >= 0, not all 0.
inline Location placeInTriangle(std::uint32_t triangle, const int (&sign)[3])
{
    int zeros = 0;
    HalfEdge zero = 0;
    HalfEdge positive = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge edge = Topology::halfEdge(triangle, i);
        zeros += sign[i] == 0 ? 1 : 0;
        (sign[i] == 0 ? zero : positive) = edge;
    }
    switch (zeros) {
        case 0:
            return {Location::Kind::Triangle, positive};
        case 1:
            return {Location::Kind::Edge, zero};
        default:
            // The vertex opposite the one side that does not contain the point.
            return {Location::Kind::Vertex, Topology::prev(positive)};
    }
}

} // namespace tessera
