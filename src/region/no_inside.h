// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"
#include "region/region.h"

namespace tessera
{

/// The Error(NoInside) for a result without any inside, saying why and what to do: no curves, only
/// open ones (with the two free ends closest to each other as places), no area, cancelling or
/// clockwise loops, holes that take everything away. Precondition: colorRegions() of the same
/// arguments kept no region.
Error explainNoInside(const RecoveryResult& recovered, const CurveNetwork& network,
                      const Pslg& pslg, FillRule fill);

} // namespace tessera
