// SPDX-License-Identifier: MIT
#pragma once

#include "sizing/area_size.h"

#include <string>

namespace tessera
{

/// The size that an expression in x and y gives, in the unit of the curves: numbers, pi, + - * / ^,
/// comparisons and "condition ? a : b", functions such as sqrt, abs, sin, exp, ln, min, max.
/// Throws Error(InvalidOption) if it cannot be read, with what is wrong and where.
AreaSource expressionSource(const std::string& expression);

} // namespace tessera
