// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "sizing/local_sizes.h"
#include "sizing/size_field.h"

#include <functional>
#include <memory>

namespace tessera
{

/// What a size field is made of. Lengths in the input's unit.
struct SizeOptions
{
    double size = 0.0;          ///< largest size; 0: defaultSize()
    double minSize = 0.0;       ///< nowhere smaller; 0: no bound
    double growth = 0.3;        ///< greatest |grad h|, 0 < growth <= 1
    LocalSizes local {};        ///< its regions do not count here: give areas instead
    /// Whether a place is to be meshed: other gaps between curves do not count. Null: everywhere.
    std::function<bool(Vec2)> inside {};
};

/// Bounding-box diagonal / 40; 0 for a network without extent.
double defaultSize(const CurveNetwork& network);

/// The field of a network: options.size, smaller at curves too short or too strongly curved for it
/// and where options.local asks for less, growing from there at most by options.growth. A
/// UniformSize where nothing is smaller. Throws Error(InvalidOption): options out of range; with
/// the place where a source gives no size above 0.
std::unique_ptr<SizeField> makeSizeField(const CurveNetwork& network, const SizeOptions& options,
                                         Execution& execution);

/// The minimum of base and what the curves ask for.
std::unique_ptr<SizeField> makeSizeField(const CurveNetwork& network,
                                         std::shared_ptr<const SizeField> base,
                                         const SizeOptions& options, Execution& execution);

} // namespace tessera
