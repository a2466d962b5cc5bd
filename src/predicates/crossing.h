// SPDX-License-Identifier: MIT
#pragma once

// The point where two lines cross, rounded once and correctly.
//
// Precondition of all functions: the lines are not parallel, that is (b - a) x (d - c) != 0, and
// the coordinates are within predicates/range.h.
// Guarantee: each coordinate is the double nearest to the true value (ties to even, zero positive),
// so that the bits do not depend on the order or the direction of the operands, and several lines
// through one point have one crossing.
// Consequences used by boundary recovery: rounding is monotone, so that the crossings of one
// segment, in their true order along it, never go backward in x or in y; and each lies in the
// bounding box of the segment.

#include "base/vec2.h"

namespace tessera
{

struct Crossing
{
    Vec2 point;    ///< the true crossing, rounded
    Vec2 residual; ///< an estimate of the true crossing minus point
};

/// Where the line through a and b meets the line through c and d.
Crossing crossLines(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

enum class Axis
{
    X,
    Y,
};

/// Sign of (coordinate of the true crossing - value), exact.
int compareCrossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Axis axis, double value);

/// Whether the line through e and f passes through the true crossing; exact.
bool passesCrossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2 e, Vec2 f);

} // namespace tessera
