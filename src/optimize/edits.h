// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"
#include "optimize/star.h"

namespace tessera
{

/// True if every triangle around the star's center stays strictly counter-clockwise with the
/// center at p. Exact.
bool isValidCenter(const Star& star, Vec2 p);

/// True if every triangle that remains is strictly counter-clockwise when the center is merged into
/// ring vertex target. Exact.
bool isValidCollapse(const Star& star, int target);

/// Merges the star's center into ring vertex target: two triangles and the center die (its incident
/// becomes Topology::kDead). Precondition: isValidCollapse, no edge at the center is constrained.
void collapse(Triangulation& triangulation, const Star& star, int target);

} // namespace tessera
