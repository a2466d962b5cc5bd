// SPDX-License-Identifier: MIT
#include "arrange/arrange.h"

#include "base/number_text.h"
#include "arrange/cross_curves.h"
#include "arrange/cross_straight.h"
#include "arrange/weld.h"
#include "arrange/weld_overlaps.h"
#include "curve/curve_tools.h"
#include "curve/default_roles.h"
#include "curve/network_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace tessera
{

namespace
{

/// By point: a curve that is meshed, or an embedded point, uses it.
std::vector<std::uint8_t> usedPoints(const CurveNetwork& network)
{
    std::vector<std::uint8_t> used(network.points.size(), 0);
    for (const NetworkCurve& curve : network.curves) {
        if (isMeshed(curve)) {
            used[curve.start.index()] = 1;
            used[curve.end.index()] = 1;
        }
    }
    for (const EmbeddedPoint& embedded : network.embedded) {
        used[embedded.point.index()] = 1;
    }
    return used;
}

/// Of the seams that are near each other, joins those of closed curves that are one ring.
void joinSeamsAlong(const CurveNetwork& network, double tolerance,
                    const std::vector<std::uint32_t>& near,
                    const std::vector<std::uint8_t>& wanted,
                    std::vector<std::uint32_t>& representative)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seams; // lowest point nearby, seam
    for (std::uint32_t p = 0; p < near.size(); ++p) {
        if (wanted[p] != 0 && representative[p] == p) {
            seams.emplace_back(near[p], p);
        }
    }
    std::sort(seams.begin(), seams.end());
    std::map<std::uint32_t, std::uint32_t> curveAt;
    for (std::uint32_t c = 0; c < network.curves.size(); ++c) {
        if (isMeshed(network.curves[c])) {
            curveAt.emplace(network.curves[c].start.value, c);
        }
    }
    const CurveSet curves(network);
    AlongTest along(curves, tolerance, meetingDistance(network, tolerance));
    std::map<std::uint32_t, std::uint32_t> joined;
    for (std::size_t i = 0; i < seams.size(); ++i) {
        for (std::size_t j = i; j-- > 0 && seams[j].first == seams[i].first;) {
            const std::uint32_t first = seams[j].second;
            const std::uint32_t seam = seams[i].second;
            if (!joined.contains(first)
                && along.areOneRing(curveAt.at(first), curveAt.at(seam))) {
                joined[seam] = first;
                break;
            }
        }
    }
    for (std::uint32_t& p : representative) {
        const auto found = joined.find(p);
        p = found == joined.end() ? p : found->second;
    }
}

/// Seams are no ends: where nothing else takes part they become one only if they are up to
/// rounding, as closed curves that touch there need it, or if their curves are one ring.
void keepSeamsApart(const CurveNetwork& network, double rounding, double tolerance,
                    const Execution& execution, std::vector<std::uint32_t>& representative)
{
    std::vector<std::uint8_t> wanted = findSeams(network);
    for (std::size_t p = 0; p < representative.size(); ++p) {
        if (wanted[p] == 0) {
            wanted[representative[p]] = 0;
        }
    }
    for (std::size_t p = 0; p < representative.size(); ++p) {
        wanted[p] = wanted[p] != 0 && wanted[representative[p]] != 0 ? 1 : 0;
    }
    const std::vector<std::uint32_t> near = representative;
    const WeldResult equal = weldPoints(network.points, wanted, rounding, execution);
    for (std::size_t p = 0; p < representative.size(); ++p) {
        if (wanted[p] != 0) {
            representative[p] = equal.representative[p];
        }
    }
    joinSeamsAlong(network, tolerance, near, wanted, representative);
}

bool movesPoints(const CurveNetwork& network, const std::vector<std::uint32_t>& representative)
{
    for (std::size_t p = 0; p < representative.size(); ++p) {
        if (!(network.points[p] == network.points[representative[p]])) {
            return true;
        }
    }
    return false;
}

/// Renumbers the points that stay, in their order, and fills report.pointOf. Points within noise of
/// each other were meant to be one: joining them is not counted.
std::vector<Vec2> compactPoints(const CurveNetwork& network, const std::vector<std::uint8_t>& used,
                                const std::vector<std::uint32_t>& representative, double noise,
                                ArrangeReport& report)
{
    std::vector<Vec2> points;
    report.pointOf.assign(network.points.size(), PointId());
    for (std::size_t p = 0; p < network.points.size(); ++p) {
        if (used[p] == 0) {
            continue;
        }
        const std::uint32_t lowest = representative[p];
        if (lowest == p) {
            report.pointOf[p] = PointId(points.size());
            points.push_back(network.points[p]);
        }
        else {
            report.pointOf[p] = report.pointOf[lowest];
            report.welded += distance(network.points[p], network.points[lowest]) > noise ? 1 : 0;
        }
    }
    return points;
}

/// A curve whose two ends became one although it is no longer than the welding can bridge has
/// collapsed: without geometry it is a straight curve of zero length, which sampling drops.
/// Returns how many did, those aside that had no length before.
std::size_t collapseShortCurves(const CurveNetwork& before, double weld, CurveNetwork& network)
{
    std::size_t count = 0;
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        NetworkCurve& curve = network.curves[c];
        const Vec2 a = before.points[before.curves[c].start.index()];
        const Vec2 b = before.points[before.curves[c].end.index()];
        if (curve.start != curve.end || before.curves[c].start == before.curves[c].end) {
            continue;
        }
        if (curve.geometry && arcLength(*curve.geometry) > 2.0 * weld) {
            continue;
        }
        count += isMeshed(curve) && (curve.geometry || !(a == b)) ? 1 : 0;
        curve.geometry = nullptr;
    }
    return count;
}

std::string counted(std::size_t count, const char* one, const char* several)
{
    return std::to_string(count) + (count == 1 ? one : several);
}

void addMessages(double weld, ArrangeReport& report)
{
    const std::string within = " within the weld tolerance " + numberText(weld);
    if (report.welded > 0) {
        std::string text = counted(report.welded, " end point was", " end points were")
            + " joined to another one" + within + ".";
        if (report.swallowed > 0) {
            text.append(" ")
                .append(counted(report.swallowed, " curve", " curves"))
                .append(" no longer than that vanished; choose a smaller tolerance.");
        }
        report.messages.push_back(std::move(text));
    }
    if (report.weldedOnto > 0) {
        report.messages.push_back(
            counted(report.weldedOnto, " end point was", " end points were")
            + " joined to the inside of a curve" + within
            + ", which moves ends or bends curves by up to " + numberText(report.greatestBend)
            + ".");
    }
    if (report.weldedAlong > 0) {
        report.messages.push_back(
            counted(report.weldedAlong, " curve runs", " curves run") + " along another one"
            + within + ", up to " + numberText(report.greatestGap)
            + " from it, and became one with it.");
    }
    if (!report.chainsLeft.empty()) {
        const Vec2 place = report.chainsLeft.front().position;
        report.messages.push_back(
            std::to_string(report.chainsLeft.size())
            + (report.chainsLeft.size() == 1 ? " row" : " rows")
            + " of end points or crossings within the weld tolerance of each other reach too far to"
              " be one point and stay as they are, the first at "
            + placeText(place) + "; choose a smaller tolerance.");
    }
}

} // namespace

CurveNetwork arrange(const CurveNetwork& network, const ArrangeOptions& options,
                     ArrangeReport& report, Execution& execution)
{
    if (!(options.weld >= 0.0) || !std::isfinite(options.weld)) {
        throw Error(ErrorKind::InvalidOption,
                    "The weld tolerance must be a number of at least 0.");
    }
    requireValid(network);
    report = {};
    const std::vector<std::uint8_t> used = usedPoints(network);
    // Without a tolerance even equal points of straight curves stay apart: a .poly is read by point
    // index. Ends of curved ones are never more exact than the curve's rounding.
    const double tolerance = std::max(options.weld, meetingDistance(network, options.weld));
    const std::vector<std::uint8_t> none(network.points.size(), 0);
    WeldResult weld =
        weldPoints(network.points, tolerance > 0.0 ? used : none, tolerance, execution);
    keepSeamsApart(network, roundingDistance(network), tolerance, execution, weld.representative);
    for (const std::uint32_t p : weld.chainsLeft) {
        report.chainsLeft.push_back({network.points[p]});
    }

    CurveNetwork result = network;
    result.points =
        compactPoints(network, used, weld.representative, noiseDistance(network), report);
    for (NetworkCurve& curve : result.curves) {
        curve.start = report.pointOf[curve.start.index()];
        curve.end = report.pointOf[curve.end.index()];
    }
    for (EmbeddedPoint& embedded : result.embedded) {
        embedded.point = report.pointOf[embedded.point.index()];
    }
    report.swallowed = collapseShortCurves(network, options.weld, result);
    if (movesPoints(network, weld.representative)) {
        renewPolyRoles(result);
    }
    settleChainRoles(result);
    for (std::size_t c = 0; c < result.curves.size(); ++c) {
        report.parent.emplace_back(c);
    }
    report.firstCrossing = result.firstCrossing = result.points.size();
    const std::vector<std::uint8_t> wasSeam = findSeams(result);
    weldPointsOntoCurves(result, options, report, execution);
    weldOverlaps(result, wasSeam, options, report, execution);
    if (options.crossStraight) {
        crossStraightCurves(result, options, report, execution);
    }
    crossCurves(result, options, report, execution);
    addMessages(tolerance, report);
    report.welded += report.weldedOnto;
    return result;
}

} // namespace tessera
