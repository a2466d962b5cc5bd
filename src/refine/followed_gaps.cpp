// SPDX-License-Identifier: MIT
//
// The least of (piece + kGrowth * distance) over the spans of a side. A sweep tells the least span over
// each interval between neighboring ends of spans; two passes spread the values at these ends. Then
// the least at any place is told by the two ends around it.

#include "refine/followed_gaps.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace tessera
{

namespace
{
constexpr double kInfinite = std::numeric_limits<double>::infinity();
} // namespace

void FollowedGaps::clear()
{
    spans_.clear();
    stops_.clear();
    firstStop_.clear();
}

void FollowedGaps::finish()
{
    std::sort(spans_.begin(), spans_.end(), [](const Span& a, const Span& b) {
        return std::pair(a.side, a.from) < std::pair(b.side, b.from);
    });
    for (std::size_t i = 0; i < spans_.size();) {
        const std::uint32_t side = spans_[i].side;
        firstStop_.resize(side + 1, static_cast<std::uint32_t>(stops_.size()));
        std::size_t end = i;
        while (end < spans_.size() && spans_[end].side == side) {
            ++end;
        }
        addStops(spans_.data() + i, spans_.data() + end);
        i = end;
    }
    firstStop_.push_back(static_cast<std::uint32_t>(stops_.size()));
    spans_ = {};
}

/// Of one side, whose spans are sorted by their beginnings.
void FollowedGaps::addStops(const Span* first, const Span* last)
{
    std::vector<double> places;
    for (const Span* span = first; span != last; ++span) {
        places.push_back(span->from);
        places.push_back(span->to);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());

    const std::size_t begin = stops_.size();
    const auto isShorter = [](const Span* a, const Span* b) { return a->piece > b->piece; };
    std::priority_queue<const Span*, std::vector<const Span*>, decltype(isShorter)> open(isShorter);
    for (const double place : places) {
        for (; first != last && first->from == place; ++first) {
            open.push(first);
        }
        const auto leastWhile = [&](auto&& hasEnded) {
            while (!open.empty() && hasEnded(open.top()->to)) {
                open.pop();
            }
            return open.empty() ? kInfinite : open.top()->piece;
        };
        const double here = leastWhile([&](double to) { return to < place; });
        const double onward = leastWhile([&](double to) { return to <= place; });
        stops_.push_back({place, here, onward});
    }
    for (std::size_t i = begin + 1; i < stops_.size(); ++i) {
        const double grown
            = stops_[i - 1].piece + kGrowth * (stops_[i].place - stops_[i - 1].place);
        stops_[i].piece = std::min(stops_[i].piece, grown);
    }
    for (std::size_t i = stops_.size() - 1; i > begin; --i) {
        const double grown = stops_[i].piece + kGrowth * (stops_[i].place - stops_[i - 1].place);
        stops_[i - 1].piece = std::min(stops_[i - 1].piece, grown);
    }
}

double FollowedGaps::at(std::uint32_t side, double place) const
{
    if (side + 1 >= firstStop_.size() || firstStop_[side] == firstStop_[side + 1]) {
        return kInfinite;
    }
    const auto first = stops_.begin() + firstStop_[side];
    const auto last = stops_.begin() + firstStop_[side + 1];
    const auto after = std::upper_bound(
        first, last, place, [](double p, const Stop& stop) { return p < stop.place; });
    double least = kInfinite;
    if (after != first) {
        const Stop& before = after[-1];
        least = std::min(before.onward, before.piece + kGrowth * (place - before.place));
    }
    if (after != last) {
        least = std::min(least, after->piece + kGrowth * (after->place - place));
    }
    return least;
}

} // namespace tessera
