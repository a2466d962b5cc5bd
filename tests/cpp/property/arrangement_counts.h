// SPDX-License-Identifier: MIT
#pragma once

#include "recover/recovery_case.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace tessera::test
{

struct ArrangementCounts
{
    std::size_t vertices = 0; ///< isolated ones too
    std::size_t edges = 0;
    std::size_t faces = 0;    ///< bounded, by Euler's formula
};

/// Of the subsegments alone, so independent of the triangles.
inline ArrangementCounts countArrangement(const RecoveryResult& result)
{
    std::vector<std::uint32_t> parent(result.triangulation.points.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t v) {
        while (parent[v] != v) {
            v = parent[v] = parent[parent[v]];
        }
        return v;
    };
    for (const Subsegment& s : result.constraints.subsegments) {
        parent[root(s.a)] = root(s.b);
    }
    ArrangementCounts counts;
    std::size_t components = 0;
    for (std::uint32_t v = 1; v < parent.size(); ++v) {
        components += root(v) == v ? 1U : 0U;
    }
    counts.vertices = result.triangulation.vertexCount();
    counts.edges = result.constraints.subsegments.size();
    counts.faces = counts.edges + components - counts.vertices;
    return counts;
}

} // namespace tessera::test
