// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "mesh/mesh.h"
#include "sizing/size_field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tessera
{

/// Quality of the corner triangles; angles in degrees.
struct QualityReport
{
    static constexpr int kAngleBins = 12;    ///< of 5 degrees, 0 .. 60
    static constexpr int kQualityBins = 20;  ///< of 0.05, 0 .. 1; below 0 counts as 0
    static constexpr std::size_t kWorst = 10;

    double minAngle = 0.0;
    double maxAngle = 0.0;
    double angleP01 = 0.0;    ///< 1st percentile of each triangle's smallest angle
    double minQuality = 0.0;  ///< q = 4 sqrt(3) area / sum of squared edges; 1 is equilateral
    double meanQuality = 0.0;
    std::array<std::size_t, kAngleBins> angleHistogram {}; ///< of each triangle's smallest angle
    std::array<std::size_t, kQualityBins> qualityHistogram {};

    /// The triangles with the smallest angles, the smallest first; at most kWorst.
    struct Worst
    {
        std::uint32_t triangle;
        Vec2 place; ///< centroid
        double angle;
        double quality;
    };
    std::vector<Worst> worst;

    /// Edge length / h at the edge's middle, each edge once; percentiles to single precision.
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
QualityReport measureQuality(const Mesh& mesh, const SizeField* size,
                             const Execution& execution = Execution());

} // namespace tessera
