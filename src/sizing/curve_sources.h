// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "sizing/graded_size.h"

#include <vector>

namespace tessera
{

struct CurveSourceOptions
{
    double piecesPerTurn = 20.0; ///< pieces for a full turn of the tangent
    double chordError = 0.0;    ///< greatest distance of a piece from its curve; 0: no bound
    double minSize = 0.0;       ///< no source is smaller; 0: a thousandth of the size in place
};

/// Where the curves need pieces clearly shorter than base asks for (below 0.7 of it): whole curves
/// that are short, stretches that are strongly curved.
std::vector<SizeSource> curveSources(const CurveNetwork& network, const SizeField& base,
                                     const CurveSourceOptions& options);

/// Appends a source like law (its ends are filled in) for each chord of the curve; the chords are
/// nearer to the curve than a tenth of law's size.
void addSourcesAlong(const CurveNetwork& network, const NetworkCurve& curve, SizeSource law,
                     std::vector<SizeSource>& sources);

} // namespace tessera
