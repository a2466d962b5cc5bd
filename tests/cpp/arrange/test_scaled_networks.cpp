// SPDX-License-Identifier: MIT
// Networks scaled by powers of two, mirrored, turned by right angles and reordered have the same
// arrangement; scaling even to the last bit.
#include "arrange/arrange.h"
#include "curve/arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tessera
{
namespace
{

/// x' = a x + b y, y' = c x + d y.
struct Matrix
{
    double a;
    double b;
    double c;
    double d;

    Vec2 operator()(Vec2 p) const { return {a * p.x + b * p.y, c * p.x + d * p.y}; }
};

/// Lines, circle arcs and ellipse arcs at random; the same for every matrix.
CurveNetwork network(unsigned seed, const Matrix& m, bool reversedOrder)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(0.0, 1.0);
    struct Given
    {
        std::shared_ptr<const Curve> geometry;
        Vec2 start;
        Vec2 end;
    };
    std::vector<Given> given;
    for (int i = 0; i < 45; ++i) {
        const Vec2 p {u(random), u(random)};
        const Vec2 q {u(random), u(random)};
        const double first = 6.0 * u(random);
        const double last = first + 0.5 + 5.0 * u(random);
        const double major = 0.1 + 0.3 * u(random);
        const double minor = i % 3 == 1 ? major : 0.5 * major;
        const Vec2 axis {std::cos(first), std::sin(first)};
        if (i % 3 == 0) {
            given.push_back({nullptr, m(p), m(q)});
            continue;
        }
        const auto arc = std::make_shared<EllipseArc>(
            m(p), m(major * axis), m(minor * Vec2 {-axis.y, axis.x}), first, last);
        given.push_back({arc, arc->point(first), arc->point(last)});
    }
    CurveNetwork result;
    result.operands.resize(1);
    for (std::size_t i = 0; i < given.size(); ++i) {
        const Given& g = given[reversedOrder ? given.size() - 1 - i : i];
        const PointId start = result.addPoint(g.start);
        const PointId end = result.addPoint(g.end);
        result.curves.push_back({g.geometry, start, end, OperandId(0U), Role::Constraint});
    }
    return result;
}

CurveNetwork arranged(const CurveNetwork& given, double weld, ArrangeReport& report)
{
    Execution execution;
    return arrange(given, {.weld = weld, .crossStraight = true}, report, execution);
}

constexpr Matrix kIdentity {1, 0, 0, 1};

TEST(ScaledNetworks, PowersOfTwoChangeNothingButTheScale)
{
    for (unsigned seed = 0; seed < 10; ++seed) {
        for (const double weld : {0.0, 1e-7}) {
            ArrangeReport report;
            const CurveNetwork plain = arranged(network(seed, kIdentity, false), weld, report);
            EXPECT_GT(plain.points.size() - report.firstCrossing, 50U);
            for (const int exponent : {-60, -30, 30, 60}) {
                const double scale = std::ldexp(1.0, exponent);
                const Matrix scaling {scale, 0, 0, scale};
                ArrangeReport scaledReport;
                const CurveNetwork scaled =
                    arranged(network(seed, scaling, false), weld * scale, scaledReport);
                ASSERT_EQ(scaled.points.size(), plain.points.size());
                ASSERT_EQ(scaled.curves.size(), plain.curves.size());
                for (std::size_t i = 0; i < plain.points.size(); ++i) {
                    EXPECT_EQ(scaled.points[i], scale * plain.points[i]);
                }
            }
        }
    }
}

TEST(ScaledNetworks, MirroredTurnedAndReorderedHaveTheSameCrossings)
{
    for (unsigned seed = 0; seed < 10; ++seed) {
        ArrangeReport report;
        const CurveNetwork plain = arranged(network(seed, kIdentity, false), 0.0, report);
        const std::size_t crossings = report.crossed.crossings;
        for (const Matrix& m : {Matrix {-1, 0, 0, 1}, Matrix {0, -1, 1, 0}, kIdentity}) {
            for (const bool reversedOrder : {false, true}) {
                const CurveNetwork other =
                    arranged(network(seed, m, reversedOrder), 0.0, report);
                EXPECT_EQ(other.points.size(), plain.points.size());
                EXPECT_EQ(other.curves.size(), plain.curves.size());
                EXPECT_EQ(report.crossed.crossings, crossings);
            }
        }
    }
}

} // namespace
} // namespace tessera
