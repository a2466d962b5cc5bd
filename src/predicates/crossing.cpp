// SPDX-License-Identifier: MIT

// With u = b - a, v = d - c, w = c - a the crossing is a + t u, t = N / D, N = w x v, D = u x v.
//   1. If all of this up to (a D + u N) is exact in double precision (small grids), one division
//      rounds correctly.
//   2. Double-double arithmetic with a running error bound: if both ends of the interval round to
//      the same double, that is the answer. It fails about once in 2^40 generic cases, and for true
//      coordinates that are zero or halfway between two doubles.
//   3. Expansion arithmetic: the sign of (a - m) D + u N compares the true coordinate with any m.
// Products have degree 3 at most, but in passesCrossing(). Coordinates outside 2^-90 .. 2^300 are first scaled by a power of
// two; with a span of at most 1e60 nothing underflows then.

#include "predicates/crossing.h"

#include "predicates/bits.h"
#include "predicates/expansion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tessera
{
namespace
{

/// head + tail, |tail| <= ulp(head) / 2, and a bound of its error.
struct Approximation
{
    double head;
    double tail;
    double error;
};

/// Covers every step below: each drops or rounds a few terms of at most 2^-104 of its operands.
constexpr double kRelative = 0x1p-99;

/// a b - c d, |tail| <= ulp(head) / 2.
TwoPart crossProduct(TwoPart a, TwoPart b, TwoPart c, TwoPart d, double& error)
{
    const TwoPart left = twoProduct(a.head, b.head);
    const TwoPart right = twoProduct(c.head, d.head);
    const TwoPart heads = twoDifference(left.head, right.head);
    const double mixed
        = (a.head * b.tail + a.tail * b.head) - (c.head * d.tail + c.tail * d.head);
    error = kRelative * (std::fabs(left.head) + std::fabs(right.head));
    return twoSum(heads.head, heads.tail + ((left.tail - right.tail) + mixed));
}

/// a / b: the quotient of the heads and one correction by what that leaves.
TwoPart divide(TwoPart a, TwoPart b)
{
    const double quotient = a.head / b.head;
    const TwoPart product = twoProduct(quotient, b.head);
    const double rest = ((a.head - product.head) - product.tail) + (a.tail - quotient * b.tail);
    return fastTwoSum(quotient, rest / b.head);
}

/// The four points with coordinates in the working range, and what crossings need of them.
class LinePair
{
public:
    LinePair(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
        : a_(a)
        , ux_(twoDifference(b.x, a.x))
        , uy_(twoDifference(b.y, a.y))
        , vx_(twoDifference(d.x, c.x))
        , vy_(twoDifference(d.y, c.y))
        , wx_(twoDifference(c.x, a.x))
        , wy_(twoDifference(c.y, a.y))
    {}

    /// Stage 1; false if something had to be rounded.
    bool crossExactly(Crossing& result) const;
    /// Stage 2. The error is infinite where it cannot be bounded.
    void approximate(Approximation& x, Approximation& y) const;
    /// Stage 3.
    int compareExactly(Axis axis, double value) const;
    double roundExactly(Axis axis, double& residual) const;
    /// (f - e) x (crossing - e) = 0.
    bool isOnLine(Vec2 e, Vec2 f) const;

private:
    using Determinant = Expansion<16>;
    using Numerator = Expansion<96>;

    Determinant denominator() const;
    Numerator numerator(Axis axis, const Determinant& d) const;

    Vec2 a_;
    TwoPart ux_, uy_, vx_, vy_, wx_, wy_;
};

bool exactProduct(double a, double b, double& product)
{
    const TwoPart p = twoProduct(a, b);
    product = p.head;
    return p.tail == 0.0;
}

/// a b + sign c d if nothing is rounded.
bool exactSum(double a, double b, double sign, double c, double d, double& sum)
{
    double left = 0.0;
    double right = 0.0;
    if (!exactProduct(a, b, left) || !exactProduct(c, d, right)) {
        return false;
    }
    const TwoPart s = twoSum(left, sign * right);
    sum = s.head;
    return s.tail == 0.0;
}

double residualOfQuotient(double numerator, double denominator, double quotient)
{
    const TwoPart product = twoProduct(quotient, denominator);
    return ((numerator - product.head) - product.tail) / denominator;
}

bool LinePair::crossExactly(Crossing& result) const
{
    if (ux_.tail != 0.0 || uy_.tail != 0.0 || vx_.tail != 0.0 || vy_.tail != 0.0
        || wx_.tail != 0.0 || wy_.tail != 0.0) {
        return false;
    }
    double n = 0.0;
    double d = 0.0;
    double x = 0.0;
    double y = 0.0;
    if (!exactSum(ux_.head, vy_.head, -1.0, uy_.head, vx_.head, d)
        || !exactSum(wx_.head, vy_.head, -1.0, wy_.head, vx_.head, n)
        || !exactSum(a_.x, d, 1.0, ux_.head, n, x) || !exactSum(a_.y, d, 1.0, uy_.head, n, y)) {
        return false;
    }
    result.point = {x / d, y / d};
    result.residual = {residualOfQuotient(x, d, result.point.x),
                       residualOfQuotient(y, d, result.point.y)};
    return true;
}

Approximation pointOnLine(double a, TwoPart u, TwoPart t, double tError)
{
    const TwoPart step = twoProduct(u.head, t.head);
    const TwoPart heads = twoSum(a, step.head);
    const double tails = heads.tail + (step.tail + (u.head * t.tail + u.tail * t.head));
    const TwoPart sum = twoSum(heads.head, tails);
    const double error = 1.01 * std::fabs(u.head) * tError
        + kRelative * (std::fabs(a) + 2.0 * std::fabs(step.head));
    return {sum.head, sum.tail, error};
}

void LinePair::approximate(Approximation& x, Approximation& y) const
{
    double dError = 0.0;
    double nError = 0.0;
    const TwoPart d = crossProduct(ux_, vy_, uy_, vx_, dError);
    const TwoPart n = crossProduct(wx_, vy_, wy_, vx_, nError);
    if (!(std::fabs(d.head) > 4.0 * dError)) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        x = y = {0.0, 0.0, infinity};
        return;
    }
    const TwoPart t = divide(n, d);
    const double tError = 1.5 * (nError + std::fabs(t.head) * dError) / std::fabs(d.head)
        + 2.0 * kRelative * std::fabs(t.head);
    x = pointOnLine(a_.x, ux_, t, tError);
    y = pointOnLine(a_.y, uy_, t, tError);
}

LinePair::Determinant LinePair::denominator() const
{
    return Expansion<2>(ux_) * Expansion<2>(vy_) - Expansion<2>(uy_) * Expansion<2>(vx_);
}

LinePair::Numerator LinePair::numerator(Axis axis, const Determinant& d) const
{
    const Determinant n
        = Expansion<2>(wx_) * Expansion<2>(vy_) - Expansion<2>(wy_) * Expansion<2>(vx_);
    return d * (axis == Axis::X ? a_.x : a_.y) + n * Expansion<2>(axis == Axis::X ? ux_ : uy_);
}

int LinePair::compareExactly(Axis axis, double value) const
{
    const Determinant d = denominator();
    return (numerator(axis, d) - d * value).sign() * d.sign();
}

bool LinePair::isOnLine(Vec2 e, Vec2 f) const
{
    const Determinant d = denominator();
    const auto x = numerator(Axis::X, d) - d * e.x;
    const auto y = numerator(Axis::Y, d) - d * e.y;
    const Expansion<2> dx(twoDifference(f.x, e.x));
    const Expansion<2> dy(twoDifference(f.y, e.y));
    return (y * dx - x * dy).sign() == 0;
}

double LinePair::roundExactly(Axis axis, double& residual) const
{
    const Determinant d = denominator();
    const Numerator n = numerator(axis, d);
    residual = 0.0;
    if (n.sign() == 0) {
        return 0.0;
    }
    // The quotient of the estimates is a few units in the last place away at most; from there on
    // step by step, comparing with the double and with the middle between it and its neighbor.
    double value = n.estimate() / d.estimate();
    for (;;) {
        const auto rest = n - d * value;
        const int side = rest.sign() * d.sign();
        residual = rest.estimate() / d.estimate();
        if (side == 0) {
            return value;
        }
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const double neighbor = std::nextafter(value, side > 0 ? infinity : -infinity);
        const Expansion<2> middle(twoSum(value, 0.5 * (neighbor - value)));
        const int beyond = (n - d * middle).sign() * d.sign() * side;
        if (beyond < 0) {
            return value;
        }
        if (beyond == 0) {
            const bool even = (std::bit_cast<std::uint64_t>(value) & 1U) == 0;
            residual = even ? residual : -residual;
            return even ? value : neighbor;
        }
        value = neighbor;
    }
}

/// Whether every number within the error rounds to the head.
bool roundsToHead(const Approximation& a)
{
    const double error = 1.01 * a.error;
    return a.head + (a.tail + error) == a.head && a.head + (a.tail - error) == a.head;
}

/// The power of two to multiply with, 0 if none is needed.
int scalingPower(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    double greatest = 0.0;
    for (const Vec2 p : {a, b, c, d}) {
        greatest = std::max({greatest, std::fabs(p.x), std::fabs(p.y)});
    }
    return greatest >= 0x1p-90 && greatest <= 0x1p300 ? 0 : -std::ilogb(greatest);
}

} // namespace

Crossing crossLines(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    if (const int power = scalingPower(a, b, c, d); power != 0) {
        const Crossing result
            = crossLines(scaled(a, power), scaled(b, power), scaled(c, power), scaled(d, power));
        return {scaled(result.point, -power), scaled(result.residual, -power)};
    }
    const LinePair lines(a, b, c, d);
    Crossing result;
    if (!lines.crossExactly(result)) {
        Approximation x;
        Approximation y;
        lines.approximate(x, y);
        result = {{x.head, y.head}, {x.tail, y.tail}};
        if (!roundsToHead(x)) {
            result.point.x = lines.roundExactly(Axis::X, result.residual.x);
        }
        if (!roundsToHead(y)) {
            result.point.y = lines.roundExactly(Axis::Y, result.residual.y);
        }
    }
    result.point = result.point + Vec2 {0.0, 0.0}; // -0 becomes 0
    return result;
}

bool passesCrossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2 e, Vec2 f)
{
    // Of degree 4: near 1 no power of the coordinates leaves the exponents of doubles.
    double greatest = 0.0;
    for (const Vec2 p : {a, b, c, d, e, f}) {
        greatest = std::max({greatest, std::fabs(p.x), std::fabs(p.y)});
    }
    const int power = -std::ilogb(greatest);
    return LinePair(scaled(a, power), scaled(b, power), scaled(c, power), scaled(d, power))
        .isOnLine(scaled(e, power), scaled(f, power));
}

int compareCrossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Axis axis, double value)
{
    if (const int power = scalingPower(a, b, c, d); power != 0) {
        return compareCrossing(scaled(a, power), scaled(b, power), scaled(c, power),
                               scaled(d, power), axis, std::ldexp(value, power));
    }
    const LinePair lines(a, b, c, d);
    Approximation x;
    Approximation y;
    lines.approximate(x, y);
    const Approximation& chosen = axis == Axis::X ? x : y;
    // Two doubles either are equal or differ by more than rounding can hide in the sum.
    const double difference = (chosen.head - value) + chosen.tail;
    if (std::fabs(difference) > 0x1p-50 * std::fabs(chosen.tail) + 1.01 * chosen.error) {
        return difference > 0.0 ? 1 : -1;
    }
    return lines.compareExactly(axis, value);
}

} // namespace tessera
