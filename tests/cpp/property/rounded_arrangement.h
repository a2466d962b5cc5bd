// SPDX-License-Identifier: MIT
#pragma once

#include "predicates/crossing.h"
#include "predicates/predicates.h"
#include "recover/raw_pslg.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace tessera::test
{

/// Points without duplicates, by x, then y.
inline void sortUnique(std::vector<Vec2>& points)
{
    std::sort(points.begin(), points.end(),
              [](Vec2 p, Vec2 q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

/// The vertices of the arrangement, by brute force over all pairs of segments, each crossing rounded
/// once: what boundary recovery must have, whatever the order and the strategy, unless it has found
/// the input ill-conditioned.
inline std::vector<Vec2> roundedArrangement(const RawPslg& raw)
{
    std::vector<Vec2> vertices = raw.points;
    for (std::size_t i = 0; i < raw.segments.size(); ++i) {
        const Vec2 a = raw.points[raw.segments[i].first];
        const Vec2 b = raw.points[raw.segments[i].second];
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2 c = raw.points[raw.segments[j].first];
            const Vec2 d = raw.points[raw.segments[j].second];
            if (orient2d(a, b, c) * orient2d(a, b, d) < 0
                && orient2d(c, d, a) * orient2d(c, d, b) < 0) {
                vertices.push_back(crossLines(a, b, c, d).point);
            }
        }
    }
    sortUnique(vertices);
    return vertices;
}

} // namespace tessera::test
