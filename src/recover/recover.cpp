// SPDX-License-Identifier: MIT

// Boundary recovery: which way for which input, and the result's maps.
//
//   no triangles    all vertices on one line: chains by sorting along it
//   otherwise       the fast path (boundary_recovery.h); where that finds the input
//                   ill-conditioned, snap rounding (snap_rounding.h) of the whole input, whose
//                   pieces meet at vertices only

#include "recover/recover.h"

#include "delaunay/delaunay.h"
#include "recover/boundary_recovery.h"
#include "recover/constraint_map.h"
#include "recover/mesh_edit.h"
#include "recover/snap_rounding.h"
#include "recover/steiner_points.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace tessera
{
namespace
{

void checkEnds(std::span<const ConstraintEnds> constraints, std::size_t vertexCount)
{
    for (std::size_t c = 0; c < constraints.size(); ++c) {
        for (const std::uint32_t v : {constraints[c].a, constraints[c].b}) {
            if (v == Topology::kInfinite || v > vertexCount) {
                throw Error(ErrorKind::InvalidInput,
                            "Constraint " + std::to_string(c) + " ends at vertex "
                                + std::to_string(v) + ", which does not exist; use 1 to "
                                + std::to_string(vertexCount) + ".",
                            {{{}, static_cast<std::uint32_t>(c)}});
            }
        }
    }
}

/// All vertices lie on one line: each segment runs through those between its ends.
Chains chainsOnLine(const Triangulation& mesh, std::span<const Segment> segments)
{
    std::vector<std::uint32_t> order(mesh.vertexCount());
    std::iota(order.begin(), order.end(), 1U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
        const Vec2 p = mesh.points[i];
        const Vec2 q = mesh.points[j];
        return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    std::vector<std::size_t> rank(mesh.points.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = i;
    }
    Chains chains(segments.size(), mesh.points.size());
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
        const std::size_t last = rank[segments[s].b];
        std::size_t i = rank[segments[s].a];
        while (i != last) {
            chains.append(s, order[i]);
            i = i < last ? i + 1 : i - 1;
        }
        chains.append(s, order[last]);
    }
    return chains;
}

void countIncidences(RecoveryResult& result)
{
    const ConstraintMap& map = result.constraints;
    RecoveryReport& report = result.report;
    for (std::size_t c = 0; c + 1 < map.chainStart.size(); ++c) {
        for (std::size_t i = map.chainStart[c] + 1U; i + 1 < map.chainStart[c + 1]; ++i) {
            report.touches += map.chainVertices[i] < result.firstCrossing ? 1U : 0U;
        }
    }
    report.overlaps = static_cast<std::size_t>(
        std::count_if(map.subsegments.begin(), map.subsegments.end(),
                      [](const Subsegment& s) { return s.useCount >= 2; }));
}

/// Renumbers the vertices so that those of points below inputCount come first, otherwise in their
/// order. Returns the vertex of each point.
std::vector<std::uint32_t> moveInputFirst(Triangulation& mesh,
                                          std::span<const std::uint32_t> vertexOfPoint,
                                          std::size_t inputCount)
{
    std::vector<std::uint32_t> pointOf(mesh.points.size());
    for (std::uint32_t p = 0; p < vertexOfPoint.size(); ++p) {
        pointOf[vertexOfPoint[p]] = p;
    }
    std::vector<std::uint32_t> renamed(mesh.points.size(), Topology::kInfinite);
    std::uint32_t next = 1;
    for (const bool input : {true, false}) {
        for (std::uint32_t v = 1; v < mesh.points.size(); ++v) {
            if ((pointOf[v] < inputCount) == input) {
                renamed[v] = next++;
            }
        }
    }
    std::vector<Vec2> points(mesh.points.size());
    std::vector<std::uint32_t> incident(mesh.points.size());
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
        points[renamed[v]] = mesh.points[v];
        incident[renamed[v]] = mesh.incident[v];
    }
    mesh.points = std::move(points);
    mesh.incident = std::move(incident);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t i = 0; i < 3 && !mesh.isDead(t); ++i) {
            mesh.triangles[t].v[i] = renamed[mesh.triangles[t].v[i]];
        }
    }
    std::vector<std::uint32_t> result(vertexOfPoint.size());
    std::transform(vertexOfPoint.begin(), vertexOfPoint.end(), result.begin(),
                   [&](std::uint32_t v) { return renamed[v]; });
    return result;
}

/// The fast path. False: the input is ill-conditioned, and the result is to be made anew.
bool recoverExactly(RecoveryResult& result, std::span<const Segment> segments, Chains& chains,
                    RecoveryStrategy strategy, Execution& execution, RecoveryObserver* observer)
{
    BoundaryRecovery recovery(result.triangulation, segments, strategy, observer);
    if (!recovery.run(execution)) {
        return false;
    }
    chains = recovery.takeChains();
    result.report = recovery.report();
    return true;
}

/// The pieces of snapped chains meet at vertices only: there is nothing to follow, and each goes
/// straight into the mesh.
void putInPieces(RecoveryResult& result, const Chains& chains, RecoveryStrategy strategy,
                 Execution& execution, RecoveryObserver* observer)
{
    MeshEdit edit(result.triangulation);
    SteinerPoints steinerPoints(result.triangulation, edit, result.report, observer);
    bool done = true;
    for (std::uint32_t s = 0; s < chains.segmentCount(); ++s) {
        execution.checkpoint();
        std::uint32_t before = Topology::kInfinite;
        chains.forEachVertex(s, [&](std::uint32_t v) {
            if (before != Topology::kInfinite) {
                done = done
                    && (strategy == RecoveryStrategy::Steiner ? steinerPoints.constrain(before, v)
                                                              : edit.constrain(before, v));
            }
            before = v;
        });
    }
    if (!done) {
        throw std::logic_error("Snap rounding: pieces cross.");
    }
    edit.closeGaps(); // no Steiner point has stayed, so that no vertex gets another name
}

/// Snap rounding of the input points, and of the segments between them.
Chains recoverSnapped(RecoveryResult& result, std::span<const Segment> segments,
                      RecoveryStrategy strategy, Execution& execution, RecoveryObserver* observer)
{
    Triangulation& mesh = result.triangulation;
    const auto end = mesh.points.begin() + static_cast<std::ptrdiff_t>(result.vertexMap.size());
    const std::vector<Vec2> input(mesh.points.begin(), end);
    mesh = {};
    SnapResult snapped = snapRound(input, segments, execution);
    DelaunayResult delaunay = triangulate(snapped.points, execution);
    mesh = std::move(delaunay.triangulation);
    const std::size_t crossings = snapped.points.size() - snapped.inputCount;
    snapped.points = std::vector<Vec2> {};
    const std::vector<std::uint32_t> vertexOfPoint
        = moveInputFirst(mesh, delaunay.vertexOfPoint, snapped.inputCount);
    for (std::size_t v = 1; v < result.vertexMap.size(); ++v) {
        result.vertexMap[v] = vertexOfPoint[snapped.pointOf[v]];
    }
    snapped.chains.renameVertices(vertexOfPoint, mesh.points.size());
    result.report = {};
    if (!mesh.triangles.empty()) {
        putInPieces(result, snapped.chains, strategy, execution, observer);
    }
    result.firstCrossing = static_cast<std::uint32_t>(snapped.inputCount + 1);
    result.report.crossings = crossings;
    if (strategy == RecoveryStrategy::Steiner) {
        result.report.steinerInserted += crossings;
    }
    result.report.maxDisplacement = snapped.maxDisplacement;
    result.report.snapPixel = snapped.pixel;
    return std::move(snapped.chains);
}

} // namespace

RecoveryResult recoverBoundaries(Triangulation triangulation,
                                 std::span<const ConstraintEnds> constraints,
                                 RecoveryStrategy strategy, Execution& execution,
                                 RecoveryObserver* observer)
{
    checkEnds(constraints, triangulation.vertexCount());
    if (observer != nullptr) {
        observer->beforeRecovery(triangulation, constraints);
    }
    RecoveryResult result;
    result.triangulation = std::move(triangulation);
    Triangulation& mesh = result.triangulation;
    result.firstCrossing = static_cast<std::uint32_t>(mesh.points.size());
    result.vertexMap.resize(mesh.points.size());
    std::iota(result.vertexMap.begin(), result.vertexMap.end(), 0U);

    const SegmentTable table(constraints, mesh.points.size());
    Chains chains;
    if (mesh.triangles.empty()) {
        chains = chainsOnLine(mesh, table.segments);
    }
    else if (!recoverExactly(result, table.segments, chains, strategy, execution, observer)) {
        chains = recoverSnapped(result, table.segments, strategy, execution, observer);
    }
    result.constraints
        = makeConstraintMap(constraints, result.vertexMap, table, std::move(chains));
    countIncidences(result);
    if (observer != nullptr) {
        observer->recovered(result);
    }
    return result;
}

} // namespace tessera
