// SPDX-License-Identifier: MIT
#pragma once

#include "arrange/arrange.h"
#include "curve/curve_network.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// A curve shall have a network point at a parameter.
struct CurveSplit
{
    std::uint32_t curve;
    double t; ///< of a straight curve: 0 at its start, 1 at its end
    PointId point;
};

/// Where a piece comes from.
struct PieceOrigin
{
    std::uint32_t curve;
    double t0;
    double t1;
};

/// Cuts the curves of a network. Splits that repeat the point of a neighboring split or end within
/// `shortest` along the curve are left out, and so are pieces that would have the same ends and be
/// no longer. Pieces follow each other in the order of their curves; report.parent and the curves'
/// names go along. Returns by piece where it comes from.
std::vector<PieceOrigin> splitCurves(CurveNetwork& network, std::vector<CurveSplit> splits,
                                     double shortest, ArrangeReport& report);

} // namespace tessera
