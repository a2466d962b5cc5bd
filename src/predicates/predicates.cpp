// SPDX-License-Identifier: MIT

// The stages behind the filters of predicates.h.
//
// orient2d and dotSign are signs of sums of two products of differences.
//   1. If the four differences are exact, compare the two products as exact head + tail pairs.
//   2. Expansion arithmetic.
// incircle:
//   1. If the points are the corners of a parallelogram (lattices of any step, rounded rectangles):
//      the signs of a cross product and a dot product.
//   2. If the six differences are exact and multiples, below 2^30, of one power of two: 128-bit
//      integers.
//   3. Cross products corrected to first order in the rounding errors of their factors, lifts in
//      double precision: enough for slivers, whose cross products are small against their terms.
//   4. Double-double arithmetic with a bound of 2^-94 of the permanent.
//   5. Expansion arithmetic (Shewchuk 1997).
// Expansions are exact while all exponents stay within the limits below. Otherwise the arguments
// are scaled by a power of two, which changes no sign; and if even that cannot bring both the
// greatest and the smallest into the limits, big integers decide. Hence every sign is right for all
// finite doubles.

#include "predicates/predicates.h"

#include "predicates/big_integer.h"
#include "predicates/bits.h"
#include "predicates/expansion.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

namespace tessera::exact
{
namespace
{

/// Exponents of the greatest and of the smallest nonzero of some doubles.
struct ExponentRange
{
    int min = 4096;
    int max = -4096;
};

ExponentRange exponentRange(std::initializer_list<double> values)
{
    ExponentRange range;
    for (const double value : values) {
        if (value != 0.0) {
            const int exponent = exponentOf(value);
            range.min = std::min(range.min, exponent);
            range.max = std::max(range.max, exponent);
        }
    }
    return range;
}

/// Within these exponents products of `degree` differences are exact: the least bit of a factor,
/// 2^(min - 52), to the power of the degree is at least 2^-1074, and the greatest value stays below
/// 2^1000.
struct ExponentLimits
{
    int min;
    int max;
};
constexpr ExponentLimits kDegree2 {-480, 490};
constexpr ExponentLimits kDegree4 {-210, 240};

bool within(ExponentRange range, ExponentLimits limits)
{
    return range.min >= limits.min && range.max <= limits.max;
}

/// The power of two that brings the greatest exponent to the upper limit.
int scaleFor(ExponentRange range, ExponentLimits limits)
{
    return limits.max - range.max;
}

int compareProducts(double a, double b, double c, double d)
{
    const TwoPart left = twoProduct(a, b);
    const TwoPart right = twoProduct(c, d);
    // Rounding is monotone: different heads are in the order of the exact products.
    if (left.head != right.head) {
        return left.head > right.head ? 1 : -1;
    }
    return left.tail == right.tail ? 0 : (left.tail > right.tail ? 1 : -1);
}

/// Sign of a b - c d for exponents within kDegree2.
int differenceOfProducts(TwoPart a, TwoPart b, TwoPart c, TwoPart d)
{
    if (a.tail == 0.0 && b.tail == 0.0 && c.tail == 0.0 && d.tail == 0.0) {
        return compareProducts(a.head, b.head, c.head, d.head);
    }
    const Expansion<2> ea(a);
    const Expansion<2> eb(b);
    const Expansion<2> ec(c);
    const Expansion<2> ed(d);
    return (ea * eb - ec * ed).sign();
}

__extension__ using Int128 = __int128;

/// In-circle sign of three vectors whose components are integers below 2^30.
int incircleSmallIntegers(const double (&x)[3], const double (&y)[3], int power)
{
    std::int64_t ix[3];
    std::int64_t iy[3];
    for (int i = 0; i < 3; ++i) {
        ix[i] = static_cast<std::int64_t>(std::ldexp(x[i], power));
        iy[i] = static_cast<std::int64_t>(std::ldexp(y[i], power));
    }
    Int128 sum = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        sum += static_cast<Int128>(ix[i] * ix[i] + iy[i] * iy[i])
            * (ix[j] * iy[k] - ix[k] * iy[j]);
    }
    return sum > 0 ? 1 : (sum < 0 ? -1 : 0);
}

/// a + c == b + d exactly.
bool sameSum(double a, double c, double b, double d)
{
    const TwoPart left = twoSum(a, c);
    const TwoPart right = twoSum(b, d);
    return left.head == right.head && left.tail == right.tail;
}

/// In-circle sign of d if a, b, c, d are a parallelogram in this order, otherwise 2. With
/// u = a - d, v = c - d and b - d = u + v the determinant
///     |u|^2 (u + v) x v + |u + v|^2 v x u + |v|^2 u x (u + v)
/// is -2 (u x v) (u . v).
int incircleParallelogram(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    if (!sameSum(a.x, c.x, b.x, d.x) || !sameSum(a.y, c.y, b.y, d.y)) {
        return 2;
    }
    const TwoPart ux = twoDifference(a.x, d.x);
    const TwoPart uy = twoDifference(a.y, d.y);
    const TwoPart vx = twoDifference(c.x, d.x);
    const TwoPart vy = twoDifference(c.y, d.y);
    const int cross = differenceOfProducts(ux, vy, uy, vx);
    return cross == 0 ? 0 : -cross * differenceOfProducts(ux, vx, uy, {-vy.head, -vy.tail});
}

/// A number as the unevaluated sum of two doubles, relative error of each operation below 2^-100.
struct DoubleDouble
{
    double head;
    double tail;
};

DoubleDouble operator+(DoubleDouble a, DoubleDouble b)
{
    const TwoPart heads = twoSum(a.head, b.head);
    const TwoPart tails = twoSum(a.tail, b.tail);
    const TwoPart sum = fastTwoSum(heads.head, heads.tail + tails.head);
    const TwoPart result = fastTwoSum(sum.head, sum.tail + tails.tail);
    return {result.head, result.tail};
}

DoubleDouble operator-(DoubleDouble a)
{
    return {-a.head, -a.tail};
}

DoubleDouble operator*(DoubleDouble a, DoubleDouble b)
{
    const TwoPart product = twoProduct(a.head, b.head);
    const TwoPart result
        = fastTwoSum(product.head, product.tail + (a.head * b.tail + a.tail * b.head));
    return {result.head, result.tail};
}

using Differences = TwoPart[3];

/// In-circle sign from corrected cross products if that suffices, otherwise 2. With u = 2^-53: a
/// lift has relative error 4u. A cross product l - r, with the exact products of the heads and all
/// terms of first order in the tails, loses at most 3u of itself and 2^-101 (|l| + |r|); product
/// and sums add 3u.
int incircleCorrected(const Differences& x, const Differences& y)
{
    double determinant = 0.0;
    double terms = 0.0;
    double permanent = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        const TwoPart left = twoProduct(x[j].head, y[k].head);
        const TwoPart right = twoProduct(x[k].head, y[j].head);
        const double correction = (x[j].tail * y[k].head + x[j].head * y[k].tail)
            - (x[k].tail * y[j].head + x[k].head * y[j].tail);
        const double cross = (left.head - right.head) + ((left.tail - right.tail) + correction);
        const double lift = x[i].head * x[i].head + y[i].head * y[i].head;
        determinant += lift * cross;
        terms += lift * std::fabs(cross);
        permanent += lift * (std::fabs(left.head) + std::fabs(right.head));
    }
    const double bound = 12.0 * kUnit * terms + 0x1p-100 * permanent;
    return determinant > bound ? 1 : (-determinant > bound ? -1 : 2);
}

/// In-circle sign by double-double arithmetic if that suffices, otherwise 2. Each product has
/// relative error below 2^-100 and each term is a product of four factors; the sums of at most
/// three terms of at most two products lose less than 2^-100 of the sum of magnitudes each.
int incircleDoubleDouble(const Differences& x, const Differences& y)
{
    DoubleDouble determinant {0.0, 0.0};
    double permanent = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        const auto dd = [](TwoPart t) { return DoubleDouble {t.head, t.tail}; };
        const DoubleDouble lift = dd(x[i]) * dd(x[i]) + dd(y[i]) * dd(y[i]);
        const DoubleDouble left = dd(x[j]) * dd(y[k]);
        const DoubleDouble right = dd(x[k]) * dd(y[j]);
        determinant = determinant + lift * (left + -right);
        permanent += lift.head * (std::fabs(left.head) + std::fabs(right.head));
    }
    const double bound = 0x1p-94 * permanent;
    return determinant.head > bound ? 1 : (-determinant.head > bound ? -1 : 2);
}

int incircleExpansions(const Differences& x, const Differences& y)
{
    const auto term = [&](int i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        const Expansion<2> xi(x[i]);
        const Expansion<2> yi(y[i]);
        const auto cross
            = Expansion<2>(x[j]) * Expansion<2>(y[k]) - Expansion<2>(x[k]) * Expansion<2>(y[j]);
        return cross * (xi * xi + yi * yi);
    };
    return (term(0) + term(1) + term(2)).sign();
}

/// The power of two that makes all six integers below 2^30, or 4096 if there is none.
int smallIntegerPower(const double (&x)[3], const double (&y)[3])
{
    int lowest = 4096;
    double greatest = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (const double value : {x[i], y[i]}) {
            lowest = value != 0.0 ? std::min(lowest, lowestBit(value)) : lowest;
            greatest = std::max(greatest, std::fabs(value));
        }
    }
    return greatest != 0.0 && exponentOf(greatest) - lowest < 30 ? -lowest : 4096;
}

/// For exponents within kDegree4.
int incircleInLimits(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    // Turning a, b, c leaves the sign: each of them may be the corner opposite d.
    const Vec2 corners[5] = {a, b, c, a, b};
    for (int i = 0; i < 3; ++i) {
        const int sign = incircleParallelogram(corners[i], corners[i + 1], corners[i + 2], d);
        if (sign != 2) {
            return sign;
        }
    }
    const Differences dx = {twoDifference(a.x, d.x), twoDifference(b.x, d.x),
                            twoDifference(c.x, d.x)};
    const Differences dy = {twoDifference(a.y, d.y), twoDifference(b.y, d.y),
                            twoDifference(c.y, d.y)};
    if (dx[0].tail == 0.0 && dx[1].tail == 0.0 && dx[2].tail == 0.0 && dy[0].tail == 0.0
        && dy[1].tail == 0.0 && dy[2].tail == 0.0) {
        const double x[3] = {dx[0].head, dx[1].head, dx[2].head};
        const double y[3] = {dy[0].head, dy[1].head, dy[2].head};
        const int power = smallIntegerPower(x, y);
        if (power != 4096) {
            return incircleSmallIntegers(x, y, power);
        }
    }
    int sign = incircleCorrected(dx, dy);
    if (sign == 2) {
        sign = incircleDoubleDouble(dx, dy);
    }
    return sign != 2 ? sign : incircleExpansions(dx, dy);
}

/// Sign of (a - b) (c - d) - (e - f) (g - h) for any finite doubles.
int differenceOfProducts(double a, double b, double c, double d, double e, double f, double g,
                         double h)
{
    const ExponentRange range = exponentRange({a, b, c, d, e, f, g, h});
    if (within(range, kDegree2)) {
        return differenceOfProducts(twoDifference(a, b), twoDifference(c, d), twoDifference(e, f),
                                    twoDifference(g, h));
    }
    const int power = scaleFor(range, kDegree2);
    if (range.min + power >= kDegree2.min) {
        const auto difference = [power](double p, double q) {
            return twoDifference(std::ldexp(p, power), std::ldexp(q, power));
        };
        return differenceOfProducts(difference(a, b), difference(c, d), difference(e, f),
                                    difference(g, h));
    }
    const auto big = [](double p, double q) { return BigInteger(p) - BigInteger(q); };
    return (big(a, b) * big(c, d) - big(e, f) * big(g, h)).sign();
}

int incircleBigIntegers(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    const BigInteger dx(d.x);
    const BigInteger dy(d.y);
    const BigInteger x[3] = {BigInteger(a.x) - dx, BigInteger(b.x) - dx, BigInteger(c.x) - dx};
    const BigInteger y[3] = {BigInteger(a.y) - dy, BigInteger(b.y) - dy, BigInteger(c.y) - dy};
    BigInteger sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        sum = sum + (x[i] * x[i] + y[i] * y[i]) * (x[j] * y[k] - x[k] * y[j]);
    }
    return sum.sign();
}

} // namespace

int orient2d(Vec2 a, Vec2 b, Vec2 c)
{
    return differenceOfProducts(a.x, c.x, b.y, c.y, a.y, c.y, b.x, c.x);
}

int dotSign(Vec2 a, Vec2 b, Vec2 p, Vec2 q)
{
    return differenceOfProducts(p.x, q.x, b.x, a.x, p.y, q.y, a.y, b.y);
}

int incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    const ExponentRange range = exponentRange({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
    if (within(range, kDegree4)) {
        return incircleInLimits(a, b, c, d);
    }
    const int power = scaleFor(range, kDegree4);
    if (range.min + power >= kDegree4.min) {
        return incircleInLimits(scaled(a, power), scaled(b, power), scaled(c, power),
                                scaled(d, power));
    }
    return incircleBigIntegers(a, b, c, d);
}

} // namespace tessera::exact
