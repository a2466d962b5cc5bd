// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "curve/curve.h"
#include "curve/curve_network.h"

#include <vector>

namespace tessera
{

/// Five-point Gauss–Legendre quadrature of f over [a, b]; exact for polynomials of degree 9.
template<class F>
double gaussLegendre(F&& f, double a, double b)
{
    constexpr double kNode[2] = {0.53846931010568309, 0.90617984593866399};
    constexpr double kWeight[2] = {0.47862867049936647, 0.23692688505618909};
    constexpr double kMiddleWeight = 0.56888888888888889;
    const double middle = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    double sum = kMiddleWeight * f(middle);
    for (int i = 0; i < 2; ++i) {
        sum += kWeight[i] * (f(middle - half * kNode[i]) + f(middle + half * kNode[i]));
    }
    return half * sum;
}

/// first(), the breaks, last().
std::vector<double> smoothIntervals(const Curve& curve);

/// Length of the curve between two parameters without a break between them, to about 1e-12 of it.
double arcLength(const Curve& curve, double a, double b);
/// Length of the whole curve.
double arcLength(const Curve& curve);

/// |x'y'' - y'x''| / |C'|^2: curvature times speed, so that its integral is the angle by which the
/// tangent turns. 0 where the speed is 0.
double turningRate(const Curve& curve, double t);

/// An upper bound of the distance between the curve and the chord from a to b; no break between.
double sagittaBound(const Curve& curve, double a, double b);

/// A box that holds the curve between two parameters without a break between them: the box of both
/// ends, grown by the sagitta bound.
Box2 arcBounds(const Curve& curve, double a, double b);

/// The whole curve's box, at most about 1e-6 of its diagonal too large.
Box2 curveBounds(const Curve& curve);

/// The box of everything that is meshed: curves of a role other than Ignored and embedded points.
Box2 networkBounds(const CurveNetwork& network);

/// Length of a curve of the network; straight without geometry.
double curveLength(const CurveNetwork& network, const NetworkCurve& curve);

} // namespace tessera
