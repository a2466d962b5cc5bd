// SPDX-License-Identifier: MIT
#include "arrange/cross_curves.h"

#include "arrange/arcs.h"
#include "arrange/box_tree.h"
#include "arrange/contacts.h"
#include "arrange/split_curves.h"
#include "arrange/weld.h"
#include "arrange/weld_overlaps.h"
#include "base/number_text.h"
#include "curve/curve_tools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace tessera
{

namespace
{

/// What computing a crossing of curves that are not almost parallel errs at most, as a part of the
/// scale; with a wide margin.
constexpr double kRounding = 1e-12;

bool hasCurved(const CurveNetwork& network)
{
    return std::any_of(network.curves.begin(), network.curves.end(),
                       [](const NetworkCurve& c) { return isMeshed(c) && c.geometry; });
}

/// The larger of the size and the greatest coordinate: what rounding errors are measured by.
double scaleOf(const CurveNetwork& network)
{
    const Box2 box = networkBounds(network);
    return box.empty() ? 0.0
                       : std::max({box.diagonal(), std::abs(box.min.x), std::abs(box.min.y),
                                   std::abs(box.max.x), std::abs(box.max.y)});
}

/// A network point near a curve's inside.
struct NearPoint
{
    std::uint32_t curve;
    std::uint32_t point;
    double t;
    double distance;
};

class PointWelder
{
public:
    PointWelder(CurveNetwork& network, const ArrangeOptions& options, ArrangeReport& report)
        : network_(network)
        , weld_(options.weld)
        , tolerance_(std::max(options.weld, meetingDistance(network, options.weld)))
        , report_(report)
        , curves_(network)
        , arcs_(cutIntoArcs(curves_))
        , isSeam_(findSeams(network))
        , seamReach_(std::min(tolerance_, roundingDistance(network)))
    {}

    void run(Execution& execution)
    {
        std::vector<Box2> boxes;
        for (const Arc& arc : arcs_) {
            boxes.push_back(arc.box().grown(tolerance_));
        }
        const BoxTree tree(boxes);
        std::vector<NearPoint> found;
        for (std::uint32_t p = 0; p < network_.points.size(); ++p) {
            if (p % 256 == 0) {
                execution.checkpoint();
            }
            const Vec2 position = network_.points[p];
            tree.forEachOverlap({position, position}, [this, p, &found](std::uint32_t i) {
                addIfNear(arcs_[i], p, found);
            });
        }
        const std::vector<CurveSplit> splits = nearest(std::move(found));
        report_.crossed.touches += splits.size();
        countBends(splits);
        moveLooseEnds(splits);
        splitCurves(network_, splits, 4.0 * tolerance_, report_);
    }

private:
    void addIfNear(const Arc& arc, std::uint32_t p, std::vector<NearPoint>& found) const
    {
        if (curves_.isStraight(arc.curve) && weld_ == 0.0) {
            return;
        }
        const Vec2 position = network_.points[p];
        const double t = nearestParameter(curves_, arc, position);
        const double d = distance(curves_[arc.curve].point(t), position);
        const double reach = isSeam_[p] != 0 ? seamReach_ : tolerance_;
        if (d <= reach && !isAtOwnEnd(arc.curve, p, t) && !isInRowWithEnd(arc.curve, p)) {
            found.push_back({arc.curve, p, t, d});
        }
    }

    /// An end of the curve, no seam, is near the point, and yet the two did not become one: both are
    /// in a row of points too long for that, which stay as they are.
    bool isInRowWithEnd(std::uint32_t c, std::uint32_t p) const
    {
        const NetworkCurve& curve = network_.curves[c];
        const auto isNear = [&](PointId end) {
            return end.value != p && isSeam_[end.index()] == 0
                && distance(network_.points[end.index()], network_.points[p]) <= weld_;
        };
        return isSeam_[p] == 0 && (isNear(curve.start) || isNear(curve.end));
    }

    /// The curve ends at the point anyway, and that end is where it is near.
    bool isAtOwnEnd(std::uint32_t c, std::uint32_t p, double t) const
    {
        const NetworkCurve& curve = network_.curves[c];
        const Curve& geometry = curves_[c];
        const auto isShort = [&](double from, double to) {
            return from >= to || arcLength(geometry, from, to) <= 4.0 * tolerance_;
        };
        return (curve.start.value == p && isShort(geometry.first(), t))
            || (curve.end.value == p && isShort(t, geometry.last()));
    }

    /// Of the findings on neighboring arcs, the one that is nearest.
    std::vector<CurveSplit> nearest(std::vector<NearPoint> found) const
    {
        std::sort(found.begin(), found.end(), [](const NearPoint& a, const NearPoint& b) {
            return std::tie(a.curve, a.point, a.t) < std::tie(b.curve, b.point, b.t);
        });
        std::vector<CurveSplit> splits;
        for (std::size_t i = 0; i < found.size();) {
            std::size_t best = i;
            std::size_t j = i + 1;
            for (; j < found.size() && found[j].curve == found[i].curve
                 && found[j].point == found[i].point
                 && arcLength(curves_[found[i].curve], found[j - 1].t, found[j].t)
                     <= 8.0 * tolerance_;
                 ++j) {
                best = found[j].distance < found[best].distance ? j : best;
            }
            splits.push_back({found[best].curve, found[best].t, PointId(found[best].point)});
            i = j;
        }
        return splits;
    }

    /// The free end of a line moves onto the curve, so that an outline is not bent to it. Points
    /// where several curves end, and embedded ones, stay: curves pass through them.
    void moveLooseEnds(const std::vector<CurveSplit>& splits)
    {
        std::vector<std::uint32_t> ends(network_.points.size(), 0);
        for (const NetworkCurve& curve : network_.curves) {
            if (isMeshed(curve)) {
                ++ends[curve.start.index()];
                ++ends[curve.end.index()];
            }
        }
        for (const EmbeddedPoint& embedded : network_.embedded) {
            ends[embedded.point.index()] = 2;
        }
        for (const CurveSplit& split : splits) {
            std::uint32_t& count = ends[split.point.index()];
            if (count == 1) {
                count = 2; // of several curves, onto the first
                network_.points[split.point.index()] = curves_[split.curve].point(split.t);
            }
        }
    }

    /// A curve passes through each of its points from now on, however far that was from it.
    void countBends(const std::vector<CurveSplit>& splits)
    {
        const double rounding = std::max(meetingDistance(network_, weld_), noiseDistance(network_));
        std::vector<std::uint32_t> points;
        for (const CurveSplit& split : splits) {
            const Vec2 position = network_.points[split.point.index()];
            const double bend = distance(curves_[split.curve].point(split.t), position);
            if (bend > rounding) {
                points.push_back(split.point.value);
                report_.greatestBend = std::max(report_.greatestBend, bend);
            }
        }
        std::sort(points.begin(), points.end());
        const auto end = std::unique(points.begin(), points.end());
        report_.weldedOnto = static_cast<std::size_t>(end - points.begin());
    }

    CurveNetwork& network_;
    double weld_;
    double tolerance_;
    ArrangeReport& report_;
    CurveSet curves_;
    std::vector<Arc> arcs_;
    std::vector<std::uint8_t> isSeam_; ///< by point
    double seamReach_;
};

class CurveCrosser
{
public:
    CurveCrosser(CurveNetwork& network, const ArrangeOptions& options, ArrangeReport& report,
                 Execution& execution)
        : network_(network)
        , near_(meetingDistance(network, options.weld))
        , tolerance_(std::max(options.weld, 16.0 * near_))
        , report_(report)
        , execution_(execution)
        , curves_(network)
        , arcs_(cutIntoArcs(curves_))
        , inputPoints_(network.points.size())
    {}

    void run()
    {
        contacts_ = findContacts(curves_, arcs_, near_, execution_);
        addMeetingPoints();
        shareSplits();
        const std::vector<PieceOrigin> origins =
            splitCurves(network_, std::move(splits_), 4.0 * tolerance_, report_);
        shareGeometry(origins);
        if (!contacts_.unresolved.empty()) {
            report_.messages.push_back(
                "Curves run beside each other so closely, first near "
                + placeText(contacts_.unresolved.front())
                + ", that crossings between them may have been missed; check the result there.");
        }
    }

private:
    /// Both places of a contact, with the point between them.
    void addMeeting(std::uint32_t a, double s, std::uint32_t b, double t)
    {
        const Vec2 p = midpoint(curves_[a].point(s), curves_[b].point(t));
        const PointId point = network_.addPoint(p);
        splits_.push_back({a, s, point});
        splits_.push_back({b, t, point});
    }

    void addMeetingPoints()
    {
        for (const Stretch& s : contacts_.overlaps) {
            addMeeting(s.curveA, s.a0, s.curveB, s.b0);
            addMeeting(s.curveA, s.a1, s.curveB, s.b1);
        }
        const std::size_t firstCrossing = network_.points.size();
        for (const Contact& c : contacts_.points) {
            addMeeting(c.curveA, c.s, c.curveB, c.t);
        }
        const WeldResult weld =
            weldMadePoints(network_.points, {inputPoints_, firstCrossing}, tolerance_,
                           roundingDistance(network_), execution_);
        for (const std::uint32_t p : weld.chainsLeft) {
            report_.chainsLeft.push_back({network_.points[p]});
        }
        compact(weld.representative);
    }

    void compact(const std::vector<std::uint32_t>& representative)
    {
        std::vector<PointId> newId(network_.points.size());
        std::vector<std::pair<std::uint32_t, PointId>> touches;
        std::size_t kept = 0;
        for (std::uint32_t p = 0; p < network_.points.size(); ++p) {
            if (representative[p] == p) {
                network_.points[kept] = network_.points[p];
                newId[p] = PointId(kept++);
            }
            else {
                newId[p] = newId[representative[p]];
            }
        }
        report_.crossed.crossings += kept - inputPoints_;
        network_.points.resize(kept);
        for (CurveSplit& split : splits_) {
            split.point = newId[split.point.index()];
            const NetworkCurve& curve = network_.curves[split.curve];
            const bool ownEnd = split.point == curve.start || split.point == curve.end;
            if (split.point.index() < inputPoints_ && !ownEnd) {
                touches.emplace_back(split.curve, split.point);
            }
        }
        std::sort(touches.begin(), touches.end());
        touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
        report_.crossed.touches += touches.size();
    }

    /// Overlapping curves are cut at the same points, whatever found these.
    void shareSplits()
    {
        const std::size_t count = splits_.size();
        std::vector<CurveSplit> byCurve(splits_.begin(), splits_.end());
        std::sort(byCurve.begin(), byCurve.end(), [](const CurveSplit& p, const CurveSplit& q) {
            return std::tie(p.curve, p.t, p.point) < std::tie(q.curve, q.t, q.point);
        });
        const auto share = [this, &byCurve](std::uint32_t from, double t0, double t1,
                                            std::uint32_t to, double u0, double u1) {
            const auto first = std::lower_bound(
                byCurve.begin(), byCurve.end(), std::pair(from, std::min(t0, t1)),
                [](const CurveSplit& s, const auto& key) {
                    return std::tie(s.curve, s.t) < std::tie(key.first, key.second);
                });
            for (auto s = first; s != byCurve.end() && s->curve == from && s->t <= std::max(t0, t1);
                 ++s) {
                const double u = nearestParameter(curves_, arcs_, to, std::min(u0, u1),
                                                  std::max(u0, u1),
                                                  network_.points[s->point.index()]);
                splits_.push_back({to, u, s->point});
            }
        };
        for (const Stretch& s : contacts_.overlaps) {
            share(s.curveA, s.a0, s.a1, s.curveB, s.b0, s.b1);
            share(s.curveB, s.b0, s.b1, s.curveA, s.a0, s.a1);
        }
        if (splits_.size() > count) {
            dropRepeated();
        }
    }

    void dropRepeated()
    {
        std::sort(splits_.begin(), splits_.end(), [](const CurveSplit& p, const CurveSplit& q) {
            return std::tie(p.curve, p.point, p.t) < std::tie(q.curve, q.point, q.t);
        });
        std::vector<CurveSplit> kept;
        for (const CurveSplit& s : splits_) {
            if (kept.empty() || kept.back().curve != s.curve || kept.back().point != s.point
                || arcLength(curves_[s.curve], kept.back().t, s.t) > 4.0 * tolerance_) {
                kept.push_back(s);
            }
        }
        splits_ = std::move(kept);
    }

    /// Pieces over the same stretch with the same ends get the geometry of the first of them.
    void shareGeometry(const std::vector<PieceOrigin>& origins)
    {
        const auto piecesOf = [&origins](std::uint32_t curve) {
            const auto begin = std::lower_bound(
                origins.begin(), origins.end(), curve,
                [](const PieceOrigin& o, std::uint32_t c) { return o.curve < c; });
            auto end = begin;
            while (end != origins.end() && end->curve == curve) {
                ++end;
            }
            return std::pair(begin - origins.begin(), end - origins.begin());
        };
        const auto liesIn = [&origins](std::ptrdiff_t piece, double t0, double t1) {
            const auto& o = origins[static_cast<std::size_t>(piece)];
            const double middle = 0.5 * (o.t0 + o.t1);
            return middle > std::min(t0, t1) && middle < std::max(t0, t1);
        };
        for (const Stretch& s : contacts_.overlaps) {
            const auto [beginA, endA] = piecesOf(s.curveA);
            const auto [beginB, endB] = piecesOf(s.curveB);
            for (auto b = beginB; b < endB; ++b) {
                for (auto a = beginA; liesIn(b, s.b0, s.b1) && a < endA; ++a) {
                    if (a != b && liesIn(a, s.a0, s.a1)
                        && takeGeometry(network_.curves[static_cast<std::size_t>(a)],
                                        network_.curves[static_cast<std::size_t>(b)],
                                        s.b0 < s.b1)) {
                        break;
                    }
                }
            }
        }
    }

    static bool takeGeometry(NetworkCurve& a, NetworkCurve& b, bool alike)
    {
        const bool sameEnds = alike ? a.start == b.start && a.end == b.end
                                    : a.start == b.end && a.end == b.start;
        if (!sameEnds) {
            return false;
        }
        tessera::shareGeometry(a, b, alike);
        return true;
    }

    CurveNetwork& network_;
    double near_;
    double tolerance_;
    ArrangeReport& report_;
    Execution& execution_;
    CurveSet curves_;
    std::vector<Arc> arcs_;
    std::size_t inputPoints_;
    CurveContacts contacts_;
    std::vector<CurveSplit> splits_;
};

} // namespace

double meetingDistance(const CurveNetwork& network, double weld)
{
    return hasCurved(network) ? std::max(kRounding * scaleOf(network), 2e-4 * weld) : 0.0;
}

double roundingDistance(const CurveNetwork& network)
{
    return 16.0 * kRounding * scaleOf(network);
}

double noiseDistance(const CurveNetwork& network)
{
    return 64.0 * std::numeric_limits<double>::epsilon() * scaleOf(network);
}

std::vector<std::uint8_t> findSeams(const CurveNetwork& network)
{
    std::vector<std::uint8_t> isSeam(network.points.size(), 0);
    for (const NetworkCurve& curve : network.curves) {
        if (isMeshed(curve) && curve.geometry) { // the others may have lost their points
            isSeam[curve.start.index()] = 1;
        }
    }
    for (const NetworkCurve& curve : network.curves) {
        if (isMeshed(curve) && (curve.start != curve.end || !curve.geometry)) {
            isSeam[curve.start.index()] = isSeam[curve.end.index()] = 0;
        }
    }
    for (const EmbeddedPoint& embedded : network.embedded) {
        isSeam[embedded.point.index()] = 0;
    }
    return isSeam;
}

void weldPointsOntoCurves(CurveNetwork& network, const ArrangeOptions& options,
                          ArrangeReport& report, Execution& execution)
{
    if (options.weld > 0.0 || hasCurved(network)) {
        PointWelder(network, options, report).run(execution);
    }
}

void crossCurves(CurveNetwork& network, const ArrangeOptions& options, ArrangeReport& report,
                 Execution& execution)
{
    if (hasCurved(network)) {
        CurveCrosser(network, options, report, execution).run();
    }
}

} // namespace tessera
