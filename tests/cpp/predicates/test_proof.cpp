// SPDX-License-Identifier: MIT

// A million cases per predicate against exact integers. Doubles are scaled to integers by a power
// of two, which changes no sign; boost's cpp_int (tests only) does the rest. Fixed-width integers
// keep it quick: the generators say how many bits they need.

#include "predicates/predicates.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace tessera
{
namespace
{

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    1024, 1024, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

constexpr int kCases = 1000000;

/// value * 2^power, which must be an integer.
Integer toInteger(double value, int power)
{
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    const int shift = exponent - 53 + power;
    Integer result = mantissa;
    if (shift >= 0) {
        result <<= shift;
    }
    else {
        const Integer divisor = Integer(1) << -shift;
        EXPECT_EQ(result % divisor, 0);
        result /= divisor;
    }
    return result;
}

struct Exact
{
    Integer x;
    Integer y;
};

Exact difference(Vec2 a, Vec2 b, int power)
{
    return {toInteger(a.x, power) - toInteger(b.x, power),
            toInteger(a.y, power) - toInteger(b.y, power)};
}

Integer cross(const Exact& a, const Exact& b)
{
    return a.x * b.y - a.y * b.x;
}
Integer dot(const Exact& a, const Exact& b)
{
    return a.x * b.x + a.y * b.y;
}

/// Points of one kind; `power` makes their coordinates integers of at most 230 bits.
struct Generator
{
    std::string name;
    int power;
    std::function<std::array<Vec2, 4>(std::mt19937_64&)> make;
};

double unit(std::mt19937_64& random)
{
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random()) >> 11), -52);
}

Vec2 inSquare(std::mt19937_64& random)
{
    return {unit(random), unit(random)};
}

double nudge(std::mt19937_64& random, double value)
{
    const auto steps = static_cast<int>(random() % 5) - 2;
    for (int i = 0; i < std::abs(steps); ++i) {
        value = std::nextafter(value, steps > 0 ? 8.0 : -8.0);
    }
    return value;
}

std::array<Vec2, 4> nearLine(std::mt19937_64& random)
{
    const Vec2 a = inSquare(random);
    const Vec2 d = inSquare(random);
    std::array<Vec2, 4> p {a, a, a, a};
    for (Vec2& q : p) {
        const double t = unit(random);
        q = {nudge(random, a.x + t * d.x), nudge(random, a.y + t * d.y)};
    }
    return p;
}

std::array<Vec2, 4> nearCircle(std::mt19937_64& random)
{
    const Vec2 center = inSquare(random);
    const double radius = std::ldexp(1.0, -static_cast<int>(random() % 20));
    std::array<Vec2, 4> p {};
    for (Vec2& q : p) {
        const double angle = 4.0 * unit(random);
        q = {nudge(random, center.x + radius * std::cos(angle)),
             nudge(random, center.y + radius * std::sin(angle))};
    }
    return p;
}

/// Corners of rounded rectangles of a decimal grid: exact ties among almost ties.
std::array<Vec2, 4> decimalGrid(std::mt19937_64& random)
{
    const auto step = [&] { return 0.1 * static_cast<double>(random() % 20); };
    const double x0 = step();
    const double x1 = step();
    const double y0 = step();
    const double y1 = step();
    std::array<Vec2, 4> p {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
    std::shuffle(p.begin(), p.end(), random);
    if (random() % 4 == 0) {
        p[random() % 4].x = step();
    }
    return p;
}

std::array<Vec2, 4> smallIntegers(std::mt19937_64& random)
{
    std::array<Vec2, 4> p {};
    for (Vec2& q : p) {
        q = {static_cast<double>(random() % 9), static_cast<double>(random() % 9)};
    }
    return p;
}

/// Lattice points of one circle, far from the origin: x^2 + y^2 = 5^2 13^2 17^2.
std::array<Vec2, 4> latticeCircle(std::mt19937_64& random)
{
    static const std::vector<Vec2> circle = [] {
        std::vector<Vec2> points;
        for (int x = -1105; x <= 1105; ++x) {
            const int y = static_cast<int>(std::lround(std::sqrt(1105.0 * 1105.0 - x * x)));
            if (x * x + y * y == 1105 * 1105) {
                points.push_back({static_cast<double>(x), static_cast<double>(y)});
                points.push_back({static_cast<double>(x), static_cast<double>(-y)});
            }
        }
        return points;
    }();
    const double shift = std::ldexp(static_cast<double>(random() % 1024), 30);
    const double unitStep = random() % 2 == 0 ? 1.0 : 0x1p-10;
    std::array<Vec2, 4> p {};
    for (Vec2& q : p) {
        const Vec2 on = circle[random() % circle.size()];
        q = {shift + unitStep * on.x, unitStep * on.y - shift};
    }
    if (random() % 3 == 0) {
        p[random() % 4].y += unitStep;
    }
    return p;
}

/// Magnitudes over 2^-90 .. 1.
std::array<Vec2, 4> manyScales(std::mt19937_64& random)
{
    const auto value = [&] {
        return random() % 8 == 0 ? 0.0
                                 : std::ldexp(unit(random), -static_cast<int>(random() % 90));
    };
    std::array<Vec2, 4> p {};
    for (Vec2& q : p) {
        q = {value(), value()};
    }
    if (random() % 4 == 0) {
        p[2] = {p[0].x + p[1].x, p[0].y + p[1].y};
    }
    return p;
}

/// With coordinates that are multiples of 2^-power.
std::vector<Generator> generators()
{
    return {{"random", 60, [](std::mt19937_64& random) {
                 return std::array<Vec2, 4> {inSquare(random), inSquare(random), inSquare(random),
                                             inSquare(random)};
             }},
            {"near a line", 200, nearLine},
            {"near a circle", 200, nearCircle},
            {"decimal grid", 60, decimalGrid},
            {"small integers", 0, smallIntegers},
            {"lattice points of a circle", 10, latticeCircle},
            {"many scales", 200, manyScales}};
}

/// Every third case is scaled by a power of two up to 2^300, which must not change the sign.
void forEachCase(const std::function<void(const Generator&, const std::array<Vec2, 4>&, double)>& f)
{
    std::mt19937_64 random(2024);
    const std::vector<Generator> all = generators();
    const int each = kCases / static_cast<int>(all.size()) + 1;
    for (const Generator& generator : all) {
        SCOPED_TRACE(generator.name);
        for (int i = 0; i < each && !testing::Test::HasFailure(); ++i) {
            const double scale
                = i % 3 == 0 ? std::ldexp(1.0, static_cast<int>(random() % 601) - 300) : 1.0;
            f(generator, generator.make(random), scale);
        }
    }
}

TEST(PredicatesProof, Orient2d)
{
    std::array<int, 3> seen {};
    forEachCase([&](const Generator& g, const std::array<Vec2, 4>& p, double scale) {
        const int expected
            = cross(difference(p[0], p[2], g.power), difference(p[1], p[2], g.power)).sign();
        ++seen[static_cast<std::size_t>(expected + 1)];
        EXPECT_EQ(orient2d(scale * p[0], scale * p[1], scale * p[2]), expected);
        EXPECT_EQ(orient2d(scale * p[2], scale * p[1], scale * p[0]), -expected);
    });
    EXPECT_GT(*std::min_element(seen.begin(), seen.end()), kCases / 100);
}

TEST(PredicatesProof, Incircle)
{
    std::array<int, 3> seen {};
    forEachCase([&](const Generator& g, const std::array<Vec2, 4>& p, double scale) {
        const Exact a = difference(p[0], p[3], g.power);
        const Exact b = difference(p[1], p[3], g.power);
        const Exact c = difference(p[2], p[3], g.power);
        const int expected = Integer(dot(a, a) * cross(b, c) + dot(b, b) * cross(c, a)
                                     + dot(c, c) * cross(a, b))
                                 .sign();
        ++seen[static_cast<std::size_t>(expected + 1)];
        EXPECT_EQ(incircle(scale * p[0], scale * p[1], scale * p[2], scale * p[3]), expected);
        EXPECT_EQ(incircle(scale * p[3], scale * p[1], scale * p[2], scale * p[0]), -expected);
    });
    EXPECT_GT(*std::min_element(seen.begin(), seen.end()), kCases / 100);
}

TEST(PredicatesProof, CompareAlong)
{
    std::array<int, 3> seen {};
    forEachCase([&](const Generator& g, const std::array<Vec2, 4>& p, double scale) {
        const int expected
            = dot(difference(p[2], p[3], g.power), difference(p[1], p[0], g.power)).sign();
        ++seen[static_cast<std::size_t>(expected + 1)];
        EXPECT_EQ(compareAlong(scale * p[0], scale * p[1], scale * p[2], scale * p[3]), expected);
        EXPECT_EQ(compareAlong(scale * p[1], scale * p[0], scale * p[2], scale * p[3]), -expected);
    });
    EXPECT_GT(*std::min_element(seen.begin(), seen.end()), kCases / 100);
}

TEST(PredicatesProof, OrderOnALineAgreesWithProjection)
{
    std::mt19937_64 random(5);
    for (int i = 0; i < 100000; ++i) {
        const auto coordinate = [&] { return static_cast<double>(random() % 7) - 3.0; };
        const Vec2 origin {coordinate(), coordinate()};
        const Vec2 step {coordinate(), coordinate()};
        if (step == Vec2 {0.0, 0.0}) {
            continue;
        }
        const auto on = [&] { return origin + coordinate() * step; };
        const Vec2 a = on();
        const Vec2 b = on();
        const Vec2 p = on();
        const Vec2 q = on();
        if (a == b) {
            EXPECT_FALSE(strictlyBetween(a, b, p));
            EXPECT_EQ(onSegment(a, b, p), p == a);
            continue;
        }
        EXPECT_EQ(compareOnLine(a, b, p, q), compareAlong(a, b, p, q));
        const bool between = compareAlong(a, b, p, a) > 0 && compareAlong(a, b, b, p) > 0;
        EXPECT_EQ(strictlyBetween(a, b, p), between);
        EXPECT_EQ(onSegment(a, b, p), between || p == a || p == b);
    }
}

} // namespace
} // namespace tessera
