// SPDX-License-Identifier: MIT

// Delaunay triangulation of a point set by Bowyer–Watson insertion (cavity.h) in a biased
// randomized order along a Hilbert curve (spatial_sort.h).
//
// Guarantees: exact, hence total: any finite points in range, duplicates, collinear and cocircular
// sets included; deterministic; ties among cocircular points are broken by the insertion order.
// Complexity: O(n log n) expected over the random rounds.

#include "delaunay/cavity.h"
#include "delaunay/delaunay.h"
#include "delaunay/spatial_sort.h"
#include "delaunay/start.h"
#include "predicates/range.h"

#include <algorithm>

namespace tessera
{
namespace
{

constexpr std::size_t kMaxPoints = (std::size_t {1} << 28) - 2; ///< 2^29 triangles

class BulkBuilder
{
public:
    BulkBuilder(std::span<const Vec2> points, Execution& execution)
        : points_(points)
        , execution_(execution)
        , order_(insertionOrder(points))
    {
        result_.vertexOfPoint.resize(points.size());
        t().points.reserve(points.size() + 1);
        t().incident.reserve(points.size() + 1);
        t().points.push_back({});
        t().incident.push_back(Topology::kDead);
    }

    DelaunayResult run()
    {
        if (!start()) {
            addCollinear();
            return std::move(result_);
        }
        t().triangles.reserve(2 * points_.size() + 2);
        addAll();
        return std::move(result_);
    }

private:
    Triangulation& t() { return result_.triangulation; }
    Vec2 ordered(std::size_t i) const { return points_[order_[i]]; }

    /// Makes the first triangle and moves its points to the front of the order. False if all
    /// points are collinear.
    bool start()
    {
        const std::size_t n = order_.size();
        std::size_t second = 1;
        while (second < n && ordered(second) == ordered(0)) {
            ++second;
        }
        std::size_t third = second + 1;
        while (third < n && orient2d(ordered(0), ordered(second), ordered(third)) == 0) {
            ++third;
        }
        if (third >= n) {
            return false;
        }
        const auto first = order_.begin();
        std::rotate(first + 1, first + static_cast<std::ptrdiff_t>(second),
                    first + static_cast<std::ptrdiff_t>(second) + 1);
        std::rotate(first + 2, first + static_cast<std::ptrdiff_t>(third),
                    first + static_cast<std::ptrdiff_t>(third) + 1);
        for (std::size_t i = 0; i < 3; ++i) {
            result_.vertexOfPoint[order_[i]] = appendVertex(t(), ordered(i));
        }
        startTriangles(t(), 1, 2, 3);
        return true;
    }

    void addCollinear()
    {
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Vec2 p = points_[a];
            const Vec2 q = points_[b];
            return p.x != q.x ? p.x < q.x : (p.y != q.y ? p.y < q.y : a < b);
        });
        for (std::size_t i = 0; i < order_.size(); ++i) {
            if (i > 0 && ordered(i) == ordered(i - 1)) {
                ++result_.duplicates;
                result_.vertexOfPoint[order_[i]] = result_.vertexOfPoint[order_[i - 1]];
            }
            else {
                result_.vertexOfPoint[order_[i]] = appendVertex(t(), ordered(i));
            }
        }
    }

    void addAll()
    {
        Cavity<true> cavity(t());
        HalfEdge hint = 0;
        for (std::size_t i = 3; i < order_.size(); ++i) {
            if (i % 4096 == 0) {
                execution_.report(static_cast<double>(i) / static_cast<double>(order_.size()));
            }
            const Vec2 p = ordered(i);
            const Location where = locate(t(), p, hint);
            if (where.kind == Location::Kind::Vertex) {
                ++result_.duplicates;
                hint = where.edge;
                result_.vertexOfPoint[order_[i]] = t().origin(where.edge);
                continue;
            }
            const std::uint32_t vertex = appendVertex(t(), p);
            result_.vertexOfPoint[order_[i]] = vertex;
            cavity.insert(vertex, where.kind == Location::Kind::Edge, where.edge);
            hint = cavity.lastSpoke();
        }
    }

    std::span<const Vec2> points_;
    Execution& execution_;
    std::vector<std::uint32_t> order_;
    DelaunayResult result_;
};

} // namespace

DelaunayResult triangulate(std::span<const Vec2> points, Execution& execution)
{
    checkRange(points);
    if (points.size() > kMaxPoints) {
        throw Error(ErrorKind::TooLarge,
                    std::to_string(points.size()) + " points are more than the "
                        + std::to_string(kMaxPoints)
                        + " that one triangulation can hold; split the input or choose a larger "
                          "size.");
    }
    return BulkBuilder(points, execution).run();
}

} // namespace tessera
