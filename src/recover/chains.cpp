// SPDX-License-Identifier: MIT
#include "recover/chains.h"

namespace tessera
{

std::uint32_t Chains::addNode(std::uint32_t segment, std::uint32_t vertex, std::uint32_t previous,
                              std::uint32_t next)
{
    if (vertex >= atVertex_.size()) {
        atVertex_.resize(vertex + 1, kNone);
    }
    const auto n = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({vertex, segment, previous, next, atVertex_[vertex]});
    atVertex_[vertex] = n;
    return n;
}

void Chains::append(std::uint32_t segment, std::uint32_t vertex)
{
    const std::uint32_t before = last_[segment];
    const std::uint32_t n = addNode(segment, vertex, before, kNone);
    if (before == kNone) {
        first_[segment] = n;
    }
    else {
        nodes_[before].next = n;
    }
    last_[segment] = n;
}

void Chains::insertAfter(std::uint32_t before, std::uint32_t vertex)
{
    const std::uint32_t after = nodes_[before].next;
    const std::uint32_t n = addNode(nodes_[before].segment, vertex, before, after);
    nodes_[before].next = n;
    nodes_[after].previous = n;
}

bool Chains::shorterList(std::uint32_t u, std::uint32_t v) const
{
    std::uint32_t i = head(u);
    std::uint32_t j = head(v);
    while (i != kNone && j != kNone) {
        i = nodes_[i].nextAtVertex;
        j = nodes_[j].nextAtVertex;
    }
    return i == kNone;
}

void Chains::renameVertex(std::uint32_t from, std::uint32_t to)
{
    if (to >= atVertex_.size()) {
        atVertex_.resize(to + 1, kNone);
    }
    atVertex_[to] = head(from);
    atVertex_[from] = kNone;
    for (std::uint32_t n = atVertex_[to]; n != kNone; n = nodes_[n].nextAtVertex) {
        nodes_[n].vertex = to;
    }
}

} // namespace tessera
