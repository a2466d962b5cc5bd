// SPDX-License-Identifier: MIT
//
// Green's theorem: half the integral of (C - C(a)) x C'. On center + cos t u + sin t v that is
// u x v (dt - sin dt) / 2; elsewhere Gauss-Legendre quadrature on halves that agree with the whole.
#include "curve/chord_area.h"

#include "curve/arc.h"
#include "curve/curve_tools.h"
#include "curve/curve_views.h"

#include <algorithm>
#include <cmath>

namespace tessera
{

namespace
{

constexpr int kMostHalvings = 20;
constexpr double kPrecision = 1e-13;

/// Between parameters without a break between them; about the point from.
double smoothArea(const Curve& curve, Vec2 from, double a, double b)
{
    const auto integrand = [&curve, from](double t) {
        return 0.5 * cross(curve.point(t) - from, curve.derivative(t));
    };
    double sum = 0.0;
    const auto add = [&](auto&& self, double low, double high, double whole, int depth) -> void {
        const double middle = 0.5 * (low + high);
        const double left = gaussLegendre(integrand, low, middle);
        const double right = gaussLegendre(integrand, middle, high);
        const double scale = squaredLength(curve.point(low) - from)
            + squaredLength(curve.point(high) - from);
        if (depth == 0 || std::abs(left + right - whole) <= kPrecision * scale) {
            sum += left + right;
            return;
        }
        self(self, low, middle, left, depth - 1);
        self(self, middle, high, right, depth - 1);
    };
    add(add, a, b, gaussLegendre(integrand, a, b), kMostHalvings);
    return sum;
}

/// a < b.
double forwardArea(const Curve& curve, double a, double b)
{
    const Vec2 from = curve.point(a);
    double sum = 0.0;
    double before = a;
    for (const double t : curve.breaks()) {
        if (t > before && t < b) {
            sum += smoothArea(curve, from, before, t);
            before = t;
        }
    }
    return sum + smoothArea(curve, from, before, b);
}

} // namespace

double chordArea(const Curve& curve, double a, double b)
{
    if (const auto* trimmed = dynamic_cast<const TrimmedCurve*>(&curve)) {
        return chordArea(*trimmed->base(), a, b);
    }
    if (const auto* reversed = dynamic_cast<const ReversedCurve*>(&curve)) {
        return chordArea(*reversed->base(), reversed->onBase(a), reversed->onBase(b));
    }
    if (const auto* arc = dynamic_cast<const EllipseArc*>(&curve)) {
        return 0.5 * cross(arc->u(), arc->v()) * ((b - a) - std::sin(b - a));
    }
    return a <= b ? forwardArea(curve, a, b) : -forwardArea(curve, b, a);
}

} // namespace tessera
