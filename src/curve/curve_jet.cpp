// SPDX-License-Identifier: MIT
#include "curve/curve_jet.h"

#include "curve/curve_views.h"

#include <cmath>

namespace tessera
{

namespace
{

/// Trimmed curves have the parameters of their base.
const EllipseArc* findArc(const Curve& curve)
{
    if (const auto* trimmed = dynamic_cast<const TrimmedCurve*>(&curve)) {
        return findArc(*trimmed->base());
    }
    return dynamic_cast<const EllipseArc*>(&curve);
}

} // namespace

JetEvaluator::JetEvaluator(const Curve& curve)
    : curve_(curve)
    , arc_(findArc(curve))
{}

CurveJet JetEvaluator::operator()(double t) const
{
    if (arc_ == nullptr) {
        return {curve_.point(t), curve_.derivative(t), curve_.secondDerivative(t)};
    }
    const double c = std::cos(t);
    const double s = std::sin(t);
    const Vec2 u = arc_->u();
    const Vec2 v = arc_->v();
    const Vec2 radius {c * u.x + s * v.x, c * u.y + s * v.y};
    return {arc_->center() + radius, c * v - s * u, -1.0 * radius};
}

} // namespace tessera
