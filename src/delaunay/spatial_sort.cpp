// SPDX-License-Identifier: MIT
#include "delaunay/spatial_sort.h"

#include "base/box2.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tessera
{
namespace
{

constexpr std::uint32_t kHilbertBits = 28;

std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y)
{
    std::uint64_t index = 0;
    for (std::uint32_t s = 1U << (kHilbertBits - 1); s > 0; s >>= 1) {
        const std::uint32_t rx = (x & s) != 0 ? 1 : 0;
        const std::uint32_t ry = (y & s) != 0 ? 1 : 0;
        index = 4 * index + ((3 * rx) ^ ry);
        if (ry == 0) {
            if (rx == 1) {
                x = ~x;
                y = ~y;
            }
            std::swap(x, y);
        }
    }
    return index;
}

std::uint64_t mix(std::uint64_t x)
{
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9ULL;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

} // namespace

std::vector<std::uint32_t> insertionOrder(std::span<const Vec2> points)
{
    Box2 box;
    for (const Vec2 p : points) {
        box.add(p);
    }
    const double side = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
    const double scale = side > 0.0 ? ((1U << kHilbertBits) - 1) / side : 0.0;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const auto x = static_cast<std::uint32_t>((points[i].x - box.min.x) * scale);
        const auto y = static_cast<std::uint32_t>((points[i].y - box.min.y) * scale);
        std::uint64_t level = 15;
        std::uint64_t random = mix(i + 1);
        for (std::size_t n = points.size(); n > 10000 && level > 0 && (random & 15U) == 0; n /= 16) {
            random >>= 4;
            --level;
        }
        keys[i] = {(level << (2 * kHilbertBits)) | hilbertIndex(x, y), i};
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order(points.size());
    std::transform(keys.begin(), keys.end(), order.begin(),
                   [](const auto& key) { return key.second; });
    return order;
}

} // namespace tessera
