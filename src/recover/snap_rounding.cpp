// SPDX-License-Identifier: MIT

// Snap rounding (J. D. Hobby, "Practical segment intersection with finite precision output",
// Computational Geometry 13, 1999), built up segment by segment as by L. Guibas and D. Marimont
// ("Rounding arrangements dynamically", IJCGA 8, 1998) over a constrained triangulation.
//
// A grid of square pixels is fixed. A pixel is hot if it contains an input point or a crossing of
// two segments; hot pixels may also be added at will. Every segment becomes the chain of the
// centers of all hot pixels that it meets, in its own order. All tests are exact on the original
// segments.
//
// Write a chain's piece as U -> V (points of the original segment in two hot pixels that it meets
// one after the other) becoming u -> v (their centers). The point at parameter t moves by a convex
// combination of u - U and v - V, hence by at most half a pixel in x and in y: a vector of the
// half-open square Q around 0, if seen from the piece to the segment.
//
// Lemma 1. No center h of a hot pixel lies inside a piece u -> v. The original point whose image is
// h would be h + q with q in Q, in the pixel of h: the segment meets that pixel, and h would be a
// vertex between u and v.
// Lemma 2. No two pieces cross. Move all points linearly from the originals to the images. Pieces U
// -> V of A and X -> Y of B that share no vertex do not meet at first (the pixel of a common point
// is hot, and would be a vertex of both). If they cross in the end, there is a first time at which
// an end of one, say U on its way to u, lies on the other. The original point of B that is there by
// then is u + (1 - t)(U - u) + t q with q in Q: a convex combination of two points of the pixel of
// u. So B meets that pixel and u is x or y; the pieces share a vertex after all. Straight pieces
// that share a vertex do not cross, and do not overlap unless they are equal (Lemma 1).
// Hence the chains meet at common vertices and along common pieces only.
//
// Termination. The hot pixels are those of the input points and of the crossings of pairs of
// original segments; nothing made here ever creates a new one. Segments are added one by one: first
// the pixels of their crossings with those already there become hot, one at a time, each led into
// all chains that meet it; then the segment's own chain is made. Both lemmas hold at every step, so
// that every piece can be put into the triangulation as an edge.
//
// Finding things. Whatever a segment s or a pixel has to do with is close: a crossing of s with B
// is within half a pixel of B's chain, and so is a pixel that B meets. So it is enough to look at
// the edges and vertices of triangles that come within one pixel of s, or of the pixel; these are
// connected through edges that do, and are collected from one of them. The closeness test is done
// in double precision with half a pixel to spare: coordinates are scaled to at most 1 and are
// multiples of the pixel, at least 2^-44 of the size, so that its error is below 2^-4 pixel.
// Cost: the triangles close to each segment, and the incidences (segment, hot pixel).

#include "recover/snap_rounding.h"

#include "delaunay/delaunay.h"
#include "predicates/bits.h"
#include "predicates/crossing.h"
#include "predicates/predicates.h"
#include "recover/mesh_edit.h"
#include "recover/pixel_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tessera
{
namespace
{

/// The vertices at hot pixels, by center: a hash table of vertex numbers with linear probing, at
/// most three quarters full.
class HotPixels
{
public:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    /// points: by vertex; may grow.
    explicit HotPixels(const std::vector<Vec2>& points)
        : points_(points)
        , slots_(64, kNone)
    {}

    /// The vertex at the center, kNone if the pixel is not hot.
    std::uint32_t find(Vec2 center) const { return slots_[slotOf(center)]; }

    /// Adds a vertex whose pixel was not hot.
    void add(std::uint32_t vertex)
    {
        if (4 * (count_ + 1) > 3 * slots_.size()) {
            const std::vector<std::uint32_t> old
                = std::exchange(slots_, std::vector<std::uint32_t>(2 * slots_.size(), kNone));
            for (const std::uint32_t v : old) {
                if (v != kNone) {
                    slots_[slotOf(points_[v])] = v;
                }
            }
        }
        slots_[slotOf(points_[vertex])] = vertex;
        ++count_;
    }

private:
    static std::size_t hash(Vec2 p)
    {
        const auto x = std::bit_cast<std::uint64_t>(p.x + 0.0); // -0 and 0 are one center
        const auto y = std::bit_cast<std::uint64_t>(p.y + 0.0);
        std::uint64_t h = x * 0x9e3779b97f4a7c15U ^ std::rotl(y, 32) * 0xc2b2ae3d27d4eb4fU;
        h ^= h >> 29;
        h *= 0xbf58476d1ce4e5b9U;
        return h ^ (h >> 32);
    }

    /// The slot with the center's vertex, or the free one where it belongs.
    std::size_t slotOf(Vec2 center) const
    {
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = hash(center) & mask;
        while (slots_[i] != kNone && !(points_[slots_[i]] == center)) {
            i = (i + 1) & mask;
        }
        return i;
    }

    const std::vector<Vec2>& points_;
    std::vector<std::uint32_t> slots_; ///< a power of two of them
    std::size_t count_ = 0;
};

/// The power of two that brings the greatest coordinate to 1/2 .. 1.
int scalingPower(std::span<const Vec2> points)
{
    double greatest = 0.0;
    for (const Vec2 p : points.subspan(1)) {
        greatest = std::max({greatest, std::fabs(p.x), std::fabs(p.y)});
    }
    return greatest > 0.0 ? -std::ilogb(greatest) - 1 : 0;
}

std::vector<Vec2> scaledPoints(std::span<const Vec2> points, int power)
{
    std::vector<Vec2> result(points.begin(), points.end());
    for (std::size_t i = 1; i < result.size(); ++i) {
        result[i] = scaled(result[i], power);
    }
    return result;
}

Box2 boxOf(std::span<const Vec2> points)
{
    Box2 box;
    for (const Vec2 p : points.subspan(1)) {
        box.add(p);
    }
    return box;
}

bool isApart(double v1, double v2, double slack)
{
    return (v1 > slack && v2 > slack) || (v1 < -slack && v2 < -slack);
}

/// False only if no point of the segment pq is within r, in x and in y, of a point of ab: no axis
/// separates them.
bool isClose(Vec2 a, Vec2 b, Vec2 p, Vec2 q, double r)
{
    if (std::max(a.x, b.x) + r < std::min(p.x, q.x) || std::max(p.x, q.x) + r < std::min(a.x, b.x)
        || std::max(a.y, b.y) + r < std::min(p.y, q.y)
        || std::max(p.y, q.y) + r < std::min(a.y, b.y)) {
        return false;
    }
    const Vec2 d = b - a;
    const Vec2 e = q - p;
    return !isApart(cross(d, p - a), cross(d, q - a), r * (std::fabs(d.x) + std::fabs(d.y)))
        && !isApart(cross(e, a - p), cross(e, b - p), r * (std::fabs(e.x) + std::fabs(e.y)));
}

class SnapRounder
{
public:
    SnapRounder(std::span<const Vec2> points, std::span<const Segment> segments,
                Execution& execution)
        : power_(scalingPower(points))
        , input_(scaledPoints(points, power_))
        , segments_(segments)
        , execution_(execution)
        , box_(boxOf(input_))
        , grid_(box_)
        , hot_(mesh_.points)
        , chains_(segments.size(), points.size())
        , edit_(mesh_)
    {
        makeMesh();
    }

    SnapResult run()
    {
        for (std::uint32_t s = 0; s < segments_.size(); ++s) {
            if (s % 16 == 0) {
                execution_.report(static_cast<double>(s) / static_cast<double>(segments_.size()));
            }
            addSegment(s);
        }
        return makeResult();
    }

private:
    static constexpr std::uint32_t kNone = HotPixels::kNone;
    /// In pixels: one, and half of one for rounding.
    static constexpr double kReach = 1.5;

    /// A piece u, v of a segment, to be led through a new vertex.
    struct Through
    {
        std::uint32_t u;
        std::uint32_t v;
        std::uint32_t before; ///< the segment's node at u or v
    };

    Vec2 start(std::uint32_t s) const { return input_[segments_[s].a]; }
    Vec2 end(std::uint32_t s) const { return input_[segments_[s].b]; }

    /// The pixels of all input points, inside a rectangle that is far enough from all of them.
    void makeMesh()
    {
        std::vector<Vec2> centers {};
        for (const Vec2 p : std::span(input_).subspan(1)) {
            centers.push_back(grid_.centerOf(p));
            maxDisplacement_ = std::max(maxDisplacement_, distance(p, centers.back()));
        }
        const double margin
            = std::max({box_.max.x - box_.min.x, box_.max.y - box_.min.y, 8.0 * grid_.side()});
        const Vec2 low = grid_.centerOf(box_.min - Vec2 {margin, margin});
        const Vec2 high = grid_.centerOf(box_.max + Vec2 {margin, margin});
        for (const Vec2 corner : {low, Vec2 {high.x, low.y}, high, Vec2 {low.x, high.y}}) {
            centers.push_back(corner);
        }
        DelaunayResult delaunay = triangulate(centers, execution_);
        mesh_ = std::move(delaunay.triangulation);
        vertexOfInput_ = std::move(delaunay.vertexOfPoint);
        vertexOfInput_.insert(vertexOfInput_.begin(), Topology::kInfinite);
        firstAdded_ = static_cast<std::uint32_t>(mesh_.points.size());
        for (std::uint32_t v = 1; v < mesh_.points.size(); ++v) {
            hot_.add(v);
        }
    }

    void addSegment(std::uint32_t s)
    {
        collectClose(mesh_.incident[vertexOfInput_[segments_[s].a]], start(s), end(s));
        collectSegments(closeEdges_, s);
        std::vector<std::uint32_t> way = closeVertices_;
        heatCrossings(s, way);
        std::erase_if(way, [&](std::uint32_t v) {
            return !grid_.meets(start(s), end(s), mesh_.points[v]);
        });
        std::sort(way.begin(), way.end(), [&](std::uint32_t v, std::uint32_t w) {
            return PixelGrid::compareAlong(start(s), end(s), mesh_.points[v], mesh_.points[w]) < 0;
        });
        way.erase(std::unique(way.begin(), way.end()), way.end());
        for (std::size_t i = 0; i < way.size(); ++i) {
            chains_.append(s, way[i]);
            if (i > 0) {
                constrain(way[i - 1], way[i]);
            }
        }
        ++added_;
    }

    /// Collects in closeEdges_ the constrained edges, and in closeVertices_ the vertices, of all
    /// triangles that come within one pixel of the segment ab, which may be a point. `first`: a
    /// half-edge of one of them, or around a vertex of one.
    void collectClose(HalfEdge first, Vec2 a, Vec2 b)
    {
        closeEdges_.clear();
        closeVertices_.clear();
        ++round_;
        triangleSeen_.resize(mesh_.triangles.size(), 0);
        vertexSeen_.resize(mesh_.points.size(), 0);
        open_.clear();
        see(first);
        while (!open_.empty()) {
            const std::uint32_t t = open_.back();
            open_.pop_back();
            for (std::uint32_t i = 0; i < 3; ++i) {
                const HalfEdge edge = Topology::halfEdge(t, i);
                const std::uint32_t v = mesh_.apex(edge);
                if (vertexSeen_[v] != round_) {
                    vertexSeen_[v] = round_;
                    closeVertices_.push_back(v);
                }
                const HalfEdge twin = mesh_.twin(edge);
                if (isClose(a, b, mesh_.points[mesh_.origin(edge)],
                            mesh_.points[mesh_.destination(edge)], kReach * grid_.side())) {
                    // Seen from both sides, taken from one.
                    if (mesh_.isConstrained(edge) && edge < twin) {
                        closeEdges_.push_back(edge);
                    }
                    see(twin);
                }
            }
        }
    }

    void see(HalfEdge edge)
    {
        const std::uint32_t t = Topology::triangleOf(edge);
        if (triangleSeen_[t] != round_ && !mesh_.isGhost(t)) {
            triangleSeen_[t] = round_;
            open_.push_back(t);
        }
    }

    /// Collects in neighbors_ the segments on the edges.
    void collectSegments(const std::vector<HalfEdge>& edges, std::uint32_t s)
    {
        neighbors_.clear();
        segmentSeen_.resize(segments_.size(), kNone);
        for (const HalfEdge edge : edges) {
            if (neighbors_.size() == added_) {
                return;
            }
            chains_.forEachUse(mesh_.origin(edge), mesh_.destination(edge),
                               [&](const Chains::Use& use) {
                                   if (segmentSeen_[use.segment] != s) {
                                       segmentSeen_[use.segment] = s;
                                       neighbors_.push_back(use.segment);
                                   }
                               });
        }
    }

    /// Makes the pixels of all proper crossings of the segment with its neighbors hot, and adds
    /// those that were not to its way. In their order along it, as each is located from the last.
    void heatCrossings(std::uint32_t s, std::vector<std::uint32_t>& way)
    {
        const Vec2 a = start(s);
        const Vec2 b = end(s);
        centers_.clear();
        for (const std::uint32_t other : neighbors_) {
            const Vec2 c = start(other);
            const Vec2 d = end(other);
            // Ends on the other segment, and overlaps, have hot pixels from the beginning.
            if (orient2d(a, b, c) * orient2d(a, b, d) < 0
                && orient2d(c, d, a) * orient2d(c, d, b) < 0) {
                const Vec2 p = crossLines(a, b, c, d).point;
                const Vec2 center = grid_.centerOfCrossing(a, b, c, d, p);
                if (hot_.find(center) == kNone) {
                    centers_.push_back(center);
                    maxDisplacement_ = std::max(maxDisplacement_, distance(p, center));
                }
            }
        }
        std::sort(centers_.begin(), centers_.end(), [&](Vec2 p, Vec2 q) {
            return PixelGrid::compareAlong(a, b, p, q) < 0;
        });
        centers_.erase(std::unique(centers_.begin(), centers_.end()), centers_.end());
        std::uint32_t last = vertexOfInput_[segments_[s].a];
        for (const Vec2 center : centers_) {
            last = heat(center, mesh_.incident[last]);
            way.push_back(last);
        }
    }

    /// Makes a pixel hot and leads all chains that meet it through its center.
    std::uint32_t heat(Vec2 center, HalfEdge hint)
    {
        collectClose(locate(mesh_, center, hint).edge, center, center);
        through_.clear();
        for (const HalfEdge edge : closeEdges_) {
            collectThrough(mesh_.origin(edge), mesh_.destination(edge), center);
        }
        const auto vertex = static_cast<std::uint32_t>(mesh_.points.size());
        for (const Through& piece : through_) {
            chains_.insertAfter(piece.before, vertex);
        }
        through_.erase(std::unique(through_.begin(), through_.end(),
                                   [](const Through& p, const Through& q) {
                                       return p.u == q.u && p.v == q.v;
                                   }),
                       through_.end());
        for (const Through& piece : through_) {
            if (!chains_.used(piece.u, piece.v)) {
                edit_.release(edgeBetween(mesh_, piece.u, piece.v));
            }
        }
        edit_.insert(center, locate(mesh_, center, hint));
        hot_.add(vertex);
        for (const Through& piece : through_) {
            constrain(piece.u, vertex);
            constrain(vertex, piece.v);
        }
        return vertex;
    }

    /// The segments on the edge u, v that meet the pixel between u and v.
    void collectThrough(std::uint32_t u, std::uint32_t v, Vec2 center)
    {
        chains_.forEachUse(u, v, [&](const Chains::Use& use) {
            const Vec2 a = start(use.segment);
            const Vec2 b = end(use.segment);
            const Vec2 before = mesh_.points[use.forward ? u : v];
            const Vec2 after = mesh_.points[use.forward ? v : u];
            if (PixelGrid::compareAlong(a, b, before, center) < 0
                && PixelGrid::compareAlong(a, b, center, after) < 0
                && grid_.meets(a, b, center)) {
                through_.push_back({u, v, use.before});
            }
        });
    }

    void constrain(std::uint32_t u, std::uint32_t v)
    {
        if (!edit_.constrain(u, v)) {
            throw std::logic_error("Snap rounding: a piece is blocked.");
        }
    }

    SnapResult makeResult()
    {
        SnapResult result;
        result.pixel = std::ldexp(grid_.side(), -power_);
        result.maxDisplacement = std::ldexp(maxDisplacement_, -power_);
        const std::vector<Vec2> centers = std::move(mesh_.points);
        mesh_ = {}; // its memory serves the result
        std::vector<std::uint32_t> index(centers.size(), kNone);
        result.points.reserve(centers.size());
        const auto take = [&](std::uint32_t v) {
            if (index[v] == kNone) {
                index[v] = static_cast<std::uint32_t>(result.points.size());
                result.points.push_back(scaled(centers[v], -power_));
            }
        };
        for (std::size_t i = 1; i < input_.size(); ++i) {
            take(vertexOfInput_[i]);
        }
        result.inputCount = result.points.size();
        for (std::uint32_t v = firstAdded_; v < centers.size(); ++v) {
            take(v);
        }
        result.pointOf.push_back(kNone);
        for (std::size_t i = 1; i < input_.size(); ++i) {
            result.pointOf.push_back(index[vertexOfInput_[i]]);
        }
        chains_.renameVertices(index, result.points.size());
        result.chains = std::move(chains_);
        return result;
    }

    int power_;
    std::vector<Vec2> input_;
    std::span<const Segment> segments_;
    Execution& execution_;
    Box2 box_;
    PixelGrid grid_;
    Triangulation mesh_;
    std::vector<std::uint32_t> vertexOfInput_;
    std::uint32_t firstAdded_ = 0; ///< vertices from here on are pixels of crossings
    HotPixels hot_;
    Chains chains_;
    MeshEdit edit_;
    std::size_t added_ = 0;
    double maxDisplacement_ = 0.0;

    std::uint32_t round_ = 0;
    std::vector<std::uint32_t> triangleSeen_; ///< by triangle and vertex: last round that met it
    std::vector<std::uint32_t> vertexSeen_;
    std::vector<std::uint32_t> segmentSeen_; ///< by segment: last segment that collected it
    std::vector<std::uint32_t> open_;
    std::vector<HalfEdge> closeEdges_;
    std::vector<std::uint32_t> closeVertices_;
    std::vector<std::uint32_t> neighbors_; ///< segments close to another one
    std::vector<Vec2> centers_;
    std::vector<Through> through_;
};

} // namespace

SnapResult snapRound(std::span<const Vec2> points, std::span<const Segment> segments,
                     Execution& execution)
{
    return SnapRounder(points, segments, execution).run();
}

} // namespace tessera
