// SPDX-License-Identifier: MIT
#include "arrange/contacts.h"

#include "arrange/box_tree.h"
#include "curve/curve_tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace tessera
{

namespace
{

class ContactFinder
{
public:
    ContactFinder(const CurveSet& curves, std::span<const Arc> arcs, double near,
                  Execution& execution)
        : curves_(curves)
        , arcs_(arcs)
        , near_(near)
        , execution_(execution)
        , pairs_(curves, near)
    {}

    CurveContacts run()
    {
        std::vector<Box2> boxes;
        boxes.reserve(arcs_.size());
        for (const Arc& arc : arcs_) {
            boxes.push_back(arc.box().grown(near_));
        }
        std::size_t count = 0;
        BoxTree(boxes).forEachPair([this, &count](std::uint32_t i, std::uint32_t j) {
            if ((++count & 0xffU) == 0) {
                execution_.checkpoint();
            }
            lookAt(arcs_[i], arcs_[j]);
        });
        crossings_ = std::move(pairs_.crossings);
        sortByPlace(crossings_);
        mergeStretches();
        result_.points.insert(result_.points.end(), crossings_.begin(), crossings_.end());
        result_.unresolved = std::move(pairs_.unresolved);
        std::erase_if(result_.points, [this](const Contact& c) { return startsAtSharedEnd(c); });
        sortByPlace(result_.points);
        return std::move(result_);
    }

private:
    void lookAt(const Arc& one, const Arc& other)
    {
        if (curves_.isStraight(one.curve) && curves_.isStraight(other.curve)) {
            return;
        }
        const bool inOrder = std::tie(one.curve, one.a) < std::tie(other.curve, other.a);
        const Arc& a = inOrder ? one : other;
        const Arc& b = inOrder ? other : one;
        if (a.curve != b.curve || !(areNeighbors(a, b) && goOneWay(a, b))) {
            pairs_.find(a, b);
        }
    }

    bool areNeighbors(const Arc& a, const Arc& b) const
    {
        const NetworkCurve& curve = curves_.network().curves[a.curve];
        const Curve& geometry = curves_[a.curve];
        return a.b == b.a
            || (curve.start == curve.end && a.a == geometry.first() && b.b == geometry.last());
    }

    /// All tangents of both lie within a half-plane, so that the two cannot meet again.
    static bool goOneWay(const Arc& a, const Arc& b)
    {
        if (a.coneSine >= 1.0 || b.coneSine >= 1.0) {
            return false;
        }
        const double angle = std::abs(
            std::atan2(cross(a.direction, b.direction), dot(a.direction, b.direction)));
        return angle + std::asin(a.coneSine) + std::asin(b.coneSine) < std::numbers::pi - 1e-3;
    }

    double speedAt(std::uint32_t curve, double t) const
    {
        return length(curves_[curve].derivative(t));
    }

    /// Joins stretches that follow each other on both curves; what reaches from an end of one of
    /// the curves to another end is an overlap, everything else a touch.
    void mergeStretches()
    {
        auto& stretches = pairs_.stretches;
        std::sort(stretches.begin(), stretches.end(), [](const Stretch& p, const Stretch& q) {
            return std::tie(p.curveA, p.curveB, p.a0, p.a1, p.b0)
                < std::tie(q.curveA, q.curveB, q.a0, q.a1, q.b0);
        });
        std::vector<Stretch> open;
        for (std::size_t i = 0; i < stretches.size(); ++i) {
            if (i > 0 && (stretches[i].curveA != stretches[i - 1].curveA
                          || stretches[i].curveB != stretches[i - 1].curveB)) {
                finish(open);
            }
            const auto before = std::find_if(open.begin(), open.end(), [&](const Stretch& s) {
                return continues(s, stretches[i]);
            });
            if (before == open.end()) {
                open.push_back(stretches[i]);
            }
            else if (stretches[i].a1 > before->a1) {
                before->a1 = stretches[i].a1;
                before->b1 = stretches[i].b1;
            }
        }
        finish(open);
    }

    bool continues(const Stretch& s, const Stretch& next) const
    {
        const double reachA = 64.0 * near_ / std::max(speedAt(s.curveA, s.a1), near_);
        const double reachB = 64.0 * near_ / std::max(speedAt(s.curveB, s.b1), near_);
        const double lengthB = std::abs(s.b1 - s.b0);
        const double nextLengthB = std::abs(next.b1 - next.b0);
        const double shorterB = std::min(lengthB, nextLengthB);
        if ((next.b1 > next.b0) != (s.b1 > s.b0) && shorterB > reachB) {
            return false; // one of the curves turns back
        }
        const Stretch& longer = lengthB > nextLengthB ? s : next;
        const double gapB = longer.b1 > longer.b0 ? next.b0 - s.b1 : s.b1 - next.b0;
        // They may overlap. A gap on B alone: both curves turn back, each at a place of its own.
        return next.a0 <= s.a1 + reachA && gapB <= reachB && gapB >= -reachB - shorterB;
    }

    void finish(std::vector<Stretch>& open)
    {
        for (Stretch& stretch : open) {
            if (isOverlap(stretch) || trimToOverlap(stretch)) {
                result_.overlaps.push_back(stretch);
            }
            else {
                addTouch(placeOf(stretch));
            }
        }
        open.clear();
    }

    /// Beside a crossing that is almost tangent, the curves are near each other for a while: that is
    /// no touch. Where they are tangent up to rounding, those crossings are no crossings.
    void addTouch(const Contact& touch)
    {
        const auto before = [](const Contact& p, const Contact& q) {
            return std::tie(p.curveA, p.curveB) < std::tie(q.curveA, q.curveB);
        };
        const auto [first, last] = std::equal_range(crossings_.begin(), crossings_.end(), touch,
                                                    before);
        const auto leadsThere = [&](const Contact& c) { return leadsTo(touch, c); };
        const double gap = distance(curves_[touch.curveA].point(touch.s),
                                    curves_[touch.curveB].point(touch.t));
        if (gap <= near_) {
            crossings_.erase(std::remove_if(first, last, leadsThere), last);
        }
        else if (std::any_of(first, last, leadsThere)) {
            return;
        }
        result_.points.push_back(touch);
    }

    bool isOverlap(const Stretch& s) const
    {
        const double length = (s.a1 - s.a0) * speedAt(s.curveA, 0.5 * (s.a0 + s.a1));
        const auto isEnd = [this, &s](double a, double b) {
            return isEndOf(s.curveA, a) || isEndOf(s.curveB, b);
        };
        return length > 256.0 * near_ && isEnd(s.a0, s.b0) && isEnd(s.a1, s.b1);
    }

    /// Curves may leave each other where neither ends: two splines with the same first spans. They
    /// are equal up to rounding as far as they overlap, while beside a touch, of whatever order, only
    /// a small part of the stretch is. Trims it to where they are.
    bool trimToOverlap(Stretch& s) const
    {
        constexpr int kSteps = 64;
        constexpr double kEqual = 1.0 / 64.0;
        const double length = (s.a1 - s.a0) * speedAt(s.curveA, 0.5 * (s.a0 + s.a1));
        if (length <= 256.0 * near_) {
            return false;
        }
        const auto equalAt = [&](double share) {
            const Vec2 p = curves_[s.curveA].point((1.0 - share) * s.a0 + share * s.a1);
            return distance(p, curves_[s.curveB].point(facing(s, p))) <= kEqual * near_;
        };
        double low = 1.0;
        double high = 0.0;
        int equal = 0;
        for (int i = 0; i <= kSteps; ++i) {
            const double share = static_cast<double>(i) / kSteps;
            if (equalAt(share)) {
                ++equal;
                low = std::min(low, share);
                high = std::max(high, share);
            }
        }
        if (equal < 0.8 * kSteps) {
            return false;
        }
        double outer[] = {std::max(0.0, low - 1.0 / kSteps), std::min(1.0, high + 1.0 / kSteps)};
        for (int i = 0; i < 30; ++i) {
            const double first = 0.5 * (outer[0] + low);
            const double last = 0.5 * (outer[1] + high);
            (equalAt(first) ? low : outer[0]) = first;
            (equalAt(last) ? high : outer[1]) = last;
        }
        const double a0 = (1.0 - low) * s.a0 + low * s.a1;
        const double a1 = (1.0 - high) * s.a0 + high * s.a1;
        const double b0 = facing(s, curves_[s.curveA].point(a0));
        const double b1 = facing(s, curves_[s.curveA].point(a1));
        s = {s.curveA, s.curveB, a0, a1, b0, b1};
        return true;
    }

    /// Where on curve B a point of curve A's stretch lies.
    double facing(const Stretch& s, Vec2 p) const
    {
        return nearestParameter(curves_, arcs_, s.curveB, std::min(s.b0, s.b1),
                                std::max(s.b0, s.b1), p);
    }

    bool isEndOf(std::uint32_t curve, double t) const
    {
        const double reach = 64.0 * near_ / std::max(speedAt(curve, t), near_);
        const std::vector<double> ends = smoothIntervals(curves_[curve]);
        return std::any_of(ends.begin(), ends.end(),
                           [t, reach](double end) { return std::abs(end - t) <= reach; });
    }

    /// The one place that stands for a stretch: where both run parallel with the gap across them,
    /// or else where they cross, if the stretch leads there; or else its middle. A touch may have
    /// been found in several parts, all of which lead to one place in this way.
    Contact placeOf(const Stretch& stretch) const
    {
        // The parameters of curves of several pieces may run at quite different speeds.
        const double a = 0.5 * (stretch.a0 + stretch.a1);
        const Contact middle {stretch.curveA, stretch.curveB, a,
                              facing(stretch, curves_[stretch.curveA].point(a))};
        for (const Contact& place : {parallelPlace(middle), crossingPlace(middle)}) {
            if (leadsTo(middle, place)) {
                return place;
            }
        }
        return middle;
    }

    /// Where a curve ends by far it may not even be finite, and Newton's method has failed.
    static bool isNearDomain(const Curve& curve, double t)
    {
        const double margin = 0.5 * (curve.last() - curve.first());
        return t >= curve.first() - margin && t <= curve.last() + margin;
    }

    /// Newton's method on gap . a' = 0 and a' x b' = 0.
    Contact parallelPlace(Contact from) const
    {
        const Curve& a = curves_[from.curveA];
        const Curve& b = curves_[from.curveB];
        for (int i = 0; i < 12; ++i) {
            const Vec2 gap = a.point(from.s) - b.point(from.t);
            const Vec2 da = a.derivative(from.s);
            const Vec2 db = b.derivative(from.t);
            const double f = dot(gap, da);
            const double g = cross(da, db);
            const double fs = squaredLength(da) + dot(gap, a.secondDerivative(from.s));
            const double ft = -dot(db, da);
            const double gs = cross(a.secondDerivative(from.s), db);
            const double gt = cross(da, b.secondDerivative(from.t));
            const double determinant = fs * gt - ft * gs;
            if (determinant == 0.0) {
                break;
            }
            from.s -= (f * gt - ft * g) / determinant;
            from.t -= (fs * g - f * gs) / determinant;
            if (!isNearDomain(a, from.s) || !isNearDomain(b, from.t)) {
                break;
            }
        }
        return from;
    }

    /// Newton's method on gap = 0.
    Contact crossingPlace(Contact from) const
    {
        const Curve& a = curves_[from.curveA];
        const Curve& b = curves_[from.curveB];
        for (int i = 0; i < 12; ++i) {
            const Vec2 gap = b.point(from.t) - a.point(from.s);
            const Vec2 da = a.derivative(from.s);
            const Vec2 db = b.derivative(from.t);
            const double determinant = cross(da, db);
            if (determinant == 0.0) {
                break;
            }
            from.s += cross(gap, db) / determinant;
            from.t += cross(gap, da) / determinant;
            if (!isNearDomain(a, from.s) || !isNearDomain(b, from.t)) {
                break;
            }
        }
        return from;
    }

    /// Whether both places are on the curves, and those stay near each other between them.
    bool leadsTo(const Contact& from, const Contact& to) const
    {
        const Curve& a = curves_[from.curveA];
        const Curve& b = curves_[from.curveB];
        if (!(to.s >= a.first() && to.s <= a.last() && to.t >= b.first() && to.t <= b.last())) {
            return false;
        }
        const Arc along = makeArc(curves_, from.curveB, std::min(from.t, to.t),
                                  std::max(from.t, to.t));
        if (along.coneSine > 0.9) {
            return false;
        }
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const Vec2 p = a.point((1.0 - share) * from.s + share * to.s);
            const double u = nearestParameter(curves_, along, p);
            if (distance(p, b.point(u)) > 4.0 * near_) {
                return false;
            }
        }
        return true;
    }

    /// A contact that belongs to an end that both curves share: between the two they run along each
    /// other. If their geometries miss the common point, then by as much as they miss it.
    bool startsAtSharedEnd(const Contact& c) const
    {
        const auto endsOf = [this](std::uint32_t index) {
            const NetworkCurve& curve = curves_.network().curves[index];
            const Curve& geometry = curves_[index];
            return std::pair(std::pair(curve.start, geometry.first()),
                             std::pair(curve.end, geometry.last()));
        };
        const auto [startA, endA] = endsOf(c.curveA);
        const auto [startB, endB] = endsOf(c.curveB);
        for (const auto& [pointA, s] : {startA, endA}) {
            for (const auto& [pointB, t] : {startB, endB}) {
                const bool seam = c.curveA == c.curveB && s == t;
                if (pointA == pointB && !seam && runsAlong(c, pointA, s, t)) {
                    return true;
                }
            }
        }
        return c.curveA == c.curveB && isOneCorner(c);
    }

    bool runsAlong(const Contact& c, PointId shared, double s, double t) const
    {
        if (s == c.s || t == c.t) {
            return s == c.s && t == c.t;
        }
        const Vec2 p = curves_.network().points[shared.index()];
        const Curve& a = curves_[c.curveA];
        const double miss = std::max(distance(p, a.point(s)),
                                     distance(p, curves_[c.curveB].point(t)));
        const Arc along = makeArc(curves_, c.curveB, std::min(t, c.t), std::max(t, c.t));
        if (along.coneSine > 0.9) {
            return false;
        }
        for (const double share : {0.25, 0.5, 0.75}) {
            const Vec2 q = a.point((1.0 - share) * s + share * c.s);
            const double u = nearestParameter(curves_, along, q);
            if (distance(q, curves_[c.curveB].point(u)) > 2.0 * (near_ + miss)) {
                return false;
            }
        }
        return true;
    }

    /// A curve that meets itself where it already is: at a corner between two of its arcs.
    bool isOneCorner(const Contact& c) const
    {
        const double reach = 32.0 * near_;
        return distance(curves_[c.curveA].point(c.s), curves_[c.curveA].point(c.t)) <= reach
            && arcLength(curves_[c.curveA], std::min(c.s, c.t), std::max(c.s, c.t)) <= reach;
    }

    static void sortByPlace(std::vector<Contact>& contacts)
    {
        std::sort(contacts.begin(), contacts.end(), [](const Contact& p, const Contact& q) {
            return std::tie(p.curveA, p.curveB, p.s, p.t)
                < std::tie(q.curveA, q.curveB, q.s, q.t);
        });
    }

    const CurveSet& curves_;
    std::span<const Arc> arcs_;
    double near_;
    Execution& execution_;
    ArcPairFinder pairs_;
    std::vector<Contact> crossings_;
    CurveContacts result_;
};

} // namespace

CurveContacts findContacts(const CurveSet& curves, std::span<const Arc> arcs, double near,
                           Execution& execution)
{
    return ContactFinder(curves, arcs, near, execution).run();
}

} // namespace tessera
