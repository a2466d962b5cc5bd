// SPDX-License-Identifier: MIT
#include "imprint/true_area.h"

#include "curve/chord_area.h"
#include "recover/constraint_map.h"

namespace tessera
{

namespace
{

/// Between the edge from vertex a to vertex b and the piece of a curve whose chord it is, positive
/// where that is to the right; 0 if it is no chord of a curve.
double correction(const OverlayResult& result, std::uint32_t a, std::uint32_t b)
{
    const ConstraintMap& constraints = result.recovered.constraints;
    const Subsegment* edge = findSubsegment(constraints, a, b);
    if (edge == nullptr) {
        return 0.0;
    }
    for (const ConstraintUse& use : constraints.usesOf(*edge)) {
        const PslgSegment& segment = result.pslg.segments[use.constraint.index()];
        const auto& curve = result.network().curves[segment.curve.index()].geometry;
        if (curve && constraints.chainOf(use.constraint).size() == 2) {
            const double area = chordArea(*curve, segment.ta, segment.tb);
            return use.forward == (a < b) ? area : -area;
        }
    }
    return 0.0;
}

} // namespace

double trueArea(const OverlayResult& result, std::size_t polygon)
{
    double area = 0.0;
    for (std::size_t i = 0; i < result.polygons.loopCount(polygon); ++i) {
        const auto loop = result.polygons.loop(polygon, i);
        const Vec2 origin = result.point(loop[0]);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::uint32_t a = loop[k];
            const std::uint32_t b = loop[(k + 1) % loop.size()];
            area += 0.5 * cross(result.point(a) - origin, result.point(b) - origin);
            area += correction(result, a, b);
        }
    }
    return area;
}

} // namespace tessera
