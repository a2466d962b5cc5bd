// SPDX-License-Identifier: MIT

// All sorting is by vertex numbers, with buckets: linear but for vertices of high degree.

#include "recover/constraint_map.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tessera
{
namespace
{

/// Items 0 .. n - 1 by key, in their order: items[start[k] .. start[k + 1]) have key k.
struct Buckets
{
    std::vector<std::uint32_t> start;
    std::vector<std::uint32_t> items;

    /// key(i) is below keyCount, or at least that for an item to be left out.
    template<class Key>
    Buckets(std::size_t n, std::size_t keyCount, Key&& key)
        : start(keyCount + 1, 0)
    {
        for (std::size_t i = 0; i < n; ++i) {
            if (key(i) < keyCount) {
                ++start[key(i)];
            }
        }
        std::exclusive_scan(start.begin(), start.end(), start.begin(), 0U);
        items.resize(start.back());
        for (std::size_t i = 0; i < n; ++i) {
            if (key(i) < keyCount) {
                items[start[key(i)]++] = static_cast<std::uint32_t>(i);
            }
        }
        std::move_backward(start.begin(), start.end() - 1, start.end());
        start[0] = 0;
    }
    std::span<std::uint32_t> of(std::size_t key)
    {
        return {items.data() + start[key], start[key + 1] - start[key]};
    }
};

class MapBuilder
{
public:
    MapBuilder(std::span<const ConstraintEnds> constraints, const SegmentTable& table,
               const Chains& chains)
        : constraints_(constraints)
        , table_(table)
        , chains_(chains)
        , constraintsOf_(constraints.size(), table.segments.size(),
                         [&](std::size_t c) { return table.segmentOf[c]; })
    {}

    ConstraintMap build(std::span<const std::uint32_t> vertexOf)
    {
        layOutChains();
        fillChains(vertexOf);
        const std::size_t pieces = chains_.nodeCount() - chains_.segmentCount();
        map_.subsegments.reserve(pieces);
        map_.uses.reserve(pieces);
        for (std::uint32_t v = 0; v < chains_.vertexCount(); ++v) {
            addEdgesAt(v);
        }
        return std::move(map_);
    }

private:
    /// A segment's piece from the vertex at hand to a higher one.
    struct Piece
    {
        std::uint32_t other;
        std::uint32_t segment;
        bool forward;
    };

    bool sameDirection(std::uint32_t c, std::uint32_t s) const
    {
        return constraints_[c].a == table_.segments[s].a;
    }

    void layOutChains()
    {
        const std::vector<std::uint32_t> lengths = chains_.lengths();
        map_.chainStart.reserve(constraints_.size() + 1);
        std::uint32_t next = 0;
        for (std::uint32_t c = 0; c < constraints_.size(); ++c) {
            map_.chainStart.push_back(next);
            const std::uint32_t s = table_.segmentOf[c];
            next += s == SegmentTable::kNone ? 1U : lengths[s];
        }
        map_.chainStart.push_back(next);
        map_.chainVertices.resize(next);
    }

    /// Where one constraint's chain is being copied.
    struct Copy
    {
        std::uint32_t node;
        std::uint32_t to;
        std::uint32_t step; ///< 1, or -1 modulo 2^32
    };

    /// Each step along a list waits for memory, so several lists are followed at a time.
    void fillChains(std::span<const std::uint32_t> vertexOf)
    {
        constexpr std::size_t kAtATime = 16;
        std::vector<Copy> copies;
        std::uint32_t c = 0;
        while (c < constraints_.size() || !copies.empty()) {
            for (; c < constraints_.size() && copies.size() < kAtATime; ++c) {
                const std::uint32_t s = table_.segmentOf[c];
                if (s == SegmentTable::kNone) {
                    map_.chainVertices[map_.chainStart[c]] = vertexOf[constraints_[c].a];
                }
                else if (sameDirection(c, s)) {
                    copies.push_back({chains_.first(s), map_.chainStart[c], 1U});
                }
                else {
                    copies.push_back({chains_.first(s), map_.chainStart[c + 1] - 1U, ~0U});
                }
            }
            for (Copy& copy : copies) {
                map_.chainVertices[copy.to] = chains_.vertexOf(copy.node);
                copy.to += copy.step;
                copy.node = chains_.next(copy.node);
            }
            std::erase_if(copies, [](const Copy& copy) { return copy.node == Chains::kNone; });
        }
    }

    void addEdgesAt(std::uint32_t v)
    {
        pieces_.clear();
        chains_.forEachAt(v, [&](std::uint32_t, std::uint32_t segment, std::uint32_t previous,
                                 std::uint32_t next) {
            for (const bool forward : {true, false}) {
                const std::uint32_t neighbor = forward ? next : previous;
                if (neighbor != Chains::kNone && chains_.vertexOf(neighbor) > v) {
                    pieces_.push_back({chains_.vertexOf(neighbor), segment, forward});
                }
            }
        });
        std::sort(pieces_.begin(), pieces_.end(), [](const Piece& p, const Piece& q) {
            return std::tie(p.other, p.segment) < std::tie(q.other, q.segment);
        });
        for (auto first = pieces_.begin(); first != pieces_.end();) {
            const auto last = std::find_if(first, pieces_.end(), [&](const Piece& p) {
                return p.other != first->other;
            });
            addSubsegment(v, {first, last});
            first = last;
        }
    }

    void addSubsegment(std::uint32_t v, std::span<const Piece> pieces)
    {
        const std::size_t firstUse = map_.uses.size();
        for (const Piece& piece : pieces) {
            for (const std::uint32_t c : constraintsOf_.of(piece.segment)) {
                const bool forward = piece.forward == sameDirection(c, piece.segment);
                map_.uses.push_back({ConstraintId(c), forward});
            }
        }
        std::sort(map_.uses.begin() + static_cast<std::ptrdiff_t>(firstUse), map_.uses.end(),
                  [](const ConstraintUse& p, const ConstraintUse& q) {
                      return p.constraint < q.constraint;
                  });
        map_.subsegments.push_back({v, pieces.front().other, static_cast<std::uint32_t>(firstUse),
                                    static_cast<std::uint32_t>(map_.uses.size() - firstUse)});
    }

    std::span<const ConstraintEnds> constraints_;
    const SegmentTable& table_;
    const Chains& chains_;
    Buckets constraintsOf_; ///< by segment
    ConstraintMap map_;
    std::vector<Piece> pieces_;
};

} // namespace

SegmentTable::SegmentTable(std::span<const ConstraintEnds> constraints, std::size_t vertexCount)
    : segmentOf(constraints.size(), kNone)
{
    const auto low = [&](std::size_t i) { return std::min(constraints[i].a, constraints[i].b); };
    const auto high = [&](std::size_t i) { return std::max(constraints[i].a, constraints[i].b); };
    Buckets byLow(constraints.size(), vertexCount, low);
    std::vector<std::uint32_t> degree(vertexCount, 0);
    for (std::size_t v = 0; v < vertexCount; ++v) {
        const auto items = byLow.of(v);
        std::sort(items.begin(), items.end(), [&](std::uint32_t i, std::uint32_t j) {
            return std::pair(high(i), i) < std::pair(high(j), j);
        });
        for (const std::uint32_t c : items) {
            if (low(c) == high(c)) {
                continue;
            }
            if (segments.empty() || segments.back().a != v || segments.back().b != high(c)) {
                segments.push_back({low(c), high(c)});
                ++degree[low(c)];
                ++degree[high(c)];
            }
            segmentOf[c] = static_cast<std::uint32_t>(segments.size() - 1);
        }
    }
    for (Segment& s : segments) {
        if (degree[s.a] > degree[s.b]) {
            std::swap(s.a, s.b);
        }
    }
}

ConstraintMap makeConstraintMap(std::span<const ConstraintEnds> constraints,
                                std::span<const std::uint32_t> vertexOf, const SegmentTable& table,
                                const Chains& chains)
{
    return MapBuilder(constraints, table, chains).build(vertexOf);
}

} // namespace tessera
