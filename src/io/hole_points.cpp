// SPDX-License-Identifier: MIT
// The outline's edges, kept side to their left, are joined into loops that follow the free side:
// at a node where several outlines meet, the next edge is the first one counter-clockwise from
// where the loop came. A loop that runs clockwise encloses a hole. The hole's point lies on a
// horizontal line through the middle of one of its edges, half way to the next outline edge.
#include "io/hole_points.h"

#include "predicates/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace tessera
{

namespace
{

using DirectedEdge = std::array<std::uint32_t, 2>;

class HoleFinder
{
public:
    explicit HoleFinder(const Mesh& mesh)
        : nodes_(mesh.nodes)
    {
        for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
            if (mesh.edgeIsOutline[e] != 0) {
                edges_.push_back(mesh.edges[e]);
            }
        }
        std::ranges::sort(edges_);
    }

    std::vector<Vec2> run()
    {
        std::vector<Vec2> points;
        std::vector<std::uint8_t> done(edges_.size(), 0);
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            std::vector<std::size_t> loop;
            for (std::size_t at = e; at < edges_.size() && done[at] == 0; at = following(at)) {
                done[at] = 1;
                loop.push_back(at);
            }
            if (!loop.empty() && signedArea(loop) < 0.0) {
                if (const std::optional<Vec2> point = pointInside(loop)) {
                    points.push_back(*point);
                }
            }
        }
        return points;
    }

private:
    /// 0 for directions less than half a turn counter-clockwise of the reference, else 1.
    static int half(Vec2 center, Vec2 reference, Vec2 p)
    {
        const int side = orient2d(center, reference, p);
        const bool ahead =
            side > 0 || (side == 0 && compareAlong(center, reference, p, center) > 0);
        return ahead ? 0 : 1;
    }

    /// The outline edge that continues at the end of this one; edges_.size() if there is none.
    std::size_t following(std::size_t edge) const
    {
        const auto [from, node] = edges_[edge];
        const auto first = std::ranges::lower_bound(edges_, DirectedEdge {node, 0});
        std::size_t best = edges_.size();
        const Vec2 center = nodes_[node];
        const Vec2 back = nodes_[from];
        for (auto it = first; it != edges_.end() && (*it)[0] == node; ++it) {
            const auto candidate = static_cast<std::size_t>(it - edges_.begin());
            if (best == edges_.size() || turnsBefore(center, back, candidate, best)) {
                best = candidate;
            }
        }
        return best;
    }

    bool turnsBefore(Vec2 center, Vec2 reference, std::size_t a, std::size_t b) const
    {
        const Vec2 pa = nodes_[edges_[a][1]];
        const Vec2 pb = nodes_[edges_[b][1]];
        const int halfA = half(center, reference, pa);
        const int halfB = half(center, reference, pb);
        return halfA != halfB ? halfA < halfB : orient2d(center, pa, pb) > 0;
    }

    double signedArea(const std::vector<std::size_t>& loop) const
    {
        const Vec2 origin = nodes_[edges_[loop.front()][0]];
        double twice = 0.0;
        for (std::size_t e : loop) {
            twice += cross(nodes_[edges_[e][0]] - origin, nodes_[edges_[e][1]] - origin);
        }
        return 0.5 * twice;
    }

    std::optional<Vec2> pointInside(std::vector<std::size_t> loop) const
    {
        constexpr std::size_t kTries = 6;
        const auto height = [this](std::size_t e) {
            return std::fabs(nodes_[edges_[e][1]].y - nodes_[edges_[e][0]].y);
        };
        const std::size_t tries = std::min(kTries, loop.size());
        std::partial_sort(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(tries),
                          loop.end(), [&](std::size_t a, std::size_t b) {
                              return height(a) > height(b);
                          });
        std::optional<Vec2> best;
        double widest = 0.0;
        for (std::size_t i = 0; i < tries; ++i) {
            const auto [point, width] = middleOfGap(loop[i]);
            if (width > widest) {
                widest = width;
                best = point;
            }
        }
        return best;
    }

    struct Gap
    {
        Vec2 middle;
        double width;
    };
    /// The free interval beside the edge's middle, on the edge's right.
    Gap middleOfGap(std::size_t edge) const
    {
        const Vec2 a = nodes_[edges_[edge][0]];
        const Vec2 b = nodes_[edges_[edge][1]];
        const Vec2 start = midpoint(a, b);
        if (a.y == b.y) {
            return {start, 0.0}; // no gap is beside a horizontal edge
        }
        const double direction = b.y > a.y ? 1.0 : -1.0;
        double width = std::numeric_limits<double>::infinity();
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const Vec2 p = nodes_[edges_[e][0]];
            const Vec2 q = nodes_[edges_[e][1]];
            if (e != edge && (p.y <= start.y) != (q.y <= start.y)) {
                const double x = p.x + (start.y - p.y) / (q.y - p.y) * (q.x - p.x);
                const double away = direction * (x - start.x);
                if (away > 0.0) {
                    width = std::min(width, away);
                }
            }
        }
        if (!std::isfinite(width)) {
            return {start, 0.0};
        }
        return {{start.x + 0.5 * direction * width, start.y}, width};
    }

    const std::vector<Vec2>& nodes_;
    std::vector<DirectedEdge> edges_; ///< ascending
};

} // namespace

std::vector<Vec2> holePoints(const Mesh& mesh)
{
    return HoleFinder(mesh).run();
}

} // namespace tessera
