// SPDX-License-Identifier: MIT
#include "region/no_inside.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace tessera
{

namespace
{

/// Where an odd number of an operand's curves end.
struct FreeEnd
{
    std::uint32_t point;
    std::uint32_t curve;
};

bool isMeshed(const NetworkCurve& curve)
{
    return curve.role != Role::Ignored;
}

bool bounds(const NetworkCurve& curve)
{
    return curve.role == Role::Boundary || curve.role == Role::Outline;
}

std::vector<FreeEnd> findFreeEnds(const CurveNetwork& network)
{
    std::map<std::pair<OperandId, PointId>, std::vector<std::uint32_t>> ends;
    for (std::uint32_t c = 0; c < network.curves.size(); ++c) {
        const NetworkCurve& curve = network.curves[c];
        if (isMeshed(curve)) {
            ends[{curve.operand, curve.start}].push_back(c);
            ends[{curve.operand, curve.end}].push_back(c);
        }
    }
    std::vector<FreeEnd> free;
    for (const auto& [where, curves] : ends) {
        if (curves.size() % 2 == 1) {
            free.push_back({where.second.value, curves.front()});
        }
    }
    return free;
}

/// The two free ends closest to each other, by a sweep over x.
std::optional<std::pair<FreeEnd, FreeEnd>> closestPair(std::vector<FreeEnd> ends,
                                                       const CurveNetwork& network)
{
    const auto position = [&network](const FreeEnd& end) { return network.points[end.point]; };
    std::stable_sort(ends.begin(), ends.end(), [&position](const FreeEnd& a, const FreeEnd& b) {
        return position(a).x < position(b).x;
    });
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<std::pair<FreeEnd, FreeEnd>> best;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t j = i + 1;
             j < ends.size() && position(ends[j]).x - position(ends[i]).x < nearest; ++j) {
            const double d = distance(position(ends[i]), position(ends[j]));
            if (d < nearest) {
                nearest = d;
                best = std::pair(ends[i], ends[j]);
            }
        }
    }
    return best;
}

std::string placeText(Vec2 p)
{
    char text[80];
    std::snprintf(text, sizeof text, "(%.6g, %.6g)", p.x, p.y);
    return text;
}

Error openError(const CurveNetwork& network, const std::vector<FreeEnd>& ends)
{
    const auto pair = closestPair(ends, network);
    if (!pair) {
        return {ErrorKind::NoInside, "No curve bounds an area: there is no closed outline."};
    }
    const Vec2 a = network.points[pair->first.point];
    const Vec2 b = network.points[pair->second.point];
    char gap[40];
    std::snprintf(gap, sizeof gap, "%.6g", distance(a, b));
    return {ErrorKind::NoInside,
            "The outline is not closed: " + std::to_string(ends.size())
                + " ends are free. The two closest to each other are " + placeText(a) + " and "
                + placeText(b) + ", " + gap
                + " apart; close the gap, or raise the weld tolerance to that.",
            {{a, pair->first.curve}, {b, pair->second.curve}}};
}

ErrorPlace startOf(const CurveNetwork& network, bool (*wanted)(const NetworkCurve&))
{
    for (std::uint32_t c = 0; c < network.curves.size(); ++c) {
        if (wanted(network.curves[c])) {
            return {network.points[network.curves[c].start.index()], c};
        }
    }
    return {};
}

bool hasFiniteTriangle(const Triangulation& t)
{
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (t.isFinite(i)) {
            return true;
        }
    }
    return false;
}

/// What the result would be without one of its possible reasons.
bool hasInside(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
               FillRule fill)
{
    Execution execution;
    return colorRegions(recovered, network, pslg, fill, execution).keptRegions > 0;
}

} // namespace

Error explainNoInside(const RecoveryResult& recovered, const CurveNetwork& network,
                      const Pslg& pslg, FillRule fill)
{
    const auto any = [&network](auto wanted) {
        return std::any_of(network.curves.begin(), network.curves.end(), wanted);
    };
    if (!any(isMeshed)) {
        return {ErrorKind::NoInside,
                "There are no curves, so there is nothing to mesh; draw a closed outline (or choose"
                " Fill = Hull for points)."};
    }
    const std::vector<FreeEnd> ends = findFreeEnds(network);
    if (!hasFiniteTriangle(recovered.triangulation) || pslg.segments.empty()) {
        return {ErrorKind::NoInside,
                "The outline encloses no area: all its points lie on one line.",
                {startOf(network, isMeshed)}};
    }
    if (!any(bounds)) {
        if (!ends.empty()) {
            return openError(network, ends);
        }
        return {ErrorKind::NoInside,
                "All curves are constraints and none bounds an area; give the outline the role"
                " boundary or choose Fill = All.",
                {startOf(network, isMeshed)}};
    }
    const bool bySign = fill == FillRule::Positive || fill == FillRule::Negative;
    if (bySign && hasInside(recovered, network, pslg, FillRule::NonZero)) {
        const std::string way = fill == FillRule::Positive ? "clockwise" : "counter-clockwise";
        return {ErrorKind::NoInside,
                "Every outline runs " + way
                    + ", which this fill rule leaves out; choose Fill = Even-odd or Non-zero.",
                {startOf(network, bounds)}};
    }
    CurveNetwork withoutHoles = network;
    withoutHoles.holes.clear();
    if (!network.holes.empty() && hasInside(recovered, withoutHoles, pslg, fill)) {
        return {ErrorKind::NoInside,
                "The hole points leave nothing of the inside; remove the one that lies in the part"
                " to mesh.",
                {{network.holes.front().position}}};
    }
    if (!ends.empty()) {
        return openError(network, ends);
    }
    return {ErrorKind::NoInside,
            "The outline encloses no area: its parts are drawn twice or run back on themselves.",
            {startOf(network, bounds)}};
}

} // namespace tessera
