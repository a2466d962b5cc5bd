// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "sample/pslg.h"
#include "sizing/size_field.h"

namespace tessera
{

/// The most pieces that sample() ever makes.
inline constexpr double kMostPieces = 67108864.0;

struct SampleOptions
{
    /// False: straight curves stay whole whatever the size (--no-refine).
    bool straightSegments = true;
    /// At least so many pieces for a full turn of the tangent, so that a circle far smaller than
    /// the size still looks like one; 3 .. 10000.
    double piecesPerTurn = 20.0;
    /// Greatest distance of a piece from its curve, in the input's unit; 0: no bound. Kept as far
    /// as curvature tells it: sagitta = piece^2 curvature / 8.
    double chordError = 0.0;
    /// Greatest sagitta of a piece as a part of the width of the gap to another curve beside it, so
    /// that areas between curves are nearly the true ones; 0: no bound. Gaps that would take more
    /// than 100,000 pieces (128 for each piece there is, if that is more; 1/20 of mostPieces, if
    /// that is less) are left, see Pslg::coarseGaps.
    double gapShare = 0.0;
    /// How fast pieces may become longer away from places where the size is not fine enough to keep
    /// curves apart; above 0. Where the size field itself grows faster, as fast as that. Infinite:
    /// only pieces that are in the way of others are halved, which takes one sampling.
    double growth = 0.3;
    double mostPieces = kMostPieces; ///< what would become more is refused
};

/// Replaces each curve by straight pieces whose ends lie on it. A curve gets n pieces with equal
/// shares of the integral of ds/h (ds/h being raised where it bends too much for piecesPerTurn or
/// chordError); n is that integral rounded so that each share lies within [0.7, 1.4] unless one
/// piece is already less. It is higher where piecesPerTurn or chordError need it, at least 3 on a
/// closed curve and 2 on a curved one that shares both ends with another curve. Corners inside a
/// curve become points.
/// Pieces of curves that do not cross do not cross either: where pieces are in the way of others
/// (see separate.h) all is sampled again with a size that is smaller there, some times if need be;
/// what is then still in the way is halved. So the pieces have the topology of the arranged curves;
/// where they do not, since curves run too close to each other, Pslg::messages say so.
/// The result does not depend on a curve's direction, and curves with the same geometry are cut at
/// the same points, bit for bit. Curves of zero length are dropped and named in Pslg::messages;
/// curves with Role::Ignored are left out silently.
/// Throws Error(InvalidOption) where the size is not positive and finite, and for options out of
/// range; Error(TooLarge) when more than options.mostPieces would result.
Pslg sample(const CurveNetwork& network, const SizeField& size, const SampleOptions& options,
            Execution& execution);

/// The number of pieces for a curve whose integral of ds/h is x: the one for which x / n is nearest
/// to 1 in ratio, and never above 1.4.
std::size_t pieceCount(double x);

} // namespace tessera
