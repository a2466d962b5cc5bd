// SPDX-License-Identifier: MIT
//
// Welding by a grid of square cells whose diagonal is the tolerance: all points of a cell are
// within it of each other (up to rounding, so the first one vouches for the rest), and their
// partners lie in the 5 x 5 cells around. Cells are sorted by row, so that three binary searches
// find the half of them that comes after. O(n log n), unless neighboring cells hold many points but
// none within the tolerance of each other.
#include "arrange/weld.h"

#include "base/box2.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace tessera
{

namespace
{

class UnionFind
{
public:
    explicit UnionFind(std::size_t count)
        : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    std::uint32_t find(std::uint32_t i)
    {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    /// The lowest number stays the root.
    void unite(std::uint32_t i, std::uint32_t j)
    {
        i = find(i);
        j = find(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// A square of the grid and its points, order_[begin .. end).
struct Cell
{
    double column;
    double row;
    std::uint32_t begin;
    std::uint32_t end;
};

class Welder
{
public:
    Welder(std::span<const Vec2> points, std::span<const std::uint8_t> wanted, double tolerance,
           const Execution& execution)
        : points_(points)
        , tolerance_(tolerance)
        , execution_(execution)
        , clusters_(points.size())
        , lowestEqual_(points.size())
    {
        std::iota(lowestEqual_.begin(), lowestEqual_.end(), 0U);
        for (std::uint32_t p = 0; p < points.size(); ++p) {
            if (wanted[p] != 0) {
                order_.push_back(p);
            }
        }
    }

    WeldResult run()
    {
        uniteEqualPoints();
        if (tolerance_ > 0.0) {
            uniteNeighbors();
        }
        return collect();
    }

private:
    /// Leaves one point of each position in order_, so that thousands of equal points cost nothing.
    void uniteEqualPoints()
    {
        std::sort(order_.begin(), order_.end(), [this](std::uint32_t p, std::uint32_t q) {
            const Vec2 a = points_[p];
            const Vec2 b = points_[q];
            return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : p < q);
        });
        std::size_t kept = 0;
        for (const std::uint32_t p : order_) {
            if (kept > 0 && points_[order_[kept - 1]] == points_[p]) {
                lowestEqual_[p] = order_[kept - 1];
                clusters_.unite(order_[kept - 1], p);
            }
            else {
                order_[kept++] = p;
            }
        }
        order_.resize(kept);
    }

    void uniteNeighbors()
    {
        sortIntoCells();
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (i % 256 == 0) {
                execution_.checkpoint();
            }
            const Cell& cell = cells_[i];
            for (double row = cell.row; row <= cell.row + 2.0; row += 1.0) {
                const Cell from {cell.column - 2.0, row, 0, 0};
                for (auto other = std::lower_bound(cells_.begin(), cells_.end(), from, isBefore);
                     other != cells_.end() && other->row == row
                     && other->column <= cell.column + 2.0;
                     ++other) {
                    uniteIfNear(cell, *other);
                }
                if (row + 1.0 == row) {
                    break; // cells finer than the coordinates: partners are equal points
                }
            }
        }
    }

    static bool isBefore(const Cell& a, const Cell& b)
    {
        return a.row != b.row ? a.row < b.row : a.column < b.column;
    }

    void sortIntoCells()
    {
        const double side = tolerance_ / std::numbers::sqrt2;
        std::vector<std::pair<Cell, std::uint32_t>> entries;
        entries.reserve(order_.size());
        for (const std::uint32_t p : order_) {
            const Vec2 a = points_[p];
            entries.push_back({{std::floor(a.x / side), std::floor(a.y / side), 0, 0}, p});
        }
        std::stable_sort(entries.begin(), entries.end(),
                         [](const auto& a, const auto& b) { return isBefore(a.first, b.first); });
        for (std::uint32_t i = 0; i < entries.size(); ++i) {
            order_[i] = entries[i].second;
            if (cells_.empty() || isBefore(cells_.back(), entries[i].first)) {
                cells_.push_back({entries[i].first.column, entries[i].first.row, i, i});
            }
            cells_.back().end = i + 1;
            uniteIfNear(order_[cells_.back().begin], order_[i]);
        }
    }

    void uniteIfNear(const Cell& cell, const Cell& other)
    {
        for (std::uint32_t i = cell.begin; i < cell.end; ++i) {
            for (std::uint32_t j = other.begin; j < other.end; ++j) {
                if (clusters_.find(order_[i]) == clusters_.find(order_[j])) {
                    return;
                }
                uniteIfNear(order_[i], order_[j]);
            }
        }
    }

    void uniteIfNear(std::uint32_t p, std::uint32_t q)
    {
        if (distance(points_[p], points_[q]) <= tolerance_) {
            clusters_.unite(p, q);
        }
    }

    WeldResult collect()
    {
        const std::vector<std::uint8_t> isChain = findChains();
        WeldResult result;
        result.representative.resize(points_.size());
        for (std::uint32_t p = 0; p < points_.size(); ++p) {
            const std::uint32_t root = clusters_.find(p);
            result.representative[p] = isChain[root] != 0 ? lowestEqual_[p] : root;
            if (isChain[p] != 0) {
                result.chainsLeft.push_back(p);
            }
        }
        return result;
    }

    /// By lowest point of each cluster: it is too long.
    std::vector<std::uint8_t> findChains()
    {
        std::vector<std::uint8_t> isChain(points_.size(), 0);
        const auto root = [this](std::uint32_t p) { return clusters_.find(p); };
        std::stable_sort(order_.begin(), order_.end(), [&root](std::uint32_t p, std::uint32_t q) {
            return root(p) < root(q);
        });
        for (std::size_t i = 0; i < order_.size();) {
            std::size_t j = i;
            while (j < order_.size() && root(order_[j]) == root(order_[i])) {
                ++j;
            }
            if (!withinTwiceTolerance({order_.data() + i, j - i})) {
                isChain[root(order_[i])] = 1;
            }
            i = j;
        }
        return isChain;
    }

    bool withinTwiceTolerance(std::span<const std::uint32_t> cluster) const
    {
        Box2 box;
        for (const std::uint32_t p : cluster) {
            box.add(points_[p]);
        }
        if (box.diagonal() <= 2.0 * tolerance_) {
            return true;
        }
        if (std::max(box.max.x - box.min.x, box.max.y - box.min.y) > 2.0 * tolerance_) {
            return false;
        }
        for (std::size_t i = 0; i < cluster.size(); ++i) {
            for (std::size_t j = i + 1; j < cluster.size(); ++j) {
                if (distance(points_[cluster[i]], points_[cluster[j]]) > 2.0 * tolerance_) {
                    return false;
                }
            }
        }
        return true;
    }

    std::span<const Vec2> points_;
    double tolerance_;
    const Execution& execution_;
    UnionFind clusters_;
    std::vector<std::uint32_t> lowestEqual_; ///< by point: the lowest one at its position
    std::vector<std::uint32_t> order_;       ///< the points in hand, one of each position
    std::vector<Cell> cells_;                ///< by row, then column
};

/// Puts the representative of each cluster of points from first on at its middlemost member.
void centerClusters(std::span<Vec2> points, std::span<const std::uint32_t> representative,
                    std::size_t first)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> members; // (representative, point)
    for (auto p = static_cast<std::uint32_t>(first); p < points.size(); ++p) {
        if (representative[p] >= first) {
            members.emplace_back(representative[p], p);
        }
    }
    std::sort(members.begin(), members.end());
    std::vector<double> values;
    const auto median = [&](std::size_t begin, std::size_t end, double Vec2::*coordinate) {
        values.clear();
        for (std::size_t i = begin; i < end; ++i) {
            values.push_back(points[members[i].second].*coordinate);
        }
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    for (std::size_t i = 0; i < members.size();) {
        std::size_t j = i;
        while (j < members.size() && members[j].first == members[i].first) {
            ++j;
        }
        if (j - i > 2) {
            const Vec2 center {median(i, j, &Vec2::x), median(i, j, &Vec2::y)};
            const auto nearer = [&](const auto& a, const auto& b) {
                return squaredLength(points[a.second] - center)
                    < squaredLength(points[b.second] - center);
            };
            const auto best = std::min_element(members.begin() + static_cast<std::ptrdiff_t>(i),
                                               members.begin() + static_cast<std::ptrdiff_t>(j),
                                               nearer);
            points[members[i].first] = points[best->second];
        }
        i = j;
    }
}

} // namespace

WeldResult weldPoints(std::span<const Vec2> points, std::span<const std::uint8_t> wanted,
                      double tolerance, const Execution& execution)
{
    return Welder(points, wanted, tolerance, execution).run();
}

WeldResult weldMadePoints(std::span<Vec2> points, const MadePoints& made, double tolerance,
                          double rounding, const Execution& execution)
{
    const std::vector<std::uint8_t> all(points.size(), 1);
    WeldResult result = weldPoints(points, all, tolerance, execution);
    std::vector<std::uint8_t> crossings(points.size(), 0);
    for (std::uint32_t p = 0; p < points.size(); ++p) {
        if (p < made.inputCount) {
            result.representative[p] = p; // welded before
        }
        else if (result.representative[p] >= made.firstCrossing) {
            crossings[p] = 1;
        }
    }
    const WeldResult close = weldPoints(points, crossings, rounding, execution);
    for (std::uint32_t p = 0; p < points.size(); ++p) {
        if (crossings[p] != 0) {
            result.representative[p] = close.representative[p];
        }
    }
    std::erase_if(result.chainsLeft, [&made](std::uint32_t p) { return p >= made.firstCrossing; });
    result.chainsLeft.insert(result.chainsLeft.end(), close.chainsLeft.begin(),
                             close.chainsLeft.end());
    centerClusters(points, result.representative, made.firstCrossing);
    return result;
}

} // namespace tessera
