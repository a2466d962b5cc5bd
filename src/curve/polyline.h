// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"
#include "curve/curve.h"
#include "curve/curve_network.h"

#include <span>
#include <vector>

namespace tessera
{

/// Straight pieces between points as one curve; piece i covers the parameters [i, i + 1]. Its inner
/// points are breaks. A point that repeats the one before is taken once.
class PolylineCurve final: public Curve
{
public:
    /// Throws Error(InvalidInput) unless there are at least two points, all finite.
    explicit PolylineCurve(std::vector<Vec2> points);

    double first() const override { return 0.0; }
    double last() const override { return static_cast<double>(points_.size() - 1); }
    Vec2 point(double t) const override;
    Vec2 derivative(double t) const override;
    Vec2 secondDerivative(double) const override { return {}; }
    std::vector<double> breaks() const override;
    double secondDerivativeBound(double, double) const override { return 0.0; }

private:
    std::size_t pieceAt(double t) const;

    std::vector<Vec2> points_;
};

/// Adds points and one straight curve for each piece, closed back to the first point if asked.
/// Source numbers count up from firstSource. Returns the id of the first point.
PointId addPolyline(CurveNetwork& network, std::span<const Vec2> points, bool closed,
                    OperandId operand, Role role, std::uint32_t firstSource = 0);

} // namespace tessera
