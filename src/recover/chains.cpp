// SPDX-License-Identifier: MIT
#include "recover/chains.h"

#include "base/grow.h"

#include <algorithm>

namespace tessera
{

std::uint32_t Chains::addNode(std::uint32_t vertex, const Links& links)
{
    while (vertex >= cells_.size()) {
        makeRoom(cells_);
        cells_.emplace_back();
    }
    ++nodeCount_;
    Cell& cell = cells_[vertex];
    const std::uint32_t k = cell.count++;
    if (k < kNear) {
        cell.near[k] = links;
        return kNear * vertex + k;
    }
    const std::uint32_t n = kFarBit | static_cast<std::uint32_t>(far_.size());
    makeRoom(far_);
    far_.push_back({links, vertex, cell.firstFar});
    cell.firstFar = n;
    return n;
}

void Chains::append(std::uint32_t segment, std::uint32_t vertex)
{
    const std::uint32_t before = last_[segment];
    const std::uint32_t n = addNode(vertex, {segment, before, kNone});
    if (before == kNone) {
        first_[segment] = n;
    }
    else {
        links(before).next = n;
    }
    last_[segment] = n;
}

void Chains::insertAfter(std::uint32_t before, std::uint32_t vertex)
{
    const Links l = links(before);
    const std::uint32_t n = addNode(vertex, {l.segment, before, l.next});
    links(before).next = n;
    links(l.next).previous = n;
}

std::vector<std::uint32_t> Chains::lengths() const
{
    std::vector<std::uint32_t> result(first_.size(), 0);
    for (std::uint32_t v = 0; v < cells_.size(); ++v) {
        forEachAt(v, [&](std::uint32_t, std::uint32_t segment, std::uint32_t, std::uint32_t) {
            ++result[segment];
        });
    }
    return result;
}

void Chains::renameVertices(std::span<const std::uint32_t> newName, std::size_t vertexCount)
{
    const auto renamed = [&](std::uint32_t n) {
        return n == kNone || isFar(n) ? n : kNear * newName[n >> 1] + (n & 1U);
    };
    const auto rename = [&](Links& l) {
        l.previous = renamed(l.previous);
        l.next = renamed(l.next);
    };
    std::vector<Cell> cells(vertexCount);
    for (std::uint32_t v = 0; v < cells_.size(); ++v) {
        Cell& cell = cells_[v];
        if (cell.count > 0) {
            std::for_each_n(cell.near, std::min(cell.count, kNear), rename);
            cells[newName[v]] = cell;
        }
    }
    cells_ = std::move(cells);
    for (FarNode& node : far_) {
        rename(node.links);
        node.vertex = newName[node.vertex];
    }
    std::transform(first_.begin(), first_.end(), first_.begin(), renamed);
    std::transform(last_.begin(), last_.end(), last_.begin(), renamed);
}

} // namespace tessera
