// SPDX-License-Identifier: MIT
#pragma once

#include "refine/mesh_editor.h"

#include <algorithm>
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

/// The same where both sides of a gap are divided alike, so that rounding decides whether the foot is
/// on the edge: at its ends too, unless there is a corner.
inline double widthAbove(const Triangulation& t, HalfEdge edge)
{
    constexpr double kRounding = 1e-6;
    const Gap gap = gapAbove(t, edge);
    const bool atOrigin = std::fabs(gap.foot) < kRounding;
    const bool atEnd = std::fabs(gap.foot - 1.0) < kRounding;
    if ((atOrigin && !t.isConstrained(Topology::prev(edge)))
        || (atEnd && !t.isConstrained(Topology::next(edge)))) {
        return distance(t.points[t.apex(edge)],
                        t.points[atOrigin ? t.origin(edge) : t.destination(edge)]);
    }
    return gap.width;
}

/// The widest hopeless gap as a multiple of the least length down to which constrained edges are
/// split: pieces are up to twice as long, and a triangle of this height above one of them has an
/// angle below minAngle (degrees) unless its apex is above the middle, so that splitting the edges
/// beside such a gap does not help.
inline double hopelessGap(double minAngle)
{
    return 2.0 * std::tan(minAngle * std::numbers::pi / 180.0);
}

/// Where short subsegments demand short edges anyway, pieces may be as short as this share of them.
inline constexpr double kShareOfSpacing = 0.5;

/// The side of a recovered subsegment in FollowedGaps.
inline std::uint32_t sideIndex(MeshEditor::RootSide on)
{
    return 2 * on.root + static_cast<std::uint32_t>(on.side);
}

/// The length below which pieces of a recovered subsegment are not split for the sake of its left
/// side (0) or right side (1) beside p, where the field is size.
inline double leastPiece(const MeshEditor& editor, MeshEditor::RootSide on, Vec2 p, double size)
{
    const double least
        = std::min(kSmallestPiece * size, kShareOfSpacing * editor.spacingBeside(on.root, p));
    const FollowedGaps& followed = editor.constMesh().followed;
    return followed.empty()
        ? least
        : std::min(least, followed.at(sideIndex(on), editor.placeAlong(on.root, p)));
}
/// The same for either side.
inline double leastPiece(const MeshEditor& editor, std::uint32_t root, Vec2 p, double size)
{
    return std::min(leastPiece(editor, {root, 0}, p, size), leastPiece(editor, {root, 1}, p, size));
}

/// Whether the apex of the triangle on a constrained edge is so near that splitting does not help;
/// size: the field there, hopeless: hopelessGap().
inline bool isHopeless(const MeshEditor& editor, HalfEdge edge, double size, double hopeless)
{
    const Triangulation& t = editor.triangulation();
    const double width = widthAbove(t, edge);
    const std::uint32_t apex = t.apex(edge);
    if (!(width < hopeless * std::min(kSmallestPiece * size,
                                      kShareOfSpacing * editor.spacingAt(apex)))) {
        return false;
    }
    const MeshEditor::RootSide on = editor.rootSideOf(edge);
    return on.root == MeshEditor::kNone
        || width < hopeless * leastPiece(editor, on, t.points[apex], size);
}

} // namespace tessera
