// SPDX-License-Identifier: MIT
#pragma once

// Families of raw PSLGs, from harmless to ill-conditioned. Deterministic in their seed.

#include "raw_pslg.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

namespace tessera::test
{

class Random
{
public:
    explicit Random(std::uint64_t seed)
        : engine_(seed)
    {}
    double uniform(double low = 0.0, double high = 1.0)
    {
        // Not std::uniform_real_distribution: its result depends on the library.
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    int integer(int low, int high)
    {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    Vec2 point(double low = 0.0, double high = 1.0)
    {
        const double x = uniform(low, high);
        return {x, uniform(low, high)};
    }

private:
    std::mt19937_64 engine_;
};

/// Both ends uniform in the unit square.
inline RawPslg longSegments(std::size_t n, std::uint64_t seed)
{
    Random random(seed);
    RawPslg raw;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = random.point();
        raw.addSegment(a, random.point());
    }
    return raw;
}

/// Length sqrt(pi n) / n at random angles: about n crossings.
inline RawPslg shortSegments(std::size_t n, std::uint64_t seed)
{
    Random random(seed);
    RawPslg raw;
    const double count = static_cast<double>(n);
    const double length = std::sqrt(std::numbers::pi * count) / count;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = random.point();
        const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        raw.addSegment(a, a + length * Vec2 {std::cos(angle), std::sin(angle)});
    }
    return raw;
}

/// End points on a side x side integer grid; a quarter each horizontal, vertical, diagonal, free.
inline RawPslg lattice(std::size_t n, int side, std::uint64_t seed)
{
    Random random(seed);
    RawPslg raw;
    while (raw.segments.size() < n) {
        const int x = random.integer(0, side - 1);
        const int y = random.integer(0, side - 1);
        int u = random.integer(0, side - 1);
        int v = random.integer(0, side - 1);
        switch (raw.segments.size() % 4) {
        case 0:
            v = y;
            break;
        case 1:
            u = x;
            break;
        case 2:
            v = y + (u - x);
            break;
        default:
            break;
        }
        if (v >= 0 && v < side && (u != x || v != y)) {
            raw.addSegment({1.0 * x, 1.0 * y}, {1.0 * u, 1.0 * v});
        }
    }
    return raw;
}

/// n near-parallel segments from x = 0 to x = 1 whose ends differ by at most `width`.
inline RawPslg sheaf(std::size_t n, double width, std::uint64_t seed)
{
    Random random(seed);
    RawPslg raw;
    for (std::size_t i = 0; i < n; ++i) {
        const double a = random.uniform(0.0, width);
        raw.addSegment({0.0, a}, {1.0, random.uniform(0.0, width)});
    }
    return raw;
}

/// n segments of length 1 in all directions, through points within `width` of the center.
inline RawPslg pencil(std::size_t n, double width, std::uint64_t seed)
{
    Random random(seed);
    RawPslg raw;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = random.uniform(0.0, std::numbers::pi);
        const Vec2 half {0.5 * std::cos(angle), 0.5 * std::sin(angle)};
        const Vec2 middle = Vec2 {0.5, 0.5} + random.point(-width, width);
        raw.addSegment(middle - half, middle + half);
    }
    return raw;
}

/// Bundles of four lines within a few units in the last place, crossing each other.
inline RawPslg bundles(std::size_t n, std::uint64_t seed)
{
    Random random(seed);
    RawPslg raw;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = random.point();
        const Vec2 b = random.point();
        for (int k = 0; k < 4; ++k) {
            const auto nudge = [&](double v) { return v + random.integer(-3, 3) * 0x1p-53; };
            const Vec2 start {nudge(a.x), nudge(a.y)};
            raw.addSegment(start, {nudge(b.x), nudge(b.y)});
        }
    }
    return raw;
}

/// Closed star polygon {n / k}, as drawn with n straight strokes.
inline RawPslg starPolygon(std::size_t n, std::size_t k)
{
    RawPslg raw;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle
            = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        raw.addPoint({std::cos(angle), std::sin(angle)});
    }
    for (std::size_t i = 0; i < n; ++i) {
        raw.segments.emplace_back(i, (i + k) % n);
    }
    return raw;
}

/// Rays from one point, and rings through them.
inline RawPslg spiderWeb(std::size_t rays, std::size_t rings, std::uint64_t seed)
{
    Random random(seed);
    RawPslg raw;
    const std::uint32_t center = raw.addPoint(random.point());
    const auto at = [&](double radius, double i) {
        const double angle = 2.0 * std::numbers::pi * i / static_cast<double>(rays);
        return raw.points[center] + radius * Vec2 {std::cos(angle), std::sin(angle)};
    };
    for (std::size_t i = 0; i < rays; ++i) {
        raw.segments.emplace_back(center, raw.addPoint(at(1.0, static_cast<double>(i))));
    }
    for (std::size_t k = 1; k <= rings; ++k) {
        const double radius = static_cast<double>(k) / static_cast<double>(rings + 1);
        for (std::size_t i = 0; i < rays; ++i) {
            const double offset = static_cast<double>(i) + 0.25 * static_cast<double>(k % 4);
            raw.addSegment(at(radius, offset), at(radius, offset + 1.0));
        }
    }
    return raw;
}

/// Two spirals around one center, one turned against the other.
inline RawPslg spirals(std::size_t n)
{
    RawPslg raw;
    for (const double turn : {1.0, -1.0}) {
        const auto first = static_cast<std::uint32_t>(raw.points.size());
        for (std::size_t i = 0; i < n; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(n);
            const double angle = turn * 30.0 * t;
            raw.addPoint(t * Vec2 {std::cos(angle), std::sin(angle)});
            if (i > 0) {
                raw.segments.emplace_back(first + i - 1, first + i);
            }
        }
    }
    return raw;
}

/// Segments of random integer ends on few lines: overlaps, touches, duplicates, spikes.
inline RawPslg overlaps(std::size_t n, std::uint64_t seed)
{
    Random random(seed);
    RawPslg raw;
    for (std::size_t i = 0; i < n; ++i) {
        const int line = random.integer(-2, 2);
        const int kind = random.integer(0, 2);
        const auto on = [&](int t) {
            return kind == 0 ? Vec2 {1.0 * t, 3.0 * line}
                 : kind == 1 ? Vec2 {3.0 * line, 1.0 * t}
                             : Vec2 {1.0 * t, 0.5 * t + line};
        };
        const Vec2 a = on(random.integer(-9, 9));
        raw.addSegment(a, on(random.integer(-9, 9)));
    }
    return raw;
}

/// Points on an integer circle with all chords between some of them.
inline RawPslg cocircular(std::size_t chords, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec2> circle;
    for (int x = -65; x <= 65; ++x) {
        for (int y = -65; y <= 65; ++y) {
            if (x * x + y * y == 65 * 65) {
                circle.push_back({1.0 * x, 1.0 * y});
            }
        }
    }
    const int last = static_cast<int>(circle.size()) - 1;
    RawPslg raw;
    raw.points = circle;
    for (std::size_t i = 0; i < chords; ++i) {
        const int a = random.integer(0, last);
        raw.segments.emplace_back(a, random.integer(0, last));
    }
    return raw;
}

template<class F>
RawPslg transformed(RawPslg raw, F&& f)
{
    for (Vec2& p : raw.points) {
        p = f(p);
    }
    return raw;
}

inline RawPslg scaled(const RawPslg& raw, double factor)
{
    return transformed(raw, [&](Vec2 p) { return factor * p; });
}

inline RawPslg shifted(const RawPslg& raw, double x, double y)
{
    return transformed(raw, [&](Vec2 p) { return p + Vec2 {x, y}; });
}

inline RawPslg rotated(const RawPslg& raw, double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return transformed(raw, [&](Vec2 p) { return Vec2 {c * p.x - s * p.y, s * p.x + c * p.y}; });
}

} // namespace tessera::test
