// SPDX-License-Identifier: MIT
#include "region/no_inside.h"

#include "region/free_ends.h"

#include <algorithm>
#include <string>
#include <utility>

namespace tessera
{

namespace
{

bool isMeshed(const NetworkCurve& curve)
{
    return curve.role != Role::Ignored;
}

bool bounds(const NetworkCurve& curve)
{
    return curve.role == Role::Boundary || curve.role == Role::Outline;
}

Error openError(const CurveNetwork& network, const std::vector<FreeEnd>& ends)
{
    const auto pair = closestPair(ends, network);
    if (!pair) {
        return {ErrorKind::NoInside, "No curve bounds an area: there is no closed outline."};
    }
    return {ErrorKind::NoInside,
            "The outline is not closed: " + std::to_string(ends.size())
                + " ends are free. The two closest to each other are "
                + describePair(*pair, network)
                + "; close the gap, or raise the weld tolerance to that.",
            {{network.points[pair->first.point], pair->first.curve},
             {network.points[pair->second.point], pair->second.curve}}};
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
                " the fill rule 'hull' for points)."};
    }
    const std::vector<FreeEnd> ends = findFreeEnds(network, {});
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
                " boundary or choose the fill rule 'all'.",
                {startOf(network, isMeshed)}};
    }
    const bool bySign = fill == FillRule::Positive || fill == FillRule::Negative;
    if (bySign && hasInside(recovered, network, pslg, FillRule::NonZero)) {
        const std::string way = fill == FillRule::Positive ? "clockwise" : "counter-clockwise";
        return {ErrorKind::NoInside,
                "Every outline runs " + way
                    + ", which this fill rule leaves out; choose 'even-odd' or 'nonzero'.",
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
