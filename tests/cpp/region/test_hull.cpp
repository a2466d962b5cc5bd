// SPDX-License-Identifier: MIT

// The whole convex hull: what lies in it is decided exactly, by a brute-force hull of integers
// here, however flat or far from the origin; and only slivers that samples make are left out.

#include "curve/arc.h"
#include "region/colored.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace tessera
{
namespace
{

using Lattice = std::vector<std::pair<std::int64_t, std::int64_t>>;

std::int64_t turn(const std::pair<std::int64_t, std::int64_t>& a,
                  const std::pair<std::int64_t, std::int64_t>& b,
                  const std::pair<std::int64_t, std::int64_t>& c)
{
    return (b.first - a.first) * (c.second - a.second)
        - (b.second - a.second) * (c.first - a.first);
}

/// Twice the area and the points on the border, by its definition: a side has nothing on its right.
struct ExactHull
{
    std::int64_t twiceArea = 0;
    std::size_t onBorder = 0;
};

ExactHull hullOf(Lattice points)
{
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    ExactHull hull;
    for (const auto& a : points) {
        bool onBorder = false;
        for (const auto& b : points) {
            std::int64_t nearest = 0;
            std::int64_t farthest = 0;
            for (const auto& c : points) {
                nearest = std::min(nearest, turn(a, b, c));
                farthest = std::max(farthest, turn(a, b, c));
            }
            if (nearest < 0 || farthest == 0) {
                continue;
            }
            onBorder = true;
            const bool next = std::none_of(points.begin(), points.end(), [&](const auto& c) {
                return c != a && c != b && turn(a, b, c) == 0 && std::min(a, b) < c
                    && c < std::max(a, b);
            });
            // Around the first point, where coordinates are small.
            hull.twiceArea += next ? turn(points.front(), a, b) : 0;
        }
        hull.onBorder += onBorder ? 1 : 0;
    }
    return hull;
}

Lattice randomLattice(std::mt19937_64& random, std::size_t count, std::int64_t width,
                      std::int64_t height)
{
    Lattice points(count);
    for (auto& [x, y] : points) {
        x = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(width));
        y = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(height));
    }
    return points;
}

/// Every vertex has a triangle that is kept, and so has every subsegment.
void expectNothingLost(const Colored& colored)
{
    const Triangulation& t = colored.recovered.triangulation;
    std::vector<std::uint8_t> kept(t.points.size(), 0);
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (t.isFinite(i)
            && colored.map.regions[colored.map.regionOfTriangle[i].index()].inside) {
            for (const std::uint32_t v : t.triangles[i].v) {
                kept[v] = 1;
            }
        }
    }
    EXPECT_EQ(std::count(kept.begin() + 1, kept.end(), 0), 0);
    const auto& outside = colored.map.isOutside;
    EXPECT_EQ(std::count(outside.begin(), outside.end(), 1), 0);
}

std::size_t keptTriangles(const Colored& colored)
{
    const auto& regionOf = colored.map.regionOfTriangle;
    return static_cast<std::size_t>(
        std::count_if(regionOf.begin(), regionOf.end(), [&colored](RegionId region) {
            return region.valid() && colored.map.regions[region.index()].inside;
        }));
}

void expectHull(const Lattice& lattice, Vec2 scale, Vec2 shift)
{
    CurveNetwork network = emptyNetwork(1);
    for (const auto& [x, y] : lattice) {
        const Vec2 p {shift.x + scale.x * static_cast<double>(x),
                      shift.y + scale.y * static_cast<double>(y)};
        network.embedded.push_back({network.addPoint(p), OperandId(0U), ""});
    }
    const ExactHull hull = hullOf(lattice);
    const Colored colored = color(network, FillRule::Hull);
    const std::size_t count = colored.recovered.triangulation.vertexCount();
    EXPECT_EQ(keptTriangles(colored), hull.onBorder == 0 ? 0 : 2 * count - 2 - hull.onBorder);
    const double area = 0.5 * static_cast<double>(hull.twiceArea) * scale.x * scale.y;
    EXPECT_NEAR(colored.areaInside(), area, 1e-12 * area);
    if (hull.onBorder > 0) {
        expectNothingLost(colored);
    }
}

TEST(Hull, OfPointsIsExactFarFromTheOrigin)
{
    std::mt19937_64 random(1);
    for (const double shift : {0.0, 1e6, 0x1p30, 0x1p44, 0x1p49, 1e15}) {
        for (int i = 0; i < 60; ++i) {
            SCOPED_TRACE(shift);
            expectHull(randomLattice(random, 3 + random() % 20, 30, 30), {1, 1}, {shift, shift});
            expectHull(randomLattice(random, 3 + random() % 20, 300, 2), {1, 1}, {shift, 0});
        }
    }
}

TEST(Hull, OfPointsIsExactHoweverFlat)
{
    std::mt19937_64 random(2);
    for (int exponent = -20; exponent >= -190; exponent -= 5) {
        SCOPED_TRACE(exponent);
        expectHull(randomLattice(random, 3 + random() % 20, 50, 9), {1, std::ldexp(1, exponent)},
                   {0, 0});
    }
}

CurveNetwork randomLines(std::mt19937_64& random, double shift)
{
    CurveNetwork network = emptyNetwork(1);
    const std::size_t count = 3 + random() % 8;
    for (const auto& [x, y] : randomLattice(random, 2 * count, 30, 30)) {
        network.addPoint({shift + static_cast<double>(x), shift + static_cast<double>(y)});
    }
    for (std::size_t i = 0; i < count; ++i) {
        network.curves.push_back({nullptr, PointId(2 * i), PointId(2 * i + 1), OperandId(0U),
                                  Role::Constraint});
    }
    return network;
}

TEST(Hull, OfLinesIsExactAndKeepsThem)
{
    std::mt19937_64 random(3);
    for (const double shift : {0.0, 1e6, 0x1p30, 0x1p44, 0x1p49, 1e15}) {
        for (int i = 0; i < 60; ++i) {
            SCOPED_TRACE(shift);
            const CurveNetwork network = randomLines(random, shift);
            Lattice ends;
            for (const Vec2 p : network.points) {
                ends.emplace_back(static_cast<std::int64_t>(p.x - shift),
                                  static_cast<std::int64_t>(p.y - shift));
            }
            const Colored colored = color(network, FillRule::Hull);
            const double area = 0.5 * static_cast<double>(hullOf(ends).twiceArea);
            EXPECT_NEAR(colored.areaInside(), area, 1e-9 * area);
            expectNothingLost(colored);
        }
    }
}

TEST(Hull, SamplesBesideTheirCurvesLoseNothing)
{
    std::mt19937_64 random(4);
    for (const double shift : {0.0, 1e6, 0x1p30, 0x1p44, 0x1p49, 1e15}) {
        for (int i = 0; i < 60; ++i) {
            SCOPED_TRACE(shift);
            expectNothingLost(color(randomLines(random, shift), FillRule::Hull, 1.7, true));
        }
    }
}

/// The least height over the longest side of a kept triangle.
double leastHeight(const Colored& colored)
{
    const Triangulation& t = colored.recovered.triangulation;
    double least = 1e300;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (!t.isFinite(i)
            || !colored.map.regions[colored.map.regionOfTriangle[i].index()].inside) {
            continue;
        }
        const auto& v = t.triangles[i].v;
        const Vec2 p[3] = {t.points[v[0]], t.points[v[1]], t.points[v[2]]};
        const double longest = std::max({distance(p[0], p[1]), distance(p[1], p[2]),
                                         distance(p[2], p[0])});
        least = std::min(least, cross(p[1] - p[0], p[2] - p[0]) / longest);
    }
    return least;
}

TEST(Hull, SliversBetweenSamplesAndTheHullAreOutside)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> angle(0.0, 2.0 * std::numbers::pi);
    std::size_t slivers = 0;
    for (int i = 0; i < 50; ++i) {
        SCOPED_TRACE(i);
        // A turned square, one side of which has a given point in its middle.
        const double a = angle(random);
        const Vec2 u {std::cos(a), std::sin(a)};
        const Vec2 v {-u.y, u.x};
        CurveNetwork network = emptyNetwork(1);
        addRing(network, {-1.0 * u - v, u - v, u + v, 0.1 * u + v, v - u}, 0, Role::Constraint);
        const Colored colored = color(network, FillRule::Hull, 0.15, true);
        expectNothingLost(colored);
        EXPECT_NEAR(colored.areaInside(), 4.0, 1e-13);
        EXPECT_EQ(colored.map.keptRegions, 1U);
        EXPECT_GT(leastHeight(colored), 0.01);
        const Triangulation& t = colored.recovered.triangulation;
        std::size_t finite = 0;
        for (std::uint32_t k = 0; k < t.triangles.size(); ++k) {
            finite += t.isFinite(k) ? 1 : 0;
        }
        slivers += finite - keptTriangles(colored);
    }
    EXPECT_GT(slivers, 100U); // there is something to leave out
}

TEST(Hull, PlacesWhereCurvesTouchAreOnTheirLines)
{
    for (int i = 1; i < 40; ++i) {
        SCOPED_TRACE(i);
        // A circle that touches a slanted side from inside.
        const double a = 0.03 * i;
        const Vec2 u {std::cos(a), std::sin(a)};
        const Vec2 v {-u.y, u.x};
        CurveNetwork network = emptyNetwork(1);
        addRing(network, {{0, 0}, 3.0 * u, 3.0 * u + 3.0 * v, 3.0 * v}, 0, Role::Constraint);
        const Vec2 center = 1.3 * u + v;
        auto circle = std::make_shared<EllipseArc>(center, Vec2 {1, 0}, Vec2 {0, 1}, 0.0,
                                                   2.0 * std::numbers::pi);
        const PointId start = network.addPoint(circle->point(0.0));
        network.curves.push_back({circle, start, start, OperandId(0U), Role::Constraint});
        const Colored colored = color(network, FillRule::Hull);
        expectNothingLost(colored);
        EXPECT_GT(leastHeight(colored), 1e-4);
    }
}

TEST(Hull, OfOneLineIsEmpty)
{
    CurveNetwork network = emptyNetwork(1);
    const Ring line {{0, 0}, {1, 0.3}};
    addPolyline(network, line, false, OperandId(0U), Role::Constraint);
    const Colored colored = color(network, FillRule::Hull, 0.01, true);
    EXPECT_EQ(colored.map.keptRegions, 0U);
    // Rounding alone has made the triangles there are.
    EXPECT_GT(colored.recovered.triangulation.triangles.size(), 50U);
}

} // namespace
} // namespace tessera
