// SPDX-License-Identifier: MIT
//
// Edits of a WorkingMesh.
//
// A subsegment is split at a point of its true curve, which lies beside the chord. The point is
// inserted like any other, on the side where it is, while the chord stays constrained; the
// conflict region cannot reach across the chord, so afterwards the triangle (a, b, p) exists if
// the old triangle on that side was in conflict with p. Then the constraint moves from a-b to
// a-p-b: three bits change and that triangle changes sides. Nothing else is touched, therefore the
// result is valid whatever p is. If the old triangle was not in conflict, something may lie between
// chord and curve, and the split is refused before anything has changed.

#include "refine/mesh_editor.h"

#include "predicates/predicates.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tessera
{

namespace
{
constexpr int kWalkLimit = 20000;
constexpr int kBisections = 40;
constexpr double kSpacingGrowth = 0.5; ///< per distance from the end of a subsegment
constexpr double kInfinite = std::numeric_limits<double>::infinity();
} // namespace

MeshEditor::MeshEditor(WorkingMesh& mesh)
    : mesh_(mesh)
{
    mesh_.regionOfTriangle.resize(mesh_.triangulation.triangles.size(), WorkingMesh::kOutside);
    wholeRoots_.reserve(mesh_.edges.size());
    for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
        const ConstrainedEdge& edge = mesh_.edges[i];
        enter(static_cast<std::uint32_t>(i));
        if (edge.useSet >= rootEnds_.size()) {
            rootEnds_.resize(edge.useSet + 1);
        }
        if (!isSplit(edge.a)) {
            rootEnds_[edge.useSet].a = edge.a;
        }
        if (!isSplit(edge.b)) {
            rootEnds_[edge.useSet].b = edge.b;
        }
    }
    shortestAt_.assign(mesh_.triangulation.points.size(), kInfinite);
    for (const Ends& ends : rootEnds_) {
        if (ends.a != kNone && ends.b != kNone) {
            const double l = distance(mesh_.triangulation.points[ends.a],
                                      mesh_.triangulation.points[ends.b]);
            shortestAt_[ends.a] = std::min(shortestAt_[ends.a], l);
            shortestAt_[ends.b] = std::min(shortestAt_[ends.b], l);
        }
    }
}

double MeshEditor::placeAlong(std::uint32_t root, Vec2 p) const
{
    const Vec2 start = mesh_.triangulation.points[rootEnds_[root].a];
    const Vec2 along = mesh_.triangulation.points[rootEnds_[root].b] - start;
    const double whole = length(along);
    return std::clamp(dot(p - start, along) / whole, 0.0, whole);
}

double MeshEditor::spacingBeside(std::uint32_t root, Vec2 p) const
{
    double spacing = kInfinite;
    for (const std::uint32_t end : {rootEnds_[root].a, rootEnds_[root].b}) {
        if (end != kNone) {
            const double away = distance(mesh_.triangulation.points[end], p);
            spacing = std::min(spacing, shortestAt_[end] + kSpacingGrowth * away);
        }
    }
    return spacing;
}

double MeshEditor::spacingAt(std::uint32_t v) const
{
    const std::uint32_t root = rootOfVertex(v);
    if (root != kNone) {
        return spacingBeside(root, mesh_.triangulation.points[v]);
    }
    return v < shortestAt_.size() ? shortestAt_[v] : kInfinite;
}

/// Makes the record known to findRecord().
void MeshEditor::enter(std::uint32_t record)
{
    const ConstrainedEdge& edge = mesh_.edges[record];
    const std::uint32_t last = std::max(edge.a, edge.b);
    if (last >= pieces_.size()) {
        pieces_.resize(std::max<std::size_t>(last + 1, triangulation().points.size()));
    }
    if (isSplit(edge.a)) {
        pieces_[edge.a].root = edge.useSet;
        pieces_[edge.a].after = record;
    }
    if (isSplit(edge.b)) {
        pieces_[edge.b].root = edge.useSet;
        pieces_[edge.b].before = record;
    }
    if (!isSplit(edge.a) && !isSplit(edge.b)) {
        wholeRoots_[keyOf(edge.a, edge.b)] = record;
    }
}

std::uint64_t MeshEditor::keyOf(std::uint32_t a, std::uint32_t b)
{
    return (std::uint64_t {std::min(a, b)} << 32U) | std::max(a, b);
}

std::uint32_t MeshEditor::findRecord(std::uint32_t a, std::uint32_t b) const
{
    if (rootOfVertex(a) == kNone) {
        std::swap(a, b);
    }
    if (rootOfVertex(a) == kNone) {
        const auto found = wholeRoots_.find(keyOf(a, b));
        return found == wholeRoots_.end() ? kNone : found->second;
    }
    const Pieces& pieces = pieces_[a];
    if (pieces.before != kNone && mesh_.edges[pieces.before].a == b) {
        return pieces.before;
    }
    return pieces.after != kNone && mesh_.edges[pieces.after].b == b ? pieces.after : kNone;
}

MeshEditor::RootSide MeshEditor::rootSideOf(HalfEdge edge) const
{
    const std::uint32_t from = triangulation().origin(edge);
    const std::uint32_t record = findRecord(from, triangulation().destination(edge));
    if (record == kNone) {
        return {kNone, 0};
    }
    return {mesh_.edges[record].useSet, mesh_.edges[record].a == from ? 0 : 1};
}

HalfEdge MeshEditor::anyEdge() const
{
    std::uint32_t v = 1;
    while (triangulation().incident[v] == Topology::kDead) {
        ++v;
    }
    return triangulation().incident[v];
}

VisibleWalk MeshEditor::walk(HalfEdge start, Vec2 p) const
{
    const Triangulation& t = triangulation();
    HalfEdge entry = start;
    bool first = true;
    for (int step = 0; step < kWalkLimit; ++step) {
        if (t.isGhost(Topology::triangleOf(entry))) {
            return {VisibleWalk::Kind::Outside, {Location::Kind::Triangle, entry}};
        }
        HalfEdge crossed = Topology::kDead;
        HalfEdge zero[3];
        int zeros = 0;
        HalfEdge h = entry;
        for (int i = 0; i < 3; ++i, h = Topology::next(h)) {
            if (i == 0 && !first) {
                continue; // p is strictly on this side of the edge that was crossed
            }
            const int side = orient2d(t.points[t.origin(h)], t.points[t.destination(h)], p);
            if (side < 0) {
                crossed = h;
                break;
            }
            if (side == 0) {
                zero[zeros++] = h;
            }
        }
        if (crossed == Topology::kDead) {
            if (zeros == 0) {
                return {VisibleWalk::Kind::Reached, {Location::Kind::Triangle, entry}};
            }
            if (zeros == 1) {
                return {VisibleWalk::Kind::Reached, {Location::Kind::Edge, zero[0]}};
            }
            const bool inOrder = Topology::next(zero[0]) == zero[1];
            return {VisibleWalk::Kind::Reached,
                    {Location::Kind::Vertex, inOrder ? zero[1] : zero[0]}};
        }
        if (t.isConstrained(crossed)) {
            return {VisibleWalk::Kind::Blocked, {Location::Kind::Edge, crossed}};
        }
        entry = t.twin(crossed);
        first = false;
    }
    return {VisibleWalk::Kind::Lost, {Location::Kind::Triangle, entry}};
}

void MeshEditor::addVertex(std::uint32_t v, VertexOrigin origin)
{
    if (v >= mesh_.origin.size()) {
        mesh_.origin.resize(v + 1, VertexOrigin::Interior);
    }
    mesh_.origin[v] = origin;
    mesh_.regionOfTriangle.resize(triangulation().triangles.size(), WorkingMesh::kOutside);
}

void MeshEditor::paintStar(std::uint32_t v, std::uint32_t region)
{
    const Triangulation& t = triangulation();
    t.forEachAround(v, [&](HalfEdge h) {
        const std::uint32_t triangle = Topology::triangleOf(h);
        mesh_.regionOfTriangle[triangle] = t.isGhost(triangle) ? WorkingMesh::kOutside : region;
    });
}

std::uint32_t MeshEditor::insertInside(Vec2 p, const Location& where)
{
    const std::uint32_t region = mesh_.regionOfTriangle[Topology::triangleOf(where.edge)];
    const std::uint32_t v = insertPointAt(mesh_.triangulation, p, where);
    addVertex(v, VertexOrigin::Interior);
    paintStar(v, region);
    return v;
}

void MeshEditor::insertIsolated(std::uint32_t vertex, const Location& where)
{
    Triangulation& t = mesh_.triangulation;
    const std::uint32_t region = mesh_.regionOfTriangle[Topology::triangleOf(where.edge)];
    const std::uint32_t temporary = insertPointAt(t, t.points[vertex], where);
    t.incident[vertex] = t.incident[temporary];
    mesh_.regionOfTriangle.resize(t.triangles.size(), WorkingMesh::kOutside);
    HalfEdge h = t.incident[vertex];
    do {
        const std::uint32_t triangle = Topology::triangleOf(h);
        t.triangles[triangle].v[Topology::next3(Topology::sideOf(h))] = vertex;
        mesh_.regionOfTriangle[triangle] = region;
        h = t.nextAround(h);
    } while (h != t.incident[vertex]);
    t.points.pop_back();
    t.incident.pop_back();
}

/// The point of the edge whose distance from its end a (else b) is fraction of the chord.
MeshEditor::CurvePoint MeshEditor::pointOnEdge(const ConstrainedEdge& edge, bool fromA,
                                               double fraction) const
{
    const Vec2 a = triangulation().points[edge.a];
    const Vec2 b = triangulation().points[edge.b];
    const bool halve = fraction == 0.5;
    if (edge.geometry == nullptr) {
        const double s = fromA ? fraction : 1.0 - fraction;
        const Vec2 p = halve ? midpoint(a, b) : fromA ? a + s * (b - a) : b + fraction * (a - b);
        return {p, edge.ta + s * (edge.tb - edge.ta)};
    }
    const double target = fraction * distance(a, b);
    double low = edge.ta;
    double high = edge.tb;
    double t = 0.5 * (low + high);
    for (int i = 0; i < kBisections; ++i) {
        const Vec2 p = edge.geometry->point(t);
        // Halving: as far from b as from a.
        const double excess = halve ? distance(a, p) - distance(p, b)
            : fromA                 ? distance(a, p) - target
                                    : target - distance(b, p);
        if (std::fabs(excess) <= 1e-6 * target) {
            break;
        }
        (excess < 0.0 ? low : high) = t;
        t = 0.5 * (low + high);
    }
    return {edge.geometry->point(t), t};
}

bool MeshEditor::isInConflict(std::uint32_t triangle, Vec2 p) const
{
    const auto& v = triangulation().triangles[triangle].v;
    const auto& points = triangulation().points;
    return incircle(points[v[0]], points[v[1]], points[v[2]], p) > 0;
}

/// p lies strictly to the left of edge, the edge's own triangle is on that side.
std::uint32_t MeshEditor::insertBeside(HalfEdge edge, Vec2 p)
{
    Triangulation& t = mesh_.triangulation;
    const std::uint32_t a = t.origin(edge);
    const std::uint32_t b = t.destination(edge);
    const std::uint32_t near = Topology::triangleOf(edge);
    const std::uint32_t far = Topology::triangleOf(t.twin(edge));
    const std::uint32_t nearRegion = mesh_.regionOfTriangle[near];
    const std::uint32_t farRegion = mesh_.regionOfTriangle[far];
    Location where {Location::Kind::Triangle, edge};
    if (!t.isGhost(near)) {
        const VisibleWalk found = walk(edge, p);
        const bool usable = found.kind == VisibleWalk::Kind::Reached
            || found.kind == VisibleWalk::Kind::Outside;
        if (!usable || found.location.kind == Location::Kind::Vertex
            || (found.location.kind == Location::Kind::Edge
                && t.isConstrained(found.location.edge))
            || (Topology::triangleOf(found.location.edge) != near && !isInConflict(near, p))) {
            return kNone;
        }
        where = found.location;
    }
    const std::uint32_t v = insertPointAt(t, p, where);
    addVertex(v, VertexOrigin::SegmentSplit);
    paintStar(v, nearRegion);
    const HalfEdge chord = t.findEdge(a, b);
    mesh_.regionOfTriangle[Topology::triangleOf(chord)] = farRegion;
    t.setConstrained(chord, false);
    t.setConstrained(Topology::next(chord), true);
    t.setConstrained(Topology::prev(chord), true);
    suspects_.assign(1, chord);
    legalize(t, suspects_);
    return v;
}

std::uint32_t MeshEditor::insertOnEdge(HalfEdge edge, Vec2 p)
{
    Triangulation& t = mesh_.triangulation;
    const Vec2 a = t.points[t.origin(edge)];
    const Vec2 b = t.points[t.destination(edge)];
    if (p == a || p == b || !isFinite(p)) {
        return kNone;
    }
    const int side = orient2d(a, b, p);
    if (side != 0) {
        return insertBeside(side > 0 ? edge : t.twin(edge), p);
    }
    if (!strictlyBetween(a, b, p)) {
        return kNone;
    }
    const std::uint32_t left = mesh_.regionOfTriangle[Topology::triangleOf(edge)];
    const std::uint32_t right = mesh_.regionOfTriangle[Topology::triangleOf(t.twin(edge))];
    const std::uint32_t from = t.origin(edge);
    const std::uint32_t to = t.destination(edge);
    const std::uint32_t v = insertPointAt(t, p, {Location::Kind::Edge, edge});
    addVertex(v, VertexOrigin::SegmentSplit);
    // From v -> b counter-clockwise to v -> a lies the left side, then the right one.
    const HalfEdge toB = t.findEdge(v, to);
    const HalfEdge toA = t.findEdge(v, from);
    std::uint32_t region = left;
    HalfEdge h = toB;
    do {
        if (h == toA) {
            region = right;
        }
        const std::uint32_t triangle = Topology::triangleOf(h);
        mesh_.regionOfTriangle[triangle] = t.isGhost(triangle) ? WorkingMesh::kOutside : region;
        h = t.nextAround(h);
    } while (h != toB);
    return v;
}

void MeshEditor::replaceRecord(std::uint32_t record, std::uint32_t v, double parameter)
{
    ConstrainedEdge second = mesh_.edges[record];
    if (!isSplit(second.a) && !isSplit(second.b)) {
        wholeRoots_.erase(keyOf(second.a, second.b));
    }
    mesh_.edges[record].b = v;
    mesh_.edges[record].tb = parameter;
    second.a = v;
    second.ta = parameter;
    mesh_.edges.push_back(second);
    enter(record);
    enter(static_cast<std::uint32_t>(mesh_.edges.size() - 1));
}

std::uint32_t MeshEditor::splitEdge(HalfEdge edge, double fraction)
{
    const std::uint32_t record
        = findRecord(triangulation().origin(edge), triangulation().destination(edge));
    if (record == kNone) {
        return kNone;
    }
    const ConstrainedEdge& constrained = mesh_.edges[record];
    const bool forward = constrained.a == triangulation().origin(edge);
    const CurvePoint on = pointOnEdge(constrained, forward, fraction);
    const std::uint32_t v = insertOnEdge(edge, on.point);
    if (v != kNone) {
        replaceRecord(record, v, on.parameter);
    }
    return v;
}

} // namespace tessera
