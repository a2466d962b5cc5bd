// SPDX-License-Identifier: MIT
//
// All of a region lies in the half-plane to the right of its least corner, so that turning
// counter-clockwise around that corner is a total order of the directions into it. The first one is
// a side of the region, whatever the triangles.
#include "region/region_order.h"

#include "predicates/predicates.h"

#include <algorithm>
#include <numeric>

namespace tessera
{

namespace
{

bool lexicographicallyLess(Vec2 a, Vec2 b)
{
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

/// The least corner of a region and the end of its first side there.
struct Place
{
    std::uint32_t corner = Topology::kInfinite; ///< none yet
    std::uint32_t toward = Topology::kInfinite;
};

class Before
{
public:
    explicit Before(const std::vector<Vec2>& points)
        : points_(points)
    {}

    bool operator()(const Place& a, const Place& b) const
    {
        if (a.corner == b.corner) {
            return orient2d(points_[a.corner], points_[a.toward], points_[b.toward]) > 0;
        }
        return lexicographicallyLess(points_[a.corner], points_[b.corner]);
    }

private:
    const std::vector<Vec2>& points_;
};

/// A counter-clockwise triangle's own place.
Place placeOf(const Triangulation& t, std::uint32_t triangle)
{
    const auto& v = t.triangles[triangle].v;
    std::uint32_t least = 0;
    for (std::uint32_t i = 1; i < 3; ++i) {
        least = lexicographicallyLess(t.points[v[i]], t.points[v[least]]) ? i : least;
    }
    return {v[least], v[Topology::next3(least)]};
}

} // namespace

std::vector<std::uint32_t> orderOfRegions(const Triangulation& triangulation,
                                          const std::vector<std::uint32_t>& regionOfTriangle,
                                          std::size_t count)
{
    const Before before(triangulation.points);
    std::vector<Place> places(count);
    for (std::uint32_t t = 0; t < triangulation.triangles.size(); ++t) {
        const std::uint32_t region = regionOfTriangle[t];
        if (region == kNoRegion || region == 0 || !triangulation.isFinite(t)) {
            continue;
        }
        const Place place = placeOf(triangulation, t);
        if (places[region].corner == Topology::kInfinite || before(place, places[region])) {
            places[region] = place;
        }
    }
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin() + 1, order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return before(places[a], places[b]);
    });
    std::vector<std::uint32_t> numbers(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        numbers[order[i]] = i;
    }
    return numbers;
}

} // namespace tessera
