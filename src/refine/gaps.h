// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/triangulation.h"
#include "refine/refine.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace tessera
{

/// The narrow place between an edge and the apex of its triangle.
struct Gap
{
    double width; ///< distance of the apex from the edge; infinite unless its foot is on the edge
    double foot;  ///< 0 .. 1 along the edge
};

inline Gap gapAbove(const Triangulation& t, HalfEdge edge)
{
    const Vec2 a = t.points[t.origin(edge)];
    const Vec2 along = t.points[t.destination(edge)] - a;
    const Vec2 toApex = t.points[t.apex(edge)] - a;
    const double squared = squaredLength(along);
    const double foot = dot(toApex, along) / squared;
    const bool isAbove = foot > 0.0 && foot < 1.0;
    return {isAbove ? cross(along, toApex) / std::sqrt(squared)
                    : std::numeric_limits<double>::infinity(),
            foot};
}

/// The widest hopeless gap for a size field of 1: above the shortest piece that constrained edges
/// are split into, a triangle of this height has an angle below minAngle (degrees) wherever its
/// apex is, so that splitting the edges beside such a gap does not help.
inline double hopelessGap(double minAngle)
{
    return 0.5 * std::tan(minAngle * std::numbers::pi / 180.0) * kSmallestPiece;
}

} // namespace tessera
