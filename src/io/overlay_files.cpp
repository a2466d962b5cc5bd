// SPDX-License-Identifier: MIT
#include "io/overlay_files.h"

#include "io/text_builder.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tessera
{

namespace
{

void appendLoop(TextBuilder& out, const OverlayResult& result,
                std::span<const std::uint32_t> loop)
{
    out << '(';
    for (std::size_t i = 0; i <= loop.size(); ++i) {
        const Vec2 p = result.point(loop[i == loop.size() ? 0 : i]);
        out << (i == 0 ? "" : ", ") << p.x << ' ' << p.y;
    }
    out << ')';
}

void appendPolygon(TextBuilder& out, const OverlayResult& result, std::size_t part)
{
    out << '(';
    for (std::size_t i = 0; i < result.polygons.loopCount(part); ++i) {
        out << (i == 0 ? "" : ", ");
        appendLoop(out, result, result.polygons.loop(part, i));
    }
    out << ')';
}

constexpr std::uint32_t kNone = 0xffffffffU;

/// An edge of the outlines between vertices a < b.
struct OutlineEdge
{
    std::uint32_t a;
    std::uint32_t b;
    std::int32_t beside; ///< parts beside it, 1 or 2
};

std::vector<OutlineEdge> outlineEdges(const Polygons& polygons)
{
    std::vector<OutlineEdge> edges;
    for (std::size_t p = 0; p < polygons.size(); ++p) {
        for (std::size_t i = 0; i < polygons.loopCount(p); ++i) {
            const auto loop = polygons.loop(p, i);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const auto [a, b] = std::minmax(loop[k], loop[(k + 1) % loop.size()]);
                edges.push_back({a, b, 1});
            }
        }
    }
    std::sort(edges.begin(), edges.end(), [](const OutlineEdge& e, const OutlineEdge& f) {
        return std::pair(e.a, e.b) < std::pair(f.a, f.b);
    });
    std::vector<OutlineEdge> different;
    for (const OutlineEdge& edge : edges) {
        if (!different.empty() && different.back().a == edge.a && different.back().b == edge.b) {
            different.back().beside = 2;
        }
        else {
            different.push_back(edge);
        }
    }
    return different;
}

double twiceArea(const Triangulation& t, std::uint32_t triangle)
{
    const auto& v = t.triangles[triangle].v;
    return cross(t.points[v[1]] - t.points[v[0]], t.points[v[2]] - t.points[v[0]]);
}

Vec2 centerOf(const Triangulation& t, std::uint32_t triangle)
{
    const auto& v = t.triangles[triangle].v;
    const Vec2 a = t.points[v[0]];
    return a + (1.0 / 3.0) * ((t.points[v[1]] - a) + (t.points[v[2]] - a));
}

/// A point in each connected set of triangles that the parts enclose: in its largest triangle.
std::vector<Vec2> holesOf(const OverlayResult& result)
{
    const Triangulation& t = result.recovered.triangulation;
    std::vector<std::uint8_t> reached(t.triangles.size(), 0);
    std::vector<std::uint32_t> stack;
    std::vector<Vec2> holes;
    for (std::uint32_t seed = 0; seed < t.triangles.size(); ++seed) {
        const auto isOpen = [&](std::uint32_t triangle) {
            return reached[triangle] == 0 && !t.isDead(triangle)
                && result.parts.partOfTriangle[triangle] == BooleanParts::kNoPart;
        };
        if (!isOpen(seed)) {
            continue;
        }
        bool outside = false;
        std::uint32_t largest = seed;
        reached[seed] = 1;
        stack.push_back(seed);
        while (!stack.empty()) {
            const std::uint32_t triangle = stack.back();
            stack.pop_back();
            outside = outside || t.isGhost(triangle);
            if (!outside && twiceArea(t, triangle) > twiceArea(t, largest)) {
                largest = triangle;
            }
            for (std::uint32_t i = 0; i < 3; ++i) {
                const std::uint32_t next =
                    Topology::triangleOf(t.twin(Topology::halfEdge(triangle, i)));
                if (isOpen(next)) {
                    reached[next] = 1;
                    stack.push_back(next);
                }
            }
        }
        if (!outside) {
            holes.push_back(centerOf(t, largest));
        }
    }
    return holes;
}

void appendRegions(TextBuilder& out, const OverlayResult& result)
{
    const Triangulation& t = result.recovered.triangulation;
    const auto& parts = result.parts.parts;
    if (parts.empty() || parts.front().operands == OperandSets::kEmpty) {
        return;
    }
    std::vector<std::uint32_t> largest(parts.size(), kNone);
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        const std::uint32_t part = result.parts.partOfTriangle[i];
        if (part != BooleanParts::kNoPart
            && (largest[part] == kNone || twiceArea(t, i) > twiceArea(t, largest[part]))) {
            largest[part] = i;
        }
    }
    out << parts.size() << '\n';
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const Vec2 inside = centerOf(t, largest[p]);
        const std::size_t number = parts[p].owner.valid() ? parts[p].owner.index() : p;
        out << p + 1 << ' ' << inside.x << ' ' << inside.y << ' ' << number + 1 << " -1\n";
    }
}

} // namespace

std::vector<OverlayLine> linesOf(const OverlayResult& result, BooleanOperation operation)
{
    const auto& parts = result.parts.parts;
    std::vector<OverlayLine> lines;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const bool joins = p > 0 && operation != BooleanOperation::Cells
            && parts[p].owner == parts[p - 1].owner;
        if (joins) {
            lines.back().endPart = p + 1;
        }
        else {
            lines.push_back({p, p + 1});
        }
    }
    return lines;
}

std::string formatWkt(const OverlayResult& result, BooleanOperation operation)
{
    const std::vector<OverlayLine> lines = linesOf(result, operation);
    TextBuilder out;
    out.reserve(40 * result.polygons.vertices.size() + 64);
    for (const OverlayLine& line : lines) {
        const bool single = line.endPart == line.firstPart + 1;
        out << (single ? "POLYGON " : "MULTIPOLYGON (");
        for (std::size_t p = line.firstPart; p < line.endPart; ++p) {
            out << (p == line.firstPart ? "" : ", ");
            appendPolygon(out, result, p);
        }
        out << (single ? "\n" : ")\n");
    }
    return lines.empty() ? "GEOMETRYCOLLECTION EMPTY\n" : out.take();
}

std::string formatPoly(const OverlayResult& result)
{
    const std::vector<OutlineEdge> edges = outlineEdges(result.polygons);
    std::vector<std::uint32_t> numberOf(result.recovered.triangulation.points.size(), 0);
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t v : result.polygons.vertices) {
        if (numberOf[v] == 0) {
            vertices.push_back(v);
            numberOf[v] = static_cast<std::uint32_t>(vertices.size());
        }
    }
    const auto& curves = result.input.curves;
    const bool marked = std::ranges::any_of(curves, [](const auto& c) { return c.marker != 0; });
    TextBuilder out;
    out.reserve(50 * (vertices.size() + edges.size()) + 4096);
    out << "# Overlay by Tessera " << TESSERA_VERSION << '\n' << vertices.size() << " 2 0 0\n";
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec2 p = result.point(vertices[i]);
        out << i + 1 << ' ' << p.x << ' ' << p.y << '\n';
    }
    out << edges.size() << " 1\n";
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const OutlineEdge& edge = edges[e];
        const std::int32_t marker =
            marked ? curves[result.curvesOn(edge.a, edge.b).front().index()].marker : edge.beside;
        out << e + 1 << ' ' << numberOf[edge.a] << ' ' << numberOf[edge.b] << ' ' << marker
            << '\n';
    }
    const std::vector<Vec2> holes = holesOf(result);
    out << holes.size() << '\n';
    for (std::size_t h = 0; h < holes.size(); ++h) {
        out << h + 1 << ' ' << holes[h].x << ' ' << holes[h].y << '\n';
    }
    appendRegions(out, result);
    return out.take();
}

} // namespace tessera
