// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve.h"

#include <memory>

namespace tessera
{

/// Arc of an ellipse, also a whole one: center + cos(t) u + sin(t) v for t in [first, last], with
/// the conjugate half axes u and v. Counter-clockwise if cross(u, v) > 0.
class EllipseArc final: public Curve
{
public:
    /// Angles in radians. Throws Error(InvalidInput) unless all values are finite and first < last.
    EllipseArc(Vec2 center, Vec2 u, Vec2 v, double first, double last);

    double first() const override { return first_; }
    double last() const override { return last_; }
    Vec2 point(double t) const override;
    Vec2 derivative(double t) const override;
    Vec2 secondDerivative(double t) const override;
    double secondDerivativeBound(double a, double b) const override;

    Vec2 center() const { return center_; }
    Vec2 u() const { return u_; }
    Vec2 v() const { return v_; }
    /// The greatest half axis of the ellipse.
    double greatestHalfAxis() const { return greatestHalfAxis_; }

private:
    Vec2 center_;
    Vec2 u_;
    Vec2 v_;
    double first_;
    double last_;
    double greatestHalfAxis_;
};

/// Circle arc from one angle to the other, radians; clockwise if endAngle < startAngle. A whole
/// circle has ends 2 pi apart. Throws Error(InvalidInput) unless radius > 0, the angles differ and
/// all are finite.
std::shared_ptr<const EllipseArc> makeCircleArc(Vec2 center, double radius, double startAngle,
                                                double endAngle);

/// Arc of an axis-parallel ellipse turned by rotation (radians), angles as parameters of the
/// ellipse; clockwise if endAngle < startAngle.
std::shared_ptr<const EllipseArc> makeEllipseArc(Vec2 center, double halfAxisX, double halfAxisY,
                                                 double rotation, double startAngle,
                                                 double endAngle);

} // namespace tessera
