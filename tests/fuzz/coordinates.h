// SPDX-License-Identifier: MIT
#pragma once

#include "bytes.h"

#include "base/vec2.h"

#include <array>
#include <cmath>

namespace tessera::fuzz
{

/// The kinds of coordinates.
enum Kind
{
    Integers, ///< 0 .. 15
    Thirds,   ///< the same, divided by three
    Turned,   ///< the same, turned by 0.3 rad
    Nudged,   ///< sixteen values, each moved by a few units in the last place
    FarAway,  ///< fractions beside 2^34
    Nested,   ///< small integers at scales 1, 2^-20, 2^-40, 2^-52
    Huge,     ///< small integers times 2^300, divided by seven
    AnyDouble, ///< any, brought to at most 2^96 and at least 2^-96 unless it is zero or no number
};

inline double coordinate(Bytes& bytes, int kind)
{
    if (kind == AnyDouble) {
        int exponent = 0;
        const double fraction = std::frexp(bytes.take<double>(), &exponent);
        return std::ldexp(fraction, exponent % 96);
    }
    const auto byte = bytes.take<std::uint8_t>();
    const double low = byte & 15U;
    const int high = byte >> 4;
    switch (kind) {
    case Nudged:
        return 1.0 + low / 16.0 + (high - 8) * 0x1p-52;
    case FarAway:
        return 0x1p34 + (low + 16.0 * high) / 19.0;
    case Nested:
        return 1.0 + std::ldexp(low, std::array {-4, -20, -40, -52}[high & 3]);
    case Huge:
        return (low - 8.0) * 0x1p300 / 7.0;
    default:
        return low;
    }
}

inline Vec2 point(Bytes& bytes, int kind)
{
    const double x = coordinate(bytes, kind);
    const double y = coordinate(bytes, kind);
    switch (kind) {
    case Thirds:
        return {x / 3.0, y / 3.0};
    case Turned:
        return {std::cos(0.3) * x - std::sin(0.3) * y, std::sin(0.3) * x + std::cos(0.3) * y};
    default:
        return {x, y};
    }
}

} // namespace tessera::fuzz
