// SPDX-License-Identifier: MIT

// All sorting is by vertex numbers, with buckets: linear but for vertices of high degree.

#include "recover/constraint_map.h"

#include <algorithm>
#include <numeric>

namespace tessera
{
namespace
{

/// The order of items 0 .. n - 1 by key(i), ties as they come; keys are below keyCount.
template<class Key>
std::vector<std::uint32_t> bucketOrder(std::size_t n, std::size_t keyCount, Key&& key)
{
    std::vector<std::uint32_t> position(keyCount + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
        ++position[key(i) + 1];
    }
    std::partial_sum(position.begin(), position.end(), position.begin());
    std::vector<std::uint32_t> order(n);
    for (std::size_t i = 0; i < n; ++i) {
        order[position[key(i)]++] = static_cast<std::uint32_t>(i);
    }
    return order;
}

/// The order of items by low(i), then high(i), ties as they come.
template<class Low, class High>
std::vector<std::uint32_t> edgeOrder(std::size_t n, std::size_t vertexCount, Low&& low, High&& high)
{
    std::vector<std::uint32_t> order = bucketOrder(n, vertexCount, low);
    for (auto first = order.begin(); first != order.end();) {
        const auto last = std::find_if(
            first, order.end(), [&](std::uint32_t i) { return low(i) != low(*first); });
        std::sort(first, last, [&](std::uint32_t i, std::uint32_t j) {
            return high(i) != high(j) ? high(i) < high(j) : i < j;
        });
        first = last;
    }
    return order;
}

/// A piece of a constraint, from the lower to the higher vertex.
struct Piece
{
    std::uint32_t low;
    std::uint32_t high;
    ConstraintUse use;
};

} // namespace

SegmentTable::SegmentTable(std::span<const ConstraintEnds> constraints, std::size_t vertexCount)
    : segmentOf(constraints.size(), kNone)
{
    const auto low = [&](std::size_t i) { return std::min(constraints[i].a, constraints[i].b); };
    const auto high = [&](std::size_t i) { return std::max(constraints[i].a, constraints[i].b); };
    for (const std::uint32_t c : edgeOrder(constraints.size(), vertexCount, low, high)) {
        if (low(c) == high(c)) {
            continue;
        }
        if (segments.empty() || segments.back().a != low(c) || segments.back().b != high(c)) {
            segments.push_back({low(c), high(c)});
        }
        segmentOf[c] = static_cast<std::uint32_t>(segments.size() - 1);
    }
}

VertexChains::VertexChains(const Chains& chains, std::size_t segmentCount)
{
    start.reserve(segmentCount + 1);
    vertices.reserve(chains.nodeCount());
    for (std::uint32_t s = 0; s < segmentCount; ++s) {
        for (std::uint32_t n = chains.first(s); n != Chains::kNone; n = chains.node(n).next) {
            vertices.push_back(chains.node(n).vertex);
        }
        closeChain();
    }
}

ConstraintMap makeConstraintMap(std::span<const ConstraintEnds> constraints,
                                std::span<const std::uint32_t> vertexOf, const SegmentTable& table,
                                const VertexChains& chains, std::size_t vertexCount)
{
    ConstraintMap map;
    map.chainStart.reserve(constraints.size() + 1);
    map.chainStart.push_back(0);
    std::vector<Piece> pieces;
    for (std::uint32_t c = 0; c < constraints.size(); ++c) {
        const std::uint32_t s = table.segmentOf[c];
        if (s == SegmentTable::kNone) {
            map.chainVertices.push_back(vertexOf[constraints[c].a]);
        }
        else {
            const auto chain = chains.of(s);
            const auto first = static_cast<std::ptrdiff_t>(map.chainVertices.size());
            map.chainVertices.insert(map.chainVertices.end(), chain.begin(), chain.end());
            if (constraints[c].a != table.segments[s].a) {
                std::reverse(map.chainVertices.begin() + first, map.chainVertices.end());
            }
            for (auto i = static_cast<std::size_t>(first); i + 1 < map.chainVertices.size(); ++i) {
                const std::uint32_t u = map.chainVertices[i];
                const std::uint32_t v = map.chainVertices[i + 1];
                pieces.push_back({std::min(u, v), std::max(u, v), {ConstraintId(c), u < v}});
            }
        }
        map.chainStart.push_back(static_cast<std::uint32_t>(map.chainVertices.size()));
    }

    map.uses.reserve(pieces.size());
    const auto low = [&](std::size_t i) { return pieces[i].low; };
    const auto high = [&](std::size_t i) { return pieces[i].high; };
    for (const std::uint32_t i : edgeOrder(pieces.size(), vertexCount, low, high)) {
        const Piece& piece = pieces[i];
        if (map.subsegments.empty() || map.subsegments.back().a != piece.low
            || map.subsegments.back().b != piece.high) {
            map.subsegments.push_back(
                {piece.low, piece.high, static_cast<std::uint32_t>(map.uses.size()), 0});
        }
        ++map.subsegments.back().useCount;
        map.uses.push_back(piece.use);
    }
    return map;
}

} // namespace tessera
