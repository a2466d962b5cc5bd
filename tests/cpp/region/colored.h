// SPDX-License-Identifier: MIT
#pragma once

#include "arrange/arrange.h"
#include "curve/polyline.h"
#include "delaunay/delaunay.h"
#include "recover/recover.h"
#include "region/region.h"
#include "sample/sample.h"
#include "sizing/uniform_size.h"

#include <cmath>
#include <vector>

namespace tessera
{

using Ring = std::vector<Vec2>;

/// The stages up to the colors.
struct Colored
{
    CurveNetwork input;
    std::vector<CurveId> parent;
    CurveNetwork network;
    Pslg pslg;
    RecoveryResult recovered;
    RegionMap map;

    double areaInside() const
    {
        double sum = 0.0;
        for (const Region& region : map.regions) {
            sum += region.inside ? region.area : 0.0;
        }
        return sum;
    }
    double areaOf(OperandId operand) const
    {
        double sum = 0.0;
        for (const Region& region : map.regions) {
            for (const OperandId o : region.operands) {
                sum += o == operand ? region.area : 0.0;
            }
        }
        return sum;
    }
};

inline void recolor(Colored& colored, FillRule fill)
{
    Execution execution;
    colored.map = colorRegions(colored.recovered, colored.network, colored.pslg, fill, execution);
}

/// Straight curves are left whole unless asked.
inline Colored color(const CurveNetwork& network, FillRule fill, double size = 1e9,
                     bool cutStraight = false,
                     RecoveryStrategy strategy = RecoveryStrategy::Cavity)
{
    Execution execution;
    ArrangeReport report;
    Colored colored;
    colored.input = network;
    colored.network = arrange(network, {}, report, execution);
    colored.parent = report.parent;
    colored.pslg = sample(colored.network, UniformSize(size),
                          {.straightSegments = cutStraight, .piecesPerTurn = 16}, execution);
    DelaunayResult delaunay = triangulate(colored.pslg.points, execution);
    std::vector<ConstraintEnds> ends;
    for (const PslgSegment& segment : colored.pslg.segments) {
        ends.push_back({delaunay.vertexOfPoint[segment.a.index()],
                        delaunay.vertexOfPoint[segment.b.index()]});
    }
    colored.recovered = recoverBoundaries(std::move(delaunay.triangulation), ends, strategy,
                                          execution);
    recolor(colored, fill);
    return colored;
}

/// A network with the given number of operands and nothing else.
inline CurveNetwork emptyNetwork(std::size_t operands)
{
    CurveNetwork network;
    network.operands.resize(operands);
    return network;
}

inline void addRing(CurveNetwork& network, const Ring& ring, std::uint32_t operand = 0,
                    Role role = Role::Boundary)
{
    addPolyline(network, ring, true, OperandId(operand), role);
}

inline Ring rectangle(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline Ring reversed(Ring ring)
{
    return {ring.rbegin(), ring.rend()};
}

inline double shoelace(const Ring& ring)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    }
    return 0.5 * twice;
}

/// Winding number of a ring around p, by counting signed crossings of the ray to the right.
inline int windingAround(const Ring& ring, Vec2 p)
{
    int winding = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i];
        const Vec2 b = ring[(i + 1) % ring.size()];
        if ((a.y <= p.y) != (b.y <= p.y)) {
            const double side = cross(b - a, p - a);
            winding += a.y <= p.y ? (side > 0.0 ? 1 : 0) : (side < 0.0 ? -1 : 0);
        }
    }
    return winding;
}

} // namespace tessera
