// SPDX-License-Identifier: MIT
#include "arrange/cross_straight.h"

#include "delaunay/delaunay.h"

#include <utility>

namespace tessera
{

namespace
{

/// The straight curves as constraints of a triangulation of all points.
struct StraightPart
{
    std::vector<std::size_t> curves; ///< by constraint: index in the network
    RecoveryResult recovered;
    std::vector<std::uint32_t> vertexOfPoint;
};

StraightPart recoverStraight(const CurveNetwork& network, const ArrangeOptions& options,
                             Execution& execution)
{
    StraightPart part;
    DelaunayResult delaunay = triangulate(network.points, execution);
    std::vector<ConstraintEnds> ends;
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        const NetworkCurve& curve = network.curves[c];
        if (curve.geometry == nullptr && curve.role != Role::Ignored) {
            part.curves.push_back(c);
            ends.push_back({delaunay.vertexOfPoint[curve.start.index()],
                            delaunay.vertexOfPoint[curve.end.index()]});
        }
    }
    part.recovered = recoverBoundaries(std::move(delaunay.triangulation), ends, options.recovery,
                                       execution, options.observer);
    part.vertexOfPoint = std::move(delaunay.vertexOfPoint);
    for (std::uint32_t& v : part.vertexOfPoint) {
        v = part.recovered.vertexMap[v];
    }
    return part;
}

/// Gives every vertex of the recovered triangulation a point: the first of the network's that is
/// there, a new one for a crossing. Points follow their vertex where snap rounding moved it.
std::vector<PointId> pointsOfVertices(CurveNetwork& network, const StraightPart& part)
{
    const auto& positions = part.recovered.triangulation.points;
    std::vector<PointId> pointOf(positions.size());
    for (std::size_t p = 0; p < part.vertexOfPoint.size(); ++p) {
        PointId& point = pointOf[part.vertexOfPoint[p]];
        network.points[p] = positions[part.vertexOfPoint[p]];
        if (!point.valid()) {
            point = PointId(p);
        }
    }
    for (std::size_t v = part.recovered.firstCrossing; v < positions.size(); ++v) {
        if (!pointOf[v].valid()) {
            pointOf[v] = network.addPoint(positions[v]);
        }
    }
    return pointOf;
}

} // namespace

void crossStraightCurves(CurveNetwork& network, const ArrangeOptions& options,
                         ArrangeReport& report, Execution& execution)
{
    const StraightPart part = recoverStraight(network, options, execution);
    const std::size_t touches = report.crossed.touches;
    report.crossed = part.recovered.report;
    report.crossed.touches += touches;
    const std::vector<PointId> pointOf = pointsOfVertices(network, part);

    std::vector<NetworkCurve> pieces;
    std::vector<CurveId> parent;
    std::vector<std::string> names;
    const auto add = [&](const NetworkCurve& curve, std::size_t index) {
        pieces.push_back(curve);
        parent.push_back(report.parent[index]);
        if (!network.curveNames.empty()) {
            names.push_back(index < network.curveNames.size() ? network.curveNames[index] : "");
        }
    };
    std::size_t constraint = 0;
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        NetworkCurve curve = network.curves[c];
        if (constraint == part.curves.size() || part.curves[constraint] != c) {
            add(curve, c);
            continue;
        }
        const auto chain = part.recovered.constraints.chainOf(ConstraintId(constraint++));
        if (chain.size() < 2) {
            add(curve, c); // zero length: sampling drops it and says so
        }
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            curve.start = pointOf[chain[i]];
            curve.end = pointOf[chain[i + 1]];
            add(curve, c);
        }
    }
    network.curves = std::move(pieces);
    network.curveNames = std::move(names);
    report.parent = std::move(parent);
}

} // namespace tessera
