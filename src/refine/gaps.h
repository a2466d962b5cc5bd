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

/// The widest hopeless gap as a multiple of the least length down to which constrained edges are
/// split: pieces are up to twice as long, and a triangle of this height above one of them has an
/// angle below minAngle (degrees) unless its apex is above the middle, so that splitting the edges
/// beside such a gap does not help.
inline double hopelessGap(double minAngle)
{
    return 2.0 * std::tan(minAngle * std::numbers::pi / 180.0);
}

/// The length below which pieces of a recovered subsegment are not split for the sake of its left
/// side (0) or right side (1) where the field is size.
inline double leastPiece(const WorkingMesh& mesh, std::uint32_t root, int side, double size)
{
    const double least = kSmallestPiece * size;
    const std::size_t index = 2 * std::size_t {root} + static_cast<std::size_t>(side);
    const bool isFollowed = index < mesh.leastPiece.size() && mesh.leastPiece[index] > 0.0;
    return isFollowed ? std::min(least, mesh.leastPiece[index]) : least;
}
/// The same for either side.
inline double leastPiece(const WorkingMesh& mesh, std::uint32_t root, double size)
{
    return std::min(leastPiece(mesh, root, 0, size), leastPiece(mesh, root, 1, size));
}

/// Whether the apex of the triangle on a constrained edge is so near that splitting does not help;
/// size: the field there, hopeless: hopelessGap().
inline bool isHopeless(const MeshEditor& editor, HalfEdge edge, double size, double hopeless)
{
    const Triangulation& t = editor.triangulation();
    const double width = gapAbove(t, edge).width;
    if (!(width < hopeless * kSmallestPiece * size)) {
        return false;
    }
    if (editor.constMesh().leastPiece.empty()) {
        return true;
    }
    const MeshEditor::RootSide on = editor.rootSideOf(edge);
    return on.root == MeshEditor::kNone
        || width < hopeless * leastPiece(editor.constMesh(), on.root, on.side, size);
}

} // namespace tessera
