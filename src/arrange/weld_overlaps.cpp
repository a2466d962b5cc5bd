// SPDX-License-Identifier: MIT
//
// An overlap within the weld tolerance begins and ends at ends of curves, and those are points of
// both curves once ends are welded onto curves. What is left to do are seams, which are no ends, and
// to compare curves between the same two points. Each comparison takes eight points of each arc and
// ends at the first that is too far away: most take one. O(n log n) with the search for seams near
// curves, apart from curves that share both ends, which are compared pair by pair.
#include "arrange/weld_overlaps.h"

#include "arrange/box_tree.h"
#include "arrange/cross_curves.h"
#include "arrange/split_curves.h"
#include "curve/curve_tools.h"
#include "curve/curve_views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

namespace tessera
{

namespace
{

/// Parts of an arc at which it is compared, far ones first.
constexpr double kShares[] = {0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875, 1.0};
/// Of curves along each other, neither is longer by more than this part.
constexpr double kLonger = 0.01;

class OverlapWelder
{
public:
    OverlapWelder(CurveNetwork& network, std::span<const std::uint8_t> wasSeam, double tolerance,
                  ArrangeReport& report, Execution& execution)
        : network_(network)
        , wasSeam_(wasSeam)
        , tolerance_(tolerance)
        , report_(report)
        , execution_(execution)
        , rounding_(meetingDistance(network, tolerance))
    {}

    void run()
    {
        cutAtSeams();
        mergeEqualEnds();
    }

private:
    void cutAtSeams()
    {
        if (std::none_of(wasSeam_.begin(), wasSeam_.end(), [](std::uint8_t s) { return s != 0; })) {
            return;
        }
        for (std::uint32_t c = 0; c < network_.curves.size(); ++c) {
            if (isMeshed(network_.curves[c])) {
                endsAt_.emplace_back(network_.curves[c].start.value, c);
                endsAt_.emplace_back(network_.curves[c].end.value, c);
            }
        }
        std::sort(endsAt_.begin(), endsAt_.end());
        const CurveSet curves(network_);
        const std::vector<Arc> arcs = cutIntoArcs(curves);
        std::vector<Box2> boxes;
        for (const Arc& arc : arcs) {
            boxes.push_back(arc.box().grown(tolerance_));
        }
        const BoxTree tree(boxes);
        AlongTest along(curves, tolerance_, rounding_);
        std::vector<CurveSplit> splits;
        for (std::uint32_t p = 0; p < wasSeam_.size(); ++p) {
            if (wasSeam_[p] == 0) {
                continue;
            }
            execution_.checkpoint();
            const Vec2 position = network_.points[p];
            tree.forEachOverlap({position, position}, [&](std::uint32_t i) {
                const double t = nearestParameter(curves, arcs[i], position);
                if (distance(curves[arcs[i].curve].point(t), position) <= tolerance_
                    && isOverlapAt(along, arcs[i].curve, t, p)) {
                    splits.push_back({arcs[i].curve, t, PointId(p)});
                }
            });
        }
        if (!splits.empty()) {
            splitCurves(network_, std::move(splits), 4.0 * tolerance_, report_);
        }
    }

    /// Whether a curve through a seam runs along another curve there, from the seam to an end.
    bool isOverlapAt(AlongTest& along, std::uint32_t c, double t, std::uint32_t seam) const
    {
        const NetworkCurve& curve = network_.curves[c];
        if (curve.start.value == seam || curve.end.value == seam) {
            return false;
        }
        const double first = curve.geometry ? curve.geometry->first() : 0.0;
        const double last = curve.geometry ? curve.geometry->last() : 1.0;
        auto at = std::lower_bound(endsAt_.begin(), endsAt_.end(), std::pair(seam, 0U));
        for (; at != endsAt_.end() && at->first == seam; ++at) {
            const std::uint32_t other = at->second;
            const bool bothClosed = curve.start == curve.end
                && network_.curves[other].start == network_.curves[other].end;
            if (bothClosed ? along.areOneRing(c, other)
                           : along.follows(c, first, t, other) || along.follows(c, t, last, other)) {
                return true;
            }
        }
        return false;
    }

    void mergeEqualEnds()
    {
        using Key = std::tuple<std::uint32_t, std::uint32_t, bool, std::uint32_t>;
        std::vector<Key> keys; // both ends, curved, curve: straight ones first
        for (std::uint32_t c = 0; c < network_.curves.size(); ++c) {
            const NetworkCurve& curve = network_.curves[c];
            if (isMeshed(curve)) {
                const auto [low, high] = std::minmax(curve.start.value, curve.end.value);
                keys.emplace_back(low, high, curve.geometry != nullptr, c);
            }
        }
        std::sort(keys.begin(), keys.end());
        const CurveNetwork before = network_;
        const CurveSet curves(before);
        AlongTest along(curves, tolerance_, rounding_);
        for (std::size_t i = 0; i < keys.size();) {
            std::size_t j = i;
            std::vector<std::uint32_t> group;
            for (; j < keys.size() && std::get<0>(keys[j]) == std::get<0>(keys[i])
                 && std::get<1>(keys[j]) == std::get<1>(keys[i]);
                 ++j) {
                group.push_back(std::get<3>(keys[j]));
            }
            execution_.checkpoint();
            mergeGroup(along, group);
            i = j;
        }
        std::sort(replaced_.begin(), replaced_.end());
        const auto end = std::unique(replaced_.begin(), replaced_.end());
        report_.weldedAlong = static_cast<std::size_t>(end - replaced_.begin());
    }

    void mergeGroup(AlongTest& along, const std::vector<std::uint32_t>& group)
    {
        std::vector<std::uint32_t> kept;
        for (const std::uint32_t c : group) {
            NetworkCurve& curve = network_.curves[c];
            const auto same = std::find_if(kept.begin(), kept.end(), [&](std::uint32_t first) {
                if (!curve.geometry) {
                    return true; // as straight as the first one
                }
                const std::optional<double> gap = along.distanceBetween(first, c);
                if (gap && *gap > rounding_) {
                    report_.greatestGap = std::max(report_.greatestGap, *gap);
                    replaced_.push_back(report_.parent[c].value);
                }
                return gap.has_value();
            });
            if (same == kept.end()) {
                kept.push_back(c);
                continue;
            }
            NetworkCurve& first = network_.curves[*same];
            const bool closed = curve.start == curve.end;
            if (curve.geometry) {
                shareGeometry(first, curve,
                                       closed ? along.runAlike(*same, c)
                                              : curve.start == first.start);
            }
        }
    }

    CurveNetwork& network_;
    std::span<const std::uint8_t> wasSeam_; ///< by point
    double tolerance_;
    ArrangeReport& report_;
    Execution& execution_;
    double rounding_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> endsAt_; ///< (point, curve), ascending
    std::vector<std::uint32_t> replaced_; ///< input curves that got another one's geometry
};

} // namespace

const AlongTest::Cut& AlongTest::cutOf(std::uint32_t curve)
{
    const auto [found, isNew] = cuts_.try_emplace(curve);
    if (isNew) {
        found->second.arcs = cutIntoArcs(curves_, curve);
        found->second.length = arcLength(curves_[curve]);
    }
    return found->second;
}

AlongTest::Nearest AlongTest::nearest(const Cut& cut, Vec2 p) const
{
    Nearest best {0.0, std::numeric_limits<double>::infinity()};
    for (const Arc& arc : cut.arcs) {
        if (!arc.box().grown(tolerance_).contains(p)) {
            continue;
        }
        const double t = nearestParameter(curves_, arc, p);
        const double d = distance(curves_[arc.curve].point(t), p);
        if (d < best.distance && d <= tolerance_) {
            best = {t, d};
        }
    }
    return best;
}

/// Infinite if more than the tolerance.
double AlongTest::greatestDistance(const Cut& from, const Cut& to) const
{
    double greatest = 0.0;
    for (const double share : kShares) {
        for (const Arc& arc : from.arcs) {
            const Vec2 p = curves_[arc.curve].point((1.0 - share) * arc.a + share * arc.b);
            greatest = std::max(greatest, nearest(to, p).distance);
            if (!(greatest <= tolerance_)) {
                return greatest;
            }
        }
    }
    return greatest;
}

std::optional<double> AlongTest::distanceBetween(std::uint32_t a, std::uint32_t b)
{
    const Cut& cutA = cutOf(a);
    const Cut& cutB = cutOf(b);
    const double allowed = kLonger * std::min(cutA.length, cutB.length) + 4.0 * tolerance_;
    if (std::abs(cutA.length - cutB.length) > allowed) {
        return std::nullopt;
    }
    double greatest = greatestDistance(cutA, cutB);
    if (greatest <= tolerance_) {
        greatest = std::max(greatest, greatestDistance(cutB, cutA));
    }
    return greatest <= tolerance_ ? std::optional(greatest) : std::nullopt;
}

/// The gap closes, or changes sides.
bool AlongTest::meet(const Cut& a, const Cut& b) const
{
    double side = 0.0;
    for (const Arc& arc : a.arcs) {
        for (int i = 0; i < 8; ++i) {
            const double share = i / 8.0;
            const double t = (1.0 - share) * arc.a + share * arc.b;
            const Vec2 p = curves_[arc.curve].point(t);
            const Nearest other = nearest(b, p);
            if (other.distance <= rounding_) {
                return true;
            }
            if (other.distance <= tolerance_) {
                const Vec2 gap = curves_[b.arcs.front().curve].point(other.t) - p;
                const double here = cross(curves_[arc.curve].derivative(t), gap);
                if (here * side < 0.0) {
                    return true;
                }
                side = here != 0.0 ? here : side;
            }
        }
    }
    return false;
}

bool AlongTest::areOneRing(std::uint32_t a, std::uint32_t b)
{
    return distanceBetween(a, b).has_value() && meet(cutOf(a), cutOf(b));
}

bool AlongTest::follows(std::uint32_t curve, double from, double to, std::uint32_t other)
{
    const Cut& cut = cutOf(other);
    bool any = false;
    for (const Arc& arc : cutOf(curve).arcs) {
        const double a = std::max(arc.a, from);
        const double b = std::min(arc.b, to);
        if (!(a < b)) {
            continue;
        }
        any = true;
        for (const double share : kShares) {
            if (!(nearest(cut, curves_[curve].point((1.0 - share) * a + share * b)).distance
                  <= tolerance_)) {
                return false;
            }
        }
    }
    return any;
}

bool AlongTest::runAlike(std::uint32_t a, std::uint32_t b)
{
    const Curve& curve = curves_[a];
    const auto on = [&](double share) {
        const double t = (1.0 - share) * curve.first() + share * curve.last();
        return nearest(cutOf(b), curve.point(t)).t;
    };
    return on(0.3) < on(0.7);
}

void shareGeometry(NetworkCurve& a, NetworkCurve& b, bool alike)
{
    if (!a.geometry || !b.geometry) {
        a.geometry = b.geometry = nullptr;
    }
    else if (alike) {
        b.geometry = a.geometry;
    }
    else {
        b.geometry = std::make_shared<ReversedCurve>(a.geometry);
    }
}

void weldOverlaps(CurveNetwork& network, std::span<const std::uint8_t> wasSeam,
                  const ArrangeOptions& options, ArrangeReport& report, Execution& execution)
{
    const bool curved = std::any_of(network.curves.begin(), network.curves.end(),
                                    [](const auto& c) { return isMeshed(c) && c.geometry; });
    if (options.weld > 0.0 && curved) {
        OverlapWelder(network, wasSeam, options.weld, report, execution).run();
    }
}

} // namespace tessera
