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

    std::vector<Segment> segments; ///< a < b; in the order of a, then b
    std::vector<std::uint32_t> segmentOf; ///< by constraint

    SegmentTable(std::span<const ConstraintEnds> constraints, std::size_t vertexCount);
};

/// The vertices of segment s, from its a to its b: vertices[start[s] .. start[s + 1]).
struct VertexChains
{
    std::vector<std::uint32_t> start {0};
    std::vector<std::uint32_t> vertices;

    VertexChains() = default;
    explicit VertexChains(const Chains& chains, std::size_t segmentCount);

    std::span<const std::uint32_t> of(std::uint32_t s) const
    {
        return {vertices.data() + start[s], start[s + 1] - start[s]};
    }
    void closeChain() { start.push_back(static_cast<std::uint32_t>(vertices.size())); }
};

/// Which constraints the edges lie on. vertexOf: the vertex that each constraint end has become.
/// The subsegments are sorted by a, then b, and their uses by constraint.
ConstraintMap makeConstraintMap(std::span<const ConstraintEnds> constraints,
                                std::span<const std::uint32_t> vertexOf, const SegmentTable& table,
                                const VertexChains& chains, std::size_t vertexCount);

} // namespace tessera
