// SPDX-License-Identifier: MIT

// Boundary recovery (paper, section 2) with crossings taken from the original segments.
//
// Each segment is followed from its start to its end. From a vertex of its chain the way toward the
// end leads to the next vertex, which is
//   - an input vertex on the segment (an exact zero against the original line), or
//   - the crossing with the first constrained edge in the way: the crossing of the two *original*
//     segments, correctly rounded (predicates/crossing.h). It splits the edge, or is one of its
//     ends or the vertex at hand; or, rounded, it lies outside the two triangles beside the edge:
//     then it is inserted wherever it falls, and the pieces of both segments are recovered again.
// The piece between the two vertices is then put in:
//   Cavity   the triangles that it crosses are removed, and both polygons beside it re-meshed
//            (mesh_edit.h);
//   Steiner  a Steiner point at every intersection of the piece with a mesh edge, then each of them
//            deleted (steiner_points.h).
// In the paper's words: the Steiner points on boundary x boundary, which stay, are made here, the
// others there. The strategies share every decision, and the mesh after a piece is the same up to
// cocircular ties, whichever has put it in.
//
// Invariant: every vertex of a chain is the correct rounding of a true point of its segment. Since
// rounding is monotone, a chain never goes backward in x or y, and lies within half a unit in the
// last place of the segment.
//
// Ill-conditioned: a piece meets a constraint that the original does not cross, or crosses again;
// an order along a segment that rounding turned over; a vertex exactly on a piece although its
// segment does not pass it; a vertex where segments meet that cross elsewhere; in the end, a
// triangle with a rounded vertex so thin that rounding could have turned it over. All these end the
// run; snap rounding takes over (snap_rounding.h). Vertices and segments whose true distances exceed
// some units in the last place of the greatest coordinate never cause them.
//
// Otherwise the result is the arrangement of the original segments, whatever their order and the
// strategy; its vertices are those of the input and the rounded crossings of all pairs.
// Proof: the least height of a triangle is the least distance of a vertex from an edge that does not
// end there: the way from one to the other leaves the vertex through the opposite side, which is as
// near, or along a side, and then another height is less. So every vertex is farther from every
// piece that does not end there than rounding has moved their segments, and segments whose chains
// share no vertex do not cross. Those that share one cross there (crossingsAreTrue()).
//
// It ends: every step adds an incidence (segment, vertex), and there are finitely many crossings.
// Cost: the triangles crossed by the pieces, and a constant number of flips and exact signs each.

#include "recover/boundary_recovery.h"

#include "delaunay/delaunay.h"
#include "predicates/crossing.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <cmath>

namespace tessera
{
namespace
{

/// Whether the closed segments ab and cd meet in exactly one point.
bool meetInPoint(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    const int sideC = orient2d(a, b, c);
    const int sideD = orient2d(a, b, d);
    return sideC * sideD <= 0 && (sideC != 0 || sideD != 0)
        && orient2d(c, d, a) * orient2d(c, d, b) <= 0;
}

/// Whether lines in these directions, each coordinate rounded once, are not parallel; quick.
bool surelyCross(Vec2 u, Vec2 v)
{
    const double left = u.x * v.y;
    const double right = u.y * v.x;
    return std::fabs(left - right) > 0x1p-50 * (std::fabs(left) + std::fabs(right));
}

/// v is zero or points the same way as direction, which is not backward in either axis.
bool sameWay(double v, double direction)
{
    return v == 0.0 || (v > 0.0 ? direction > 0.0 : direction < 0.0);
}

bool inBox(Vec2 a, Vec2 b, Vec2 p)
{
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y
        && p.y <= std::max(a.y, b.y);
}

/// With all coordinates at most 1, a true point moves by at most 2^-54 in x and in y when rounded. So
/// the cross product d x e of three points of one line is at most 2^-52 (|d.x| + |d.y|) afterwards;
/// computing it adds less than that. As a height of triangles, that is 8 times what moving all three
/// corners does.
constexpr double kFlat = 0x1p-49;

/// The factor for that.
double unscalingFactor(const Triangulation& mesh)
{
    double greatest = 0.0;
    for (std::size_t v = 1; v < mesh.points.size(); ++v) {
        greatest
            = std::max({greatest, std::fabs(mesh.points[v].x), std::fabs(mesh.points[v].y)});
    }
    return greatest > 0.0 ? 1.0 / greatest : 1.0;
}

} // namespace

BoundaryRecovery::BoundaryRecovery(Triangulation& mesh, std::span<const Segment> segments,
                                   RecoveryStrategy strategy, RecoveryObserver* observer)
    : mesh_(mesh)
    , segments_(segments)
    , strategy_(strategy)
    , firstCrossing_(static_cast<std::uint32_t>(mesh.points.size()))
    , unscale_(unscalingFactor(mesh))
    , chains_(segments.size(), mesh.points.size())
    , edit_(mesh)
    , steinerPoints_(mesh, edit_, report_, observer)
{}

bool BoundaryRecovery::run(Execution& execution)
{
    for (std::uint32_t s = 0; s < segments_.size(); ++s) {
        if (s % 64 == 0) {
            execution.report(static_cast<double>(s) / static_cast<double>(segments_.size()));
        }
        if (!recover(s)) {
            return false;
        }
    }
    if (!crossingsAreTrue()) {
        return false;
    }
    if (const std::vector<std::uint32_t> newName = edit_.closeGaps(); !newName.empty()) {
        chains_.renameVertices(newName, mesh_.points.size());
    }
    return trianglesAreTrue();
}

bool BoundaryRecovery::recover(std::uint32_t s)
{
    std::uint32_t from = segments_[s].a;
    chains_.append(s, from);
    while (from != segments_[s].b) {
        const Step step = next(s, from);
        const std::uint32_t to
            = step.kind == Step::Kind::Edge ? cross(s, from, step.edge) : step.vertex;
        if (to == from) {
            continue; // the other constraint has been led through this vertex
        }
        if (to == kNone || !putIn(from, to)) {
            return false;
        }
        chains_.append(s, to);
        if (!pickUpTouches(from, to)) {
            return false;
        }
        from = to;
    }
    return true;
}

/// Makes the piece between two vertices a constrained edge. False if something is in the way.
bool BoundaryRecovery::putIn(std::uint32_t x, std::uint32_t y)
{
    return strategy_ == RecoveryStrategy::Steiner ? steinerPoints_.constrain(x, y)
                                                  : edit_.constrain(x, y);
}

BoundaryRecovery::Step BoundaryRecovery::next(std::uint32_t s, std::uint32_t from)
{
    const std::uint32_t target = segments_[s].b;
    const Departure departure = depart(mesh_, from, target);
    if (departure.kind == Departure::Kind::Along) {
        return atVertex(s, mesh_.destination(departure.edge));
    }
    if (departure.kind == Departure::Kind::None) {
        return {};
    }
    // A chain vertex that was rounded lies beside the line: vertices that the segment passes may
    // stand on either side of the way from there.
    const bool beside = from != segments_[s].a;
    HalfEdge edge = departure.edge;
    for (const HalfEdge spoke : {Topology::prev(edge), mesh_.twin(Topology::next(edge))}) {
        const std::uint32_t vertex = mesh_.destination(spoke);
        if ((beside && isInput(vertex) && onLine(s, vertex) && isAhead(s, from, vertex))
            || followsOverlap(s, from, spoke)) {
            return {Step::Kind::Vertex, vertex};
        }
    }
    const Vec2 origin = mesh_.points[from];
    const Vec2 goal = mesh_.points[target];
    while (!mesh_.isConstrained(edge)) {
        const HalfEdge entered = mesh_.twin(edge);
        const std::uint32_t apex = mesh_.apex(entered);
        if (apex == target) {
            return {Step::Kind::Vertex, apex};
        }
        if (apex == Topology::kInfinite) {
            return {};
        }
        const int side = orient2d(origin, goal, mesh_.points[apex]);
        if (side == 0) {
            return atVertex(s, apex);
        }
        if (beside && isInput(apex) && onLine(s, apex)) {
            return {Step::Kind::Vertex, apex};
        }
        edge = side > 0 ? Topology::next(entered) : Topology::prev(entered);
    }
    return {Step::Kind::Edge, kNone, edge};
}

/// The way leads exactly through the vertex.
BoundaryRecovery::Step BoundaryRecovery::atVertex(std::uint32_t s, std::uint32_t vertex)
{
    const bool passed = isInput(vertex) ? onLine(s, vertex) : meetsAll(s, vertex, {});
    return passed ? Step {Step::Kind::Vertex, vertex} : Step {};
}

/// Whether the segment and each other one at the vertex meet there, in the sense of meetHere(); the
/// given pieces are known to. Where many segments run through one true point, a new one has to be
/// compared with two of them only.
bool BoundaryRecovery::meetsAll(std::uint32_t s, std::uint32_t vertex,
                                std::span<const Chains::Use> known)
{
    if (!isInput(vertex) && chains_.degree(vertex) > kFewSegments) {
        const auto [at, isNew] = concurrent_.try_emplace(vertex);
        if (isNew) {
            at->second = findConcurrent(vertex);
        }
        const TwoSegments two = at->second;
        if (two.first != kNone
            && passesCrossing(start(two.first), end(two.first), start(two.second),
                              end(two.second), start(s), end(s))) {
            return true;
        }
        at->second = {}; // from now on not all do
    }
    return !chains_.anyAt(vertex, [&](std::uint32_t other) {
        const bool isKnown = std::any_of(known.begin(), known.end(), [&](const Chains::Use& use) {
            return use.segment == other;
        });
        return !isKnown && other != s && !meetHere(s, other, vertex);
    });
}

/// Two segments at a crossing vertex in whose true crossing all others there cross them.
BoundaryRecovery::TwoSegments BoundaryRecovery::findConcurrent(std::uint32_t vertex) const
{
    TwoSegments two;
    const auto isOther = [&](std::uint32_t s) {
        if (two.first == kNone) {
            two.first = s;
        }
        else if (two.second == kNone) {
            const int sideA = orient2d(start(two.first), end(two.first), start(s));
            const int sideB = orient2d(start(two.first), end(two.first), end(s));
            two.second = sideA != 0 || sideB != 0 ? s : kNone;
        }
        else {
            return !passesCrossing(start(two.first), end(two.first), start(two.second),
                                   end(two.second), start(s), end(s));
        }
        return false;
    };
    const bool any = chains_.anyAt(vertex, isOther);
    return any || two.second == kNone ? TwoSegments {} : two;
}

bool BoundaryRecovery::onLine(std::uint32_t s, std::uint32_t vertex) const
{
    return orient2d(start(s), end(s), mesh_.points[vertex]) == 0;
}

bool BoundaryRecovery::isAhead(std::uint32_t s, std::uint32_t from, std::uint32_t vertex) const
{
    const Vec2 step = mesh_.points[vertex] - mesh_.points[from];
    const Vec2 direction = end(s) - start(s);
    return vertex != from && sameWay(step.x, direction.x) && sameWay(step.y, direction.y);
}

/// Whether the triangle of the three vertices is so flat that rounded points of one line could make
/// it. No decision on its own.
bool BoundaryRecovery::isFlat(std::uint32_t x, std::uint32_t y, std::uint32_t z) const
{
    const Vec2 d = unscale_ * (mesh_.points[y] - mesh_.points[x]);
    const Vec2 e = unscale_ * (mesh_.points[z] - mesh_.points[x]);
    return std::fabs(tessera::cross(d, e)) <= kFlat * (std::fabs(d.x) + std::fabs(d.y));
}

/// Whether the constrained edge belongs to a segment on the same line: then this one goes along.
bool BoundaryRecovery::followsOverlap(std::uint32_t s, std::uint32_t from, HalfEdge spoke) const
{
    const std::uint32_t vertex = mesh_.destination(spoke);
    if (!mesh_.isConstrained(spoke) || !isFlat(from, segments_[s].b, vertex)
        || !isAhead(s, from, vertex)) {
        return false;
    }
    bool follows = false;
    chains_.forEachUse(from, vertex, [&](const Chains::Use& use) {
        const Segment& other = segments_[use.segment];
        follows = follows || (onLine(s, other.a) && onLine(s, other.b));
    });
    return follows;
}

/// Crosses the segment, coming from a vertex of its chain, with all constraints on the edge.
/// Returns its next vertex, `from` if only the others have changed, kNone if ill-conditioned.
std::uint32_t BoundaryRecovery::cross(std::uint32_t s, std::uint32_t from, HalfEdge edge)
{
    Crossing crossing;
    if (!findCrossing(s, edge, crossing)) {
        return kNone;
    }
    const Vec2 p = crossing.point;
    const std::uint32_t u = mesh_.origin(edge);
    const std::uint32_t v = mesh_.destination(edge);
    const Vec2 direction = end(s) - start(s);
    const Vec2 step = p - mesh_.points[from];
    if (!inBox(mesh_.points[u], mesh_.points[v], p) || !sameWay(step.x, direction.x)
        || !sameWay(step.y, direction.y)) {
        return kNone;
    }
    for (const std::uint32_t end : {u, v}) {
        if (p == mesh_.points[end]) {
            if (isInput(end)) {
                doubtful_.push_back(end);
            }
            return isInput(end) || meetsAll(s, end, uses_) ? end : kNone;
        }
    }
    if (!edit_.splitsEdge(edge, p)) {
        return crossBeside(u, v, edge, crossing);
    }
    const std::uint32_t vertex = edit_.splitEdge(edge, p);
    countCrossing(vertex, crossing.residual);
    leadThrough(vertex);
    return vertex;
}

/// The one crossing of the segment with all segments on the edge, which uses_ then has. False if
/// there is none: they do not cross, or not in one point. Those on the edge share two vertices, so
/// that they do not cross each other.
bool BoundaryRecovery::findCrossing(std::uint32_t s, HalfEdge edge, Crossing& crossing)
{
    uses_.clear();
    chains_.forEachUse(mesh_.origin(edge), mesh_.destination(edge),
                       [this](const Chains::Use& use) { uses_.push_back(use); });
    bool first = true;
    for (const Chains::Use& use : uses_) {
        const Vec2 c = start(use.segment);
        const Vec2 d = end(use.segment);
        if (!meetInPoint(start(s), end(s), c, d)) {
            return false;
        }
        const Crossing candidate = crossLines(start(s), end(s), c, d);
        if (!first && !(candidate.point == crossing.point)) {
            return false;
        }
        crossing = candidate;
        first = false;
    }
    return !first;
}

/// The crossing is outside the two triangles beside the edge: into the mesh wherever it falls.
std::uint32_t BoundaryRecovery::crossBeside(std::uint32_t u, std::uint32_t v, HalfEdge edge,
                                            const Crossing& crossing)
{
    edit_.release(edge);
    const Location where = locate(mesh_, crossing.point, mesh_.incident[u]);
    std::uint32_t vertex = mesh_.origin(where.edge);
    if (where.kind != Location::Kind::Vertex) {
        if (where.kind == Location::Kind::Edge && mesh_.isConstrained(where.edge)) {
            return kNone;
        }
        vertex = edit_.insert(crossing.point, where);
        countCrossing(vertex, crossing.residual);
    }
    leadThrough(vertex);
    doubtful_.push_back(vertex);
    return edit_.constrain(u, vertex) && edit_.constrain(vertex, v) ? vertex : kNone;
}

/// Puts the vertex into the chains of all segments in uses_.
void BoundaryRecovery::leadThrough(std::uint32_t vertex)
{
    for (const Chains::Use& use : uses_) {
        chains_.insertAfter(use.before, vertex);
    }
}

void BoundaryRecovery::countCrossing(std::uint32_t vertex, Vec2 residual)
{
    ++report_.crossings;
    if (std::fabs(residual.x) + std::fabs(residual.y) > report_.maxDisplacement) {
        report_.maxDisplacement = std::max(report_.maxDisplacement, length(residual));
    }
    if (strategy_ == RecoveryStrategy::Steiner) {
        steinerPoints_.countInserted(vertex);
    }
}

/// A rounded chain may pass beside an input vertex on the line without crossing a triangle of it.
/// The vertex is then so close that it is the apex of a triangle at the piece x, y.
bool BoundaryRecovery::pickUpTouches(std::uint32_t x, std::uint32_t y)
{
    if (isInput(x) && isInput(y)) {
        return true;
    }
    const HalfEdge edge = edgeBetween(mesh_, x, y);
    for (const std::uint32_t z : {mesh_.apex(edge), mesh_.apex(mesh_.twin(edge))}) {
        if (z != Topology::kInfinite && isInput(z) && isFlat(x, y, z) && touches(x, y, z)) {
            leadThrough(z);
            if (!chains_.used(x, y)) {
                edit_.release(edge);
            }
            return edit_.constrain(x, z) && edit_.constrain(z, y) && pickUpTouches(x, z)
                && pickUpTouches(z, y);
        }
    }
    return true;
}

/// Collects in uses_ the segments on the edge x, y that pass z in between.
bool BoundaryRecovery::touches(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
    uses_.clear();
    chains_.forEachUse(x, y, [&](const Chains::Use& use) {
        const std::uint32_t before = use.forward ? x : y;
        const std::uint32_t after = use.forward ? y : x;
        if (onLine(use.segment, z) && isAhead(use.segment, before, z)
            && isAhead(use.segment, z, after)) {
            uses_.push_back(use);
        }
    });
    return !uses_.empty();
}

/// Whether segments that share a vertex cross there, if they cross at all. Otherwise three that
/// meet almost in one point have been led through one vertex, or through two or three, as their
/// order would have it. Looks at the vertices where that was not seen on the way.
bool BoundaryRecovery::crossingsAreTrue()
{
    std::sort(doubtful_.begin(), doubtful_.end());
    doubtful_.erase(std::unique(doubtful_.begin(), doubtful_.end()), doubtful_.end());
    return std::all_of(doubtful_.begin(), doubtful_.end(), [this](std::uint32_t vertex) {
        return !chains_.anyAt(vertex, [&](std::uint32_t s) {
            const bool isExact = isInput(vertex)
                && (segments_[s].a == vertex || segments_[s].b == vertex || onLine(s, vertex));
            return !isExact && !meetsAll(s, vertex, {});
        });
    });
}

/// Whether two segments through the vertex lie on one line or cross there. At an input vertex they
/// may also both be near it without meeting: the vertex is what it is.
bool BoundaryRecovery::meetHere(std::uint32_t s, std::uint32_t other, std::uint32_t vertex) const
{
    const Vec2 a = start(s);
    const Vec2 b = end(s);
    const Vec2 c = start(other);
    const Vec2 d = end(other);
    // A crossing vertex is inside both: their lines tell all.
    if (isInput(vertex) || !surelyCross(b - a, d - c)) {
        const int sideC = orient2d(a, b, c);
        const int sideD = orient2d(a, b, d);
        if ((sideC == 0 && sideD == 0) || (isInput(vertex) && !meetInPoint(a, b, c, d))) {
            return true;
        }
        if (sideC * sideD > 0) {
            return false;
        }
    }
    return crossLines(a, b, c, d).point == mesh_.points[vertex];
}

/// Whether no triangle is so thin that rounding its corners could turn it over. Triangles of exact
/// vertices do not count: they are what they are.
bool BoundaryRecovery::trianglesAreTrue() const
{
    const auto isRounded = [this](std::uint32_t vertex) {
        return !isInput(vertex)
            || std::binary_search(doubtful_.begin(), doubtful_.end(), vertex);
    };
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        if (!mesh_.isFinite(t)) {
            continue;
        }
        const auto& v = mesh_.triangles[t].v;
        const Vec2 d = unscale_ * (mesh_.points[v[1]] - mesh_.points[v[0]]);
        const Vec2 e = unscale_ * (mesh_.points[v[2]] - mesh_.points[v[0]]);
        const double longest = std::max({std::fabs(d.x) + std::fabs(d.y),
                                         std::fabs(e.x) + std::fabs(e.y),
                                         std::fabs(e.x - d.x) + std::fabs(e.y - d.y)});
        if (std::fabs(tessera::cross(d, e)) <= kFlat * longest
            && std::any_of(std::begin(v), std::end(v), isRounded)) {
            return false;
        }
    }
    return true;
}

} // namespace tessera
