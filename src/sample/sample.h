// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "sample/pslg.h"
#include "sizing/size_field.h"

namespace tessera
{

struct SampleOptions
{
    /// False: straight curves stay whole whatever the size (--no-refine).
    bool straightSegments = true;
    /// At least so many pieces for a full turn of the tangent, so that a circle far smaller than the
    /// size still looks like one; 3 .. 10000.
    double piecesPerTurn = 8.0;
    /// Greatest distance of a piece from its curve, in the input's unit; 0: no bound.
    double chordError = 0.0;
};

/// Replaces each curve by straight pieces whose ends lie on it. A curve gets n pieces with equal
/// shares of the integral of ds/h, n being the integral rounded so that each share is within
/// [0.7, 1.4] where one piece is not already shorter; more where piecesPerTurn or chordError ask for
/// it, at least 3 on a closed curve and 2 on a curved one that shares both ends with another curve.
/// Independent of the curve's direction. Curves of zero length are dropped and named in
/// Pslg::messages; Role::Ignored is left out silently.
/// Throws Error(InvalidOption) where the size is not positive and finite, Error(TooLarge) when more
/// than 2^28 pieces would result.
Pslg sample(const CurveNetwork& network, const SizeField& size, const SampleOptions& options,
            Execution& execution);

} // namespace tessera
