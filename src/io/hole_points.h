// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/mesh.h"

#include <vector>

namespace tessera
{

/// A point in every hole: in every bounded part of the plane that the mesh leaves free, away from
/// the nodes as far as a few tries reach. Holes narrower than rounding allows a point in may lack
/// theirs. O(outline edges) per hole.
std::vector<Vec2> holePoints(const Mesh& mesh);

} // namespace tessera
