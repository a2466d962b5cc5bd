// SPDX-License-Identifier: MIT
#pragma once

#include "recover/raw_pslg.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <set>

namespace tessera::test
{

/// x and y as reduced fractions: numerator, denominator > 0, numerator, denominator.
using FractionPoint = std::array<std::int64_t, 4>;

/// The vertices of the arrangement of points and segments with small integer coordinates (below
/// 10,000), by brute force in integers: an independent oracle that is quick.
inline std::set<FractionPoint> integerArrangement(const RawPslg& raw)
{
    using Int = std::int64_t;
    std::set<FractionPoint> vertices;
    const auto point = [&](std::uint32_t i) {
        return std::array {static_cast<Int>(raw.points[i].x), static_cast<Int>(raw.points[i].y)};
    };
    const auto cross = [](Int ax, Int ay, Int bx, Int by) { return ax * by - ay * bx; };
    for (std::size_t i = 0; i < raw.segments.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const auto a = point(raw.segments[i].first);
            const auto b = point(raw.segments[i].second);
            const auto c = point(raw.segments[j].first);
            const auto d = point(raw.segments[j].second);
            Int det = cross(b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]);
            Int t = cross(c[0] - a[0], c[1] - a[1], d[0] - c[0], d[1] - c[1]);
            Int u = cross(c[0] - a[0], c[1] - a[1], b[0] - a[0], b[1] - a[1]);
            if (det < 0) {
                det = -det;
                t = -t;
                u = -u;
            }
            if (det != 0 && 0 <= t && t <= det && 0 <= u && u <= det) {
                const Int x = a[0] * det + t * (b[0] - a[0]);
                const Int y = a[1] * det + t * (b[1] - a[1]);
                vertices.insert({x / std::gcd(x, det), det / std::gcd(x, det),
                                 y / std::gcd(y, det), det / std::gcd(y, det)});
            }
        }
    }
    for (std::uint32_t i = 0; i < raw.points.size(); ++i) {
        vertices.insert({point(i)[0], 1, point(i)[1], 1});
    }
    return vertices;
}

} // namespace tessera::test
