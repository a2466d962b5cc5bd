// SPDX-License-Identifier: MIT
#pragma once

#include "curve/arc.h"

namespace tessera
{

/// What a curve does at a parameter.
struct CurveJet
{
    Vec2 point;
    Vec2 derivative;
    Vec2 secondDerivative;
};

/// Evaluates all of it at once. Parts of ellipses need one sine and one cosine for the three, any
/// other curve is asked three times. The curve must outlive it.
class JetEvaluator
{
public:
    explicit JetEvaluator(const Curve& curve);

    CurveJet operator()(double t) const;

private:
    const Curve& curve_;
    const EllipseArc* arc_; ///< null: another curve
};

} // namespace tessera
