// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// Adds a mid node to every edge: on the true curve for edges on constraints (edgeMiddle, by mesh
/// edge), else the chord's middle. A mid node that would make the Jacobian of a 6-node triangle
/// non-positive anywhere is moved towards the chord until it is positive. Returns the edges for
/// which that was needed. Regions get the areas of the curved triangles. Proof of positivity: all six Bernstein coefficients of the (quadratic)
/// Jacobian determinant are positive.
std::vector<std::uint32_t> makeSecondOrder(Mesh& mesh, const std::vector<Vec2>& edgeMiddle);

/// The smallest Bernstein coefficient of the Jacobian determinant of a 6-node triangle: a lower
/// bound of the determinant over the triangle. Twice the area for straight edges.
double jacobianLowerBound(const Vec2 corner[3], const Vec2 middle[3]);

} // namespace tessera
