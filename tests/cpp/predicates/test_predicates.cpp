// SPDX-License-Identifier: MIT
// Exact signs against exact rationals (boost::multiprecision, tests only).
#include "predicates/predicates.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace tessera
{
namespace
{

using Rational = boost::multiprecision::cpp_rational;

int orientOracle(Vec2 a, Vec2 b, Vec2 c)
{
    const Rational ax = Rational(a.x) - Rational(c.x), ay = Rational(a.y) - Rational(c.y);
    const Rational bx = Rational(b.x) - Rational(c.x), by = Rational(b.y) - Rational(c.y);
    return Rational(ax * by - ay * bx).sign();
}

int incircleOracle(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    const Rational ax = Rational(a.x) - Rational(d.x), ay = Rational(a.y) - Rational(d.y);
    const Rational bx = Rational(b.x) - Rational(d.x), by = Rational(b.y) - Rational(d.y);
    const Rational cx = Rational(c.x) - Rational(d.x), cy = Rational(c.y) - Rational(d.y);
    const Rational determinant = (ax * ax + ay * ay) * (bx * cy - cx * by)
        + (bx * bx + by * by) * (cx * ay - ax * cy) + (cx * cx + cy * cy) * (ax * by - bx * ay);
    return determinant.sign();
}

TEST(Predicates, SmallExamples)
{
    EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
    EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
    EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
    EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), 1);
    EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {1, 1}), 0);
    EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {1, 1.0000001}), -1);
}

TEST(Predicates, RandomAndNearDegenerateAgainstRationals)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 5000; ++i) {
        const double scale = std::ldexp(1.0, static_cast<int>(random() % 600) - 300);
        const auto p = [&] { return Vec2 {scale * unit(random), scale * unit(random)}; };
        const Vec2 a = p(), b = p();
        const double t = unit(random);
        Vec2 c = a + t * (b - a);
        EXPECT_EQ(orient2d(a, b, c), orientOracle(a, b, c));
        EXPECT_EQ(orient2d(c, b, a), orientOracle(c, b, a));
        const double s1 = 3.14159 * unit(random), s2 = 3.14159 * unit(random),
                     s3 = 3.14159 * unit(random), s4 = 3.14159 * unit(random);
        const auto on = [&](double s) { return a + scale * Vec2 {std::cos(s), std::sin(s)}; };
        EXPECT_EQ(incircle(on(s1), on(s2), on(s3), on(s4)),
                  incircleOracle(on(s1), on(s2), on(s3), on(s4)));
    }
}

TEST(Predicates, AnyFiniteDoubles)
{
    std::mt19937_64 random(2);
    const auto value = [&] {
        for (;;) {
            const std::uint64_t bits = random();
            double d = 0.0;
            std::memcpy(&d, &bits, sizeof d);
            if (std::isfinite(d)) {
                return random() % 8 == 0 ? 0.0 : d;
            }
        }
    };
    for (int i = 0; i < 500; ++i) {
        const Vec2 a {value(), value()}, b {value(), value()}, c {value(), value()};
        const Vec2 d {random() % 2 ? value() : a.x, value()};
        EXPECT_EQ(orient2d(a, b, c), orientOracle(a, b, c));
        EXPECT_EQ(incircle(a, b, c, d), incircleOracle(a, b, c, d));
    }
}

} // namespace
} // namespace tessera
