// SPDX-License-Identifier: MIT
#include "curve/arc.h"

#include "base/error.h"

#include <cmath>

namespace tessera
{

namespace
{

double largestSingularValue(Vec2 u, Vec2 v)
{
    const double sum = length({u.x + v.y, u.y - v.x});
    const double difference = length({u.x - v.y, u.y + v.x});
    return 0.5 * (sum + difference);
}

} // namespace

EllipseArc::EllipseArc(Vec2 center, Vec2 u, Vec2 v, double first, double last)
    : center_(center)
    , u_(u)
    , v_(v)
    , first_(first)
    , last_(last)
    , greatestHalfAxis_(largestSingularValue(u, v))
{
    if (!tessera::isFinite(center) || !tessera::isFinite(u) || !tessera::isFinite(v)
        || !std::isfinite(first) || !std::isfinite(last) || !(first < last)) {
        throw Error(ErrorKind::InvalidInput,
                    "An arc needs finite values, half axes and two different angles.", {{center}});
    }
}

Vec2 EllipseArc::point(double t) const
{
    const double c = std::cos(t);
    const double s = std::sin(t);
    return {center_.x + (c * u_.x + s * v_.x), center_.y + (c * u_.y + s * v_.y)};
}

Vec2 EllipseArc::derivative(double t) const
{
    return std::cos(t) * v_ - std::sin(t) * u_;
}

Vec2 EllipseArc::secondDerivative(double t) const
{
    return -std::cos(t) * u_ - std::sin(t) * v_;
}

double EllipseArc::secondDerivativeBound(double, double) const
{
    return greatestHalfAxis_;
}

std::shared_ptr<const EllipseArc> makeEllipseArc(Vec2 center, double halfAxisX, double halfAxisY,
                                                 double rotation, double startAngle,
                                                 double endAngle)
{
    if (!(halfAxisX > 0.0) || !(halfAxisY > 0.0) || startAngle == endAngle) {
        throw Error(ErrorKind::InvalidInput,
                    "An arc needs a radius above 0 and two different angles.", {{center}});
    }
    const double c = std::cos(rotation);
    const double s = std::sin(rotation);
    const Vec2 u {halfAxisX * c, halfAxisX * s};
    const Vec2 v {-halfAxisY * s, halfAxisY * c};
    if (startAngle < endAngle) {
        return std::make_shared<EllipseArc>(center, u, v, startAngle, endAngle);
    }
    return std::make_shared<EllipseArc>(center, u, Vec2 {-v.x, -v.y}, -startAngle, -endAngle);
}

std::shared_ptr<const EllipseArc> makeCircleArc(Vec2 center, double radius, double startAngle,
                                                double endAngle)
{
    return makeEllipseArc(center, radius, radius, 0.0, startAngle, endAngle);
}

} // namespace tessera
