// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"
#include "region/region.h"

#include <span>

namespace tessera
{

/// What an arranged network was made of, for telling which roles its curves were given.
struct ArrangedInput
{
    const CurveNetwork& network;     ///< before arrange()
    std::span<const CurveId> parent; ///< ArrangeReport::parent
    double weld = 0.0;
    std::size_t weldedAlong = 0; ///< ArrangeReport::weldedAlong
};

/// The Error(NoInside) for a result without any inside, saying why and what to do: no curves, only
/// open ones (with the place to mend, see findOutlineFlaw()), roles that leave no outline, no area,
/// cancelling or clockwise loops, holes that take everything away. Precondition: colorRegions() of
/// the same arguments kept no region.
Error explainNoInside(const RecoveryResult& recovered, const CurveNetwork& network,
                      const Pslg& pslg, FillRule fill, const ArrangedInput& input);

} // namespace tessera
