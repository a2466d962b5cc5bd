// SPDX-License-Identifier: MIT
#pragma once

#include "recover/recover.h"
#include "region/region.h"
#include "sample/pslg.h"

#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// What to tell the user about constraints, chains that do not close, and boundary curves with a
/// free end, of which a part lies outside everything that is meshed: their names, and the gap or
/// crossing that may be the reason.
/// parent as for findOutlineFlaw(). Empty if there are none. O(subsegments log subsegments).
std::vector<std::string> describeDroppedCurves(const RecoveryResult& recovered,
                                               const CurveNetwork& network, const Pslg& pslg,
                                               const RegionMap& regions,
                                               std::span<const CurveId> parent = {});

} // namespace tessera
