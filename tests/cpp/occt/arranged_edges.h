// SPDX-License-Identifier: MIT
// Edges arranged as a user's would be, and what every arrangement must fulfill.
#pragma once

#include "arrange/arrange.h"
#include "curve/curve_tools.h"
#include "occt/shape_network.h"

#include "random_edges.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace tessera::test
{

struct Crossed
{
    CurveNetwork network;
    ArrangeReport report;
    std::vector<std::uint32_t> edgeOf; ///< by curve of the network: number of the edge
};

inline Crossed arranged(const std::vector<Handle(Geom_Curve)>& curves, double weld)
{
    const CadOptions cad {.looseEdges = LooseEdges::Constraint};
    const CadInput input = networkFromShape(edgesOf(curves), cad);
    Crossed result;
    Execution execution;
    result.network = arrange(input.network, {.weld = weld, .crossStraight = true}, result.report,
                             execution);
    for (const NetworkCurve& curve : result.network.curves) {
        result.edgeOf.push_back(curve.source);
    }
    return result;
}

/// Points at which pieces of two different edges end.
inline std::vector<Vec2> meetings(const Crossed& crossed)
{
    std::map<std::uint32_t, std::set<std::uint32_t>> edgesAt;
    for (std::size_t c = 0; c < crossed.network.curves.size(); ++c) {
        edgesAt[crossed.network.curves[c].start.value].insert(crossed.edgeOf[c]);
        edgesAt[crossed.network.curves[c].end.value].insert(crossed.edgeOf[c]);
    }
    std::vector<Vec2> result;
    for (const auto& [point, edges] : edgesAt) {
        if (edges.size() > 1) {
            result.push_back(crossed.network.points[point]);
        }
    }
    return result;
}

/// The greatest distance of a piece's end from the point that it ends at.
inline double greatestResidual(const Crossed& crossed)
{
    double greatest = 0.0;
    for (const NetworkCurve& piece : crossed.network.curves) {
        if (piece.geometry) {
            const Curve& c = *piece.geometry;
            const auto& points = crossed.network.points;
            greatest = std::max({greatest, distance(c.point(c.first()), points[piece.start.index()]),
                                 distance(c.point(c.last()), points[piece.end.index()])});
        }
    }
    return greatest;
}

} // namespace tessera::test
