// SPDX-License-Identifier: MIT
#include "curve/curve_tools.h"

#include "curve/arc.h"

#include <algorithm>
#include <cmath>

namespace tessera
{

namespace
{

constexpr int kMaxDepth = 40;

double adaptiveLength(const Curve& curve, double a, double b, double whole, double tolerance,
                      int depth)
{
    const auto speed = [&curve](double t) { return length(curve.derivative(t)); };
    const double middle = 0.5 * (a + b);
    const double left = gaussLegendre(speed, a, middle);
    const double right = gaussLegendre(speed, middle, b);
    if (depth == 0 || std::abs(left + right - whole) <= tolerance) {
        return left + right;
    }
    return adaptiveLength(curve, a, middle, left, tolerance, depth - 1)
        + adaptiveLength(curve, middle, b, right, tolerance, depth - 1);
}

/// Adds [a, b] to the box, halving it as long as its sagitta may reach out by more than tolerance.
void addTightBounds(const Curve& curve, double a, double b, double tolerance, int depth, Box2& box)
{
    const double sagitta = sagittaBound(curve, a, b);
    const Box2 outer = arcBounds(curve, a, b);
    if (box.contains(outer.min) && box.contains(outer.max)) {
        return;
    }
    if (sagitta <= tolerance || depth == 0) {
        box.add(outer);
        return;
    }
    const double middle = 0.5 * (a + b);
    box.add(curve.point(middle));
    addTightBounds(curve, a, middle, tolerance, depth - 1, box);
    addTightBounds(curve, middle, b, tolerance, depth - 1, box);
}

/// Whether the bounds of an arc of an ellipse are certainly within the box: those of its whole
/// ellipse are.
bool staysWithin(const Curve& curve, const Box2& box)
{
    const auto* arc = dynamic_cast<const EllipseArc*>(&curve);
    if (arc == nullptr) {
        return false;
    }
    const Vec2 extent {std::hypot(arc->u().x, arc->v().x), std::hypot(arc->u().y, arc->v().y)};
    const Box2 whole {arc->center() - extent, arc->center() + extent};
    const Box2 generous = whole.grown(1e-5 * whole.diagonal());
    return box.contains(generous.min) && box.contains(generous.max);
}

} // namespace

std::vector<double> smoothIntervals(const Curve& curve)
{
    std::vector<double> result {curve.first()};
    for (const double t : curve.breaks()) {
        result.push_back(t);
    }
    result.push_back(curve.last());
    return result;
}

double arcLength(const Curve& curve, double a, double b)
{
    const auto speed = [&curve](double t) { return length(curve.derivative(t)); };
    const double whole = gaussLegendre(speed, a, b);
    // No better than the parameters of its ends are known: below that there is only noise.
    const double rounding = 0x1p-52 * std::max(std::abs(a), std::abs(b)) / std::abs(b - a) * whole;
    return adaptiveLength(curve, a, b, whole, std::max(1e-13 * whole, rounding), kMaxDepth);
}

double arcLength(const Curve& curve)
{
    const std::vector<double> ends = smoothIntervals(curve);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        sum += arcLength(curve, ends[i], ends[i + 1]);
    }
    return sum;
}

double turningRate(const Curve& curve, double t)
{
    const Vec2 d = curve.derivative(t);
    const double speed = length(d);
    if (!(speed > 0.0)) {
        return 0.0;
    }
    const Vec2 direction = (1.0 / speed) * d;
    return std::abs(cross(direction, curve.secondDerivative(t))) / speed;
}

double sagittaBound(const Curve& curve, double a, double b)
{
    return 0.125 * (b - a) * (b - a) * curve.secondDerivativeBound(a, b);
}

Box2 arcBounds(const Curve& curve, double a, double b)
{
    Box2 box;
    box.add(curve.point(a));
    box.add(curve.point(b));
    return box.grown(sagittaBound(curve, a, b));
}

Box2 curveBounds(const Curve& curve)
{
    const std::vector<double> ends = smoothIntervals(curve);
    Box2 box;
    for (const double t : ends) {
        box.add(curve.point(t));
    }
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        box.add(curve.point(0.5 * (ends[i] + ends[i + 1])));
    }
    // No better than points are known, of an ellipse to the rounding of its axes: below that halving
    // has no end.
    const double known = std::fabs(box.min.x) + std::fabs(box.min.y)
        + curve.secondDerivativeBound(curve.first(), curve.last());
    const double tolerance = std::max(1e-6 * box.diagonal(), 0x1p-51 * known);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        addTightBounds(curve, ends[i], ends[i + 1], tolerance, 24, box);
    }
    return box;
}

Box2 networkBounds(const CurveNetwork& network)
{
    Box2 box;
    for (const NetworkCurve& curve : network.curves) {
        if (curve.role == Role::Ignored) {
            continue;
        }
        box.add(network.points[curve.start.index()]);
        box.add(network.points[curve.end.index()]);
    }
    for (const EmbeddedPoint& embedded : network.embedded) {
        box.add(network.points[embedded.point.index()]);
    }
    for (const NetworkCurve& curve : network.curves) {
        if (curve.role != Role::Ignored && curve.geometry && !staysWithin(*curve.geometry, box)) {
            box.add(curveBounds(*curve.geometry));
        }
    }
    return box;
}

double curveLength(const CurveNetwork& network, const NetworkCurve& curve)
{
    return curve.geometry
        ? arcLength(*curve.geometry)
        : distance(network.points[curve.start.index()], network.points[curve.end.index()]);
}

} // namespace tessera
