// SPDX-License-Identifier: MIT

// All sorting is by vertex numbers, with buckets: linear but for vertices of high degree. The
// chains are copied out and freed first, so that the subsegments take the place of their memory.

#include "recover/constraint_map.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tessera
{
namespace
{

/// Items 0 .. n - 1 by key, in their order: items[start[k] .. start[k + 1]) have key k.
struct Buckets
{
    std::vector<std::uint32_t> start;
    std::vector<std::uint32_t> items;

    /// key(i) is below keyCount.
    template<class Key>
    Buckets(std::size_t n, std::size_t keyCount, Key&& key)
        : start(keyCount + 1, 0)
    {
        for (std::size_t i = 0; i < n; ++i) {
            ++start[key(i)];
        }
        std::exclusive_scan(start.begin(), start.end(), start.begin(), 0U);
        items.resize(start.back());
        for (std::size_t i = 0; i < n; ++i) {
            items[start[key(i)]++] = static_cast<std::uint32_t>(i);
        }
        std::move_backward(start.begin(), start.end() - 1, start.end());
        start[0] = 0;
    }
    std::span<std::uint32_t> of(std::size_t key)
    {
        return {items.data() + start[key], start[key + 1] - start[key]};
    }
};

/// Finds the subsegments of a map that has its chains only.
class SubsegmentFinder
{
public:
    explicit SubsegmentFinder(ConstraintMap& map)
        : map_(map)
    {}

    void run(std::size_t vertexCount)
    {
        bucketUses(vertexCount);
        addSubsegments(groupUses());
    }

private:
    /// Calls f(constraint, u, v) for every piece of every chain, in the constraint's direction.
    template<class F>
    void forEachPiece(F&& f) const
    {
        for (std::uint32_t c = 0; c < map_.chainStart.size() - 1; ++c) {
            const auto chain = map_.chainOf(ConstraintId(c));
            for (std::size_t i = 1; i < chain.size(); ++i) {
                f(c, chain[i - 1], chain[i]);
            }
        }
    }

    /// Puts a use for each piece into map_.uses and its higher vertex into higher_, in the order of
    /// the lower vertex, then of the constraint.
    void bucketUses(std::size_t vertexCount)
    {
        usesAt_.assign(vertexCount + 1, 0);
        forEachPiece([this](std::uint32_t, std::uint32_t u, std::uint32_t v) {
            ++usesAt_[std::min(u, v)];
        });
        std::exclusive_scan(usesAt_.begin(), usesAt_.end(), usesAt_.begin(), 0U);
        map_.uses.resize(usesAt_.back());
        higher_.resize(usesAt_.back());
        forEachPiece([this](std::uint32_t c, std::uint32_t u, std::uint32_t v) {
            const std::uint32_t i = usesAt_[std::min(u, v)]++;
            map_.uses[i] = {ConstraintId(c), u < v};
            higher_[i] = std::max(u, v);
        });
        std::move_backward(usesAt_.begin(), usesAt_.end() - 1, usesAt_.end());
        usesAt_[0] = 0;
    }

    /// Sorts each bucket by the higher vertex, then by the constraint. Returns the number of edges.
    std::size_t groupUses()
    {
        std::vector<std::pair<std::uint32_t, ConstraintUse>> bucket;
        std::size_t edges = 0;
        for (std::size_t v = 0; v + 1 < usesAt_.size(); ++v) {
            if (usesAt_[v + 1] - usesAt_[v] <= 1) {
                edges += usesAt_[v + 1] - usesAt_[v];
                continue;
            }
            bucket.clear();
            for (std::uint32_t i = usesAt_[v]; i < usesAt_[v + 1]; ++i) {
                bucket.emplace_back(higher_[i], map_.uses[i]);
            }
            std::sort(bucket.begin(), bucket.end(), [](const auto& p, const auto& q) {
                return p.first != q.first ? p.first < q.first
                                          : p.second.constraint < q.second.constraint;
            });
            std::uint32_t before = SegmentTable::kNone;
            std::uint32_t i = usesAt_[v];
            for (const auto& [higher, use] : bucket) {
                edges += higher != before ? 1 : 0;
                before = higher;
                higher_[i] = higher;
                map_.uses[i] = use;
                ++i;
            }
        }
        return edges;
    }

    void addSubsegments(std::size_t count)
    {
        map_.subsegments.reserve(count);
        for (std::uint32_t v = 0; v + 1 < usesAt_.size(); ++v) {
            const std::uint32_t end = usesAt_[v + 1];
            for (std::uint32_t first = usesAt_[v]; first < end;) {
                std::uint32_t last = first + 1;
                while (last < end && higher_[last] == higher_[first]) {
                    ++last;
                }
                map_.subsegments.push_back({v, higher_[first], first, last - first});
                first = last;
            }
        }
    }

    ConstraintMap& map_;
    std::vector<std::uint32_t> usesAt_; ///< by lower vertex: where its uses begin
    std::vector<std::uint32_t> higher_; ///< by use: the edge's higher vertex
};

class MapBuilder
{
public:
    MapBuilder(std::span<const ConstraintEnds> constraints, const SegmentTable& table)
        : constraints_(constraints)
        , table_(table)
    {}

    ConstraintMap build(std::span<const std::uint32_t> vertexOf, Chains chains)
    {
        const std::size_t vertexCount = chains.vertexCount();
        layOutChains(chains);
        fillChains(vertexOf, chains);
        chains = {}; // their memory serves the rest
        addSubsegments(map_, vertexCount);
        return std::move(map_);
    }

private:
    bool sameDirection(std::uint32_t c, std::uint32_t s) const
    {
        return constraints_[c].a == table_.segments[s].a;
    }

    void layOutChains(const Chains& chains)
    {
        const std::vector<std::uint32_t> lengths = chains.lengths();
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
    void fillChains(std::span<const std::uint32_t> vertexOf, const Chains& chains)
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
                    copies.push_back({chains.first(s), map_.chainStart[c], 1U});
                }
                else {
                    copies.push_back({chains.first(s), map_.chainStart[c + 1] - 1U, ~0U});
                }
            }
            for (Copy& copy : copies) {
                map_.chainVertices[copy.to] = chains.vertexOf(copy.node);
                copy.to += copy.step;
                copy.node = chains.next(copy.node);
            }
            std::erase_if(copies, [](const Copy& copy) { return copy.node == Chains::kNone; });
        }
    }

    std::span<const ConstraintEnds> constraints_;
    const SegmentTable& table_;
    ConstraintMap map_;
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
                                Chains chains)
{
    return MapBuilder(constraints, table).build(vertexOf, std::move(chains));
}

void addSubsegments(ConstraintMap& map, std::size_t vertexCount)
{
    SubsegmentFinder(map).run(vertexCount);
}

const Subsegment* findSubsegment(const ConstraintMap& map, std::uint32_t u, std::uint32_t v)
{
    const std::pair ends(std::min(u, v), std::max(u, v));
    const auto found = std::lower_bound(
        map.subsegments.begin(), map.subsegments.end(), ends,
        [](const Subsegment& s, const auto& wanted) { return std::pair(s.a, s.b) < wanted; });
    return found == map.subsegments.end() || std::pair(found->a, found->b) != ends ? nullptr
                                                                                   : &*found;
}

} // namespace tessera
