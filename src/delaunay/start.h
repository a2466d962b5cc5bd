// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"

namespace tessera
{

/// Makes the first triangle and its three ghosts from vertices that are not collinear, in either
/// turn. Precondition: no triangles yet; points and incident have the vertices.
void startTriangles(Triangulation& triangulation, std::uint32_t a, std::uint32_t b,
                    std::uint32_t c);

/// Appends a vertex without connecting it; also makes room for the vertex at infinity.
std::uint32_t appendVertex(Triangulation& triangulation, Vec2 p);

} // namespace tessera
