// SPDX-License-Identifier: MIT
#pragma once

#include "arrange/arrange.h"

namespace tessera
{

/// Splits the straight curves of a welded network where they cross, touch or overlap one another
/// or meet a point of the network, so that sampling by size starts from the crossings and leaves no
/// sliver beside them. Boundary recovery itself finds them: it decides exactly and is total.
/// Curves on a geometry stay as they are. New points follow the old ones
/// (ArrangeReport::firstCrossing); what recovery did is in ArrangeReport::crossed.
void crossStraightCurves(CurveNetwork& network, const ArrangeOptions& options,
                         ArrangeReport& report, Execution& execution);

} // namespace tessera
