// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tessera
{

/// A balanced tree of boxes for finding overlaps. Built in O(n log n); reports in an order that
/// depends on the boxes only.
class BoxTree
{
public:
    explicit BoxTree(std::span<const Box2> boxes)
        : boxes_(boxes.begin(), boxes.end())
        , items_(boxes.size())
    {
        for (std::uint32_t i = 0; i < items_.size(); ++i) {
            items_[i] = i;
        }
        if (!items_.empty()) {
            build(0, static_cast<std::uint32_t>(items_.size()));
        }
    }

    /// Calls f(i, j), i != j, once for every pair of overlapping boxes.
    template<class F>
    void forEachPair(F&& f) const
    {
        if (!nodes_.empty()) {
            pairsWithin(0, f);
        }
    }

    /// Calls f(i) for every box that overlaps the given one.
    template<class F>
    void forEachOverlap(const Box2& box, F&& f) const
    {
        std::vector<std::uint32_t> stack;
        if (!nodes_.empty()) {
            stack.push_back(0);
        }
        while (!stack.empty()) {
            const Node& node = nodes_[stack.back()];
            stack.pop_back();
            if (!node.box.overlaps(box)) {
                continue;
            }
            if (node.right == 0) {
                for (std::uint32_t k = node.begin; k < node.end; ++k) {
                    if (boxes_[items_[k]].overlaps(box)) {
                        f(items_[k]);
                    }
                }
                continue;
            }
            stack.push_back(node.right);
            stack.push_back(node.left);
        }
    }

    /// Looks for the item nearest to p: calls f(i), which returns the square of the least distance
    /// found so far, for every item whose box is nearer than that, nearer boxes first.
    template<class F>
    void searchNearest(Vec2 p, F&& f) const
    {
        if (!nodes_.empty()) {
            double best = std::numeric_limits<double>::infinity();
            searchNearest(0, p, best, f);
        }
    }

private:
    static constexpr std::uint32_t kLeafSize = 4;

    static double squaredDistance(const Box2& box, Vec2 p)
    {
        const double x = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
        const double y = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
        return x * x + y * y;
    }

    template<class F>
    void searchNearest(std::uint32_t index, Vec2 p, double& best, F& f) const
    {
        const Node& node = nodes_[index];
        if (node.right == 0) {
            for (std::uint32_t k = node.begin; k < node.end; ++k) {
                if (squaredDistance(boxes_[items_[k]], p) < best) {
                    best = f(items_[k]);
                }
            }
            return;
        }
        std::uint32_t nearer = node.left;
        std::uint32_t farther = node.right;
        double toNearer = squaredDistance(nodes_[nearer].box, p);
        double toFarther = squaredDistance(nodes_[farther].box, p);
        if (toFarther < toNearer) {
            std::swap(nearer, farther);
            std::swap(toNearer, toFarther);
        }
        if (toNearer < best) {
            searchNearest(nearer, p, best, f);
        }
        if (toFarther < best) {
            searchNearest(farther, p, best, f);
        }
    }

    struct Node
    {
        Box2 box;
        std::uint32_t begin; ///< of items_
        std::uint32_t end;
        std::uint32_t left = 0;
        std::uint32_t right = 0; ///< 0: a leaf
    };

    std::uint32_t build(std::uint32_t begin, std::uint32_t end)
    {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({{}, begin, end});
        Box2 box;
        Box2 centers;
        for (std::uint32_t k = begin; k < end; ++k) {
            box.add(boxes_[items_[k]]);
            centers.add(boxes_[items_[k]].center());
        }
        nodes_[index].box = box;
        if (end - begin <= kLeafSize) {
            return index;
        }
        const bool byX = centers.max.x - centers.min.x >= centers.max.y - centers.min.y;
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                         [this, byX](std::uint32_t i, std::uint32_t j) {
                             const Vec2 p = boxes_[i].center();
                             const Vec2 q = boxes_[j].center();
                             return std::pair(byX ? p.x : p.y, i) < std::pair(byX ? q.x : q.y, j);
                         });
        const std::uint32_t left = build(begin, middle);
        const std::uint32_t right = build(middle, end);
        nodes_[index].left = left;
        nodes_[index].right = right;
        return index;
    }

    template<class F>
    void pairsWithin(std::uint32_t index, F& f) const
    {
        const Node& node = nodes_[index];
        if (node.right != 0) {
            pairsWithin(node.left, f);
            pairsWithin(node.right, f);
            pairsBetween(node.left, node.right, f);
            return;
        }
        for (std::uint32_t k = node.begin; k < node.end; ++k) {
            for (std::uint32_t l = k + 1; l < node.end; ++l) {
                reportIfOverlapping(k, l, f);
            }
        }
    }

    template<class F>
    void pairsBetween(std::uint32_t p, std::uint32_t q, F& f) const
    {
        const Node& a = nodes_[p];
        const Node& b = nodes_[q];
        if (!a.box.overlaps(b.box)) {
            return;
        }
        if (a.right == 0 && b.right == 0) {
            for (std::uint32_t k = a.begin; k < a.end; ++k) {
                for (std::uint32_t l = b.begin; l < b.end; ++l) {
                    reportIfOverlapping(k, l, f);
                }
            }
        }
        else if (b.right == 0 || (a.right != 0 && a.box.diagonal() >= b.box.diagonal())) {
            pairsBetween(a.left, q, f);
            pairsBetween(a.right, q, f);
        }
        else {
            pairsBetween(p, b.left, f);
            pairsBetween(p, b.right, f);
        }
    }

    template<class F>
    void reportIfOverlapping(std::uint32_t k, std::uint32_t l, F& f) const
    {
        if (boxes_[items_[k]].overlaps(boxes_[items_[l]])) {
            f(items_[k], items_[l]);
        }
    }

    std::vector<Box2> boxes_;
    std::vector<std::uint32_t> items_;
    std::vector<Node> nodes_;
};

} // namespace tessera
