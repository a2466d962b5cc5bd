// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "recover/recover.h"
#include "refine/followed_gaps.h"
#include "region/region.h"
#include "sizing/size_field.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// A subsegment during refinement and optimization: it may be split, its halves keep the uses.
struct ConstrainedEdge
{
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t useSet;    ///< index of the recovered subsegment that it is part of
    const Curve* geometry;   ///< of the representative curve; null: straight
    double ta = 0.0;         ///< parameters of a and b on it
    double tb = 0.0;
};

/// The triangulation that refine and optimize work on.
struct WorkingMesh
{
    Triangulation triangulation;
    std::vector<VertexOrigin> origin;             ///< by vertex
    std::vector<std::uint32_t> regionOfTriangle;  ///< by triangle slot; kOutside if not kept
    std::vector<ConstrainedEdge> edges;           ///< all constrained edges
    FollowedGaps followed {}; ///< side: 2 useSet, + 1 for the right one

    static constexpr std::uint32_t kOutside = 0xffffffffU;
};

/// A target that was not met, and where.
struct Unreached
{
    std::string what; ///< "min_angle", "max_area"
    Vec2 place;
    double value;     ///< what was reached
    double target;
};

/// Constrained edges are not split into pieces shorter than this share of the size there, but for
/// narrow places that RefineOptions::narrowShare pays for.
inline constexpr double kSmallestPiece = 1.0 / 64.0;

/// Default of RefineOptions::narrowShare.
inline constexpr double kNarrowShare = 2.0;

struct RefineOptions
{
    double minAngle = 30.0;        ///< degrees, 0..33
    double maxArea = 0.0;          ///< 0: none
    bool freezeBoundary = false;   ///< constrained edges may not be split
    std::vector<double> regionMaxArea; ///< by region; 0: none
    /// optimize() will be called with the same options: small angles are left to it, which mends
    /// most of them without further points; but not with a frozen boundary.
    bool optimizeFollows = false;
    double maxTriangles = 0.0; ///< more are refused; 0: no limit
    /// Triangles that may be spent on gaps too narrow for kSmallestPiece, as a share of the others;
    /// cheapest first, but those between the arms of a corner below 60 degrees last; each gap
    /// entirely, or only where its neighbors are followed. At least 0, which leaves all of them coarse.
    double narrowShare = kNarrowShare;
};

struct RefineReport
{
    std::size_t interiorPoints = 0;
    std::size_t segmentSplits = 0;
    std::vector<Unreached> unreached; ///< empty if optimizeFollows
    /// For the user: narrow gaps that take most of the triangles, or are left.
    std::vector<std::string> messages;
};

/// Inserts interior points (paper, Algorithm 1, step 3) by the size field, then refines by Delaunay
/// refinement what is left, inside the kept regions. Where the constrained edges are finer than the
/// size field, sizes grow from theirs. Constrained edges are split on their curves only.
/// Guarantees, for input angles of at least 60 degrees: no angle below minAngle except those listed
/// in report.unreached (20.7 degrees in theory, see delaunay_refinement.cpp). Ends for any input.
/// Throws Error(TooLarge) when there would be more than options.maxTriangles: gaps can need many more
/// than estimateTriangles() tells.
RefineReport refine(WorkingMesh& mesh, const SizeField& size, const RefineOptions& options,
                    Execution& execution);

/// Number of triangles that refine() will make, estimated from the integral of 1/h² over the kept
/// triangles, h being no larger than options.maxArea and regionMaxArea allow; within about 20 % where
/// the field is smooth, 40 % where areas decide. Stops counting at 1e12.
double estimateTriangles(const WorkingMesh& mesh, const SizeField& size,
                         const RefineOptions& options = {});

/// The smaller of maxArea and the region's; 0: none.
double areaLimitOf(const RefineOptions& options, std::uint32_t region);

/// Edge length that keeps triangles below an area; infinity for no limit (0).
double sizeForArea(double area);

/// Whether the area of triangles is limited anywhere.
bool hasAreaLimits(const RefineOptions& options);

/// Throws Error(TooLarge) if triangles is more than options.maxTriangles.
void requireFewTriangles(double triangles, const RefineOptions& options);

/// What a finished mesh does not reach: angles below options.minAngle ("min_angle", degrees) and
/// areas above the limits ("max_area"), worst first, at the triangles' centroids.
std::vector<Unreached> findUnreached(const WorkingMesh& mesh, const RefineOptions& options,
                                     const Execution& execution);
/// The same of these triangles only.
std::vector<Unreached> findUnreached(const WorkingMesh& mesh, const RefineOptions& options,
                                     std::span<const std::uint32_t> triangles,
                                     const Execution& execution);

} // namespace tessera
