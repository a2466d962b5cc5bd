// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <vector>

namespace tessera
{

/// A smooth parametric curve of the plane over [first(), last()]. Lines, arcs and polylines are
/// in this folder; OpenCASCADE's curves implement it in occt/. Immutable and thread-safe.
class Curve
{
public:
    virtual ~Curve() = default;

    virtual double first() const = 0;
    virtual double last() const = 0;
    virtual Vec2 point(double t) const = 0;
    /// d/dt and d²/dt².
    virtual Vec2 derivative(double t) const = 0;
    virtual Vec2 secondDerivative(double t) const = 0;

    /// Parameters strictly between first() and last(), ascending, where the curve is not twice
    /// continuously differentiable: corners of a polyline, multiple knots of a spline. Sampling
    /// puts a point on those where the tangent jumps.
    virtual std::vector<double> breaks() const { return {}; }

    /// An upper bound of |d²/dt²| over [a, b], which has no break inside. The default samples the
    /// second derivative and adds a margin, which is enough for curves of moderate degree; curves
    /// that know better override it. Bounds of sub-arcs and sagittas rest on it.
    virtual double secondDerivativeBound(double a, double b) const;
};

} // namespace tessera
