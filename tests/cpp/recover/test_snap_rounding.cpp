// SPDX-License-Identifier: MIT
#include "generators.h"

#include "predicates/crossing.h"
#include "predicates/predicates.h"
#include "recover/pixel_grid.h"
#include "recover/snap_rounding.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace tessera::test
{
namespace
{

using Rational = boost::multiprecision::cpp_rational;

/// The part of 0 <= t <= 1 where low <= a + t (b - a) < high.
struct Interval
{
    Rational low = 0;
    Rational high = 1;
    bool lowOpen = false;
    bool highOpen = false;

    void cutLow(const Rational& t, bool open)
    {
        if (t > low || (t == low && open)) {
            low = t;
            lowOpen = open;
        }
    }
    void cutHigh(const Rational& t, bool open)
    {
        if (t < high || (t == high && open)) {
            high = t;
            highOpen = open;
        }
    }
    void clip(double a, double b, double from, double to)
    {
        if (a == b) {
            if (!(from <= a && a < to)) {
                high = -1;
            }
            return;
        }
        const Rational d = Rational(b) - Rational(a);
        const Rational tFrom = (Rational(from) - Rational(a)) / d;
        const Rational tTo = (Rational(to) - Rational(a)) / d;
        if (d > 0) {
            cutLow(tFrom, false);
            cutHigh(tTo, true);
        }
        else {
            cutLow(tTo, true);
            cutHigh(tFrom, false);
        }
    }
    bool empty() const { return low > high || (low == high && (lowOpen || highOpen)); }
};

bool meetsByClipping(Vec2 a, Vec2 b, Vec2 center, double side)
{
    Interval t;
    t.clip(a.x, b.x, center.x - 0.5 * side, center.x + 0.5 * side);
    t.clip(a.y, b.y, center.y - 0.5 * side, center.y + 0.5 * side);
    return !t.empty();
}

TEST(PixelGrid, pixelFollowsSizeAndPlace)
{
    EXPECT_EQ(PixelGrid({{0, 0}, {1, 1}}).side(), 0x1p-43);
    EXPECT_EQ(PixelGrid({{0, 0}, {0x1p20, 1}}).side(), 0x1p-23);
    EXPECT_EQ(PixelGrid({{0x1p34, 0}, {0x1p34 + 1, 1}}).side(), 0x1p-16);
}

TEST(PixelGrid, centerIsHalfOpen)
{
    const PixelGrid grid({{0, 0}, {1, 1}});
    const double h = 0.5 * grid.side();
    EXPECT_EQ(grid.centerOf({-h, h}), (Vec2 {0.0, 2 * h}));
    EXPECT_EQ(grid.centerOf({std::nextafter(h, 0), -0x1p-200}), (Vec2 {0.0, 0.0}));
    EXPECT_EQ(grid.centerOf({std::nextafter(-h, -1), 3 * h}), (Vec2 {-2 * h, 4 * h}));
}

TEST(PixelGrid, meetsIsExactAndHalfOpen)
{
    const PixelGrid grid({{0, 0}, {0x1p43, 0}});
    ASSERT_EQ(grid.side(), 1.0);
    Random random(3);
    int met = 0;
    for (int i = 0; i < 30000; ++i) {
        const auto p = [&] {
            const double x = 0.5 * random.integer(-5, 5);
            return Vec2 {x, 0.5 * random.integer(-5, 5)};
        };
        const Vec2 a = p();
        const Vec2 b = p();
        if (a == b) {
            continue;
        }
        const bool expected = meetsByClipping(a, b, {0, 0}, 1.0);
        EXPECT_EQ(grid.meets(a, b, {0, 0}), expected)
            << a.x << " " << a.y << " " << b.x << " " << b.y;
        met += expected ? 1 : 0;
    }
    EXPECT_GT(met, 5000);
}

TEST(PixelGrid, crossingOnABorderBelongsToTheUpperPixel)
{
    const PixelGrid grid({{0, 0}, {0x1p43, 0}});
    const auto center = [&](Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
        return grid.centerOfCrossing(a, b, c, d, crossLines(a, b, c, d).point);
    };
    EXPECT_EQ(center({0, 0}, {1, 1}, {0, 1}, {1, 0}), (Vec2 {1, 1}));
    // The true crossing lies below 1/2 by less than rounding shows: at x = y = 1 / (2 + 2^-60).
    EXPECT_EQ(center({0, 0}, {1, 1}, {0, 1}, {0x1p60, 1 - 0x1p60 - 0x1p8}), (Vec2 {0, 0}));
}

/// The same by definition: all pairs, all pixels.
class BruteForce
{
public:
    BruteForce(const std::vector<Vec2>& points, const std::vector<Segment>& segments)
        : points_(points)
        , segments_(segments)
        , grid_(boxOf(points))
    {
        for (std::size_t i = 1; i < points.size(); ++i) {
            heat(grid_.centerOf(points[i]));
        }
        for (std::size_t i = 0; i < segments.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                heatCrossing(segments[i], segments[j]);
            }
        }
    }
    const std::set<std::pair<double, double>>& hot() const { return hot_; }
    std::vector<Vec2> chain(const Segment& s) const
    {
        const Vec2 a = points_[s.a];
        const Vec2 b = points_[s.b];
        std::vector<Vec2> result;
        for (const auto& [x, y] : hot_) {
            if (meetsByClipping(a, b, {x, y}, grid_.side())) {
                result.push_back({x, y});
            }
        }
        std::sort(result.begin(), result.end(), [&](Vec2 p, Vec2 q) {
            return PixelGrid::compareAlong(a, b, p, q) < 0;
        });
        return result;
    }

private:
    static Box2 boxOf(const std::vector<Vec2>& points)
    {
        Box2 box;
        for (std::size_t i = 1; i < points.size(); ++i) {
            box.add(points[i]);
        }
        return box;
    }
    void heat(Vec2 center) { hot_.insert({center.x, center.y}); }
    void heatCrossing(const Segment& s, const Segment& t)
    {
        const Vec2 a = points_[s.a];
        const Vec2 b = points_[s.b];
        const Vec2 c = points_[t.a];
        const Vec2 d = points_[t.b];
        if (orient2d(a, b, c) * orient2d(a, b, d) < 0
            && orient2d(c, d, a) * orient2d(c, d, b) < 0) {
            heat(grid_.centerOfCrossing(a, b, c, d, crossLines(a, b, c, d).point));
        }
    }

    const std::vector<Vec2>& points_;
    const std::vector<Segment>& segments_;
    PixelGrid grid_;
    std::set<std::pair<double, double>> hot_;
};

void compareWithBruteForce(const RawPslg& raw)
{
    std::vector<Vec2> points {{}};
    points.insert(points.end(), raw.points.begin(), raw.points.end());
    std::vector<Segment> segments;
    for (const auto& [a, b] : raw.segments) {
        if (raw.points[a] != raw.points[b]) {
            segments.push_back({a + 1, b + 1});
        }
    }
    const BruteForce expected(points, segments);
    Execution execution;
    const SnapResult result = snapRound(points, segments, execution);
    std::set<std::pair<double, double>> hot;
    for (const Vec2 p : result.points) {
        EXPECT_TRUE(hot.insert({p.x, p.y}).second);
    }
    EXPECT_EQ(hot, expected.hot());
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
        std::vector<Vec2> chain;
        result.chains.forEachVertex(s, [&](std::uint32_t v) { chain.push_back(result.points[v]); });
        EXPECT_EQ(chain, expected.chain(segments[s]));
    }
}

TEST(SnapRounding, routesThroughAllHotPixels)
{
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE(seed);
        compareWithBruteForce(longSegments(12, seed));
        compareWithBruteForce(pencil(12, 1e-14, seed));
        compareWithBruteForce(bundles(3, seed));
        compareWithBruteForce(shifted(longSegments(12, seed), 0x1p48, -0x1p48));
        compareWithBruteForce(shifted(scaled(lattice(12, 6, seed), 0.3), 0x1p49, 0x1p49));
        compareWithBruteForce(shifted(longSegments(30, seed), 0x1p49, 0x1p49));
    }
}

TEST(SnapRounding, coarsePixelsMergeEverything)
{
    const RawPslg raw = shifted(scaled(longSegments(5, 1), 1e-3), 1e15, 1e15);
    std::vector<Vec2> points {{}};
    points.insert(points.end(), raw.points.begin(), raw.points.end());
    points.push_back(points[1] + Vec2 {0.25, 0.0});
    const std::vector<Segment> segments {{1, 2}, {3, 4}, {1, 11}};
    Execution execution;
    const SnapResult result = snapRound(points, segments, execution);
    EXPECT_LE(result.points.size(), 2U);
    EXPECT_LE(result.maxDisplacement, result.pixel);
}

} // namespace
} // namespace tessera::test
