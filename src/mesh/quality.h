// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/mesh.h"
#include "sizing/size_field.h"

#include <cstdint>

namespace tessera
{

/// Quality of the corner triangles; angles in degrees.
struct QualityReport
{
    double minAngle = 0.0;
    double maxAngle = 0.0;
    double angleP01 = 0.0;    ///< 1st percentile of each triangle's smallest angle
    double minQuality = 0.0;  ///< q = 4 sqrt(3) area / sum of squared edges; 1 is equilateral
    double meanQuality = 0.0;
    std::uint32_t worstTriangle = 0; ///< the one with the smallest angle

    /// Edge length / h at the edge's middle, each edge once.
    struct Conformity
    {
        double min = 0.0, p05 = 0.0, median = 0.0, p95 = 0.0, max = 0.0;
    } sizeConformity;
};

/// q of one triangle; negative if clockwise, 0 if degenerate.
double triangleQuality(Vec2 a, Vec2 b, Vec2 c);

/// Smallest and largest angle of one triangle, degrees.
struct AngleRange
{
    double smallest;
    double largest;
};
AngleRange triangleAngles(Vec2 a, Vec2 b, Vec2 c);

/// All zeros for an empty mesh. O(n). Without a size field the conformity stays 0.
QualityReport measureQuality(const Mesh& mesh, const SizeField* size);

} // namespace tessera
