// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/mesh_editor.h"
#include "refine/refine.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// A connected place between constrained edges too narrow for pieces of kSmallestPiece.
struct NarrowPlace
{
    /// Of the triangulation of the boundary; between arms the widest first.
    std::vector<std::uint32_t> triangles;
    std::vector<double> costs; ///< of each triangle, without what the place costs as a whole
    double cost; ///< triangles that a graded mesh with good angles has there and around, estimated
    double width; ///< where it is narrowest
    Vec2 middle;  ///< between its sides there
    bool isBetweenArms; ///< of one corner below 60 degrees, where small angles stay in any case
};

/// Which of the narrow places are followed and at what cost.
struct NarrowChoice
{
    std::vector<NarrowPlace> places; ///< first those that are followed
    std::size_t followed = 0;        ///< how many of them
    double others = 0.0;             ///< triangles of the rest of the mesh, estimated
    bool isUnderestimated = false;   ///< those chosen took far more, so that all are left

    double spent() const; ///< triangles of the places that are followed, estimated
};

/// The places that narrowShare, >= 0, and at most kMostForNarrowPlaces pay for one after the other. Of
/// places between arms the wide part that can be paid for becomes a place of its own.
NarrowChoice chooseNarrowPlaces(std::vector<NarrowPlace> places, double others, double narrowShare,
                                const Triangulation& t);

/// What the user is told: where the places that are followed take more triangles than the others,
/// and where places are left, each with the narrowest place and what to do. At most two messages.
std::vector<std::string> describeNarrowPlaces(const NarrowChoice& choice);

/// All such places of the kept regions, cheapest first, but those between the arms of a corner last.
/// field, sizes: by vertex, the size field and the size that triangles have if no such place is
/// followed.
/// Precondition: no interior vertex yet. Complexity: O(n log n) for n triangles.
std::vector<NarrowPlace> findNarrowPlaces(const MeshEditor& editor, std::span<const double> field,
                                          std::span<const double> sizes, double minAngle);

struct FollowedTriangle
{
    std::uint32_t triangle;
    double width;
    Vec2 reach[2]; ///< ends of the part of its constrained edge beside which it is so narrow

    /// From there, but 0 across the gap.
    double distanceTo(Vec2 p) const
    {
        const Vec2 along = reach[1] - reach[0];
        const double squared = squaredLength(along);
        const double part
            = squared > 0.0 ? std::clamp(dot(p - reach[0], along) / squared, 0.0, 1.0) : 0.0;
        return std::max(0.0, distance(p, reach[0] + part * along) - width);
    }
};

/// The triangles of the places that are followed; and those of places that are left, or at acute
/// corners, that have a constrained edge in common with one that is no wider, and so on: small sizes
/// reach them anyway, so that they cost little, and if one side only were divided they would be full
/// of bad triangles. Their widths and reaches are those of the triangle from which they were reached.
std::vector<FollowedTriangle> trianglesToFollow(const NarrowChoice& choice,
                                                const MeshEditor& editor);

/// Lets refinement divide the constrained edges around these triangles down to a share of their
/// widths, by mesh.followed; returns the vertices concerned with that length.
std::vector<std::pair<std::uint32_t, double>> follow(std::span<const FollowedTriangle> triangles,
                                                     MeshEditor& editor);

} // namespace tessera
