// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tessera
{

inline double squaredDistance(Vec2 a, Vec2 b)
{
    return squaredLength(b - a);
}

/// A triangle with its corners in order, so that the edge opposite corner 0 is the shortest.
struct TriangleShape
{
    std::uint32_t v[3];
    Vec2 p[3];
    double squared[3]; ///< length of the edge opposite each corner
    double area;

    double cosineOfSmallest() const
    {
        return (squared[1] + squared[2] - squared[0])
            / (2.0 * std::sqrt(squared[1]) * std::sqrt(squared[2]));
    }
    double circumradius() const
    {
        return 0.25 * std::sqrt(squared[0] / area * (squared[1] / area) * squared[2]);
    }
    Vec2 incenter() const
    {
        const double l[3] = {std::sqrt(squared[0]), std::sqrt(squared[1]), std::sqrt(squared[2])};
        const double around = l[0] + l[1] + l[2];
        return p[0] + (l[1] / around) * (p[1] - p[0]) + (l[2] / around) * (p[2] - p[0]);
    }
};

inline TriangleShape shapeOf(const Triangulation& t, std::uint32_t triangle)
{
    const auto& v = t.triangles[triangle].v;
    double squared[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
        squared[i] = squaredDistance(t.points[v[(i + 1) % 3]], t.points[v[(i + 2) % 3]]);
    }
    const std::uint32_t first = static_cast<std::uint32_t>(
        std::min_element(squared, squared + 3) - squared);
    TriangleShape s;
    for (std::uint32_t i = 0; i < 3; ++i) {
        s.v[i] = v[(first + i) % 3];
        s.p[i] = t.points[s.v[i]];
        s.squared[i] = squared[(first + i) % 3];
    }
    s.area = 0.5 * cross(s.p[1] - s.p[0], s.p[2] - s.p[0]);
    return s;
}

} // namespace tessera
