// SPDX-License-Identifier: MIT
#pragma once

#include "arrange/arrange.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// Distance within which curves of the network count as meeting: far above the rounding of their
/// points. 0 if all are straight, since those are decided exactly.
double meetingDistance(const CurveNetwork& network, double weld);

/// Crossings closer to each other than this are one: 16 times what computing one may err.
double roundingDistance(const CurveNetwork& network);

/// Points closer than this differ by rounding alone, of whoever computed them: 64 units in the last
/// place of the greatest coordinate or the size.
double noiseDistance(const CurveNetwork& network);

/// By point: only closed curves use it, which begin and end there because they must somewhere.
std::vector<std::uint8_t> findSeams(const CurveNetwork& network);

/// Makes points of the network that lie within the tolerance of a curve's inside points of that
/// curve: it is cut there and passes through them. The free end of a line moves onto the curve
/// instead, the first one if there are several. Seams only if they are on it up to rounding.
/// Straight curves are left to exact incidence if the tolerance is 0.
void weldPointsOntoCurves(CurveNetwork& network, const ArrangeOptions& options,
                          ArrangeReport& report, Execution& execution);

/// Cuts curves where they cross, touch or overlap one another or themselves, if one of the two is
/// not straight; straight ones among themselves are for crossStraightCurves(). Meeting places
/// become points by the rules of weldMadePoints(). Pieces
/// that overlap get the same geometry, so that they are sampled alike and all their curves are
/// kept. New points follow the old ones; counts go to report.crossed.
///
/// Crossings are within rounding of both curves. Curves that come within about 1e-12 of the
/// greatest coordinate (or 2e-4 of the weld tolerance, if that is more) without crossing touch; two
/// crossings of a lens deeper than that are two points.
void crossCurves(CurveNetwork& network, const ArrangeOptions& options, ArrangeReport& report,
                 Execution& execution);

} // namespace tessera
