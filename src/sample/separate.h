// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "base/ids.h"
#include "base/vec2.h"
#include "curve/curve.h"
#include "sample/pslg.h"

#include <cstddef>
#include <vector>

namespace tessera
{

/// A chord of a curve. Null geometry: straight.
struct CurvePiece
{
    PointId a;
    PointId b;
    CurveId curve;
    const Curve* geometry;
    double ta; ///< parameters of a and b on the geometry; ta > tb if the curve runs backwards
    double tb;
};

struct SeparateOptions
{
    /// Greatest sagitta of a piece as a part of its distance from pieces that it does not hang
    /// together with; 0: no bound, only the topology counts.
    double gapShare = 0.0;
    /// For gapShare no more than so many pieces are halved in all.
    std::size_t mostHalvesForGaps = 100000;
};

struct Separation
{
    std::vector<CurvePiece> halves; ///< the pieces that were made
    /// Where keeping gapShare would take more than mostHalvesForGaps; one of each such piece.
    std::vector<CoarseGap> coarseGaps;
    bool done = true;               ///< false: some pieces are still in the way of others
    Vec2 unseparated;               ///< a place of one of them
};

/// Halves curved pieces until the pieces meet only where their curves do: no two of them cross, and
/// no point lies between a piece and its curve. Thin gaps between arcs and small loops beside an
/// arc need that. Equal pieces are halved alike. With gapShare also until the pieces on both sides
/// of a gap follow it, so that its width and area are nearly those between the curves; next to a
/// common end, where the gap closes, as far as a fiftieth of the shorter curve. Pieces
/// that still want that when mostHalvesForGaps is used up are left as the topology wants them, and
/// named.
///
/// Precondition: the curves themselves meet in common end points only, or coincide. Where that
/// fails (straight curves may cross straight ones) curved pieces are halved a bounded number of
/// times and then left. The pieces of a curve follow one another.
Separation separatePieces(std::vector<Vec2>& points, std::vector<CurvePiece>& pieces,
                          const SeparateOptions& options, Execution& execution);

} // namespace tessera
