// SPDX-License-Identifier: MIT
//
// The polygon's area, and for each edge that is the chord of a piece of a curve the area between
// the two: half the integral of (p - m) x p' over the piece, m the middle of the chord. Pieces are
// short (their sagitta is a small part of the whole), so that Gauss's rule of four points is exact
// to rounding.
#include "imprint/true_area.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tessera
{

namespace
{

constexpr std::array<std::pair<double, double>, 4> kGauss {{
    {-0.8611363115940526, 0.3478548451374538},
    {-0.3399810435848563, 0.6521451548625461},
    {0.3399810435848563, 0.6521451548625461},
    {0.8611363115940526, 0.3478548451374538},
}};

/// Between the piece of the curve from ta to tb and its chord; positive to the right of the chord.
double areaBeside(const Curve& curve, double ta, double tb)
{
    const Vec2 middle = midpoint(curve.point(ta), curve.point(tb));
    double sum = 0.0;
    for (const auto& [x, weight] : kGauss) {
        const double t = 0.5 * (ta + tb) + 0.5 * (tb - ta) * x;
        sum += weight * cross(curve.point(t) - middle, curve.derivative(t));
    }
    return 0.25 * (tb - ta) * sum;
}

/// As areaBeside() for the edge from vertex a to vertex b; 0 if it is no chord of a curve.
double correction(const OverlayResult& result, std::uint32_t a, std::uint32_t b)
{
    const ConstraintMap& constraints = result.recovered.constraints;
    const std::pair ends(std::min(a, b), std::max(a, b));
    const auto found = std::lower_bound(
        constraints.subsegments.begin(), constraints.subsegments.end(), ends,
        [](const Subsegment& s, const auto& wanted) { return std::pair(s.a, s.b) < wanted; });
    if (found == constraints.subsegments.end() || std::pair(found->a, found->b) != ends) {
        return 0.0;
    }
    for (const ConstraintUse& use : constraints.usesOf(*found)) {
        const PslgSegment& segment = result.pslg.segments[use.constraint.index()];
        const auto& curve = result.network().curves[segment.curve.index()].geometry;
        if (curve && constraints.chainOf(use.constraint).size() == 2) {
            const double area = areaBeside(*curve, segment.ta, segment.tb);
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
