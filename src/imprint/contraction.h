// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "delaunay/delaunay.h"
#include "recover/recover.h"
#include "region/region_outlines.h"
#include "sample/pslg.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tessera
{

/// A planar straight-line graph with fewer segments that divides the plane in the same way: runs of
/// segments near which there is nothing else are replaced by the chord between their ends.
struct Contraction
{
    Pslg pslg;                        ///< the points that are left, and one segment a piece
    std::vector<std::uint32_t> point; ///< by point of it: the given graph's point
    /// Piece i stands for the given segments firstSegment[i] .. firstSegment[i + 1] - 1, head to
    /// tail; of several if it is a chord.
    std::vector<std::uint32_t> firstSegment;

    std::size_t pieceCount() const { return firstSegment.size() - 1; }
    bool isChord(std::size_t piece) const
    {
        return firstSegment[piece + 1] - firstSegment[piece] > 1;
    }
};

/// None if the graph would not become much smaller. Precondition: every segment's points exist and
/// are finite. O(n log n) for n segments, O(n) where it gives up.
std::optional<Contraction> contract(const Pslg& pslg, const CurveNetwork& network,
                                    Execution& execution);

/// Whether recovery left all points where they were and all chords alone: then the result can be
/// expanded. It cannot be after snap rounding.
bool isExpandable(const Contraction& contraction, const RecoveryResult& recovered);

/// What the given graph has that the contracted one has not.
struct ExpandedOverlay
{
    /// Points and constraint map of the given graph, no triangles. Vertices are numbered in the
    /// order of its points, then the crossings.
    RecoveryResult recovered;
    std::vector<std::uint32_t> vertexOfPoint;
    Polygons polygons;
};

/// Puts the runs of segments back in the place of their chords. polygons: loops of vertices of the
/// recovered contraction. O(n). Precondition: isExpandable().
ExpandedOverlay expand(const Contraction& contraction, const Pslg& pslg,
                       const RecoveryResult& recovered,
                       std::span<const std::uint32_t> vertexOfPoint, const Polygons& polygons);

/// By piece: the signed area between it and its run of segments, positive where that is on the right
/// of it. O(n).
std::vector<double> runAreas(const Contraction& contraction, const Pslg& pslg);

} // namespace tessera
