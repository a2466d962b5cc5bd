// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"

#include <cstdint>

namespace tessera
{

/// Rule 1 (paper, section 3, step 2): of two elements that share a boundary border one is outer and
/// the other is not. Section 4: they get different colors.
constexpr bool rule1Outer(bool outerHere)
{
    return !outerHere;
}

/// Rule 2: two elements that share a border that is no boundary are both outer or both inner.
/// Section 4: they get the same color.
constexpr bool rule2Outer(bool outerHere)
{
    return outerHere;
}

/// Both rules for a border that lies on `count` boundary curves of one operand: rule 1 once for
/// each of them, so that a boundary drawn twice cancels.
constexpr bool outerAcross(bool outerHere, std::uint32_t count)
{
    return count % 2 == 1 ? rule1Outer(outerHere) : rule2Outer(outerHere);
}

/// Whether a winding number is inside. Parity of the winding number is what rules 1 and 2 count.
constexpr bool isInside(FillRule rule, std::int32_t winding)
{
    switch (rule) {
        case FillRule::EvenOdd:
        case FillRule::Hull:
            return winding % 2 != 0;
        case FillRule::Positive:
            return winding > 0;
        case FillRule::Negative:
            return winding < 0;
        case FillRule::NonZero:
        case FillRule::All:
            break;
    }
    return winding != 0;
}

} // namespace tessera
