// SPDX-License-Identifier: MIT
#pragma once

// The plate that meshes are compared on: unit square, five round holes, four inner lines; and a size
// that grows from a point or a segment.

#include "curve/arc.h"
#include "curve/curve_network.h"
#include "sizing/size_field.h"

#include <algorithm>
#include <cmath>

namespace tessera::bench
{

/// smallest + growth × distance to the segment from a to b.
class GradedSize: public SizeField
{
public:
    GradedSize(Vec2 a, Vec2 b, double smallest, double growth)
        : a_(a)
        , b_(b)
        , smallest_(smallest)
        , growth_(growth)
    {}
    double size(Vec2 p) const override
    {
        const Vec2 along = b_ - a_;
        const double square = squaredLength(along);
        const double s = square > 0.0 ? std::clamp(dot(p - a_, along) / square, 0.0, 1.0) : 0.0;
        return smallest_ + growth_ * std::sqrt(squaredLength(p - a_ - s * along));
    }
    double gradientBound() const override { return growth_; }

private:
    Vec2 a_, b_;
    double smallest_, growth_;
};

inline CurveNetwork plate()
{
    CurveNetwork network;
    network.operands.push_back({"plate"});
    const OperandId operand(0U);
    const auto line = [&](PointId a, PointId b, Role role) {
        NetworkCurve curve;
        curve.start = a;
        curve.end = b;
        curve.operand = operand;
        curve.role = role;
        network.curves.push_back(curve);
    };
    const PointId corner[4] = {network.addPoint({0, 0}), network.addPoint({1, 0}),
                               network.addPoint({1, 1}), network.addPoint({0, 1})};
    for (int i = 0; i < 4; ++i) {
        line(corner[i], corner[(i + 1) % 4], Role::Boundary);
    }
    const struct
    {
        Vec2 center;
        double radius;
    } holes[5] = {{{0.22, 0.24}, 0.08}, {{0.78, 0.22}, 0.08}, {{0.24, 0.77}, 0.08},
                  {{0.76, 0.79}, 0.08}, {{0.52, 0.49}, 0.12}};
    for (const auto& hole : holes) {
        NetworkCurve circle;
        circle.geometry = makeCircleArc(hole.center, hole.radius, 0.0, 2.0 * M_PI);
        circle.start = network.addPoint(circle.geometry->point(circle.geometry->first()));
        circle.end = circle.start;
        circle.operand = operand;
        network.curves.push_back(circle);
    }
    const Vec2 lines[4][2] = {{{0.1, 0.45}, {0.3, 0.52}}, {{0.7, 0.55}, {0.92, 0.45}},
                              {{0.45, 0.08}, {0.55, 0.25}}, {{0.42, 0.72}, {0.58, 0.93}}};
    for (const auto& l : lines) {
        const PointId a = network.addPoint(l[0]);
        line(a, network.addPoint(l[1]), Role::Constraint);
    }
    return network;
}

} // namespace tessera::bench
