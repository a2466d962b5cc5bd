// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/overlay.h"

#include <string>

namespace tessera
{

/// The report of an overlay as JSON. Operands are numbered from 1, in the order of the input; with
/// cells or a priority, `cells` has an entry for each line of the result.
std::string formatReport(const OverlayResult& result, BooleanOperation operation);

} // namespace tessera
