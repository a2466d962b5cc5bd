// SPDX-License-Identifier: MIT
#pragma once

// The plate that meshes are compared on: unit square, five round holes, four inner lines; and a size
// that grows from a point or a segment.

#include "curve/arc.h"
#include "curve/curve_network.h"
#include "sizing/size_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

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

    /// The same in x and y, without min and max, which Gmsh's expressions lack.
    std::string expression() const
    {
        const Vec2 along = b_ - a_;
        const double square = squaredLength(along);
        std::ostringstream text;
        text.precision(17);
        if (square > 0.0) {
            std::ostringstream s;
            s.precision(17);
            s << "(((x-" << a_.x << ")*(" << along.x << ")+(y-" << a_.y << ")*(" << along.y << "))/"
              << square << ')';
            const std::string clamped
                = "(0.5*(abs" + s.str() + "-abs(" + s.str() + "-1)+1))";
            text << smallest_ << '+' << growth_ << "*sqrt((x-" << a_.x << "-(" << along.x << ")*"
                 << clamped << ")^2+(y-" << a_.y << "-(" << along.y << ")*" << clamped << ")^2)";
        }
        else {
            text << smallest_ << '+' << growth_ << "*sqrt((x-" << a_.x << ")^2+(y-" << a_.y
                 << ")^2)";
        }
        return text.str();
    }

private:
    Vec2 a_, b_;
    double smallest_, growth_;
};

struct Hole
{
    Vec2 center;
    double radius;
};
inline constexpr Hole kHoles[5] = {{{0.22, 0.24}, 0.08}, {{0.78, 0.22}, 0.08},
                                   {{0.24, 0.77}, 0.08}, {{0.76, 0.79}, 0.08},
                                   {{0.52, 0.49}, 0.12}};
inline constexpr Vec2 kLines[4][2] = {{{0.1, 0.45}, {0.3, 0.52}}, {{0.7, 0.55}, {0.92, 0.45}},
                                      {{0.45, 0.08}, {0.55, 0.25}}, {{0.42, 0.72}, {0.58, 0.93}}};

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
    for (const Hole& hole : kHoles) {
        NetworkCurve circle;
        circle.geometry = makeCircleArc(hole.center, hole.radius, 0.0, 2.0 * std::numbers::pi);
        circle.start = network.addPoint(circle.geometry->point(circle.geometry->first()));
        circle.end = circle.start;
        circle.operand = operand;
        network.curves.push_back(circle);
    }
    for (const auto& inner : kLines) {
        const PointId a = network.addPoint(inner[0]);
        line(a, network.addPoint(inner[1]), Role::Constraint);
    }
    return network;
}

} // namespace tessera::bench
