// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "base/ids.h"
#include "delaunay/triangulation.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// How a missing boundary is recovered. Both give the same constrained Delaunay triangulation, up
/// to cocircular ties.
enum class RecoveryStrategy
{
    Steiner, ///< the paper's section 2: a Steiner point at every intersection of the missing
             ///< boundary with a mesh edge; those not on two boundaries are deleted again
    Cavity,  ///< remove the triangles that the piece crosses, re-mesh both polygons at once
};

/// Why a vertex exists.
enum class VertexOrigin : std::uint8_t
{
    Input,        ///< end point of a curve or embedded point
    CurveSample,  ///< inside a curve
    Crossing,     ///< where constraints cross
    SegmentSplit, ///< put on a constraint by refinement
    Interior,     ///< put inside by refinement
};

/// A constraint as the recovery takes it: two vertices of the triangulation.
struct ConstraintEnds
{
    std::uint32_t a;
    std::uint32_t b;
};

/// One constraint that a subsegment lies on.
struct ConstraintUse
{
    ConstraintId constraint;
    bool forward; ///< the subsegment's a comes before its b on the way from the constraint's a to b
};

/// A mesh edge on one or more constraints; a < b.
struct Subsegment
{
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t firstUse; ///< its uses are uses[firstUse .. firstUse + useCount), by constraint
    std::uint32_t useCount;
};

/// Which constraints every constrained edge lies on, and through which vertices each constraint
/// runs.
struct ConstraintMap
{
    std::vector<Subsegment> subsegments;
    std::vector<ConstraintUse> uses;

    /// The vertices of constraint c from its start to its end:
    /// chainVertices[chainStart[c] .. chainStart[c + 1]). A zero-length constraint has one.
    std::vector<std::uint32_t> chainStart;
    std::vector<std::uint32_t> chainVertices;

    std::span<const ConstraintUse> usesOf(const Subsegment& s) const
    {
        return {uses.data() + s.firstUse, s.useCount};
    }
    std::span<const std::uint32_t> chainOf(ConstraintId c) const
    {
        const std::size_t begin = chainStart[c.index()];
        return {chainVertices.data() + begin, chainStart[c.index() + 1] - begin};
    }
};

struct RecoveryReport
{
    std::size_t crossings = 0;       ///< distinct vertices made where constraints cross
    std::size_t touches = 0;         ///< (constraint, input vertex strictly inside it) incidences
    std::size_t overlaps = 0;        ///< subsegments on at least two constraints
    std::size_t steinerInserted = 0; ///< Steiner strategy only
    std::size_t steinerRemoved = 0;
    double maxDisplacement = 0.0;    ///< greatest rounding of a constructed point
    double snapPixel = 0.0;          ///< 0: the fast path sufficed
};

struct RecoveryResult
{
    Triangulation triangulation; ///< constrained bits set; constrained Delaunay
    ConstraintMap constraints;
    /// By vertex of the given triangulation: the vertex that it is now. The identity but after snap
    /// rounding, which may merge vertices.
    std::vector<std::uint32_t> vertexMap;
    /// By vertex: the first one that recovery made; all from here on are crossings.
    std::uint32_t firstCrossing = 0;
    RecoveryReport report;
};

/// Watches a recovery, for pictures. Default: looks away.
struct RecoveryObserver
{
    virtual ~RecoveryObserver() = default;
    virtual void beforeRecovery(const Triangulation&, std::span<const ConstraintEnds>) {}
    /// Strategy Steiner only: after each insertion and deletion (the paper's Fig. 1).
    virtual void steinerInserted(const Triangulation&, std::uint32_t /*vertex*/) {}
    virtual void steinerRemoved(const Triangulation&, std::uint32_t /*formerVertex*/) {}
    virtual void recovered(const RecoveryResult&) {}
};

/// Makes every constraint a connected chain of mesh edges (paper, section 2). Total: any
/// constraints, crossing, overlapping, touching, repeated, of zero length. The triangulation is
/// Delaunay, without constrained edges. Throws Error(InvalidInput) for an end that is no vertex.
RecoveryResult recoverBoundaries(Triangulation triangulation,
                                 std::span<const ConstraintEnds> constraints,
                                 RecoveryStrategy strategy, Execution& execution,
                                 RecoveryObserver* observer = nullptr);

/// Proves that every constraint is a connected chain of constrained mesh edges within the rounding
/// bound, that every constrained edge lies on a constraint, and that the maps agree. One sentence a
/// problem. Use together with verify(triangulation). inputPoints: the points of the triangulation
/// that was given to recoverBoundaries(), [0] unused.
std::vector<std::string> verifyConstraints(const RecoveryResult& result,
                                           std::span<const ConstraintEnds> constraints,
                                           std::span<const Vec2> inputPoints);

} // namespace tessera
