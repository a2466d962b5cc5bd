// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace tessera::test
{

struct PointSet
{
    std::string name;
    std::vector<Vec2> points;
};

inline std::vector<Vec2> uniformPoints(std::size_t n, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Vec2> points(n);
    for (Vec2& p : points) {
        p.x = unit(random);
        p.y = unit(random);
    }
    return points;
}

inline std::vector<Vec2> gridPoints(std::size_t side, double step)
{
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < side; ++i) {
        for (std::size_t j = 0; j < side; ++j) {
            points.push_back({step * static_cast<double>(i), step * static_cast<double>(j)});
        }
    }
    return points;
}

inline std::vector<Vec2> circlePoints(std::size_t n, double radius = 1.0)
{
    std::vector<Vec2> points(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n);
        points[i] = {radius * std::cos(angle), radius * std::sin(angle)};
    }
    return points;
}

/// Gaussian clusters whose widths range over many powers of ten.
inline std::vector<Vec2> clusterPoints(std::size_t n, std::size_t clusters, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    std::vector<Vec2> centers = uniformPoints(clusters, seed + 1);
    std::vector<Vec2> points(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t c = random() % clusters;
        const double width = 0.05 * std::pow(10.0, -5.0 * static_cast<double>(c)
                                                       / static_cast<double>(clusters));
        points[i] = centers[c] + width * Vec2 {normal(random), normal(random)};
    }
    return points;
}

inline std::vector<Vec2> transformed(std::vector<Vec2> points, double scale, Vec2 shift)
{
    for (Vec2& p : points) {
        p = scale * p + shift;
    }
    return points;
}

/// Every kind of set that has its own way to go wrong, each of about n points.
inline std::vector<PointSet> hardPointSets(std::size_t n)
{
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
    std::vector<PointSet> sets;
    const auto add = [&](const std::string& name, std::vector<Vec2> points) {
        sets.push_back({name, std::move(points)});
    };
    add("uniform", uniformPoints(n, 1));
    add("integer grid", gridPoints(side, 1.0));
    add("grid of tenths", gridPoints(side, 0.1));
    add("circle", circlePoints(n));
    add("clusters", clusterPoints(n, 20, 5));
    add("uniform scaled by 2^300", transformed(uniformPoints(n, 2), 0x1p300, {}));
    add("uniform scaled by 2^-300", transformed(uniformPoints(n, 2), 0x1p-300, {}));
    add("circle scaled by 2^300", transformed(circlePoints(n), 0x1p300, {}));
    add("circle scaled by 2^-300", transformed(circlePoints(n), 0x1p-300, {}));
    add("uniform shifted by 1e15", transformed(uniformPoints(n, 3), 100.0, {1e15, -1e15}));
    add("grid scaled by 2^-300", transformed(gridPoints(side, 0.1), 0x1p-300, {}));

    std::vector<Vec2> points = circlePoints(n / 2);
    points.push_back({0.0, 0.0});
    for (std::size_t i = 0; i < n / 2; ++i) {
        points.push_back({2.0 * points[i].x, 2.0 * points[i].y});
    }
    add("two circles and their center", points);

    points = uniformPoints(n / 2, 4);
    const std::vector<Vec2> once = points;
    points.insert(points.end(), once.begin(), once.end());
    add("each point twice", points);

    points.clear();
    for (std::size_t i = 0; i < n; ++i) {
        points.push_back({static_cast<double>(i), 0.0});
    }
    points.push_back({0.3, 1e-9});
    add("line and one point", points);

    points.clear();
    for (std::size_t i = 0; i < n / 2; ++i) {
        points.push_back({0.1 * static_cast<double>(i), 0.0});
        points.push_back({0.0, 0.1 * static_cast<double>(i)});
    }
    add("two axes", points);

    points.clear();
    std::mt19937_64 random(6);
    for (std::size_t i = 0; i < n; ++i) {
        const double t = std::ldexp(static_cast<double>(random() % 1024), -10);
        const double nudge = std::ldexp(static_cast<double>(random() % 8), -52);
        points.push_back({1.0 + t, 1.0 + 0.5 * t + nudge});
    }
    add("within a few ulp of a line", points);

    points.clear();
    for (std::size_t i = 0; i < n; ++i) {
        const double s = 1e-30 * std::pow(1.07, static_cast<double>(i % 800));
        const double angle = static_cast<double>(i);
        points.push_back({s * std::cos(angle), s * std::sin(angle)});
    }
    add("spiral over many powers of ten", points);
    return sets;
}

} // namespace tessera::test
