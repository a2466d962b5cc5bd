// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tessera
{

/// The e with 2^e <= |value| < 2^(e + 1) of a nonzero finite double; -1022 for subnormal ones.
inline int exponentOf(double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return std::max(static_cast<int>((bits >> 52) & 0x7ff), 1) - 1023;
}

/// The e such that a nonzero finite double is an odd multiple of 2^e.
inline int lowestBit(double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t hidden = ((bits >> 52) & 0x7ff) != 0 ? 0x10000000000000ULL : 0ULL;
    const std::uint64_t mantissa = (bits & 0xfffffffffffffULL) | hidden;
    return exponentOf(value) - 52 + std::countr_zero(mantissa);
}

/// p times 2^power: exact unless a coordinate leaves the range of doubles.
inline Vec2 scaled(Vec2 p, int power)
{
    return {std::ldexp(p.x, power), std::ldexp(p.y, power)};
}

} // namespace tessera
