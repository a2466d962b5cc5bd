// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "recover/recover.h"
#include "region/subsegment_graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// A subsegment (or none) between the faces on its two sides.
struct FaceLink
{
    static constexpr std::uint32_t kNoSubsegment = 0xffffffffU;

    std::uint32_t left; ///< of the way from the subsegment's a to its b
    std::uint32_t right;
    std::uint32_t subsegment;
};

/// Faces: sets of triangles that no subsegment of any role separates. Face 0 holds the outer seeds;
/// the others are numbered by their lowest triangle.
struct FaceGraph
{
    std::vector<std::uint32_t> faceOfTriangle; ///< kNoFace for dead triangles
    std::size_t faceCount = 0;
    std::vector<FaceLink> links; ///< links[s] is subsegment s; hull edges without one may follow
    /// The links at each face: linksAt[start[f] .. start[f + 1]). Links with the same face on both
    /// sides are left out.
    std::vector<std::uint32_t> start;
    std::vector<std::uint32_t> linksAt;

    static constexpr std::uint32_t kNoFace = 0xffffffffU;

    std::span<const std::uint32_t> linksOf(std::uint32_t face) const
    {
        return {linksAt.data() + start[face], start[face + 1] - start[face]};
    }
    std::uint32_t across(std::uint32_t link, std::uint32_t face) const
    {
        return links[link].left == face ? links[link].right : links[link].left;
    }
};

/// Floods the triangles from the outer seeds, then from each triangle not reached yet.
/// O(triangles + subsegments).
FaceGraph buildFaces(const RecoveryResult& recovered, const SubsegmentGraph& graph,
                     Execution& execution);

/// The same with the convex hull as a border too: outside of it are the outer seeds and the
/// triangles named (see hull_slivers.h).
FaceGraph buildHullFaces(const RecoveryResult& recovered, const SubsegmentGraph& graph,
                         const std::vector<std::uint32_t>& outside, Execution& execution);

} // namespace tessera
