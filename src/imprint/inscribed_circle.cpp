// SPDX-License-Identifier: MIT
//
// Branch and bound over the triangles. The distance to one edge is convex, and so is the mean of the
// distances to two: over a triangle it is greatest at a corner. The least of these greatest values
// over edges and pairs of edges bounds the distance to the border from above; in a strip between
// parallel edges the pair gives just half its width, however long the triangle. From below it is
// bounded by any circle: one around a triangle's center is pushed away from the edge that it touches
// until it touches another. Edges too far to matter for a triangle are dropped for its parts. Bounded:
// the number of triangles looked at has a limit, after which the best circle so far stands.
#include "imprint/inscribed_circle.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <queue>
#include <vector>

namespace tessera
{

namespace
{

constexpr double kAccuracy = 1e-3;
constexpr double kRounding = 1e-9; ///< relative
constexpr std::size_t kMaxPairs = 100'000'000; ///< triangles x edges that are worth looking at
constexpr std::size_t kLooks = 20'000;

using Edge = std::array<Vec2, 2>;
using Candidates = std::shared_ptr<const std::vector<std::uint32_t>>;

Vec2 nearestOn(const Edge& edge, Vec2 p)
{
    const Vec2 along = edge[1] - edge[0];
    const double square = squaredLength(along);
    const double t =
        square > 0.0 ? std::clamp(dot(p - edge[0], along) / square, 0.0, 1.0) : 0.0;
    return edge[0] + t * along;
}

double distanceTo(const Edge& edge, Vec2 p)
{
    return distance(p, nearestOn(edge, p));
}

/// Radius at which a circle that grows from q towards the unit vector u, always touching q, meets the
/// edge; infinite if it never does.
double growthUntil(const Edge& edge, Vec2 q, Vec2 u)
{
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const auto untilPoint = [&](Vec2 p) {
        const double ahead = dot(u, p - q);
        return ahead > 0.0 ? squaredLength(p - q) / (2.0 * ahead) : kNever;
    };
    double radius = std::min(untilPoint(edge[0]), untilPoint(edge[1]));
    const Vec2 along = edge[1] - edge[0];
    const double length = distance(edge[0], edge[1]);
    if (length > 0.0) {
        Vec2 normal {-along.y / length, along.x / length};
        double height = dot(normal, q - edge[0]);
        if (height < 0.0) {
            normal = -1.0 * normal;
            height = -height;
        }
        const double closing = 1.0 - dot(normal, u);
        const double touching = closing > 0.0 ? height / closing : kNever;
        if (touching < radius) {
            const double at = dot(q + touching * u - edge[0], along);
            radius = at > 0.0 && at < length * length ? touching : radius;
        }
    }
    return radius;
}

struct Node
{
    std::array<Vec2, 3> corners;
    double bound; ///< no point of it is farther from the border
    Candidates candidates;

    friend bool operator<(const Node& a, const Node& b) { return a.bound < b.bound; }
};

class Search
{
public:
    Search(std::span<const Edge> border, double limit)
        : border_(border)
        , limit_((1.0 + kRounding) * limit)
    {}

    InscribedCircle run(std::span<const std::array<Vec2, 3>> triangles)
    {
        std::vector<std::uint32_t> all(border_.size());
        for (std::uint32_t e = 0; e < all.size(); ++e) {
            all[e] = e;
        }
        const auto everything = std::make_shared<const std::vector<std::uint32_t>>(std::move(all));
        for (const auto& triangle : triangles) {
            look(triangle, everything);
        }
        std::size_t looks = 0;
        while (!queue_.empty() && matters(queue_.top().bound) && looks < kLooks) {
            const Node node = queue_.top();
            queue_.pop();
            const auto& [a, b, c] = node.corners;
            const Vec2 ab = midpoint(a, b);
            const Vec2 bc = midpoint(b, c);
            const Vec2 ca = midpoint(c, a);
            look({a, ab, ca}, node.candidates);
            look({ab, b, bc}, node.candidates);
            look({ca, bc, c}, node.candidates);
            look({ab, bc, ca}, node.candidates);
            looks += 4;
        }
        best_.isWithin =
            best_.radius <= limit_ && (queue_.empty() || !matters(queue_.top().bound));
        return best_;
    }

private:
    /// A circle of that radius would change the answer.
    bool matters(double radius) const
    {
        return radius > (1.0 + kAccuracy) * best_.radius
            || (radius > limit_ && best_.radius <= limit_);
    }

    void look(const std::array<Vec2, 3>& corners, const Candidates& candidates)
    {
        const Vec2 center = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
        const double reach = std::max({distance(center, corners[0]), distance(center, corners[1]),
                                       distance(center, corners[2])});
        distances_.clear();
        std::uint32_t nearest = candidates->front();
        double least = distanceTo(border_[nearest], center);
        for (const std::uint32_t e : *candidates) {
            distances_.push_back(distanceTo(border_[e], center));
            if (distances_.back() < least) {
                least = distances_.back();
                nearest = e;
            }
        }
        if (least > best_.radius) {
            best_ = {center, least};
        }
        const double bound = boundOver(corners, *candidates, nearest, least + reach);
        if (!matters(bound)) {
            return;
        }
        grow(center, border_[nearest]);
        if (!matters(bound)) {
            return;
        }
        auto near = std::make_shared<std::vector<std::uint32_t>>();
        for (std::size_t i = 0; i < distances_.size(); ++i) {
            if (distances_[i] - reach <= bound) {
                near->push_back((*candidates)[i]);
            }
        }
        queue_.push({corners, bound, std::move(near)});
    }

    /// No point of the triangle is farther from the border.
    double boundOver(const std::array<Vec2, 3>& corners,
                     const std::vector<std::uint32_t>& candidates, std::uint32_t nearest,
                     double bound) const
    {
        std::array<double, 3> own {};
        for (std::size_t i = 0; i < 3; ++i) {
            own[i] = distanceTo(border_[nearest], corners[i]);
        }
        bound = std::min(bound, std::max({own[0], own[1], own[2]}));
        for (const std::uint32_t e : candidates) {
            double alone = 0.0;
            double mean = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double d = distanceTo(border_[e], corners[i]);
                alone = std::max(alone, d);
                mean = std::max(mean, 0.5 * (own[i] + d));
            }
            bound = std::min({bound, alone, mean});
        }
        return bound;
    }

    /// Pushes the circle around p that touches the edge away from it.
    void grow(Vec2 p, const Edge& edge)
    {
        const Vec2 q = nearestOn(edge, p);
        const double start = distance(p, q);
        if (start == 0.0) {
            return;
        }
        const Vec2 u = (1.0 / start) * (p - q);
        double radius = std::numeric_limits<double>::infinity();
        for (const Edge& other : border_) {
            if (distanceTo(other, q) > kRounding * start) { // not where it starts from
                radius = std::min(radius, growthUntil(other, q, u));
            }
        }
        if (!(radius > best_.radius) || radius == std::numeric_limits<double>::infinity()) {
            return;
        }
        const Vec2 center = q + radius * u;
        double free = radius;
        for (const Edge& other : border_) {
            free = std::min(free, distanceTo(other, center));
        }
        // It reaches back to p, so that it lies in the same part of the plane.
        if (free > best_.radius && free > radius - start) {
            best_ = {center, free};
        }
    }

    std::span<const Edge> border_;
    double limit_;
    std::priority_queue<Node> queue_;
    std::vector<double> distances_;
    InscribedCircle best_;
};

InscribedCircle meanWidth(std::span<const std::array<Vec2, 3>> triangles,
                          std::span<const Edge> border)
{
    double area = 0.0;
    double perimeter = 0.0;
    double largest = -1.0;
    InscribedCircle circle;
    for (const auto& [a, b, c] : triangles) {
        const double twice = cross(b - a, c - a);
        area += 0.5 * twice;
        if (twice > largest) {
            largest = twice;
            circle.center = (1.0 / 3.0) * (a + b + c);
        }
    }
    for (const auto& [a, b] : border) {
        perimeter += distance(a, b);
    }
    circle.radius = area / perimeter;
    return circle;
}

} // namespace

InscribedCircle largestCircleIn(std::span<const std::array<Vec2, 3>> triangles,
                                std::span<const std::array<Vec2, 2>> border, double limit)
{
    if (triangles.empty() || border.empty()) {
        return {};
    }
    if (triangles.size() > kMaxPairs / border.size()) {
        InscribedCircle circle = meanWidth(triangles, border);
        circle.isWithin = circle.radius <= limit;
        return circle;
    }
    return Search(border, limit).run(triangles);
}

} // namespace tessera
