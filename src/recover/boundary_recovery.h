// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "predicates/crossing.h"
#include "recover/chains.h"
#include "recover/mesh_edit.h"
#include "recover/recover.h"
#include "recover/steiner_points.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tessera
{

/// The fast path of boundary recovery: all there is for input that is well-conditioned at double
/// resolution. See the head of boundary_recovery.cpp.
class BoundaryRecovery
{
public:
    /// mesh: a Delaunay triangulation with triangles, none of its edges constrained; changed in
    /// place. segments: different from each other, of non-zero length.
    BoundaryRecovery(Triangulation& mesh, std::span<const Segment> segments,
                     RecoveryStrategy strategy, RecoveryObserver* observer);

    /// Recovers all segments. False: the input is ill-conditioned; the mesh is still valid, but not
    /// all segments are in it and it has further vertices. Throws Error if cancelled.
    bool run(Execution& execution);

    Chains takeChains() { return std::move(chains_); }
    /// Counts crossings, Steiner points and the displacement.
    const RecoveryReport& report() const { return report_; }

private:
    static constexpr std::uint32_t kNone = Chains::kNone;

    /// What stands next on a segment's way from a vertex of its chain.
    struct Step
    {
        enum class Kind
        {
            Vertex,  ///< `vertex` is the segment's next vertex
            Edge,    ///< it crosses `edge`, seen from the side it comes from
            Stopped, ///< ill-conditioned
        };
        Kind kind = Kind::Stopped;
        std::uint32_t vertex = kNone;
        HalfEdge edge = Topology::kDead;
    };
    struct TwoSegments
    {
        std::uint32_t first = kNone;
        std::uint32_t second = kNone;
    };
    /// More than these at one vertex are not compared in pairs if they are concurrent.
    static constexpr std::uint32_t kFewSegments = 8;

    bool recover(std::uint32_t s);
    bool putIn(std::uint32_t x, std::uint32_t y);
    Step next(std::uint32_t s, std::uint32_t from);
    Step atVertex(std::uint32_t s, std::uint32_t vertex);
    std::uint32_t cross(std::uint32_t s, std::uint32_t from, HalfEdge edge);
    bool findCrossing(std::uint32_t s, HalfEdge edge, Crossing& crossing);
    std::uint32_t crossBeside(std::uint32_t u, std::uint32_t v, HalfEdge edge,
                              const Crossing& crossing);
    void leadThrough(std::uint32_t vertex);
    void countCrossing(std::uint32_t vertex, Vec2 residual);
    bool pickUpTouches(std::uint32_t x, std::uint32_t y);
    bool touches(std::uint32_t x, std::uint32_t y, std::uint32_t z);
    bool crossingsAreTrue();
    bool meetHere(std::uint32_t s, std::uint32_t other, std::uint32_t vertex) const;
    bool trianglesAreTrue() const;

    bool meetsAll(std::uint32_t s, std::uint32_t vertex, std::span<const Chains::Use> known);
    TwoSegments findConcurrent(std::uint32_t vertex) const;
    bool onLine(std::uint32_t s, std::uint32_t vertex) const;
    bool isAhead(std::uint32_t s, std::uint32_t from, std::uint32_t vertex) const;
    bool isFlat(std::uint32_t x, std::uint32_t y, std::uint32_t z) const;
    bool followsOverlap(std::uint32_t s, std::uint32_t from, HalfEdge spoke) const;
    bool isInput(std::uint32_t vertex) const { return vertex < firstCrossing_; }
    Vec2 start(std::uint32_t s) const { return mesh_.points[segments_[s].a]; }
    Vec2 end(std::uint32_t s) const { return mesh_.points[segments_[s].b]; }

    Triangulation& mesh_;
    std::span<const Segment> segments_;
    RecoveryStrategy strategy_;
    std::uint32_t firstCrossing_;
    double unscale_; ///< brings the greatest coordinate to about 1
    Chains chains_;
    MeshEdit edit_;
    RecoveryReport report_;
    SteinerPoints steinerPoints_;
    std::vector<Chains::Use> uses_; ///< the pieces that a new vertex goes into
    std::unordered_map<std::uint32_t, TwoSegments> concurrent_; ///< by vertex: findConcurrent()
    std::vector<std::uint32_t> doubtful_; ///< vertices whose segments are still to be compared
};

} // namespace tessera
