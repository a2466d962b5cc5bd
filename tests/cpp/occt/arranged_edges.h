// SPDX-License-Identifier: MIT
// Edges arranged as a user's would be, and what every arrangement must fulfill.
#pragma once

#include "arrange/arrange.h"
#include "curve/curve_tools.h"
#include "occt/shape_network.h"

#include "random_edges.h"

#include <algorithm>
#include <limits>
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

/// Pieces of two edges between the same two points and along the same way: of one geometry, or of
/// opposed ones that differ by rounding, at most by `most`.
inline std::size_t sharedPieces(const Crossed& crossed,
                                double most = std::numeric_limits<double>::infinity())
{
    const auto at = [](const Curve& c, double share) {
        return c.point((1.0 - share) * c.first() + share * c.last());
    };
    const auto same = [&](const NetworkCurve& a, const NetworkCurve& b) {
        const bool alike = a.start == b.start && a.end == b.end;
        const bool opposed = a.start == b.end && a.end == b.start;
        if (!a.geometry || !b.geometry) {
            return (alike || opposed) && !a.geometry && !b.geometry;
        }
        const Vec2 p = at(*a.geometry, 0.3);
        return (alike && a.geometry == b.geometry)
            || (opposed
                && distance(p, at(*b.geometry, 0.7))
                    <= std::min(most, 1e-14 * (length(p) + arcLength(*a.geometry))));
    };
    const auto& curves = crossed.network.curves;
    std::size_t shared = 0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        for (std::size_t j = 0; j < curves.size(); ++j) {
            shared += crossed.edgeOf[i] < crossed.edgeOf[j] && same(curves[i], curves[j]) ? 1 : 0;
        }
    }
    return shared;
}

/// A circle and an ellipse that start neither at an axis nor at the origin.
inline std::vector<Handle(Geom_Curve)> closedConics()
{
    const gp_Ax2 place(gp_Pnt(3, 4, 0), gp_Dir(0, 0, 1), gp_Dir(1, 1, 0));
    return {new Geom_Circle(place, 2.5), new Geom_Ellipse(place, 2.5, 1.0)};
}

} // namespace tessera::test
