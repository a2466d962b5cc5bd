// SPDX-License-Identifier: MIT
#include "io/drawing.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tessera
{

namespace
{

constexpr std::uint32_t kNone = DrawnTriangles::kNone;

/// Soft colors that dark lines stand out from; the first is for the largest class.
constexpr std::array<Color, 12> kPalette {{
    {0.73, 0.85, 0.93},
    {0.98, 0.88, 0.68},
    {0.78, 0.89, 0.76},
    {0.95, 0.78, 0.74},
    {0.84, 0.80, 0.92},
    {0.69, 0.88, 0.86},
    {0.99, 0.82, 0.65},
    {0.87, 0.91, 0.67},
    {0.94, 0.80, 0.88},
    {0.86, 0.83, 0.78},
    {0.72, 0.79, 0.91},
    {0.97, 0.94, 0.77},
}};

Box2 boxOf(std::span<const Vec2> points, const DrawnEdge& edge)
{
    Box2 box;
    box.add(points[edge.a]);
    box.add(points[edge.b]);
    if (edge.middle != kNone) {
        box.add(points[edge.middle]);
    }
    return box;
}

void drawTo(Canvas& canvas, std::span<const Vec2> points, std::uint32_t from, std::uint32_t to,
            std::uint32_t middle)
{
    if (middle == kNone) {
        canvas.lineTo(points[to]);
    }
    else {
        canvas.parabolaTo(points[from], points[middle], points[to]);
    }
}

/// Edge e seen from one of its ends.
struct Incidence
{
    std::uint32_t edge;
    std::uint32_t other;
};

/// Walks through all edges in few, long trails.
class TrailDrawer
{
public:
    TrailDrawer(Canvas& canvas, std::span<const Vec2> points, std::span<const DrawnEdge> edges)
        : canvas_(canvas)
        , points_(points)
        , edges_(edges)
        , used_(edges.size(), 0)
    {
        vertices_.reserve(2 * edges.size());
        for (const DrawnEdge& edge : edges) {
            vertices_.push_back(edge.a);
            vertices_.push_back(edge.b);
        }
        std::ranges::sort(vertices_);
        vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
        start_.assign(vertices_.size() + 1, 0);
        for (const DrawnEdge& edge : edges) {
            ++start_[local(edge.a) + 1];
            ++start_[local(edge.b) + 1];
        }
        for (std::size_t v = 0; v < vertices_.size(); ++v) {
            start_[v + 1] += start_[v];
        }
        next_.assign(start_.begin(), start_.end() - 1);
        incident_.resize(2 * edges.size());
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            const std::uint32_t a = local(edges[e].a);
            const std::uint32_t b = local(edges[e].b);
            incident_[next_[a]++] = {e, b};
            incident_[next_[b]++] = {e, a};
        }
        next_.assign(start_.begin(), start_.end() - 1);
    }

    void run(Color color, double width)
    {
        // Trails that start at vertices of odd degree leave only closed ones for the second pass.
        for (const bool oddOnly : {true, false}) {
            for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
                if (!oddOnly || (start_[v + 1] - start_[v]) % 2 == 1) {
                    walk(v, color, width);
                }
            }
        }
        canvas_.stroke(color, width);
    }

private:
    /// Strokes longer than this cost the drawing library more time than they save.
    static constexpr std::size_t kLongestStroke = 1000;

    std::uint32_t local(std::uint32_t vertex) const
    {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(vertices_, vertex)
                                          - vertices_.begin());
    }

    void walk(std::uint32_t v, Color color, double width)
    {
        bool moved = false;
        while (true) {
            while (next_[v] < start_[v + 1] && used_[incident_[next_[v]].edge] != 0) {
                ++next_[v];
            }
            if (next_[v] == start_[v + 1]) {
                return;
            }
            if (!moved) {
                canvas_.moveTo(points_[vertices_[v]]);
                moved = true;
            }
            const auto [edge, other] = incident_[next_[v]];
            used_[edge] = 1;
            drawTo(canvas_, points_, vertices_[v], vertices_[other], edges_[edge].middle);
            v = other;
            if (++length_ % kLongestStroke == 0) {
                canvas_.stroke(color, width);
                canvas_.moveTo(points_[vertices_[v]]);
            }
        }
    }

    Canvas& canvas_;
    std::span<const Vec2> points_;
    std::span<const DrawnEdge> edges_;
    std::vector<std::uint8_t> used_;
    std::vector<std::uint32_t> vertices_; ///< ascending
    std::vector<std::uint32_t> start_;    ///< by local vertex: range in incident_
    std::vector<std::uint32_t> next_;
    std::vector<Incidence> incident_;
    std::size_t length_ = 0;
};

/// Joins directed edges into closed loops and adds them to the canvas's path.
void addLoops(Canvas& canvas, std::span<const Vec2> points, std::vector<DrawnEdge>& edges)
{
    std::ranges::sort(edges, {}, &DrawnEdge::a);
    std::vector<std::uint8_t> used(edges.size(), 0);
    const auto following = [&](std::uint32_t vertex) {
        auto it = std::ranges::lower_bound(edges, vertex, {}, &DrawnEdge::a);
        for (; it != edges.end() && it->a == vertex; ++it) {
            const auto e = static_cast<std::size_t>(it - edges.begin());
            if (used[e] == 0) {
                return e;
            }
        }
        return edges.size();
    };
    for (std::size_t first = 0; first < edges.size(); ++first) {
        if (used[first] != 0) {
            continue;
        }
        canvas.moveTo(points[edges[first].a]);
        for (std::size_t e = first; e < edges.size(); e = following(edges[e].b)) {
            used[e] = 1;
            drawTo(canvas, points, edges[e].a, edges[e].b, edges[e].middle);
        }
        canvas.closePath();
    }
}

} // namespace

std::vector<DrawnEdge> sidesOf(const DrawnTriangles& triangles)
{
    struct Keyed
    {
        std::uint64_t key;
        std::uint32_t side; ///< 3 x triangle + corner opposite
    };
    std::vector<Keyed> keyed;
    keyed.reserve(3 * triangles.corners.size());
    for (std::uint32_t t = 0; t < triangles.corners.size(); ++t) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t a = triangles.corners[t][(i + 1) % 3];
            const std::uint32_t b = triangles.corners[t][(i + 2) % 3];
            keyed.push_back({std::uint64_t {std::min(a, b)} << 32U | std::max(a, b), 3 * t + i});
        }
    }
    std::ranges::sort(keyed, [](const Keyed& x, const Keyed& y) {
        return x.key != y.key ? x.key < y.key : x.side < y.side;
    });
    std::vector<DrawnEdge> sides;
    sides.reserve(keyed.size() / 2 + 16);
    std::uint64_t last = ~std::uint64_t {0};
    for (const auto& [key, side] : keyed) {
        const std::uint32_t t = side / 3;
        const std::uint32_t i = side % 3;
        if (key != last) {
            const auto& c = triangles.corners[t];
            sides.push_back({c[(i + 1) % 3], c[(i + 2) % 3],
                             triangles.middles.empty() ? kNone : triangles.middles[t][i],
                             triangles.classOf[t], kNone});
            last = key;
        }
        else {
            sides.back().right = triangles.classOf[t];
        }
    }
    return sides;
}

void fillClasses(Canvas& canvas, std::span<const Vec2> points, std::span<const DrawnEdge> sides,
                 std::span<const Color> colorOfClass)
{
    std::vector<std::vector<DrawnEdge>> borders(colorOfClass.size());
    for (const DrawnEdge& side : sides) {
        if (side.left == side.right) {
            continue;
        }
        if (side.left != kNone) {
            borders[side.left].push_back(side);
        }
        if (side.right != kNone) {
            borders[side.right].push_back({side.b, side.a, side.middle, side.right, side.left});
        }
    }
    for (std::size_t c = 0; c < borders.size(); ++c) {
        addLoops(canvas, points, borders[c]);
        canvas.fill(colorOfClass[c]);
    }
}

std::vector<Color> chooseColors(std::span<const DrawnEdge> sides, std::size_t classes)
{
    std::vector<std::vector<std::uint32_t>> beside(classes);
    for (const DrawnEdge& side : sides) {
        if (side.left != side.right && side.left != kNone && side.right != kNone) {
            beside[side.left].push_back(side.right);
            beside[side.right].push_back(side.left);
        }
    }
    constexpr std::size_t kColors = kPalette.size();
    std::vector<std::size_t> colorOf(classes, kColors);
    for (std::size_t c = 0; c < classes; ++c) {
        std::array<bool, kColors> taken {};
        for (std::uint32_t other : beside[c]) {
            if (colorOf[other] < kColors) {
                taken[colorOf[other]] = true;
            }
        }
        colorOf[c] = c % kColors;
        for (std::size_t i = 0; i < kColors && taken[colorOf[c]]; ++i) {
            colorOf[c] = (colorOf[c] + 1) % kColors;
        }
    }
    std::vector<Color> colors;
    for (std::size_t index : colorOf) {
        colors.push_back(kPalette[index]);
    }
    return colors;
}

void strokeEdges(Canvas& canvas, std::span<const Vec2> points, std::span<const DrawnEdge> edges,
                 const Pen& pen)
{
    // One width for each octave of length below the full length.
    constexpr int kOctaves = 8;
    std::array<std::vector<DrawnEdge>, kOctaves> byOctave;
    for (const DrawnEdge& edge : edges) {
        if (!canvas.view().overlaps(boxOf(points, edge))) {
            continue;
        }
        const double pixels = distance(points[edge.a], points[edge.b]) * canvas.pixelsPerUnit();
        const double octave = std::log2(pen.fullLength / pixels);
        byOctave[static_cast<std::size_t>(std::clamp(octave + 1.0, 0.0, kOctaves - 1.0))].push_back(
            edge);
    }
    for (int octave = kOctaves - 1; octave >= 0; --octave) {
        const auto& group = byOctave[static_cast<std::size_t>(octave)];
        if (!group.empty()) {
            const double width = std::max(pen.leastWidth, std::ldexp(pen.width, -octave));
            TrailDrawer(canvas, points, group).run(pen.color, width);
        }
    }
}

} // namespace tessera
