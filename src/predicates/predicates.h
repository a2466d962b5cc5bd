// SPDX-License-Identifier: MIT
#pragma once

// Orientation and in-circle tests, exact for all finite doubles.
//
// A dynamic filter decides nearly all cases inline: the determinant in double precision against a
// bound of its rounding error. What it leaves goes through ever more careful stages to expansion
// arithmetic, and beyond the exponents where that is exact to big integers (see predicates.cpp).
// Each function returns the sign of the true determinant of its arguments: -1, 0 or 1.
//
// Filter bounds. u = 2^-53. Each difference has relative error u; each product of two differences
// 3u + O(u^2) of its magnitude; the final sums add u each. Orientation: 3u + 16u^2 of
// |left| + |right|, in-circle: 10u + 96u^2 of the permanent (Shewchuk 1997, section 4). Underflow
// adds at most 2^-1074 per product before it is multiplied on; the constants kUnderflow, far above
// that and far below any determinant of ordinary input, cover it. Overflow makes the bound infinite
// or not a number: then no comparison holds and the exact stages decide.

#include "base/vec2.h"

#include <cmath>

namespace tessera
{

namespace exact
{
/// The exact stages of the functions below.
int orient2d(Vec2 a, Vec2 b, Vec2 c);
int incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
int dotSign(Vec2 a, Vec2 b, Vec2 p, Vec2 q);

constexpr double kUnit = 0x1p-53;
constexpr double kOrientBound = (3.0 + 16.0 * kUnit) * kUnit;
constexpr double kIncircleBound = (10.0 + 96.0 * kUnit) * kUnit;
constexpr double kUnderflow = 0x1p-960; ///< times kUnit still far above 2^-1074
} // namespace exact

/// 1: a, b, c turn counter-clockwise; 0: collinear; -1: clockwise.
inline int orient2d(Vec2 a, Vec2 b, Vec2 c)
{
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    const double bound
        = exact::kOrientBound * (std::fabs(left) + std::fabs(right) + exact::kUnderflow);
    if (determinant > bound) {
        return 1;
    }
    if (-determinant > bound) {
        return -1;
    }
    return exact::orient2d(a, b, c);
}

/// For counter-clockwise a, b, c: 1: d is strictly inside their circle; 0: on it; -1: outside.
/// Reversed for clockwise a, b, c.
inline int incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    const Vec2 ad = a - d;
    const Vec2 bd = b - d;
    const Vec2 cd = c - d;
    const double bxcy = bd.x * cd.y;
    const double cxby = cd.x * bd.y;
    const double cxay = cd.x * ad.y;
    const double axcy = ad.x * cd.y;
    const double axby = ad.x * bd.y;
    const double bxay = bd.x * ad.y;
    const double aLift = squaredLength(ad);
    const double bLift = squaredLength(bd);
    const double cLift = squaredLength(cd);
    const double determinant
        = aLift * (bxcy - cxby) + bLift * (cxay - axcy) + cLift * (axby - bxay);
    constexpr double tiny = exact::kUnderflow;
    const double permanent = (std::fabs(bxcy) + std::fabs(cxby) + tiny) * (aLift + tiny)
        + (std::fabs(cxay) + std::fabs(axcy) + tiny) * (bLift + tiny)
        + (std::fabs(axby) + std::fabs(bxay) + tiny) * (cLift + tiny) + tiny;
    const double bound = exact::kIncircleBound * permanent;
    if (determinant > bound) {
        return 1;
    }
    if (-determinant > bound) {
        return -1;
    }
    return exact::incircle(a, b, c, d);
}

/// Order of any p and q along the direction from a to b: the sign of (p - q) . (b - a).
/// 1: p lies beyond q; 0: side by side; -1: p lies before q.
inline int compareAlong(Vec2 a, Vec2 b, Vec2 p, Vec2 q)
{
    const double x = (p.x - q.x) * (b.x - a.x);
    const double y = (p.y - q.y) * (b.y - a.y);
    const double sum = x + y;
    const double bound = exact::kOrientBound * (std::fabs(x) + std::fabs(y) + exact::kUnderflow);
    if (sum > bound) {
        return 1;
    }
    if (-sum > bound) {
        return -1;
    }
    return exact::dotSign(a, b, p, q);
}

/// The same for p and q on the line through a and b (a != b): comparisons only.
constexpr int compareOnLine(Vec2 a, Vec2 b, Vec2 p, Vec2 q)
{
    const bool useX = a.x != b.x;
    const bool forward = useX ? a.x < b.x : a.y < b.y;
    const double pKey = useX ? p.x : p.y;
    const double qKey = useX ? q.x : q.y;
    if (pKey == qKey) {
        return 0;
    }
    return (pKey > qKey) == forward ? 1 : -1;
}

/// For p on the line through a and b: p lies between them and is neither. False if a == b.
constexpr bool strictlyBetween(Vec2 a, Vec2 b, Vec2 p)
{
    return a.x != b.x ? (a.x < p.x && p.x < b.x) || (b.x < p.x && p.x < a.x)
                      : (a.y < p.y && p.y < b.y) || (b.y < p.y && p.y < a.y);
}

/// p lies on the closed segment from a to b, which may be a single point. Exact.
inline bool onSegment(Vec2 a, Vec2 b, Vec2 p)
{
    return p == a || p == b || (strictlyBetween(a, b, p) && orient2d(a, b, p) == 0);
}

} // namespace tessera
