// SPDX-License-Identifier: MIT
//
// Branch and bound over the triangles. The distance to one edge is convex, so over a triangle it is
// greatest at a corner; the least of these greatest values over all edges bounds the distance to the
// border from above, the distance of any point from below. A strip of any length needs a number of
// halvings that depends on the accuracy only, since the bound is tight for triangles that are long
// beside their edge. Edges too far to matter for a triangle are dropped for its parts. Bounded: the
// number of triangles looked at has a limit, after which the best circle so far stands.
#include "imprint/inscribed_circle.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <queue>
#include <vector>

namespace tessera
{

namespace
{

constexpr double kAccuracy = 0.01;
constexpr std::size_t kMaxPairs = 100'000'000; ///< triangles x edges that are worth looking at
constexpr std::size_t kLooks = 20'000;

using Edge = std::array<Vec2, 2>;
using Candidates = std::shared_ptr<const std::vector<std::uint32_t>>;

double distanceTo(const Edge& edge, Vec2 p)
{
    const Vec2 along = edge[1] - edge[0];
    const double square = squaredLength(along);
    const double t =
        square > 0.0 ? std::clamp(dot(p - edge[0], along) / square, 0.0, 1.0) : 0.0;
    return distance(p, edge[0] + t * along);
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
    explicit Search(std::span<const Edge> border)
        : border_(border)
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
        while (!queue_.empty() && queue_.top().bound > (1.0 + kAccuracy) * best_.radius
               && looks < kLooks) {
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
        return best_;
    }

private:
    void look(const std::array<Vec2, 3>& corners, const Candidates& candidates)
    {
        const Vec2 center = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
        const double reach = std::max({distance(center, corners[0]), distance(center, corners[1]),
                                       distance(center, corners[2])});
        distances_.clear();
        double nearest = reach + distanceTo(border_[candidates->front()], center);
        double bound = nearest;
        for (const std::uint32_t e : *candidates) {
            distances_.push_back(distanceTo(border_[e], center));
            nearest = std::min(nearest, distances_.back());
            if (distances_.back() - reach <= bound) {
                double farthest = 0.0;
                for (const Vec2 corner : corners) {
                    farthest = std::max(farthest, distanceTo(border_[e], corner));
                }
                bound = std::min(bound, farthest);
            }
        }
        if (nearest > best_.radius) {
            best_ = {center, nearest};
        }
        if (bound <= (1.0 + kAccuracy) * best_.radius) {
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

    std::span<const Edge> border_;
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
                                std::span<const std::array<Vec2, 2>> border)
{
    if (triangles.empty() || border.empty()) {
        return {};
    }
    if (triangles.size() > kMaxPairs / border.size()) {
        return meanWidth(triangles, border);
    }
    return Search(border).run(triangles);
}

} // namespace tessera
