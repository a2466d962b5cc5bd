// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/imprint.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace tessera
{

/// What the report of an imprint needs besides its result.
struct ImprintReportInput
{
    std::vector<ImprintSide> side; ///< by operand
    /// From the common plane to space.
    std::function<std::array<double, 3>(Vec2)> toSpace;
};

/// The report of an imprint as JSON: that of the overlay with operation cells, and besides
/// `tolerance`, `cells [{area, operands, sources, targets}]`, `sources` and `targets [{name, area,
/// cells}]`, `closed` and `left [{kind, area, width, at, sources, targets}]`. Operands, sources,
/// targets and cells are numbered from 1; `at` is a point of the plane of the first source.
std::string formatReport(const ImprintResult& result, const ImprintReportInput& input);

} // namespace tessera
