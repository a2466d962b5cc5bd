// SPDX-License-Identifier: MIT
#pragma once

// Numbers and places as messages show them.

#include "base/vec2.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace tessera
{

/// With so many significant digits, without trailing zeros; "%g".
inline std::string numberText(double value, int digits = 6)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value + 0.0); // no -0
    return text;
}

/// "(1000000.25, 3)": six digits, more for places far from the origin (four decimals) and where
/// the message names another place, no closer than `apart` (the two then differ).
inline std::string placeText(Vec2 p, double apart = std::numeric_limits<double>::infinity())
{
    const double greatest = std::max(std::fabs(p.x), std::fabs(p.y));
    int digits = 6;
    if (greatest > 0.0 && std::isfinite(greatest)) {
        const double integers = std::floor(std::log10(greatest)) + 1.0;
        const double decimals = apart > 0.0 ? std::max(4.0, 1.0 - std::floor(std::log10(apart)))
                                            : 4.0;
        // Numbers below one need few; without other places near, six digits serve them.
        digits = static_cast<int>(std::clamp(integers + decimals, 6.0, 17.0));
    }
    char text[80];
    std::snprintf(text, sizeof text, "(%.*g, %.*g)", digits, p.x + 0.0, digits, p.y + 0.0);
    return text;
}

} // namespace tessera
