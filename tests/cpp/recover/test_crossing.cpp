// SPDX-License-Identifier: MIT
#include "predicates/crossing.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace tessera
{
namespace
{

using Rational = boost::multiprecision::cpp_rational;

struct Lines
{
    Vec2 a, b, c, d;
};

struct TrueCrossing
{
    Rational x, y;
};

/// False if parallel.
bool crossExactly(const Lines& l, TrueCrossing& result)
{
    const auto exact = [](double v) { return Rational(v); };
    const Rational ux = exact(l.b.x) - exact(l.a.x);
    const Rational uy = exact(l.b.y) - exact(l.a.y);
    const Rational vx = exact(l.d.x) - exact(l.c.x);
    const Rational vy = exact(l.d.y) - exact(l.c.y);
    const Rational wx = exact(l.c.x) - exact(l.a.x);
    const Rational wy = exact(l.c.y) - exact(l.a.y);
    const Rational d = ux * vy - uy * vx;
    if (d == 0) {
        return false;
    }
    const Rational t = (wx * vy - wy * vx) / d;
    result = {exact(l.a.x) + t * ux, exact(l.a.y) + t * uy};
    return true;
}

/// Whether value is the double nearest to the truth, even in a tie.
void expectNearest(double value, const Rational& truth)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const Rational error = abs(Rational(value) - truth);
    for (const double direction : {-infinity, infinity}) {
        const double neighbor = std::nextafter(value, direction);
        const Rational other = abs(Rational(neighbor) - truth);
        EXPECT_LE(error, other) << value;
        if (error == other) {
            EXPECT_EQ(std::bit_cast<std::uint64_t>(value) & 1U, 0U) << value;
        }
    }
    if (value == 0.0) {
        EXPECT_FALSE(std::signbit(value));
    }
}

void expectSameBits(Vec2 p, Vec2 q)
{
    EXPECT_EQ(std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(q.x));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(p.y), std::bit_cast<std::uint64_t>(q.y));
}

/// Returns whether the lines cross.
bool check(const Lines& l)
{
    TrueCrossing truth;
    if (!crossExactly(l, truth)) {
        return false;
    }
    const Crossing crossing = crossLines(l.a, l.b, l.c, l.d);
    expectNearest(crossing.point.x, truth.x);
    expectNearest(crossing.point.y, truth.y);
    expectSameBits(crossing.point, crossLines(l.b, l.a, l.c, l.d).point);
    expectSameBits(crossing.point, crossLines(l.d, l.c, l.a, l.b).point);
    expectSameBits(crossing.point, crossLines(l.c, l.d, l.b, l.a).point);
    const double value = crossing.point.x;
    const double ulp = std::max(std::nextafter(std::fabs(value), 1e300) - std::fabs(value), 1e-280);
    EXPECT_NEAR(crossing.residual.x, static_cast<double>(truth.x - Rational(value)), 0.5 * ulp);
    for (const double v : {value, value + ulp, value - ulp}) {
        const Rational difference = truth.x - Rational(v);
        EXPECT_EQ(compareCrossing(l.a, l.b, l.c, l.d, Axis::X, v),
                  difference > 0 ? 1 : (difference < 0 ? -1 : 0));
    }
    const Rational difference = truth.y - Rational(crossing.point.y);
    EXPECT_EQ(compareCrossing(l.a, l.b, l.c, l.d, Axis::Y, crossing.point.y),
              difference > 0 ? 1 : (difference < 0 ? -1 : 0));
    return true;
}

class CrossingTest: public testing::Test
{
protected:
    double uniform(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    int integer(int low, int high)
    {
        return std::uniform_int_distribution<int>(low, high)(random_);
    }
    std::mt19937_64 random_ {20};
};

TEST_F(CrossingTest, isRoundedCorrectlyOnRandomLines)
{
    for (int i = 0; i < 4000; ++i) {
        const auto p = [&] { return Vec2 {uniform(-1, 1), uniform(-1, 1)}; };
        EXPECT_TRUE(check({p(), p(), p(), p()}));
    }
}

TEST_F(CrossingTest, isRoundedCorrectlyOnGrids)
{
    int crossing = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto p = [&] { return Vec2 {1.0 * integer(-4, 4), 1.0 * integer(-4, 4)}; };
        crossing += check({p(), p(), p(), p()}) ? 1 : 0;
    }
    EXPECT_GT(crossing, 2000);
}

TEST_F(CrossingTest, isRoundedCorrectlyOnLargeIntegers)
{
    for (int i = 0; i < 2000; ++i) {
        const auto p = [&] {
            return Vec2 {std::round(uniform(-0x1p52, 0x1p52)), std::round(uniform(-9, 9))};
        };
        check({p(), p(), p(), p()});
    }
}

TEST_F(CrossingTest, isRoundedCorrectlyOnNearParallelLines)
{
    int crossing = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec2 a {uniform(0, 1), uniform(0, 1)};
        const Vec2 b {uniform(1, 2), uniform(0, 1)};
        const auto nudged = [&](Vec2 p) {
            return Vec2 {p.x + integer(-3, 3) * 0x1p-52, p.y + integer(-3, 3) * 0x1p-52};
        };
        crossing += check({a, b, nudged(a), nudged(b)}) ? 1 : 0;
    }
    EXPECT_GT(crossing, 3000);
}

TEST_F(CrossingTest, isRoundedCorrectlyThroughTheOriginAndMidpoints)
{
    for (int i = 0; i < 2000; ++i) {
        const Vec2 a {uniform(-1, 1), uniform(-1, 1)};
        const Vec2 c {uniform(-1, 1), uniform(-1, 1)};
        EXPECT_TRUE(check({a, {-a.x, -a.y}, c, {-c.x, -c.y}}));
        EXPECT_EQ(crossLines(a, {-a.x, -a.y}, c, {-c.x, -c.y}).point, (Vec2 {0, 0}));
        // x is exactly halfway between two doubles.
        const double x = uniform(1, 2);
        const double next = std::nextafter(x, 3);
        EXPECT_TRUE(check({{x, 1}, {next, -1}, {0, 0}, {3, 0}}));
    }
}

TEST_F(CrossingTest, isRoundedCorrectlyAtAllScales)
{
    for (int i = 0; i < 2000; ++i) {
        const double scale = std::ldexp(1.0, integer(-480, 480));
        const auto p = [&] { return Vec2 {scale * uniform(-1, 1), scale * uniform(-1, 1)}; };
        EXPECT_TRUE(check({p(), p(), p(), p()}));
    }
    for (int i = 0; i < 500; ++i) {
        const auto coordinate = [&] { return uniform(-1, 1) * std::pow(10.0, integer(-29, 29)); };
        const auto p = [&] { return Vec2 {coordinate(), coordinate()}; };
        EXPECT_TRUE(check({p(), p(), p(), p()}));
    }
}

/// A third line through or beside the crossing, at all scales.
TEST_F(CrossingTest, tellsWhetherAThirdLinePasses)
{
    int passing = 0;
    int beside = 0;
    for (int i = 0; i < 6000; ++i) {
        const double scale = std::ldexp(i % 3 == 0 ? 1.0 / 3.0 : 1.0, integer(-480, 480));
        const auto p = [&] {
            return Vec2 {1.0 * integer(-2, 2), 1.0 * integer(-2, 2)};
        };
        const Lines l {scale * p(), scale * p(), scale * p(), scale * p()};
        const Vec2 e = scale * p();
        Vec2 f = scale * p();
        if (i % 4 == 0 && f.x != 0.0) {
            f.x = std::nextafter(f.x, 1e300);
        }
        TrueCrossing truth;
        if (e == f || !crossExactly(l, truth)) {
            continue;
        }
        const Rational side = (Rational(f.x) - Rational(e.x)) * (truth.y - Rational(e.y))
            - (Rational(f.y) - Rational(e.y)) * (truth.x - Rational(e.x));
        EXPECT_EQ(passesCrossing(l.a, l.b, l.c, l.d, e, f), side == 0);
        (side == 0 ? passing : beside) += 1;
    }
    EXPECT_GT(passing, 300);
    EXPECT_GT(beside, 500);
}

} // namespace
} // namespace tessera
