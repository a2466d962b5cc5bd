// SPDX-License-Identifier: MIT
// The sweep is that of Shamos and Hoey ("Geometric intersection problems", 1976) with a line that
// goes from left to right, tilted so that points with equal x are met from below: segments cross
// somewhere if and only if two that are neighbors on the line at some time do. All signs are exact.
#include "io/outline_check.h"

#include "predicates/predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace tessera
{

namespace
{

bool comesBefore(Vec2 p, Vec2 q)
{
    return p.x != q.x ? p.x < q.x : p.y < q.y;
}

/// p is on the inside of a-b, or so near that rounding p alone may have put it beside, or nearer
/// than that part of the length.
bool liesAlong(Vec2 a, Vec2 b, Vec2 p, double part)
{
    if (compareAlong(a, b, p, a) <= 0 || compareAlong(a, b, p, b) >= 0) {
        return false;
    }
    if (orient2d(a, b, p) == 0) {
        return true;
    }
    const double greatest =
        std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
    const double away = std::fabs(cross(b - a, p - a)) / distance(a, b);
    return away <= std::max(2.0 * std::numeric_limits<double>::epsilon() * greatest,
                            part * distance(a, b));
}

class Sweep
{
public:
    Sweep(std::span<const Vec2> points, std::span<const OutlineSide> sides)
        : points_(points)
        , sides_(sides)
        , active_(Below {this})
        , place_(sides.size(), active_.end())
        , coveredAbove_(sides.size(), 0)
    {
        for (std::uint32_t s = 0; s < sides.size(); ++s) {
            if (low(s) != high(s)) {
                events_.push_back({low(s), false, s});
                events_.push_back({high(s), true, s});
            }
        }
        std::ranges::sort(events_, [](const Event& a, const Event& b) {
            if (a.at != b.at) {
                return comesBefore(a.at, b.at);
            }
            return a.isEnd != b.isEnd ? a.isEnd : a.side < b.side;
        });
    }

    std::vector<OutlineProblem> run()
    {
        for (std::size_t first = 0; first < events_.size();) {
            std::size_t last = first;
            for (; last < events_.size() && events_[last].at == events_[first].at; ++last) {
                const Event& event = events_[last];
                const auto crossing = event.isEnd ? remove(event.side) : insert(event.side);
                if (crossing) {
                    return {*crossing};
                }
            }
            cover(first, last);
            first = last;
        }
        return std::move(problems_);
    }

private:
    struct Event
    {
        Vec2 at;
        bool isEnd;
        std::uint32_t side;
    };
    /// Order along the sweep line, from below. Both sides are on the line at once.
    struct Below
    {
        const Sweep* sweep;
        bool operator()(std::uint32_t s, std::uint32_t t) const { return sweep->isBelow(s, t); }
    };
    using Active = std::set<std::uint32_t, Below>;

    Vec2 low(std::uint32_t s) const { return runsForward(s) ? start(s) : end(s); }
    Vec2 high(std::uint32_t s) const { return runsForward(s) ? end(s) : start(s); }
    Vec2 start(std::uint32_t s) const { return points_[sides_[s][0]]; }
    Vec2 end(std::uint32_t s) const { return points_[sides_[s][1]]; }
    bool runsForward(std::uint32_t s) const { return comesBefore(start(s), end(s)); }

    bool isBelow(std::uint32_t s, std::uint32_t t) const
    {
        if (s == t) {
            return false;
        }
        if (comesBefore(low(s), low(t))) {
            const int side = orient2d(low(s), high(s), low(t));
            return side != 0 ? side > 0 : endsBelow(s, t);
        }
        const int side = orient2d(low(t), high(t), low(s));
        return side != 0 ? side < 0 : endsBelow(s, t);
    }
    /// For sides that start on each other: by direction, then by number.
    bool endsBelow(std::uint32_t s, std::uint32_t t) const
    {
        const int side = orient2d(low(s), high(s), high(t));
        return side != 0 ? side > 0 : s < t;
    }

    /// The sides have more than end points in common.
    std::optional<OutlineProblem> crossing(Active::iterator a, Active::iterator b) const
    {
        const Vec2 p = low(*a);
        const Vec2 q = high(*a);
        const Vec2 r = low(*b);
        const Vec2 s = high(*b);
        const int pSide = orient2d(r, s, p);
        const int qSide = orient2d(r, s, q);
        const int rSide = orient2d(p, q, r);
        const int sSide = orient2d(p, q, s);
        const bool cross = pSide * qSide < 0 && rSide * sSide < 0;
        const bool ends = (pSide == 0 && strictlyBetween(r, s, p))
            || (qSide == 0 && strictlyBetween(r, s, q)) || (rSide == 0 && strictlyBetween(p, q, r))
            || (sSide == 0 && strictlyBetween(p, q, s));
        if (!cross && !ends && !(p == r && q == s)) {
            return std::nullopt;
        }
        return OutlineProblem {OutlineProblem::Kind::Crossing, 0, {*a, *b}};
    }

    std::optional<OutlineProblem> insert(std::uint32_t side)
    {
        const auto at = active_.insert(side).first;
        place_[side] = at;
        if (at != active_.begin()) {
            if (auto found = crossing(std::prev(at), at)) {
                return found;
            }
        }
        const auto above = std::next(at);
        return above == active_.end() ? std::nullopt : crossing(at, above);
    }

    std::optional<OutlineProblem> remove(std::uint32_t side)
    {
        const auto above = active_.erase(place_[side]);
        if (above == active_.begin() || above == active_.end()) {
            return std::nullopt;
        }
        return crossing(std::prev(above), above);
    }

    /// How often the mesh covers the plane above the sides that start here.
    void cover(std::size_t first, std::size_t last)
    {
        std::vector<std::uint32_t> started;
        for (std::size_t e = first; e < last; ++e) {
            if (!events_[e].isEnd) {
                started.push_back(events_[e].side);
            }
        }
        std::ranges::sort(started, Below {this});
        for (std::uint32_t s : started) {
            const int below = place_[s] == active_.begin()
                ? 0
                : coveredAbove_[*std::prev(place_[s])];
            const int above = below + (runsForward(s) ? 1 : -1);
            coveredAbove_[s] = above;
            if (std::min(below, above) != 0 || std::max(below, above) != 1) {
                problems_.push_back({OutlineProblem::Kind::Covered, 0, {s, s}});
            }
        }
    }

    std::span<const Vec2> points_;
    std::span<const OutlineSide> sides_;
    std::vector<Event> events_;
    Active active_;
    std::vector<Active::iterator> place_; ///< by side
    std::vector<int> coveredAbove_;       ///< by side
    std::vector<OutlineProblem> problems_;
};

} // namespace

std::vector<OutlineProblem> findHangingNodes(std::span<const Vec2> points,
                                             std::span<const OutlineSide> sides, double part)
{
    std::vector<OutlineSide> byStart(sides.begin(), sides.end());
    std::ranges::sort(byStart);
    std::vector<OutlineProblem> problems;
    for (std::size_t s = 0; s < sides.size(); ++s) {
        const std::uint32_t a = sides[s][0];
        const std::uint32_t b = sides[s][1];
        std::vector<std::uint32_t> chain;
        std::uint32_t at = b;
        while (at != a) {
            auto it = std::ranges::lower_bound(byStart, OutlineSide {at, 0});
            const auto leadsBack = [&](const OutlineSide& side) {
                return side[1] == a ? at != b
                                    : liesAlong(points[a], points[at], points[side[1]], part)
                        && liesAlong(points[a], points[b], points[side[1]], part);
            };
            while (it != byStart.end() && (*it)[0] == at && !leadsBack(*it)) {
                ++it;
            }
            if (it == byStart.end() || (*it)[0] != at) {
                break;
            }
            at = (*it)[1];
            chain.push_back(at);
        }
        if (at == a) {
            for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
                problems.push_back({OutlineProblem::Kind::Hanging, chain[i], {s, s}});
            }
        }
    }
    return problems;
}

std::vector<OutlineProblem> sweepOutline(std::span<const Vec2> points,
                                         std::span<const OutlineSide> sides)
{
    return Sweep(points, sides).run();
}

} // namespace tessera
