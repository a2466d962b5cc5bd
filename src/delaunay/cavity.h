// SPDX-License-Identifier: MIT
#pragma once

// Bowyer–Watson insertion of one point (A. Bowyer, D. F. Watson, both The Computer Journal 24,
// 1981), with the conflict region walked as a tree.
//
//            b = end
//           /|\            The stack holds the rest of the cavity's boundary as seen from p,
//          / | \           counter-clockwise: the current edge a -> b is on top. If the triangle
//         p  |  c          beyond it (apex c) is in conflict, the edge is replaced by a -> c and
//          \ | /           c -> b and the triangle's slot is freed; otherwise the new triangle
//           \|/            (p, a, b) is written and linked to its predecessor around p.
//            a
//
// Why no marks are needed. Let p see a -> b from the left and lie strictly inside the circle of
// (c, b, a). The part of that disk beyond a b, where p is, lies strictly left of a -> c and of
// c -> b, so p sees both. By induction p sees every edge on the stack, each edge replaces its
// parent within the same angle at p, and these angles never overlap: no triangle is met twice, the
// boundary comes out in order, and all new triangles are strictly counter-clockwise. This holds in
// any triangulation, Delaunay or not. Where the triangulation is (constrained) Delaunay, the region
// is all of the conflict region that p sees, and the result is (constrained) Delaunay again.
// A ghost is in conflict only if p lies beyond its hull edge; then insertion starts there, so a
// ghost met from the inside always bounds the region.
//
// The in-circle filter. With vectors a, b, c relative to p, rounded once (u = 2^-53): a lift
// |a|^2 has relative error 4u, a cross product error 4u |b||c| (since |bx cy| + |by cx| <= |b||c|),
// a term lift * cross 9u, the two final sums 2u: in all at most 11u |a||b||c| (|a| + |b| + |c|)
// <= 11/3 u S^2, with S = |a|^2 + |b|^2 + |c|^2. The bound 4u S^2 leaves room for the terms of
// order u^2 and for its own rounding; kUnderflow covers underflow as in predicates.h. If all
// coordinates are multiples of a unit g and S^2 < 2^50 g^4, every intermediate value is an integer
// multiple of g^4 (or g^2, g) below 2^53 of them: nothing was rounded, and the sign of the double
// is exact.
//
// Cost: constant per triangle of the region, six on average for points in general position.

#include "delaunay/triangulation.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tessera
{

/// The unfinished part of a cavity's boundary; the first kInline edges need no allocation.
template<class Edge>
class EdgeStack
{
public:
    EdgeStack()
        : top_(inline_)
        , limit_(inline_ + kInline)
        , bottom_(inline_)
    {}
    EdgeStack(const EdgeStack&) = delete;
    EdgeStack& operator=(const EdgeStack&) = delete;

    bool empty() const { return top_ == bottom_; }
    Edge pop() { return *--top_; }
    template<class... Fields>
    void push(Fields... fields)
    {
        if (top_ == limit_) {
            grow();
        }
        *top_++ = Edge {fields...};
    }

private:
    static constexpr std::size_t kInline = 48;

    void grow()
    {
        const auto size = static_cast<std::size_t>(top_ - bottom_);
        std::vector<Edge> larger(2 * size);
        std::copy(bottom_, top_, larger.begin());
        heap_ = std::move(larger);
        bottom_ = heap_.data();
        top_ = bottom_ + size;
        limit_ = bottom_ + heap_.size();
    }

    Edge inline_[kInline];
    std::vector<Edge> heap_;
    Edge* top_;
    Edge* limit_;
    Edge* bottom_;
};

enum class CavityMode
{
    General,
    Bulk, ///< no constrained edges; Triangulation::incident is left alone, to be filled at the end
};

/// Inserts points into a triangulation that has triangles.
template<CavityMode Mode>
class Cavity
{
public:
    /// exactSquare: S^2 below which a double determinant is exact (see above); 0 if unknown.
    explicit Cavity(Triangulation& triangulation, double exactSquare = 0.0)
        : t_(triangulation)
        , exactSquare_(exactSquare)
    {}

    /// The vertex, at p, strictly inside the edge (onEdge), or in its triangle, which may be a
    /// ghost.
    void insert(std::uint32_t vertex, bool onEdge, HalfEdge edge)
    {
        insert(vertex, t_.points[vertex], onEdge, edge);
    }
    void insert(std::uint32_t vertex, Vec2 p, bool onEdge, HalfEdge edge)
    {
        const std::uint32_t triangle = Topology::triangleOf(edge);
        if (onEdge) {
            insertOnEdge(vertex, p, edge);
        }
        else if (t_.isGhost(triangle)) {
            insertOutside(vertex, p, triangle);
        }
        else {
            insertInTriangle(vertex, p, triangle);
        }
    }

    /// A half-edge out of the last inserted vertex, in a finite triangle.
    HalfEdge lastSpoke() const { return Topology::halfEdge(firstNew_, 2); }

private:
    /// p strictly inside the finite triangle.
    void insertInTriangle(std::uint32_t vertex, Vec2 p, std::uint32_t triangle)
    {
        begin(vertex, p);
        const Topology::Triangle& old = t_.triangles[triangle];
        const Corner a = corner(old.v[0]);
        const Corner b = corner(old.v[1]);
        const Corner c = corner(old.v[2]);
        push(old.link[1], c, a);
        push(old.link[0], b, c);
        push(old.link[2], a, b);
        release(triangle);
        run(a);
        closeInside();
    }

    /// p strictly inside the edge u -> v; the twin may be a ghost's.
    void insertOnEdge(std::uint32_t vertex, Vec2 p, HalfEdge edge)
    {
        begin(vertex, p);
        if (t_.apex(edge) == Topology::kInfinite) {
            edge = t_.twin(edge);
        }
        const HalfEdge twin = t_.twin(edge);
        const bool constrained = t_.isConstrained(edge);
        const std::uint32_t u = t_.origin(edge);
        const std::uint32_t v = t_.destination(edge);
        if (t_.apex(twin) == Topology::kInfinite) {
            splitHullEdge(edge, u, v);
        }
        else {
            splitEdge(edge, twin, u, v);
        }
        if (constrained) {
            constrainSpoke(u);
            constrainSpoke(v);
        }
    }

    /// p strictly beyond the hull edge of the ghost.
    void insertOutside(std::uint32_t vertex, Vec2 p, std::uint32_t ghost)
    {
        begin(vertex, p);
        HalfEdge hull = hullEdgeOf(ghost); // v -> u in the ghost; the hull runs u -> v
        for (HalfEdge behind = preceding(hull); sees(behind); behind = preceding(hull)) {
            hull = behind;
        }
        const HalfEdge before = t_.twin(t_.next(hull)); // infinity -> u, in the ghost that stays
        const std::uint32_t first = t_.destination(hull);
        HalfEdge after = 0; // v -> infinity, in the ghost that stays
        std::uint32_t last = 0;
        for (bool more = true; more;) {
            const HalfEdge ahead = following(hull);
            more = sees(ahead);
            after = t_.twin(t_.prev(hull));
            last = t_.origin(hull);
            push(t_.triangles[hull >> 2].link[hull & 3U], corner(last),
                 corner(t_.destination(hull)));
            release(hull >> 2);
            hull = ahead;
        }
        run(corner(last));
        closeOutside(first, last, before, after);
    }

    /// A vertex relative to p.
    struct Corner
    {
        std::uint32_t vertex;
        double x;
        double y;
        double lift;
    };
    /// An edge of the cavity's boundary from its predecessor's end to `end`.
    struct Edge
    {
        std::uint32_t outer;  ///< link: the half-edge beyond, with its constrained bit
        std::uint32_t vertex; ///< the end, relative to p
        double x;
        double y;
        double lift;
        double cross; ///< start x end, positive
    };

    static constexpr std::uint32_t kNone = 0xffffffffU;
    static constexpr double kBound = 4.0 * exact::kUnit;

    static bool isConstrained(std::uint32_t link)
    {
        return Mode == CavityMode::General && (link & Topology::kConstrainedBit) != 0;
    }
    static double cross(const Corner& a, const Corner& b) { return a.x * b.y - a.y * b.x; }

    Corner corner(std::uint32_t vertex) const
    {
        const Vec2 q = t_.points[vertex];
        const double x = q.x - p_.x;
        const double y = q.y - p_.y;
        return {vertex, x, y, x * x + y * y};
    }

    /// Every insertion needs two slots more than it frees.
    void begin(std::uint32_t vertex, Vec2 p)
    {
        vertex_ = vertex;
        p_ = p;
        freed_ = kNone;
        release(t_.takeTriangle());
        release(t_.takeTriangle());
    }

    void push(std::uint32_t outer, const Corner& from, const Corner& to)
    {
        stack_.push(outer, to.vertex, to.x, to.y, to.lift, cross(from, to));
    }

    void release(std::uint32_t triangle)
    {
        t_.triangles[triangle].v[1] = freed_;
        freed_ = triangle;
    }

    /// The next of the freed slots.
    std::uint32_t reuse()
    {
        const std::uint32_t slot = freed_;
        freed_ = t_.triangles[slot].v[1];
        return slot;
    }

    /// Turns the edges on the stack, which start at `start`, into the triangles around p. What an
    /// iteration needs is kept in locals: copies through memory would stall on store forwarding.
    void run(const Corner& start)
    {
        Topology::Triangle* const triangles = t_.triangles.data();
        const Vec2* const points = t_.points.data();
        const double px = p_.x;
        const double py = p_.y;
        std::uint32_t a = start.vertex;
        double ax = start.x;
        double ay = start.y;
        double aLift = start.lift;
        std::uint32_t freed = freed_;
        std::uint32_t last = kNone;
        while (!stack_.empty()) {
            Edge edge = stack_.pop();
            for (;;) {
                if (isConstrained(edge.outer)) {
                    break;
                }
                const std::uint32_t beyond = edge.outer >> 2;
                const std::uint32_t side = edge.outer & 3U;
                Topology::Triangle& triangle = triangles[beyond];
                const std::uint32_t c = triangle.v[side];
                if (c == Topology::kInfinite) {
                    break;
                }
                const double cx = points[c].x - px;
                const double cy = points[c].y - py;
                const double cLift = cx * cx + cy * cy;
                const double ac = ax * cy - ay * cx;
                const double cb = cx * edge.y - cy * edge.x;
                const double sum = aLift + edge.lift + cLift;
                const double determinant = edge.lift * ac + aLift * cb - cLift * edge.cross;
                if (!inConflict(determinant, sum * sum, a, edge.vertex, c)) {
                    break;
                }
                stack_.push(triangle.link[Topology::prev3(side)], edge.vertex, edge.x, edge.y,
                            edge.lift, cb);
                edge = {triangle.link[Topology::next3(side)], c, cx, cy, cLift, ac};
                triangle.v[1] = freed;
                freed = beyond;
            }
            const std::uint32_t slot = freed;
            freed = triangles[slot].v[1];
            firstNew_ = last == kNone ? slot : firstNew_;
            last = last == kNone ? slot : last; // closed by the caller
            emit(triangles, slot, last, a, edge.vertex, edge.outer);
            last = slot;
            a = edge.vertex;
            ax = edge.x;
            ay = edge.y;
            aLift = edge.lift;
        }
        lastNew_ = last;
        freed_ = freed;
    }

    /// Writes the triangle (p, a, b) against the outer half-edge and its predecessor around p.
    void emit(Topology::Triangle* triangles, std::uint32_t slot, std::uint32_t predecessor,
              std::uint32_t a, std::uint32_t b, std::uint32_t outer)
    {
        Topology::Triangle& triangle = triangles[slot];
        triangle.v[0] = vertex_;
        triangle.v[1] = a;
        triangle.v[2] = b;
        triangle.link[0] = outer;
        triangle.link[2] = Topology::halfEdge(predecessor, 1);
        triangles[predecessor].link[1] = Topology::halfEdge(slot, 2);
        const std::uint32_t bit = isConstrained(outer) ? Topology::kConstrainedBit : 0U;
        triangles[(outer & ~bit) >> 2].link[outer & 3U] = Topology::halfEdge(slot, 0) | bit;
        if constexpr (Mode == CavityMode::General) {
            t_.incident[a] = Topology::halfEdge(slot, 0);
        }
    }

    /// The sign of the determinant is positive; near zero by exact arithmetic.
    bool inConflict(double determinant, double square, std::uint32_t a, std::uint32_t b,
                    std::uint32_t c) const
    {
        const double bound = kBound * square + exact::kUnderflow;
        if (std::fabs(determinant) > bound || square < exactSquare_) {
            return determinant > 0.0;
        }
        return exact::incircle(t_.points[c], t_.points[b], t_.points[a], p_) > 0;
    }

    void closeInside()
    {
        t_.join(Topology::halfEdge(lastNew_, 1), Topology::halfEdge(firstNew_, 2));
        if constexpr (Mode == CavityMode::General) {
            t_.incident[vertex_] = Topology::halfEdge(firstNew_, 2);
        }
    }

    /// p becomes a hull vertex between first and last: two new ghosts, joined to the ghosts that
    /// stay.
    void closeOutside(std::uint32_t first, std::uint32_t last, HalfEdge before, HalfEdge after)
    {
        const std::uint32_t ahead = reuse();
        const std::uint32_t behind = reuse();
        t_.triangles[ahead] = {{Topology::kInfinite, last, vertex_}, {}};
        t_.triangles[behind] = {{Topology::kInfinite, vertex_, first}, {}};
        t_.join(Topology::halfEdge(ahead, 0), Topology::halfEdge(firstNew_, 2));
        t_.join(Topology::halfEdge(behind, 0), Topology::halfEdge(lastNew_, 1));
        t_.join(Topology::halfEdge(ahead, 1), Topology::halfEdge(behind, 2));
        t_.join(Topology::halfEdge(ahead, 2), after);
        t_.join(Topology::halfEdge(behind, 1), before);
        if constexpr (Mode == CavityMode::General) {
            t_.incident[vertex_] = Topology::halfEdge(firstNew_, 2);
            t_.incident[first] = Topology::halfEdge(lastNew_, 1);
            t_.incident[Topology::kInfinite] = Topology::halfEdge(ahead, 2);
        }
    }

    void splitEdge(HalfEdge edge, HalfEdge twin, std::uint32_t u, std::uint32_t v)
    {
        const Topology::Triangle& left = t_.triangles[edge >> 2];
        const Topology::Triangle& right = t_.triangles[twin >> 2];
        const std::uint32_t i = edge & 3U;
        const std::uint32_t j = twin & 3U;
        const Corner start = corner(u);
        const Corner end = corner(v);
        const Corner above = corner(left.v[i]);
        const Corner below = corner(right.v[j]);
        push(left.link[Topology::prev3(i)], above, start);
        push(left.link[Topology::next3(i)], end, above);
        push(right.link[Topology::prev3(j)], below, end);
        push(right.link[Topology::next3(j)], start, below);
        release(edge >> 2);
        release(twin >> 2);
        run(start);
        closeInside();
    }

    void splitHullEdge(HalfEdge edge, std::uint32_t u, std::uint32_t v)
    {
        const HalfEdge hull = t_.twin(edge);
        const HalfEdge after = t_.twin(t_.prev(hull));
        const HalfEdge before = t_.twin(t_.next(hull));
        const Topology::Triangle& old = t_.triangles[edge >> 2];
        const std::uint32_t i = edge & 3U;
        const Corner start = corner(v);
        const Corner apex = corner(old.v[i]);
        push(old.link[Topology::prev3(i)], apex, corner(u));
        push(old.link[Topology::next3(i)], start, apex);
        release(edge >> 2);
        release(hull >> 2);
        run(start);
        closeOutside(u, v, before, after);
    }

    /// Sets the bit of the edge from p to one of its new neighbors.
    void constrainSpoke(std::uint32_t end)
    {
        HalfEdge spoke = lastSpoke();
        while (t_.destination(spoke) != end) {
            spoke = t_.nextAround(spoke);
        }
        t_.setConstrained(spoke, true);
    }

    /// The edge of a ghost that lies on the hull.
    HalfEdge hullEdgeOf(std::uint32_t ghost) const
    {
        const auto& v = t_.triangles[ghost].v;
        return Topology::halfEdge(ghost, v[0] == Topology::kInfinite ? 0
                                      : v[1] == Topology::kInfinite  ? 1
                                                                     : 2);
    }
    /// The ghosts' hull edges after and before in the hull's counter-clockwise order.
    HalfEdge following(HalfEdge hull) const { return t_.prev(t_.twin(t_.prev(hull))); }
    HalfEdge preceding(HalfEdge hull) const { return t_.next(t_.twin(t_.next(hull))); }

    /// p lies strictly beyond the hull edge.
    bool sees(HalfEdge hull) const
    {
        return orient2d(t_.points[t_.origin(hull)], t_.points[t_.destination(hull)], p_) > 0;
    }

    Triangulation& t_;
    double exactSquare_;
    EdgeStack<Edge> stack_;
    Vec2 p_;
    std::uint32_t vertex_ = 0;
    std::uint32_t firstNew_ = 0; ///< the new triangles at p, counter-clockwise from first to last
    std::uint32_t lastNew_ = 0;
    std::uint32_t freed_ = kNone; ///< slots to be used again, chained through v[1]
};

} // namespace tessera
