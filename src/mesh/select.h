// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"

#include <span>
#include <vector>

namespace tessera
{

/// Values that are not negative, in pieces that several threads have filled.
using ValuePieces = std::vector<std::vector<float>>;

/// For each of the ascending fractions the value that this share of all values lies below: the one
/// at fraction × (count - 1) of the sorted values. Counts by the values' bits, twelve at a time, so it
/// reads the values three times at most and moves none. Precondition: there is a value.
std::vector<float> percentiles(const ValuePieces& values, std::span<const double> fractions,
                               const Execution& execution);

} // namespace tessera
