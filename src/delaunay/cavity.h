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
// <= 11/3 u S^2, with S = |a|^2 + |b|^2 + |c|^2. The bound 4u S^2 leaves room for the terms of order
// u^2 and for its own rounding; kUnderflow covers underflow as in predicates.h. If all coordinates
// are multiples of a unit g and S^2 < 2^50 g^4, every intermediate value is an integer multiple of
// g^4 (or g^2, g) below 2^53 of them: nothing was rounded, and the sign of the double is exact.
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
        : data_(reinterpret_cast<Edge*>(inline_))
    {}
    EdgeStack(const EdgeStack&) = delete;
    EdgeStack& operator=(const EdgeStack&) = delete;

    bool empty() const { return size_ == 0; }
    Edge& top() { return data_[size_ - 1]; }
    void pop() { --size_; }
    void push(const Edge& edge)
    {
        if (size_ == capacity_) {
            grow();
        }
        data_[size_++] = edge;
    }

private:
    static constexpr std::size_t kInline = 48;

    void grow()
    {
        std::vector<Edge> larger(2 * capacity_);
        std::copy(data_, data_ + size_, larger.begin());
        heap_ = std::move(larger);
        data_ = heap_.data();
        capacity_ = heap_.size();
    }

    alignas(Edge) std::byte inline_[kInline * sizeof(Edge)];
    std::vector<Edge> heap_;
    Edge* data_;
    std::size_t size_ = 0;
    std::size_t capacity_ = kInline;
};

/// Inserts points into a triangulation that has triangles. KeepIncident: maintain
/// Triangulation::incident (the bulk builder fills it once at the end instead).
template<bool KeepIncident>
class Cavity
{
public:
    /// exactSquare: S^2 below which a double determinant is exact (see above); 0 if unknown.
    explicit Cavity(Triangulation& triangulation, double exactSquare = 0.0)
        : t_(triangulation)
        , exactSquare_(exactSquare)
    {}

    /// p strictly inside the edge (onEdge), or in its triangle, which may be a ghost.
    void insert(std::uint32_t vertex, bool onEdge, HalfEdge edge)
    {
        const std::uint32_t triangle = Topology::triangleOf(edge);
        if (onEdge) {
            insertOnEdge(vertex, edge);
        }
        else if (t_.isGhost(triangle)) {
            insertOutside(vertex, triangle);
        }
        else {
            insertInTriangle(vertex, triangle);
        }
    }

    /// p strictly inside the finite triangle.
    void insertInTriangle(std::uint32_t vertex, std::uint32_t triangle)
    {
        begin(vertex);
        const Topology::Triangle old = t_.triangles[triangle];
        release(triangle);
        const Corner a = corner(old.v[0]);
        const Corner b = corner(old.v[1]);
        const Corner c = corner(old.v[2]);
        push(old.link[1], c, a);
        push(old.link[0], b, c);
        push(old.link[2], a, b);
        start_ = a;
        run();
        closeInside(false);
    }

    /// p strictly inside the edge u -> v; the twin may be a ghost's.
    void insertOnEdge(std::uint32_t vertex, HalfEdge edge)
    {
        if (t_.apex(edge) == Topology::kInfinite) {
            edge = t_.twin(edge);
        }
        const HalfEdge twin = t_.twin(edge);
        if (t_.apex(twin) == Topology::kInfinite) {
            insertOnHullEdge(vertex, edge);
            return;
        }
        begin(vertex);
        const bool constrained = t_.isConstrained(edge);
        const Topology::Triangle left = t_.triangles[edge >> 2];
        const Topology::Triangle right = t_.triangles[twin >> 2];
        const std::uint32_t i = edge & 3U;
        const std::uint32_t j = twin & 3U;
        const Corner u = corner(t_.origin(edge));
        const Corner v = corner(t_.destination(edge));
        const Corner above = corner(left.v[i]);
        const Corner below = corner(right.v[j]);
        release(edge >> 2);
        release(twin >> 2);
        push(right.link[Topology::prev3(j)], below, v);
        push(right.link[Topology::next3(j)], u, below);
        start_ = u;
        run();
        spokeConstrained_ = constrained;
        push(left.link[Topology::prev3(i)], above, u);
        push(left.link[Topology::next3(i)], v, above);
        run();
        closeInside(constrained);
    }

    /// p strictly beyond the hull edge of the ghost.
    void insertOutside(std::uint32_t vertex, std::uint32_t ghost)
    {
        begin(vertex);
        HalfEdge hull = hullEdgeOf(ghost); // v -> u in the ghost; the hull runs u -> v
        for (HalfEdge ahead = following(hull); sees(ahead); ahead = following(hull)) {
            hull = ahead;
        }
        const HalfEdge after = t_.twin(t_.prev(hull)); // v -> infinity, in the ghost that stays
        const std::uint32_t last = t_.origin(hull);
        start_ = corner(last);
        HalfEdge before = 0;
        std::uint32_t first = 0;
        for (;;) {
            const HalfEdge behind = preceding(hull);
            const bool more = sees(behind);
            before = t_.twin(t_.next(hull)); // infinity -> u
            first = t_.destination(hull);
            const std::uint32_t link = t_.triangles[hull >> 2].link[hull & 3U];
            release(hull >> 2);
            push(link, start_, corner(first));
            run();
            if (!more) {
                break;
            }
            hull = behind;
        }
        closeOutside(first, last, before, after, false);
    }

    /// A live triangle at the last inserted vertex, as a half-edge out of it.
    HalfEdge lastSpoke() const { return Topology::halfEdge(firstNew_, 2); }

private:
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
        std::uint32_t outer; ///< link: the half-edge beyond, with its constrained bit
        Corner end;
        double cross; ///< start x end, positive
    };

    static constexpr std::uint32_t kNone = 0xffffffffU;
    static constexpr double kBound = 4.0 * exact::kUnit;

    static double cross(const Corner& a, const Corner& b) { return a.x * b.y - a.y * b.x; }

    Corner corner(std::uint32_t vertex) const
    {
        const Vec2 q = t_.points[vertex];
        const double x = q.x - p_.x;
        const double y = q.y - p_.y;
        return {vertex, x, y, x * x + y * y};
    }

    void begin(std::uint32_t vertex)
    {
        vertex_ = vertex;
        p_ = t_.points[vertex];
        firstNew_ = kNone;
        lastNew_ = kNone;
        freed_ = kNone;
        spokeConstrained_ = false;
    }

    void push(std::uint32_t outer, const Corner& from, const Corner& to)
    {
        stack_.push({outer, to, cross(from, to)});
    }

    void release(std::uint32_t triangle)
    {
        t_.triangles[triangle].v[1] = freed_;
        freed_ = triangle;
    }

    std::uint32_t allocate()
    {
        if (freed_ != kNone) {
            const std::uint32_t slot = freed_;
            freed_ = t_.triangles[slot].v[1];
            return slot;
        }
        if (!t_.freeList.empty()) {
            const std::uint32_t slot = t_.freeList.back();
            t_.freeList.pop_back();
            return slot;
        }
        t_.triangles.push_back({});
        return static_cast<std::uint32_t>(t_.triangles.size() - 1);
    }

    void run()
    {
        Corner a = start_;
        while (!stack_.empty()) {
            Edge& edge = stack_.top();
            if (!expand(a, edge)) {
                emit(a.vertex, edge.end.vertex, edge.outer);
                a = edge.end;
                stack_.pop();
            }
        }
        start_ = a;
    }

    /// Replaces the edge from a by two if the triangle beyond it is in conflict.
    bool expand(const Corner& a, Edge& edge)
    {
        if ((edge.outer & Topology::kConstrainedBit) != 0) {
            return false;
        }
        const std::uint32_t triangle = edge.outer >> 2;
        const std::uint32_t side = edge.outer & 3U;
        Topology::Triangle& beyond = t_.triangles[triangle];
        if (beyond.v[side] == Topology::kInfinite) {
            return false;
        }
        const Corner c = corner(beyond.v[side]);
        const double ac = cross(a, c);
        const double cb = cross(c, edge.end);
        const double determinant = edge.end.lift * ac + a.lift * cb - c.lift * edge.cross;
        const double sum = a.lift + edge.end.lift + c.lift;
        const double square = sum * sum;
        const double bound = kBound * square + exact::kUnderflow;
        bool conflict = determinant > bound;
        if (!conflict && !(-determinant > bound)) {
            conflict = square < exactSquare_
                ? determinant > 0.0
                : exact::incircle(t_.points[c.vertex], t_.points[edge.end.vertex],
                                  t_.points[a.vertex], p_)
                    > 0;
        }
        if (!conflict) {
            return false;
        }
        const std::uint32_t toC = beyond.link[Topology::next3(side)];
        edge.outer = beyond.link[Topology::prev3(side)];
        edge.cross = cb;
        beyond.v[1] = freed_;
        freed_ = triangle;
        stack_.push({toC, c, ac});
        return true;
    }

    /// Writes the triangle (p, a, b) against the outer half-edge and its predecessor around p.
    void emit(std::uint32_t a, std::uint32_t b, std::uint32_t outer)
    {
        const std::uint32_t slot = allocate();
        Topology::Triangle& triangle = t_.triangles[slot];
        triangle.v[0] = vertex_;
        triangle.v[1] = a;
        triangle.v[2] = b;
        triangle.link[0] = outer;
        const HalfEdge other = outer & ~Topology::kConstrainedBit;
        t_.triangles[other >> 2].link[other & 3U]
            = Topology::halfEdge(slot, 0) | (outer & Topology::kConstrainedBit);
        if (lastNew_ == kNone) {
            firstNew_ = slot;
        }
        else {
            t_.join(Topology::halfEdge(lastNew_, 1), Topology::halfEdge(slot, 2),
                    spokeConstrained_);
            spokeConstrained_ = false;
        }
        lastNew_ = slot;
        if constexpr (KeepIncident) {
            t_.incident[a] = Topology::halfEdge(slot, 0);
        }
    }

    void closeInside(bool constrained)
    {
        t_.join(Topology::halfEdge(lastNew_, 1), Topology::halfEdge(firstNew_, 2), constrained);
        if constexpr (KeepIncident) {
            t_.incident[vertex_] = Topology::halfEdge(firstNew_, 2);
        }
    }

    /// p becomes a hull vertex between first and last: two new ghosts, joined to the ghosts that
    /// stay.
    void closeOutside(std::uint32_t first, std::uint32_t last, HalfEdge before, HalfEdge after,
                      bool constrained)
    {
        const std::uint32_t ahead = allocate();
        const std::uint32_t behind = allocate();
        t_.triangles[ahead] = {{Topology::kInfinite, last, vertex_}, {}};
        t_.triangles[behind] = {{Topology::kInfinite, vertex_, first}, {}};
        t_.join(Topology::halfEdge(ahead, 0), Topology::halfEdge(firstNew_, 2), constrained);
        t_.join(Topology::halfEdge(behind, 0), Topology::halfEdge(lastNew_, 1), constrained);
        t_.join(Topology::halfEdge(ahead, 1), Topology::halfEdge(behind, 2));
        t_.join(Topology::halfEdge(ahead, 2), after);
        t_.join(Topology::halfEdge(behind, 1), before);
        if constexpr (KeepIncident) {
            t_.incident[vertex_] = Topology::halfEdge(firstNew_, 2);
            t_.incident[first] = Topology::halfEdge(lastNew_, 1);
            t_.incident[Topology::kInfinite] = Topology::halfEdge(ahead, 2);
        }
    }

    void insertOnHullEdge(std::uint32_t vertex, HalfEdge edge)
    {
        begin(vertex);
        const bool constrained = t_.isConstrained(edge);
        const HalfEdge hull = t_.twin(edge);
        const HalfEdge after = t_.twin(t_.prev(hull));
        const HalfEdge before = t_.twin(t_.next(hull));
        const Topology::Triangle old = t_.triangles[edge >> 2];
        const std::uint32_t i = edge & 3U;
        const Corner u = corner(t_.origin(edge));
        const Corner v = corner(t_.destination(edge));
        const Corner c = corner(old.v[i]);
        release(edge >> 2);
        release(hull >> 2);
        push(old.link[Topology::prev3(i)], c, u);
        push(old.link[Topology::next3(i)], v, c);
        start_ = v;
        run();
        closeOutside(u.vertex, v.vertex, before, after, constrained);
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
    Corner start_ {};
    std::uint32_t vertex_ = 0;
    std::uint32_t firstNew_ = kNone;
    std::uint32_t lastNew_ = kNone;
    std::uint32_t freed_ = kNone;  ///< slots of removed triangles, chained through v[1]
    bool spokeConstrained_ = false; ///< of the join before the next new triangle
};

} // namespace tessera
