// SPDX-License-Identifier: MIT

// Delaunay triangulation of a point set by Bowyer–Watson insertion (cavity.h) in a biased
// randomized order along a Hilbert curve (spatial_sort.h).
//
// The points are copied in insertion order, which numbers the vertices, so that neighbors in the
// plane are neighbors in memory; each point is located by a walk from the triangle made last. A
// visibility walk cannot cycle in a Delaunay triangulation, whichever edge it takes. The vertices'
// incident half-edges are filled in at the end. Very great or small coordinates are scaled by a
// power of two meanwhile, so that the filters still decide; that is exact and undone at the end.
//
// Guarantees: exact, hence total: any finite points in range, duplicates, collinear and cocircular
// sets included; deterministic; ties among cocircular points are broken by the insertion order.
// Complexity: O(n log n) expected over the random rounds. Memory: 76 bytes a point.

#include "base/huge_pages.h"
#include "delaunay/cavity.h"
#include "delaunay/delaunay.h"
#include "delaunay/place.h"
#include "delaunay/spatial_sort.h"
#include "delaunay/start.h"
#include "predicates/bits.h"
#include "predicates/range.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace tessera
{
namespace
{

constexpr std::size_t kMaxPoints = (std::size_t {1} << 28) - 2; ///< 2^29 triangles
constexpr std::size_t kReportEvery = 4096;

/// What the bounding box and the common unit of all coordinates say about rounding.
struct StaticFilter
{
    double orientBound; ///< a cross product of relative vectors beyond it has the right sign
    double exactSquare; ///< see cavity.h
};

/// The e of the greatest power of two 2^e that divides all coordinates; limit - 1 if below limit.
int commonUnit(std::span<const Vec2> points, int limit)
{
    int unit = std::numeric_limits<int>::max();
    for (const Vec2 p : points) {
        for (const double value : {p.x, p.y}) {
            unit = value != 0.0 ? std::min(unit, lowestBit(value)) : unit;
        }
        if (unit < limit) {
            return limit - 1;
        }
    }
    return unit;
}

StaticFilter makeStaticFilter(std::span<const Vec2> points, const Box2& box)
{
    const double side = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
    const double bound
        = 2.0 * exact::kOrientBound * (1.0 + 8.0 * exact::kUnit) * side * side + exact::kUnderflow;
    const int size = exponentOf(side) + 1;
    const int unit = commonUnit(points, size - 48);
    if (unit < size - 48) {
        return {bound, 0.0};
    }
    // Below 26 bits both products and their difference are exact.
    return {size - unit <= 26 ? 0.0 : bound, std::ldexp(1.0, 4 * unit + 50)};
}

/// The power of two that brings coordinates near 1 if they are so great or small that squares of
/// areas would leave the range where the filters decide; 0 if they are not.
int filterScale(const Box2& box)
{
    const double greatest = std::max({std::fabs(box.min.x), std::fabs(box.min.y),
                                      std::fabs(box.max.x), std::fabs(box.max.y)});
    const int exponent = greatest > 0.0 ? exponentOf(greatest) : 0;
    return std::abs(exponent) > 64 ? -exponent : 0;
}

class BulkBuilder
{
public:
    BulkBuilder(std::span<const Vec2> points, Execution& execution)
        : points_(points)
        , execution_(execution)
    {
        for (const Vec2 p : points) {
            box_.add(p);
        }
        reserveOnHugePages(t().points, points.size() + 1);
        t().points.resize(points.size() + 1);
        order_ = sortForInsertion(points, box_, std::span(t().points).subspan(1));
        result_.vertexOfPoint.resize(points.size());
        scale_ = points.empty() ? 0 : filterScale(box_);
        scalePoints(scale_);
    }

    DelaunayResult run()
    {
        if (start()) {
            insertAll();
            fillVertexOfPoint();
            fillIncident();
            scalePoints(-scale_);
        }
        else {
            addCollinear();
        }
        return std::move(result_);
    }

private:
    Triangulation& t() { return result_.triangulation; }
    /// The points in insertion order; vertex i + 1 as long as there are no duplicates.
    Vec2 ordered(std::size_t i) { return t().points[i + 1]; }

    /// Multiplies all points by a power of two: exact, since they stay within kMaxSpan of 1.
    void scalePoints(int power)
    {
        const auto scale = [power](Vec2& p) { p = scaled(p, power); };
        if (power != 0) {
            std::for_each(t().points.begin(), t().points.end(), scale);
            scale(box_.min);
            scale(box_.max);
        }
    }

    /// Makes the first triangle from the first three points, which it first moves there. False if
    /// all points are collinear.
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
        moveTo(1, second);
        moveTo(2, third);
        t().incident.assign(4, Topology::kDead);
        reserveOnHugePages(t().triangles, 2 * n);
        startTriangles(t(), 1, 2, 3);
        return true;
    }

    void moveTo(std::size_t to, std::size_t from)
    {
        const auto rotate = [=](auto begin) {
            std::rotate(begin + static_cast<std::ptrdiff_t>(to),
                        begin + static_cast<std::ptrdiff_t>(from),
                        begin + static_cast<std::ptrdiff_t>(from) + 1);
        };
        rotate(order_.begin());
        rotate(t().points.begin() + 1);
    }

    /// No triangles: the vertices along the line.
    void addCollinear()
    {
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Vec2 p = points_[a];
            const Vec2 q = points_[b];
            return p.x != q.x ? p.x < q.x : (p.y != q.y ? p.y < q.y : a < b);
        });
        t().points.clear();
        for (std::size_t i = 0; i < order_.size(); ++i) {
            const Vec2 p = points_[order_[i]];
            const bool duplicate = i > 0 && p == t().points.back();
            result_.duplicates += duplicate ? 1 : 0;
            result_.vertexOfPoint[order_[i]] = duplicate
                ? static_cast<std::uint32_t>(t().points.size() - 1)
                : appendVertex(t(), p);
        }
    }

    void insertAll()
    {
        const std::size_t n = order_.size();
        filter_ = makeStaticFilter(std::span(t().points).subspan(1), box_);
        Cavity<CavityMode::Bulk> cavity(t(), filter_.exactSquare);
        std::uint32_t vertex = 4;
        HalfEdge hint = 0;
        for (std::size_t i = 3; i < n; ++i) {
            if (i % kReportEvery == 0) {
                execution_.report(static_cast<double>(i) / static_cast<double>(n));
            }
            const Vec2 p = ordered(i);
            const Location where = walk(p, Topology::triangleOf(hint));
            if (where.kind == Location::Kind::Vertex) {
                duplicates_.push_back({static_cast<std::uint32_t>(i), t().origin(where.edge)});
                continue;
            }
            if (!duplicates_.empty()) {
                t().points[vertex] = p; // they have left room
            }
            cavity.insert(vertex, p, where.kind == Location::Kind::Edge, where.edge);
            hint = cavity.lastSpoke();
            ++vertex;
        }
        t().points.resize(vertex);
    }

    /// Visibility walk from a finite triangle. The static filter decides most steps.
    Location walk(Vec2 p, std::uint32_t triangle)
    {
        const double bound = filter_.orientBound;
        const std::vector<Vec2>& points = t().points;
        // Of the triangle at hand: the side behind which p is not, strictly, and its ends.
        HalfEdge entered = Topology::halfEdge(triangle, 0);
        int side = sideOf(p, entered);
        while (side == 0) {
            entered = Topology::next(entered);
            side = sideOf(p, entered);
        }
        entered = side > 0 ? entered : t().twin(entered);
        Vec2 from = points[t().origin(entered)] - p;
        Vec2 to = points[t().destination(entered)] - p;
        for (;;) {
            const std::uint32_t apex = t().apex(entered);
            if (apex == Topology::kInfinite) {
                return {Location::Kind::Triangle, entered};
            }
            const Vec2 tip = points[apex] - p;
            const double ahead = cross(to, tip);
            const double behind = cross(tip, from);
            const double least = std::min(ahead, behind);
            if (least > bound) {
                return {Location::Kind::Triangle, entered};
            }
            if (least < -bound) {
                const bool next = ahead < behind;
                entered = t().twin(next ? Topology::next(entered) : Topology::prev(entered));
                (next ? from : to) = tip;
                continue;
            }
            int sign[3];
            const std::uint32_t exit = exactSigns(p, Topology::triangleOf(entered), sign);
            if (exit == 3) {
                return placeInTriangle(Topology::triangleOf(entered), sign);
            }
            entered = t().twin(Topology::halfEdge(Topology::triangleOf(entered), exit));
            from = points[t().origin(entered)] - p;
            to = points[t().destination(entered)] - p;
        }
    }

    int sideOf(Vec2 p, HalfEdge edge)
    {
        return orient2d(t().points[t().origin(edge)], t().points[t().destination(edge)], p);
    }

    /// The exact orientations of p to the sides; returns the first negative one or 3.
    std::uint32_t exactSigns(Vec2 p, std::uint32_t triangle, int (&sign)[3])
    {
        for (std::uint32_t i = 0; i < 3; ++i) {
            sign[i] = sideOf(p, Topology::halfEdge(triangle, i));
            if (sign[i] < 0) {
                return i;
            }
        }
        return 3;
    }

    void fillVertexOfPoint()
    {
        result_.duplicates = duplicates_.size();
        duplicates_.push_back({static_cast<std::uint32_t>(order_.size()), 0}); // ends the list
        std::size_t met = 0;
        for (std::size_t i = 0; i < order_.size(); ++i) {
            const bool duplicate = i == duplicates_[met].position;
            result_.vertexOfPoint[order_[i]] = duplicate
                ? duplicates_[met].vertex
                : static_cast<std::uint32_t>(i + 1 - met);
            met += duplicate ? 1 : 0;
        }
    }

    void fillIncident()
    {
        t().incident.assign(t().points.size(), Topology::kDead);
        for (std::uint32_t triangle = 0; triangle < t().triangles.size(); ++triangle) {
            const auto& v = t().triangles[triangle].v;
            for (std::uint32_t i = 0; i < 3; ++i) {
                t().incident[v[i]] = Topology::halfEdge(triangle, Topology::prev3(i));
            }
        }
    }

    std::span<const Vec2> points_;
    Execution& execution_;
    std::vector<std::uint32_t> order_;
    struct Duplicate
    {
        std::uint32_t position; ///< in order_
        std::uint32_t vertex;
    };
    Box2 box_; ///< of the points, scaled as they are
    StaticFilter filter_ {};
    int scale_ = 0; ///< of the points while the triangulation is built
    std::vector<Duplicate> duplicates_;
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
