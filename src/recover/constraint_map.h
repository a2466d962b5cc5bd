// SPDX-License-Identifier: MIT
#pragma once

#include "recover/chains.h"
#include "recover/recover.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// The constraints as different straight segments. Constraints with the same ends share one; those
/// of zero length have none.
struct SegmentTable
{
    static constexpr std::uint32_t kNone = 0xffffffffU;

    /// In the order of the lower, then the higher vertex. Each starts at its end with the fewer
    /// segments: going around a vertex where many start would cost too much every time.
    std::vector<Segment> segments;
    std::vector<std::uint32_t> segmentOf; ///< by constraint

    SegmentTable(std::span<const ConstraintEnds> constraints, std::size_t vertexCount);
};

/// Which constraints the edges lie on. vertexOf: the vertex that each constraint end has become.
/// The subsegments are sorted by a, then b, and their uses by constraint. Consumes the chains.
ConstraintMap makeConstraintMap(std::span<const ConstraintEnds> constraints,
                                std::span<const std::uint32_t> vertexOf, const SegmentTable& table,
                                Chains chains);

/// Fills in the subsegments and uses of a map that has its chains, of vertices below vertexCount.
/// O(n), plus sorting at vertices of high degree.
void addSubsegments(ConstraintMap& map, std::size_t vertexCount);

/// The subsegment between two vertices; null if there is none. O(log n).
const Subsegment* findSubsegment(const ConstraintMap& map, std::uint32_t u, std::uint32_t v);

} // namespace tessera
