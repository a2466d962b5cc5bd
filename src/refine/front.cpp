// SPDX-License-Identifier: MIT
//
// Frontal placement of interior points, after Rebay (1993): Delaunay insertion whose points are
// chosen so that they make equilateral triangles on the edges of the front.
//
// A triangle is accepted when its circumradius is below kAcceptedRadius of the size (an equilateral
// one has 0.577). An edge is active if it is constrained or its other triangle is accepted. A
// triangle with an active edge that is not accepted gets a point on the bisector of that edge, at
// the distance that makes an equilateral triangle, but not beyond its circumcenter. The point is
// refused if it is closer than kTooClose of the size to a vertex around or than kTooCloseToEdge to
// a constrained edge, or if it lies behind one. What is refused everywhere is left to Delaunay
// refinement. Of several active edges the one that is shortest for its size comes first: with a size
// that grows by 0.3 per length, mean quality after optimization was 0.9625 with the shortest first,
// 0.9500 in the order of sides, 0.9492 with the longest first; no difference at 0.1 and below.
//
// Triangles wait on a stack: last in, first out grows large patches in one orientation, which
// leaves fewer seams than first in, first out (measured: mean quality 0.990 instead of 0.980).
//
// Guarantees: every insertion keeps the triangulation valid and constrained Delaunay. Ends: new
// points keep a distance from all vertices around that is bounded from below by the size.
// Complexity: O(n) insertions of O(1) expected cost, two evaluations of the size field each.

#include "refine/front.h"

#include "base/parallel.h"
#include "delaunay/delaunay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tessera
{

namespace
{

constexpr double kAcceptedRadius = 0.62;
constexpr double kTooClose = 0.8;
constexpr double kTooCloseToEdge = 0.35;
constexpr std::size_t kSeedStride = 16;
constexpr double kThin = 16.0; ///< longest / shortest edge
constexpr std::size_t kCheckpointEvery = 4096;

enum class State : std::uint8_t
{
    Open,     ///< not accepted, waits or has been refused
    Accepted,
};

struct Waiting
{
    std::uint32_t triangle;
    std::uint32_t stamp;
};

double squaredDistanceToSegment(Vec2 p, Vec2 a, Vec2 b)
{
    const Vec2 along = b - a;
    const double s = std::clamp(dot(p - a, along) / squaredLength(along), 0.0, 1.0);
    return squaredLength(p - a - s * along);
}

class Front
{
public:
    Front(MeshEditor& editor, VertexSizes& sizes, Execution& execution)
        : editor_(editor)
        , t_(editor.triangulation())
        , sizes_(sizes)
        , execution_(execution)
    {}

    FrontResult run(std::uint32_t firstGood, std::uint32_t endGood)
    {
        reserveTouched(execution_, stamp_, t_.triangles.capacity());
        state_.reserve(t_.triangles.capacity());
        grow();
        std::fill(state_.begin() + firstGood, state_.begin() + endGood, State::Accepted);
        const auto skipGood = [&](std::uint32_t i) { return i == firstGood ? endGood : i; };
        const auto end = static_cast<std::uint32_t>(t_.triangles.size());
        for (std::uint32_t i = skipGood(0); i < end; i = skipGood(i + 1)) {
            judge(i);
        }
        for (std::uint32_t i = skipGood(0); i < end; i = skipGood(i + 1)) {
            push(i);
        }
        breakUpFans();
        std::size_t steps = 0;
        while (!stack_.empty()) {
            if (steps++ % kCheckpointEvery == 0) {
                execution_.checkpoint();
                sizes_.requireFew(t_.triangles.size());
            }
            const Waiting top = stack_.back();
            stack_.pop_back();
            if (stamp_[top.triangle] == top.stamp) {
                advance(top.triangle);
            }
        }
        FrontResult result {points_, {}};
        for (std::uint32_t i = skipGood(0); i < t_.triangles.size(); i = skipGood(i + 1)) {
            if (isOpen(i)) {
                result.open.push_back(i);
            }
        }
        return result;
    }

private:
    void grow()
    {
        state_.resize(t_.triangles.size(), State::Open);
        stamp_.resize(t_.triangles.size(), 0);
    }

    void judge(std::uint32_t triangle)
    {
        ++stamp_[triangle];
        state_[triangle] = State::Open;
        if (!editor_.isKept(triangle)) {
            return;
        }
        const auto& v = t_.triangles[triangle].v;
        const Vec2 a = t_.points[v[0]];
        const Vec2 b = t_.points[v[1]];
        const Vec2 c = t_.points[v[2]];
        const double twiceArea = cross(b - a, c - a);
        const double h = (sizes_[v[0]] + sizes_[v[1]] + sizes_[v[2]]) / 3.0;
        const double limit = 2.0 * kAcceptedRadius * h;
        // Ratios first: no power of a length above the second, for the sake of the range.
        const double ratios = squaredLength(b - a) / twiceArea * (squaredLength(c - b) / twiceArea);
        if (ratios * squaredLength(a - c) < limit * limit) {
            state_[triangle] = State::Accepted;
        }
    }

    bool isOpen(std::uint32_t triangle) const
    {
        return editor_.isKept(triangle) && state_[triangle] == State::Open;
    }

    bool isActive(HalfEdge h) const
    {
        return t_.isConstrained(h)
            || state_[Topology::triangleOf(t_.twin(h))] == State::Accepted;
    }

    void push(std::uint32_t triangle)
    {
        if (!isOpen(triangle)) {
            return;
        }
        for (std::uint32_t side = 0; side < 3; ++side) {
            if (isActive(Topology::halfEdge(triangle, side))) {
                stack_.push_back({triangle, stamp_[triangle]});
                return;
            }
        }
    }

    /// Long thin triangles on finely divided edges share far apexes, and a point near one of them
    /// conflicts with all. Points spread over such edges, each halving what is left between the ones
    /// before, keep conflict regions small.
    void breakUpFans()
    {
        std::vector<Waiting> thin;
        for (const Waiting& waiting : stack_) {
            if (isThin(waiting.triangle)) {
                thin.push_back(waiting);
            }
        }
        std::size_t stride = 1;
        while (stride < thin.size()) {
            stride *= 2;
        }
        for (; stride >= kSeedStride; stride /= 2) {
            for (std::size_t i = stride / 2; i < thin.size(); i += stride) {
                if (stamp_[thin[i].triangle] == thin[i].stamp) {
                    advance(thin[i].triangle);
                }
            }
        }
    }

    bool isThin(std::uint32_t triangle) const
    {
        const auto& v = t_.triangles[triangle].v;
        const double ab = squaredLength(t_.points[v[1]] - t_.points[v[0]]);
        const double bc = squaredLength(t_.points[v[2]] - t_.points[v[1]]);
        const double ca = squaredLength(t_.points[v[0]] - t_.points[v[2]]);
        return std::max({ab, bc, ca}) > kThin * kThin * std::min({ab, bc, ca});
    }

    /// Tries the active edges, the one that is shortest for its size first.
    void advance(std::uint32_t triangle)
    {
        struct Candidate
        {
            double relative;
            HalfEdge edge;
        };
        Candidate candidates[3];
        int count = 0;
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge h = Topology::halfEdge(triangle, side);
            if (isActive(h)) {
                const Vec2 along = t_.points[t_.destination(h)] - t_.points[t_.origin(h)];
                const double size = sizes_[t_.origin(h)] + sizes_[t_.destination(h)];
                const Candidate candidate {squaredLength(along) / (size * size), h};
                int at = count++;
                for (; at > 0 && candidates[at - 1].relative > candidate.relative; --at) {
                    candidates[at] = candidates[at - 1];
                }
                candidates[at] = candidate;
            }
        }
        for (int i = 0; i < count; ++i) {
            if (placeOn(candidates[i].edge)) {
                return;
            }
        }
    }

    /// Tries to put a point on the bisector of an active edge.
    bool placeOn(HalfEdge edge)
    {
        const Vec2 a = t_.points[t_.origin(edge)];
        const Vec2 b = t_.points[t_.destination(edge)];
        const Vec2 c = t_.points[t_.apex(edge)];
        const Vec2 along = b - a;
        const double l = std::sqrt(squaredLength(along));
        const Vec2 normal {-along.y / l, along.x / l};
        const Vec2 middle = midpoint(a, b);
        const double atEdge = 0.5 * (sizes_[t_.origin(edge)] + sizes_[t_.destination(edge)]);
        const double height = 0.5 * std::numbers::sqrt3 * atEdge;
        const double beyond = limitedSize(middle + height * normal, atEdge, height);
        const double wanted = 0.5 * (atEdge + beyond);
        const double half = 0.5 * l;
        double d = std::sqrt(std::max(wanted * wanted - half * half, 0.25 * wanted * wanted));
        // Signed distance of the circumcenter from the edge.
        const Vec2 u = a - c;
        const Vec2 w = b - c;
        d = std::min(d, 0.5 * l * (dot(u, w) / cross(u, w)));
        if (!(d > 0.0)) {
            return false;
        }
        const Vec2 p = middle + d * normal;
        const double h = limitedSize(p, atEdge, d);
        const VisibleWalk found = editor_.walk(edge, p);
        if (found.kind != VisibleWalk::Kind::Reached
            || found.location.kind == Location::Kind::Vertex
            || (found.location.kind == Location::Kind::Edge
                && t_.isConstrained(found.location.edge))
            || isTooClose(Topology::triangleOf(found.location.edge), p, h)) {
            return false;
        }
        const std::uint32_t v = editor_.insertInside(p, found.location);
        sizes_.set(v, h);
        ++points_;
        afterInsertion(v);
        return true;
    }

    double limitedSize(Vec2 p, double from, double reach) const
    {
        return std::min(sizes_.fieldAt(p), from + VertexSizes::kGrowth * reach);
    }

    bool isTooClose(std::uint32_t triangle, Vec2 p, double h) const
    {
        const double limit = kTooClose * kTooClose * h * h;
        const double edgeLimit = kTooCloseToEdge * kTooCloseToEdge * h * h;
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge inner = Topology::halfEdge(triangle, side);
            if (squaredLength(t_.points[t_.apex(inner)] - p) < limit) {
                return true;
            }
            if (t_.isConstrained(inner)) {
                if (isEdgeClose(inner, p, edgeLimit)) {
                    return true;
                }
                continue;
            }
            const HalfEdge outer = t_.twin(inner);
            if (t_.apex(outer) == Topology::kInfinite) {
                continue;
            }
            if (squaredLength(t_.points[t_.apex(outer)] - p) < limit) {
                return true;
            }
            for (const HalfEdge h2 : {Topology::next(outer), Topology::prev(outer)}) {
                if (t_.isConstrained(h2) && isEdgeClose(h2, p, edgeLimit)) {
                    return true;
                }
            }
        }
        return false;
    }

    bool isEdgeClose(HalfEdge edge, Vec2 p, double limit) const
    {
        return squaredDistanceToSegment(p, t_.points[t_.origin(edge)],
                                        t_.points[t_.destination(edge)])
            < limit;
    }

    void afterInsertion(std::uint32_t v)
    {
        grow();
        star_.clear();
        t_.forEachAround(v, [this](HalfEdge h) { star_.push_back(h); });
        for (const HalfEdge h : star_) {
            judge(Topology::triangleOf(h));
        }
        for (const HalfEdge h : star_) {
            const std::uint32_t triangle = Topology::triangleOf(h);
            if (state_[triangle] == State::Open) {
                push(triangle);
                continue;
            }
            const HalfEdge rim = Topology::next(h);
            const std::uint32_t outer = Topology::triangleOf(t_.twin(rim));
            if (!t_.isConstrained(rim) && isOpen(outer)) {
                stack_.push_back({outer, stamp_[outer]});
            }
        }
    }

    MeshEditor& editor_;
    const Triangulation& t_;
    VertexSizes& sizes_;
    Execution& execution_;
    std::vector<State> state_;
    std::vector<std::uint32_t> stamp_; ///< changes when a slot gets a new triangle
    std::vector<Waiting> stack_;
    std::vector<HalfEdge> star_;
    std::size_t points_ = 0;
};

} // namespace

FrontResult placeFrontal(MeshEditor& editor, VertexSizes& sizes, std::uint32_t firstGood,
                         std::uint32_t endGood, Execution& execution)
{
    return Front(editor, sizes, execution).run(firstGood, endGood);
}

} // namespace tessera
