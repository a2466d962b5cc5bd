// SPDX-License-Identifier: MIT
#include "arrange/cross_straight.h"

#include "arrange/cross_curves.h"
#include "arrange/weld.h"
#include "delaunay/delaunay.h"

#include <algorithm>
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

/// By vertex of the recovered triangulation: its point of the network. Crossings get new points,
/// with a tolerance by the rules of weldMadePoints(): where many lines are drawn through one place,
/// rounding spreads their crossings.
std::vector<PointId> pointsOfVertices(CurveNetwork& network, const StraightPart& part,
                                      double tolerance, const Execution& execution)
{
    const auto& positions = part.recovered.triangulation.points;
    const std::size_t inputPoints = network.points.size();
    std::vector<PointId> pointOf(positions.size());
    for (std::size_t p = 0; p < inputPoints; ++p) {
        PointId& point = pointOf[part.vertexOfPoint[p]];
        network.points[p] = positions[part.vertexOfPoint[p]];
        if (!point.valid()) {
            point = PointId(p);
        }
    }
    std::vector<std::uint32_t> crossings;
    std::vector<Vec2> places = network.points;
    for (auto v = part.recovered.firstCrossing; v < positions.size(); ++v) {
        if (!pointOf[v].valid()) {
            crossings.push_back(v);
            places.push_back(positions[v]);
        }
    }
    WeldResult weld;
    if (tolerance > 0.0) {
        weld = weldMadePoints(places, {inputPoints, inputPoints}, tolerance,
                              roundingDistance(network), execution);
    }
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const std::size_t place = inputPoints + i;
        const std::size_t first = tolerance > 0.0 ? weld.representative[place] : place;
        pointOf[crossings[i]] = first == place   ? network.addPoint(places[place])
            : first < inputPoints                ? PointId(first)
                                                 : pointOf[crossings[first - inputPoints]];
    }
    return pointOf;
}

/// The points that a constraint runs through, each once in a row.
std::vector<PointId> stopsOf(const StraightPart& part, ConstraintId constraint,
                             const std::vector<PointId>& pointOf)
{
    std::vector<PointId> stops;
    for (const std::uint32_t v : part.recovered.constraints.chainOf(constraint)) {
        if (stops.empty() || stops.back() != pointOf[v]) {
            stops.push_back(pointOf[v]);
        }
    }
    return stops;
}

} // namespace

void crossStraightCurves(CurveNetwork& network, const ArrangeOptions& options,
                         ArrangeReport& report, Execution& execution)
{
    const StraightPart part = recoverStraight(network, options, execution);
    const std::size_t touches = report.crossed.touches;
    report.crossed = part.recovered.report;
    report.crossed.touches += touches;
    const double tolerance =
        std::max(options.weld, 16.0 * meetingDistance(network, options.weld));
    const std::size_t inputPoints = network.points.size();
    const std::vector<PointId> pointOf = pointsOfVertices(network, part, tolerance, execution);
    report.crossed.crossings = network.points.size() - inputPoints;

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
        const std::vector<PointId> stops = stopsOf(part, ConstraintId(constraint++), pointOf);
        if (stops.size() < 2) {
            add(curve, c); // zero length: sampling drops it and says so
        }
        for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
            curve.start = stops[i];
            curve.end = stops[i + 1];
            add(curve, c);
        }
    }
    network.curves = std::move(pieces);
    network.curveNames = std::move(names);
    report.parent = std::move(parent);
}

} // namespace tessera
