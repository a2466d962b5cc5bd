// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve.h"

namespace tessera
{

/// Straight line from a to b over [0, 1]. A NetworkCurve without geometry means the same; this
/// class serves where a Curve is needed.
class LineCurve final: public Curve
{
public:
    LineCurve(Vec2 a, Vec2 b)
        : a_(a)
        , b_(b)
    {}

    double first() const override { return 0.0; }
    double last() const override { return 1.0; }
    /// Symmetric: the same point, bit for bit, for the line from b to a at 1 - t.
    /// Exact in a coordinate that both ends share, and the same from either end.
    Vec2 point(double t) const override
    {
        return t < 0.5 ? a_ + t * (b_ - a_) : b_ - (1.0 - t) * (b_ - a_);
    }
    Vec2 derivative(double) const override { return b_ - a_; }
    Vec2 secondDerivative(double) const override { return {}; }
    double secondDerivativeBound(double, double) const override { return 0.0; }

private:
    Vec2 a_;
    Vec2 b_;
};

} // namespace tessera
