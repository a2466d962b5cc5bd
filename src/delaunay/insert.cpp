// SPDX-License-Identifier: MIT

// Insertion of single points (the algorithm and its proof: cavity.h).

#include "delaunay/cavity.h"
#include "delaunay/delaunay.h"
#include "delaunay/start.h"

#include <algorithm>

namespace tessera
{
namespace
{

/// The vertices so far are collinear and p is off their line: a fan from p over them.
void makeFan(Triangulation& t, std::uint32_t apex)
{
    std::vector<std::uint32_t> line;
    for (std::uint32_t v = 1; v < apex; ++v) {
        line.push_back(v);
    }
    std::sort(line.begin(), line.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Vec2 p = t.points[a];
        const Vec2 q = t.points[b];
        return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    startTriangles(t, line[0], line[1], apex);
    Cavity<CavityMode::General> cavity(t);
    for (std::size_t i = 2; i < line.size(); ++i) {
        const Location where = locate(t, t.points[line[i]], t.incident[line[i - 1]]);
        cavity.insert(line[i], where.kind == Location::Kind::Edge, where.edge);
    }
}

/// Without triangles: all vertices are collinear. O(n).
std::uint32_t insertWithoutTriangles(Triangulation& t, Vec2 p)
{
    for (std::uint32_t v = 1; v < t.points.size(); ++v) {
        if (t.points[v] == p) {
            return v;
        }
    }
    const std::uint32_t vertex = appendVertex(t, p);
    if (vertex >= 3 && orient2d(t.points[1], t.points[2], p) != 0) {
        makeFan(t, vertex);
    }
    return vertex;
}

} // namespace

std::uint32_t insertPointAt(Triangulation& t, Vec2 p, const Location& where)
{
    if (where.kind == Location::Kind::Vertex) {
        return t.origin(where.edge);
    }
    const std::uint32_t vertex = appendVertex(t, p);
    Cavity<CavityMode::General> cavity(t);
    cavity.insert(vertex, p, where.kind == Location::Kind::Edge, where.edge);
    return vertex;
}

std::uint32_t insertPoint(Triangulation& t, Vec2 p, HalfEdge hint)
{
    if (t.triangles.empty()) {
        return insertWithoutTriangles(t, p);
    }
    return insertPointAt(t, p, locate(t, p, hint));
}

} // namespace tessera
