// SPDX-License-Identifier: MIT

// Boundary recovery: which way for which input, and the result's maps.
//
//   no triangles    all vertices on one line: chains by sorting along it
//   otherwise       the fast path (boundary_recovery.h)

#include "recover/recover.h"

#include "predicates/predicates.h"
#include "recover/boundary_recovery.h"
#include "recover/constraint_map.h"

#include <algorithm>
#include <numeric>

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
VertexChains chainsOnLine(const Triangulation& mesh, std::span<const Segment> segments)
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
    VertexChains chains;
    for (const Segment& s : segments) {
        std::size_t i = rank[s.a];
        for (; i != rank[s.b]; i += rank[s.b] > rank[s.a] ? 1U : std::size_t(-1)) {
            chains.vertices.push_back(order[i]);
        }
        chains.vertices.push_back(s.b);
        chains.closeChain();
    }
    return chains;
}

void countIncidences(const RecoveryResult& result, RecoveryReport& report)
{
    const ConstraintMap& map = result.constraints;
    report.touches = 0;
    for (std::size_t c = 0; c + 1 < map.chainStart.size(); ++c) {
        for (std::size_t i = map.chainStart[c] + 1U; i + 1 < map.chainStart[c + 1]; ++i) {
            report.touches += map.chainVertices[i] < result.firstCrossing ? 1U : 0U;
        }
    }
    report.overlaps = static_cast<std::size_t>(
        std::count_if(map.subsegments.begin(), map.subsegments.end(),
                      [](const Subsegment& s) { return s.useCount >= 2; }));
}

} // namespace

RecoveryResult recoverBoundaries(Triangulation triangulation,
                                 std::span<const ConstraintEnds> constraints,
                                 RecoveryStrategy strategy, Execution& execution,
                                 RecoveryObserver* observer)
{
    checkEnds(constraints, triangulation.vertexCount());
    RecoveryResult result;
    result.triangulation = std::move(triangulation);
    Triangulation& mesh = result.triangulation;
    result.firstCrossing = static_cast<std::uint32_t>(mesh.points.size());
    result.vertexMap.resize(mesh.points.size());
    std::iota(result.vertexMap.begin(), result.vertexMap.end(), 0U);

    const SegmentTable table(constraints, mesh.points.size());
    VertexChains chains;
    if (mesh.triangles.empty()) {
        chains = chainsOnLine(mesh, table.segments);
    }
    else {
        BoundaryRecovery recovery(mesh, table.segments, strategy, observer);
        if (!recovery.run(execution)) {
            throw Error(ErrorKind::InvalidInput, "The input is ill-conditioned.");
        }
        chains = VertexChains(recovery.chains(), table.segments.size());
        result.report = recovery.report();
    }
    result.constraints
        = makeConstraintMap(constraints, result.vertexMap, table, chains, mesh.points.size());
    countIncidences(result, result.report);
    return result;
}

} // namespace tessera
