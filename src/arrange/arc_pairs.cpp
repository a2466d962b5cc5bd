// SPDX-License-Identifier: MIT
#include "arrange/arc_pairs.h"

#include <algorithm>
#include <cmath>

namespace tessera
{

namespace
{

constexpr int kMostSteps = 20000;
/// The part of the tolerance that rounding can take of a crossing's residual.
constexpr double kRounding = 1.0 / 64.0;
/// Arcs are compared for running along each other once their sagittas are this part of their chords
/// and their cones are this narrow.
constexpr double kFlat = 0.05;
constexpr double kFlatCone = 0.3;

/// The extent of an arc along a unit axis, grown by its sagitta.
struct Extent
{
    double low;
    double high;
};

Extent along(const Arc& arc, Vec2 axis, Vec2 origin)
{
    const double p = dot(arc.pa - origin, axis);
    const double q = dot(arc.pb - origin, axis);
    return {std::min(p, q) - arc.sagitta, std::max(p, q) + arc.sagitta};
}

bool apartAlong(const Arc& a, const Arc& b, Vec2 axis, double near)
{
    const Extent p = along(a, axis, a.pa);
    const Extent q = along(b, axis, a.pa);
    return p.low > q.high + near || q.low > p.high + near;
}

} // namespace

void ArcPairFinder::find(const Arc& a, const Arc& b)
{
    budget_ = kMostSteps;
    search(a, b);
    if (budget_ < 0) {
        unresolved.push_back(midpoint(a.pa, a.pb));
    }
}

void ArcPairFinder::search(const Arc& a, const Arc& b)
{
    if (--budget_ < 0 || apart(a, b)) {
        return;
    }
    if ((neverParallel(a, b) && addCrossing(a, b)) || addStretch(a, b)) {
        return;
    }
    const double chordA = a.chord();
    const double chordB = b.chord();
    if (std::max(chordA + a.sagitta, chordB + b.sagitta) <= 2.0 * near_) {
        const double s = 0.5 * (a.a + a.b);
        const double t = 0.5 * (b.a + b.b);
        stretches.push_back({a.curve, b.curve, s, s, t, t});
        return;
    }
    if (chordA > 2.0 * chordB) {
        const auto [left, right] = halve(curves_, a);
        search(left, b);
        search(right, b);
    }
    else if (chordB > 2.0 * chordA) {
        const auto [left, right] = halve(curves_, b);
        search(a, left);
        search(a, right);
    }
    else {
        const auto [leftA, rightA] = halve(curves_, a);
        const auto [leftB, rightB] = halve(curves_, b);
        search(leftA, leftB);
        search(leftA, rightB);
        search(rightA, leftB);
        search(rightA, rightB);
    }
}

/// Boxes along both chords: the distance of two curves that are almost parallel shows across them.
bool ArcPairFinder::apart(const Arc& a, const Arc& b) const
{
    for (const Arc* arc : {&a, &b}) {
        const double chord = arc->chord();
        if (chord > 0.0) {
            const Vec2 direction = (1.0 / chord) * (arc->pb - arc->pa);
            if (apartAlong(a, b, {-direction.y, direction.x}, near_)
                || apartAlong(a, b, direction, near_)) {
                return true;
            }
        }
    }
    return !a.box().grown(near_).overlaps(b.box());
}

bool ArcPairFinder::neverParallel(const Arc& a, const Arc& b) const
{
    if (a.coneSine >= 1.0 || b.coneSine >= 1.0) {
        return false;
    }
    const double sine = std::abs(cross(a.direction, b.direction))
        / (length(a.direction) * length(b.direction));
    return std::asin(std::min(1.0, sine)) > std::asin(a.coneSine) + std::asin(b.coneSine) + 1e-9;
}

bool ArcPairFinder::addCrossing(const Arc& a, const Arc& b)
{
    const Curve& curveA = curves_[a.curve];
    const Curve& curveB = curves_[b.curve];
    const double marginA = 0.25 * (a.b - a.a);
    const double marginB = 0.25 * (b.b - b.a);
    double s = 0.5 * (a.a + a.b);
    double t = 0.5 * (b.a + b.b);
    double distanceBefore = 0.0;
    for (int i = 0; i < 16; ++i) {
        const Vec2 gap = curveB.point(t) - curveA.point(s);
        const Vec2 da = curveA.derivative(s);
        const Vec2 db = curveB.derivative(t);
        const double determinant = cross(da, db);
        const double distanceNow = length(gap);
        if (determinant == 0.0 || (i > 3 && distanceNow >= distanceBefore)) {
            break; // as close as rounding allows
        }
        distanceBefore = distanceNow;
        s = std::clamp(s + cross(gap, db) / determinant, a.a - marginA, a.b + marginA);
        t = std::clamp(t + cross(gap, da) / determinant, b.a - marginB, b.b + marginB);
    }
    s = std::clamp(s, std::max(curveA.first(), a.a - near_ / length(a.direction)),
                   std::min(curveA.last(), a.b + near_ / length(a.direction)));
    t = std::clamp(t, std::max(curveB.first(), b.a - near_ / length(b.direction)),
                   std::min(curveB.last(), b.b + near_ / length(b.direction)));
    // Inside both, a crossing has no gap but rounding; an end may miss the other curve.
    const bool atEnd = s == curveA.first() || s == curveA.last() || t == curveB.first()
        || t == curveB.last();
    if (distance(curveA.point(s), curveB.point(t)) > (atEnd ? near_ : kRounding * near_)) {
        return false;
    }
    crossings.push_back({a.curve, b.curve, s, t});
    return true;
}

/// Compares the parts of both that face each other, at five points. Beyond these parts the arcs
/// cannot meet: each lies behind the normals at its own ends, and the other one leads away from
/// there. The tolerance is twice the one of apart(), so that no gap lies between the two decisions.
bool ArcPairFinder::addStretch(const Arc& a, const Arc& b)
{
    const bool flat = a.sagitta + b.sagitta <= kFlat * std::min(a.chord(), b.chord());
    const double sine = std::abs(cross(a.direction, b.direction));
    const bool alike = sine <= 0.5 * length(a.direction) * length(b.direction);
    if (!flat || !alike || a.coneSine > kFlatCone || b.coneSine > kFlatCone) {
        return false;
    }
    const double toStart = nearestParameter(curves_, a, b.pa);
    const double toEnd = nearestParameter(curves_, a, b.pb);
    const double low = std::min(toStart, toEnd);
    const double high = std::max(toStart, toEnd);
    constexpr double kShares[] = {0.5, 0.0, 1.0, 0.3, 0.7};
    double onB[5];
    for (int i = 0; i < 5; ++i) {
        const Vec2 p = curves_[a.curve].point((1.0 - kShares[i]) * low + kShares[i] * high);
        onB[i] = nearestParameter(curves_, b, p);
        if (distance(p, curves_[b.curve].point(onB[i])) > 2.0 * near_) {
            return false;
        }
    }
    stretches.push_back({a.curve, b.curve, low, high, onB[1], onB[2]});
    return true;
}

} // namespace tessera
