// SPDX-License-Identifier: MIT
#include "curve/polyline.h"

#include "base/error.h"

#include <algorithm>

namespace tessera
{

PolylineCurve::PolylineCurve(std::vector<Vec2> points)
    : points_(std::move(points))
{
    if (points_.size() < 2) {
        throw Error(ErrorKind::InvalidInput, "A polyline needs at least two points.");
    }
    for (const Vec2 p : points_) {
        if (!isFinite(p)) {
            throw Error(ErrorKind::InvalidInput, "A polyline has a point that is not finite.",
                        {{p}});
        }
    }
    // A piece without length has no tangent.
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    if (points_.size() < 2) {
        points_.push_back(points_.front());
    }
}

std::size_t PolylineCurve::pieceAt(double t) const
{
    const double inside = std::clamp(t, 0.0, last());
    return std::min(static_cast<std::size_t>(inside), points_.size() - 2);
}

Vec2 PolylineCurve::point(double t) const
{
    const std::size_t i = pieceAt(t);
    const double s = t - static_cast<double>(i);
    return (1.0 - s) * points_[i] + s * points_[i + 1];
}

Vec2 PolylineCurve::derivative(double t) const
{
    const std::size_t i = pieceAt(t);
    return points_[i + 1] - points_[i];
}

std::vector<double> PolylineCurve::breaks() const
{
    std::vector<double> result;
    for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
        result.push_back(static_cast<double>(i));
    }
    return result;
}

PointId addPolyline(CurveNetwork& network, std::span<const Vec2> points, bool closed,
                    OperandId operand, Role role, std::uint32_t firstSource)
{
    const std::size_t firstPoint = network.points.size();
    network.points.insert(network.points.end(), points.begin(), points.end());
    const std::size_t count = points.size();
    const std::size_t pieces = count < 2 ? 0 : (closed ? count : count - 1);
    for (std::size_t i = 0; i < pieces; ++i) {
        NetworkCurve curve;
        curve.start = PointId(firstPoint + i);
        curve.end = PointId(firstPoint + (i + 1) % count);
        curve.operand = operand;
        curve.role = role;
        curve.source = firstSource + static_cast<std::uint32_t>(i);
        network.curves.push_back(std::move(curve));
    }
    return PointId(firstPoint);
}

} // namespace tessera
