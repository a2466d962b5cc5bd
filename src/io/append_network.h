// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"

namespace tessera
{

/// Adds the operands of another input after those that are there: all ids of more are shifted.
/// Throws Error(TooLarge) when the sum does not fit into 32-bit ids.
void appendNetwork(CurveNetwork& network, CurveNetwork more);

} // namespace tessera
