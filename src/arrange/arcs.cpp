// SPDX-License-Identifier: MIT
#include "arrange/arcs.h"

#include "curve/curve_tools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera
{

namespace
{

/// Half the angle that the tangents of a ready arc may span: sin(28 degrees).
constexpr double kConeSine = 0.47;
constexpr int kMaxDepth = 24;

Arc finishArc(const Curve& curve, Arc arc)
{
    const double half = 0.5 * (arc.b - arc.a);
    arc.direction = curve.derivative(0.5 * (arc.a + arc.b));
    arc.sagitta = 0.5 * half * half * arc.secondBound;
    const double speed = length(arc.direction);
    const double change = half * arc.secondBound;
    arc.coneSine = change < speed ? change / speed : 1.0;
    return arc;
}

void cut(const CurveSet& curves, const Arc& arc, int depth, std::vector<Arc>& arcs)
{
    if (arc.chord() + arc.sagitta == 0.0) {
        return; // without length it meets nothing but points
    }
    if (arc.coneSine <= kConeSine || depth == 0) {
        arcs.push_back(arc);
        return;
    }
    const double middle = 0.5 * (arc.a + arc.b);
    // Fresh bounds while the pieces are large; halve() would keep the whole curve's.
    cut(curves, makeArc(curves, arc.curve, arc.a, middle), depth - 1, arcs);
    cut(curves, makeArc(curves, arc.curve, middle, arc.b), depth - 1, arcs);
}

void cutOne(const CurveSet& curves, std::uint32_t curve, std::vector<Arc>& arcs)
{
    const std::vector<double> ends = smoothIntervals(curves[curve]);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        cut(curves, makeArc(curves, curve, ends[i], ends[i + 1]), kMaxDepth, arcs);
    }
}

} // namespace

CurveSet::CurveSet(const CurveNetwork& network)
    : network_(network)
{
    curves_.reserve(network.curves.size());
    for (const NetworkCurve& curve : network.curves) {
        if (curve.role == Role::Ignored) {
            curves_.push_back(nullptr);
        }
        else if (curve.geometry) {
            curves_.push_back(curve.geometry.get());
        }
        else {
            lines_.emplace_back(network.points[curve.start.index()],
                                network.points[curve.end.index()]);
            curves_.push_back(&lines_.back());
        }
    }
}

Box2 Arc::box() const
{
    Box2 result;
    result.add(pa);
    result.add(pb);
    return result.grown(sagitta);
}

Arc makeArc(const CurveSet& curves, std::uint32_t curve, double a, double b)
{
    const Curve& geometry = curves[curve];
    Arc arc {};
    arc.curve = curve;
    arc.a = a;
    arc.b = b;
    arc.pa = geometry.point(a);
    arc.pb = geometry.point(b);
    arc.secondBound = geometry.secondDerivativeBound(a, b);
    return finishArc(geometry, arc);
}

std::pair<Arc, Arc> halve(const CurveSet& curves, const Arc& arc)
{
    const Curve& geometry = curves[arc.curve];
    const double middle = 0.5 * (arc.a + arc.b);
    Arc left = arc;
    Arc right = arc;
    left.b = right.a = middle;
    left.pb = right.pa = geometry.point(middle);
    return {finishArc(geometry, left), finishArc(geometry, right)};
}

std::vector<Arc> cutIntoArcs(const CurveSet& curves)
{
    std::vector<Arc> arcs;
    for (std::uint32_t c = 0; c < curves.size(); ++c) {
        if (curves.find(c) != nullptr) {
            cutOne(curves, c, arcs);
        }
    }
    return arcs;
}

std::vector<Arc> cutIntoArcs(const CurveSet& curves, std::uint32_t curve)
{
    std::vector<Arc> arcs;
    cutOne(curves, curve, arcs);
    return arcs;
}

double nearestParameter(const CurveSet& curves, const Arc& arc, Vec2 p)
{
    const Curve& curve = curves[arc.curve];
    const Vec2 chord = arc.pb - arc.pa;
    const double square = squaredLength(chord);
    const double share =
        square > 0.0 ? std::clamp(dot(p - arc.pa, chord) / square, 0.0, 1.0) : 0.5;
    double t = arc.a + share * (arc.b - arc.a);
    // Newton on (C - p) . C' = 0, with the Gauss part alone where the full derivative is negative.
    for (int i = 0; i < 30; ++i) {
        const Vec2 offset = curve.point(t) - p;
        const Vec2 d = curve.derivative(t);
        const double speed = squaredLength(d);
        const double full = speed + dot(offset, curve.secondDerivative(t));
        const double slope = full > 0.0 ? full : speed;
        if (!(slope > 0.0)) {
            break;
        }
        const double next = std::clamp(t - dot(offset, d) / slope, arc.a, arc.b);
        const double step = std::abs(next - t);
        t = next;
        if (step <= 1e-16 * (std::abs(arc.a) + std::abs(arc.b))) {
            break;
        }
    }
    return t;
}

double nearestParameter(const CurveSet& curves, std::span<const Arc> arcs, std::uint32_t curve,
                        double low, double high, Vec2 p)
{
    double best = low;
    double least = std::numeric_limits<double>::infinity();
    auto arc = std::lower_bound(arcs.begin(), arcs.end(), curve,
                                [](const Arc& a, std::uint32_t c) { return a.curve < c; });
    for (; arc != arcs.end() && arc->curve == curve; ++arc) {
        const double from = std::max(low, arc->a);
        const double to = std::min(high, arc->b);
        if (from <= to) {
            const double t = std::clamp(nearestParameter(curves, *arc, p), from, to);
            const double d = distance(curves[curve].point(t), p);
            best = d < least ? t : best;
            least = std::min(least, d);
        }
    }
    return best;
}

} // namespace tessera
