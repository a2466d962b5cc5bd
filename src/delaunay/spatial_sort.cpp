// SPDX-License-Identifier: MIT

// Rounds: a point is in the last round with probability 15/16, in the one before with 15/256, ...,
// as long as a round has more than kSmallRound points. The choice hashes the point's index, so it
// is independent of the positions.
//
// Within a round: Hilbert index on a grid over the bounding box, from a table of 4 bits per axis
// and step. Round and index make one 32-bit key, sorted by radix. The points are then copied in
// order. Those that share a cell are sorted again by the same method over their own bounding box;
// so clusters of any scale come out in order. Each level of this recursion divides the box at least
// by 16; at kMaxDepth, or when all points of a cell are equal, the order of the indices stays.

#include "delaunay/spatial_sort.h"

#include "base/huge_pages.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <utility>

namespace tessera
{
namespace
{

constexpr std::size_t kSmallRound = 10000;
constexpr std::uint32_t kRatioBits = 4; ///< rounds differ by a factor of 16
constexpr std::uint32_t kRoundBits = 2; ///< in the key: at most four rounds
constexpr std::uint32_t kMaxBits = 14;  ///< of the grid, per axis
constexpr std::uint32_t kRadixBits = 10;
constexpr std::size_t kCrowded = 16; ///< points in one cell that are sorted further
constexpr int kMaxDepth = 60;
constexpr std::size_t kSmallRange = 256; ///< sorted by comparisons

/// One step of the Hilbert curve over a 16 x 16 grid: index and the next orientation.
struct HilbertStep
{
    std::uint8_t index;
    std::uint8_t orientation;
};
using HilbertTable = std::array<std::array<HilbertStep, 256>, 4>;

/// The curve's orientations: bit 0 swaps x and y, bit 1 turns by 180 degrees.
constexpr HilbertTable makeHilbertTable()
{
    HilbertTable table {};
    for (std::uint32_t start = 0; start < 4; ++start) {
        for (std::uint32_t xy = 0; xy < 256; ++xy) {
            std::uint32_t orientation = start;
            std::uint32_t index = 0;
            for (int bit = 3; bit >= 0; --bit) {
                std::uint32_t x = (xy >> (4 + bit)) & 1U;
                std::uint32_t y = (xy >> bit) & 1U;
                if ((orientation & 1U) != 0) {
                    std::swap(x, y);
                }
                if ((orientation & 2U) != 0) {
                    x ^= 1U;
                    y ^= 1U;
                }
                index = 4 * index + ((3 * x) ^ y);
                if (y == 0) {
                    orientation ^= 1U;
                    if (x == 1) {
                        orientation ^= 2U;
                    }
                }
            }
            table[start][xy] = {static_cast<std::uint8_t>(index),
                                static_cast<std::uint8_t>(orientation)};
        }
    }
    return table;
}
constexpr HilbertTable kHilbert = makeHilbertTable();

/// Hilbert index of a cell of the grid of 2^bits x 2^bits cells.
std::uint32_t hilbertIndex(std::uint32_t x, std::uint32_t y, std::uint32_t bits)
{
    const std::uint32_t rounded = (bits + 3) / 4 * 4;
    const std::uint32_t excess = rounded - bits;
    x <<= excess;
    y <<= excess;
    std::uint32_t index = 0;
    std::uint32_t orientation = 0;
    for (std::uint32_t shift = rounded; shift > 0;) {
        shift -= 4;
        const HilbertStep step
            = kHilbert[orientation][(((x >> shift) & 15U) << 4) | ((y >> shift) & 15U)];
        index = (index << 8) | step.index;
        orientation = step.orientation;
    }
    return index >> (2 * excess);
}

struct Item
{
    std::uint32_t key;
    std::uint32_t place; ///< where the point is before sorting
};

std::uint64_t mix(std::uint64_t x)
{
    x *= 0x9e3779b97f4a7c15ULL;
    x ^= x >> 32;
    x *= 0xd6e8feb86659fd93ULL;
    return x ^ (x >> 32);
}

class SpatialSort
{
public:
    SpatialSort(std::span<const Vec2> points, std::span<Vec2> sorted)
        : points_(points)
        , sorted_(sorted)
        , items_(std::make_unique_for_overwrite<Item[]>(points.size()))
        , order_(points.size())
    {
        preferHugePages(items_.get(), points.size() * sizeof(Item));
    }

    std::vector<std::uint32_t> run(const Box2& box)
    {
        const std::uint32_t count = rounds();
        const std::uint32_t bits = gridBits(points_.size());
        setKeys(points_, box, 0, bits);
        for (std::size_t i = 0; i < points_.size() && count > 1; ++i) {
            const auto zeros = static_cast<std::uint32_t>(std::countr_zero(mix(i + 1)));
            const std::uint32_t round = count - 1 - std::min(zeros / kRatioBits, count - 1);
            items_[i].key |= round << (2 * bits);
        }
        sortItems(0, points_.size(), 2 * bits + (count > 1 ? kRoundBits : 0));
        for (std::size_t i = 0; i < points_.size(); ++i) {
            order_[i] = items_[i].place;
            sorted_[i] = points_[items_[i].place];
        }
        sortCrowdedCells(0, points_.size(), 0);
        return std::move(order_);
    }

private:
    std::uint32_t rounds() const
    {
        std::uint32_t count = 1;
        for (std::size_t n = points_.size(); n > kSmallRound && count < (1U << kRoundBits);
             n >>= kRatioBits) {
            ++count;
        }
        return count;
    }

    /// Bits per axis for at least four cells a point.
    static std::uint32_t gridBits(std::size_t count)
    {
        const auto log = static_cast<std::uint32_t>(std::bit_width(count));
        return count < kSmallRange ? (log + 3) / 2 : kMaxBits;
    }

    /// Sets the items from `begin` on to the points' cells in the box and their numbers. False if
    /// there is one cell.
    bool setKeys(std::span<const Vec2> points, const Box2& box, std::size_t begin,
                 std::uint32_t bits)
    {
        const double side = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
        const double scale = side > 0.0 ? static_cast<double>(1U << bits) / side : 0.0;
        const auto last = static_cast<std::int32_t>((1U << bits) - 1);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto x = static_cast<std::int32_t>((points[i].x - box.min.x) * scale);
            const auto y = static_cast<std::int32_t>((points[i].y - box.min.y) * scale);
            items_[begin + i].key
                = hilbertIndex(static_cast<std::uint32_t>(std::min(x, last)),
                               static_cast<std::uint32_t>(std::min(y, last)), bits);
            items_[begin + i].place = static_cast<std::uint32_t>(i);
        }
        return side > 0.0;
    }

    void sortItems(std::size_t begin, std::size_t end, std::uint32_t keyBits)
    {
        if (end - begin >= kSmallRange) {
            radixSort(begin, end, keyBits);
            return;
        }
        std::sort(items_.get() + begin, items_.get() + end, [](const Item& a, const Item& b) {
            return a.key != b.key ? a.key < b.key : a.place < b.place;
        });
    }

    /// Stable.
    void radixSort(std::size_t begin, std::size_t end, std::uint32_t keyBits)
    {
        constexpr std::uint32_t kMaxKeyBits = 2 * kMaxBits + kRoundBits;
        constexpr std::uint32_t kMaxPasses = (kMaxKeyBits + kRadixBits - 1) / kRadixBits;
        const std::uint32_t passes = (keyBits + kRadixBits - 1) / kRadixBits;
        const std::uint32_t mask = (1U << kRadixBits) - 1;
        const std::size_t count = end - begin;
        if (scratch_ == nullptr) {
            scratch_ = std::make_unique_for_overwrite<Item[]>(points_.size());
            preferHugePages(scratch_.get(), points_.size() * sizeof(Item));
        }
        Item* from = items_.get() + begin;
        Item* to = scratch_.get();
        std::array<std::array<std::uint32_t, mask + 1>, kMaxPasses> starts {};
        for (std::size_t i = 0; i < count; ++i) {
            for (std::uint32_t pass = 0; pass < kMaxPasses; ++pass) {
                ++starts[pass][(from[i].key >> (pass * kRadixBits)) & mask];
            }
        }
        for (std::uint32_t pass = 0; pass < passes; ++pass) {
            std::uint32_t sum = 0;
            for (std::uint32_t& start : starts[pass]) {
                sum += std::exchange(start, sum);
            }
            for (std::size_t i = 0; i < count; ++i) {
                to[starts[pass][(from[i].key >> (pass * kRadixBits)) & mask]++] = from[i];
            }
            std::swap(from, to);
        }
        if (passes % 2 == 1) {
            std::copy(from, from + count, to);
        }
    }

    void sortCrowdedCells(std::size_t begin, std::size_t end, int depth)
    {
        for (std::size_t i = begin; i < end;) {
            const std::uint32_t key = items_[i].key;
            std::size_t j = i + 1;
            while (j < end && items_[j].key == key) {
                ++j;
            }
            if (j - i > kCrowded && depth < kMaxDepth) {
                sortCell(i, j, depth + 1);
            }
            i = j;
        }
    }

    /// Sorts points that are in their places up to their order in this range. Uses the items of the
    /// range only, so that the caller's, behind it, stay.
    void sortCell(std::size_t begin, std::size_t end, int depth)
    {
        const std::size_t count = end - begin;
        const std::uint32_t bits = gridBits(count);
        const auto points = sorted_.subspan(begin, count);
        Box2 box;
        for (const Vec2 p : points) {
            box.add(p);
        }
        if (!setKeys(points, box, begin, bits)) {
            return;
        }
        sortItems(begin, end, 2 * bits);
        cellPoints_.assign(sorted_.begin() + static_cast<std::ptrdiff_t>(begin),
                           sorted_.begin() + static_cast<std::ptrdiff_t>(end));
        cellOrder_.assign(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                          order_.begin() + static_cast<std::ptrdiff_t>(end));
        for (std::size_t i = begin; i < end; ++i) {
            sorted_[i] = cellPoints_[items_[i].place];
            order_[i] = cellOrder_[items_[i].place];
        }
        sortCrowdedCells(begin, end, depth);
    }

    std::span<const Vec2> points_;
    std::span<Vec2> sorted_;
    std::unique_ptr<Item[]> items_;
    std::unique_ptr<Item[]> scratch_;
    std::vector<std::uint32_t> order_;
    std::vector<Vec2> cellPoints_;
    std::vector<std::uint32_t> cellOrder_;
};

} // namespace

std::vector<std::uint32_t> sortForInsertion(std::span<const Vec2> points, const Box2& box,
                                            std::span<Vec2> sorted)
{
    return SpatialSort(points, sorted).run(box);
}

} // namespace tessera
