// SPDX-License-Identifier: MIT
#include "region/free_ends.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

namespace tessera
{

namespace
{

std::string describeEnd(const FreeEnd& end, const CurveNetwork& network)
{
    const Vec2 p = network.points[end.point];
    char text[80];
    std::snprintf(text, sizeof text, "(%.6g, %.6g)", p.x, p.y);
    const bool named
        = end.curve < network.curveNames.size() && !network.curveNames[end.curve].empty();
    return named ? text + (" of " + network.curveNames[end.curve]) : text;
}

} // namespace

std::vector<FreeEnd> findFreeEnds(const CurveNetwork& network, std::span<const std::uint8_t> wanted)
{
    std::map<std::pair<OperandId, PointId>, std::vector<std::uint32_t>> ends;
    for (std::uint32_t c = 0; c < network.curves.size(); ++c) {
        const NetworkCurve& curve = network.curves[c];
        if (curve.role != Role::Ignored && (wanted.empty() || wanted[c] != 0)) {
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

std::string describePair(const std::pair<FreeEnd, FreeEnd>& pair, const CurveNetwork& network)
{
    char gap[40];
    std::snprintf(gap, sizeof gap, "%.6g",
                  distance(network.points[pair.first.point], network.points[pair.second.point]));
    return describeEnd(pair.first, network) + " and " + describeEnd(pair.second, network) + ", "
        + gap + " apart";
}

} // namespace tessera
