// SPDX-License-Identifier: MIT
//
// A quadtree whose corners each know the place whose size, grown by the distance, is the least
// there. Rounds of: spread these places from corner to corner within cells, big and small, until
// nothing changes (the distance is measured from the place itself, so that nothing piles up on the
// way); split the cells whose bilinear surface misses the field in the middle of the cell or of a
// side. A cell is not split below a part of the size in it. All cells together are bounded in
// number; beyond that bound the field stays limited in growth but gets coarse.
//
// Complexity: a round is linear in the number of cells; the rounds are as many as levels, about.
#include "sizing/area_size.h"

#include "base/error.h"
#include "base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tessera
{

namespace
{

/// Cells along the longer side of the box before any is split, and most along a thin box.
constexpr double kRoots = 128.0;
constexpr double kMostRoots = 4096.0;
constexpr int kMostLevels = 18;
constexpr std::size_t kMostCells = 1500000;
/// Slope of what spreads, as a part of growth: leaves room for interpolation.
constexpr double kSlopeShare = 0.95;
/// Interpolation error allowed, as a part of growth and size.
constexpr double kErrorShare = 0.02;
/// Longest side of a cell that is not split any more, as a part of the size in it.
constexpr double kFinest = 0.15;
constexpr int kMostSweeps = 60;

/// Numbers for positions on the grid, by open addressing.
class PositionTable
{
public:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    PositionTable()
        : slots_(1U << 16, Slot {0, kNone})
    {}

    std::uint32_t find(std::uint64_t key) const { return slots_[slotOf(key)].number; }
    void add(std::uint64_t key, std::uint32_t number)
    {
        if (2 * ++count_ > slots_.size()) {
            grow();
        }
        slots_[slotOf(key)] = {key, number};
    }

private:
    struct Slot
    {
        std::uint64_t key;
        std::uint32_t number;
    };

    std::size_t slotOf(std::uint64_t key) const
    {
        const std::size_t mask = slots_.size() - 1;
        // Grid positions differ in few bits: all of them must reach the low ones.
        std::uint64_t mixed = (key ^ (key >> 33U)) * 0xff51afd7ed558ccdULL;
        mixed = (mixed ^ (mixed >> 33U)) * 0xc4ceb9fe1a85ec53ULL;
        std::size_t i = (mixed ^ (mixed >> 33U)) & mask;
        while (slots_[i].number != kNone && slots_[i].key != key) {
            i = (i + 1) & mask;
        }
        return i;
    }
    void grow()
    {
        std::vector<Slot> old(2 * slots_.size(), Slot {0, kNone});
        old.swap(slots_);
        for (const Slot& slot : old) {
            if (slot.number != kNone) {
                slots_[slotOf(slot.key)] = slot;
            }
        }
    }

    std::vector<Slot> slots_;
    std::size_t count_ = 0;
};

} // namespace

class AreaSizeBuilder
{
public:
    /// Thrown where a size is no number above 0 in a place that is not meshed.
    struct BadOutside
    {};

    AreaSizeBuilder(AreaSize& field, std::span<const AreaSource> sources,
                    const AreaSize::Options& options, bool ignoreOutside, Execution& execution)
        : field_(field)
        , sources_(sources)
        , options_(options)
        , ignoreOutside_(ignoreOutside)
        , execution_(execution)
        , slope_(kSlopeShare * options.growth)
    {}

    void run()
    {
        makeRoots();
        lookAtDetails();
        for (std::size_t untested = 0; untested < cells_.size();) {
            spread();
            untested = splitCells();
        }
        store();
    }

private:
    /// Of a cell, lower left first: 0 1 / 2 3, x fastest.
    struct Corner
    {
        Vec2 position;
        double value;
        Vec2 place;  ///< where the value comes from
        double size; ///< there
    };
    struct Cell
    {
        std::uint32_t x; ///< of the lower left corner, in grid steps
        std::uint32_t y;
        std::uint32_t step; ///< side in grid steps
        std::uint32_t child = 0;
        std::array<std::uint32_t, 4> corner {};
        std::uint32_t spreadAt = 0; ///< the last change that was spread within it
        double tested = 0.0; ///< the sum of the corners' values with which it was found good
    };

    static constexpr std::uint32_t kRootStep = 1U << kMostLevels;

    double wanted(Vec2 p) const
    {
        double least = options_.maxSize;
        if (ignoreOutside_ && isOutside(p)) {
            return std::max(least, options_.minSize);
        }
        for (const AreaSource& source : sources_) {
            const double h = source.size(p);
            if (!(h > 0.0) || (source.asksEverywhere && std::isinf(h))) {
                if (isOutside(p)) {
                    throw BadOutside();
                }
                throw Error(ErrorKind::InvalidOption,
                            source.name.substr(0, 200) + " is " + numberText(h) + " at "
                                + placeText(p)
                                + "; it must be a number above 0 in all that is meshed, as with "
                                  "max(..., 0.1).",
                            {{p}});
            }
            least = std::min(least, h);
        }
        return std::max(least, options_.minSize);
    }

    /// Neither the place nor any other that close to it is meshed: what lies on a boundary is.
    bool isOutside(Vec2 p) const
    {
        if (!options_.inside) {
            return false;
        }
        const double step = 1e-6 * field_.box_.diagonal();
        const std::array<Vec2, 5> places {p, {p.x - step, p.y - step}, {p.x + step, p.y - step},
                                          {p.x - step, p.y + step}, {p.x + step, p.y + step}};
        return std::none_of(places.begin(), places.end(), options_.inside);
    }

    Vec2 positionOf(std::uint32_t x, std::uint32_t y) const
    {
        const Box2& box = field_.box_;
        const double u = x / (field_.countX_ * kRootStep);
        const double v = y / (field_.countY_ * kRootStep);
        return {box.min.x + u * (box.max.x - box.min.x), box.min.y + v * (box.max.y - box.min.y)};
    }

    static std::uint64_t keyOf(std::uint32_t x, std::uint32_t y)
    {
        return (static_cast<std::uint64_t>(x) << 32U) | y;
    }

    std::uint32_t cornerAt(std::uint32_t x, std::uint32_t y)
    {
        const std::uint64_t key = keyOf(x, y);
        std::uint32_t number = table_.find(key);
        if (number == PositionTable::kNone) {
            number = static_cast<std::uint32_t>(corners_.size());
            const Vec2 p = positionOf(x, y);
            const double h = wanted(p);
            corners_.push_back({p, h, p, h});
            changedAt_.push_back(++changes_);
            table_.add(key, number);
        }
        return number;
    }

    void makeRoots()
    {
        const Box2& box = field_.box_;
        const double width = box.max.x - box.min.x;
        const double height = box.max.y - box.min.y;
        const double longer = std::max(width, height);
        const double shorter = std::min(width, height);
        const double side = std::max(std::min(longer / kRoots, shorter), longer / kMostRoots);
        field_.countX_ = std::max(1.0, std::ceil(width / side * (1.0 - 1e-9)));
        field_.countY_ = std::max(1.0, std::ceil(height / side * (1.0 - 1e-9)));
        side_ = {width / field_.countX_, height / field_.countY_};
        const auto nx = static_cast<std::uint32_t>(field_.countX_);
        const auto ny = static_cast<std::uint32_t>(field_.countY_);
        for (std::uint32_t y = 0; y < ny; ++y) {
            execution_.checkpoint();
            for (std::uint32_t x = 0; x < nx; ++x) {
                addCell(x * kRootStep, y * kRootStep, kRootStep);
            }
        }
    }

    void addCell(std::uint32_t x, std::uint32_t y, std::uint32_t step)
    {
        Cell cell {x, y, step};
        for (std::uint32_t i = 0; i < 4; ++i) {
            cell.corner[i] = cornerAt(x + (i % 2) * step, y + (i / 2) * step);
        }
        cells_.push_back(cell);
    }

    void split(std::size_t c)
    {
        const Cell cell = cells_[c];
        const std::uint32_t half = cell.step / 2;
        cells_[c].child = static_cast<std::uint32_t>(cells_.size());
        for (std::uint32_t i = 0; i < 4; ++i) {
            addCell(cell.x + (i % 2) * half, cell.y + (i / 2) * half, half);
        }
    }

    double lengthOf(const Cell& cell) const
    {
        return std::max(side_.x, side_.y) * cell.step / kRootStep;
    }

    void lookAtDetails()
    {
        const double longest = std::max(side_.x, side_.y);
        for (const AreaSource& source : sources_) {
            for (const AreaSource::Detail& detail : source.details) {
                if (detail.scale < longest && field_.box_.contains(detail.place)) {
                    splitAround(detail);
                }
            }
        }
    }

    void splitAround(const AreaSource::Detail& detail)
    {
        const Vec2 offset = detail.place - field_.box_.min;
        const auto along = [](double x, double side, double count) {
            return side > 0.0 ? std::min(x / side, count * (1.0 - 1e-12)) : 0.0;
        };
        const double u = along(offset.x, side_.x, field_.countX_);
        const double v = along(offset.y, side_.y, field_.countY_);
        const auto x = static_cast<std::uint32_t>(u * kRootStep);
        const auto y = static_cast<std::uint32_t>(v * kRootStep);
        std::size_t c = static_cast<std::size_t>(v) * static_cast<std::size_t>(field_.countX_)
            + static_cast<std::size_t>(u);
        while (lengthOf(cells_[c]) > detail.scale && cells_[c].step > 1
               && cells_.size() < kMostCells) {
            if (cells_[c].child == 0) {
                split(c);
            }
            const Cell& cell = cells_[c];
            const std::uint32_t half = cell.step / 2;
            c = cell.child + (x >= cell.x + half ? 1U : 0U) + (y >= cell.y + half ? 2U : 0U);
        }
    }

    /// Lowers q to what comes from p's place, if that is less.
    bool lower(Corner& q, const Corner& p) const
    {
        // Most corners are far below what could reach them.
        if (p.size >= q.value) {
            return false;
        }
        const double value = p.size + slope_ * std::sqrt(squaredLength(q.position - p.place));
        if (!(value < q.value * (1.0 - 1e-12))) {
            return false;
        }
        q.value = value;
        q.place = p.place;
        q.size = p.size;
        return true;
    }

    /// False if nothing has changed in the cell since the last time.
    bool spreadWithin(Cell& cell)
    {
        const auto isNew = [&](std::uint32_t corner) { return changedAt_[corner] > cell.spreadAt; };
        if (std::none_of(cell.corner.begin(), cell.corner.end(), isNew)) {
            return false;
        }
        for (const std::uint32_t from : cell.corner) {
            for (const std::uint32_t to : cell.corner) {
                if (lower(corners_[to], corners_[from])) {
                    changedAt_[to] = ++changes_;
                }
            }
        }
        cell.spreadAt = changes_;
        return true;
    }

    void spread()
    {
        for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
            bool changed = false;
            execution_.checkpoint();
            for (std::size_t c = 0; c < cells_.size(); ++c) {
                changed = spreadWithin(cells_[c]) || changed;
            }
            execution_.checkpoint();
            for (std::size_t c = cells_.size(); c-- > 0;) {
                changed = spreadWithin(cells_[c]) || changed;
            }
            if (!changed) {
                return;
            }
        }
    }

    /// The field where there may be no corner yet.
    double valueAt(const Cell& cell, std::uint32_t x, std::uint32_t y) const
    {
        const Vec2 p = positionOf(x, y);
        Corner here {p, wanted(p), p, 0.0};
        for (const std::uint32_t corner : cell.corner) {
            lower(here, corners_[corner]);
        }
        return here.value;
    }

    /// Whether the bilinear surface meets the field in the middle of the cell and of its sides.
    bool isGoodEnough(Cell& cell) const
    {
        double at[4];
        for (std::size_t i = 0; i < 4; ++i) {
            at[i] = corners_[cell.corner[i]].value;
        }
        const double least = std::min({at[0], at[1], at[2], at[3]});
        if (lengthOf(cell) <= kFinest * least || cell.step == 1) {
            return true;
        }
        const double allowed = kErrorShare * options_.growth * least;
        const std::uint32_t half = cell.step / 2;
        const double sum = at[0] + at[1] + at[2] + at[3];
        const bool same = sum == cell.tested;
        const auto meets = [&](std::uint32_t i, std::uint32_t j, double expected) {
            const std::uint32_t x = cell.x + i * half;
            const std::uint32_t y = cell.y + j * half;
            const std::uint32_t known = table_.find(keyOf(x, y));
            if (known == PositionTable::kNone && same) {
                return true;
            }
            const double value =
                known != PositionTable::kNone ? corners_[known].value : valueAt(cell, x, y);
            return std::abs(value - expected) <= allowed;
        };
        const bool good = meets(1, 1, 0.25 * sum) && meets(1, 0, 0.5 * (at[0] + at[1]))
            && meets(0, 1, 0.5 * (at[0] + at[2])) && meets(2, 1, 0.5 * (at[1] + at[3]))
            && meets(1, 2, 0.5 * (at[2] + at[3]));
        cell.tested = good ? sum : 0.0;
        return good;
    }

    /// Splits the cells that need it; returns where the new ones begin.
    std::size_t splitCells()
    {
        const std::size_t before = cells_.size();
        for (std::size_t c = 0; c < before && cells_.size() < kMostCells; ++c) {
            if (c % 1024 == 0) {
                execution_.checkpoint();
            }
            if (cells_[c].child == 0 && !isGoodEnough(cells_[c])) {
                split(c);
            }
        }
        return before;
    }

    void store()
    {
        field_.cells_.reserve(cells_.size());
        for (const Cell& cell : cells_) {
            if (cell.child != 0) {
                field_.cells_.push_back(AreaSize::kSplit | cell.child);
                continue;
            }
            field_.cells_.push_back(static_cast<std::uint32_t>(field_.values_.size()));
            for (const std::uint32_t corner : cell.corner) {
                field_.values_.push_back(corners_[corner].value);
            }
        }
    }

    AreaSize& field_;
    std::span<const AreaSource> sources_;
    const AreaSize::Options& options_;
    bool ignoreOutside_;
    Execution& execution_;
    double slope_;
    Vec2 side_ {}; ///< of a root
    PositionTable table_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> changedAt_; ///< by corner: the number of its last change
    std::uint32_t changes_ = 0;
    std::vector<Cell> cells_;
};

AreaSize::AreaSize(const Box2& box, std::span<const AreaSource> sources, const Options& options,
                   Execution& execution)
    : box_(box)
    , growth_(options.growth)
{
    try {
        AreaSizeBuilder(*this, sources, options, false, execution).run();
    }
    catch (const AreaSizeBuilder::BadOutside&) {
        AreaSizeBuilder(*this, sources, options, true, execution).run();
    }
    const double width = box.max.x - box.min.x;
    const double height = box.max.y - box.min.y;
    perRoot_ = {width > 0.0 ? countX_ / width : 0.0, height > 0.0 ? countY_ / height : 0.0};
}

double AreaSize::size(Vec2 p) const
{
    // From here on x and y are relative to the cell in hand, whose sides are 1.
    double x = (std::clamp(p.x, box_.min.x, box_.max.x) - box_.min.x) * perRoot_.x;
    double y = (std::clamp(p.y, box_.min.y, box_.max.y) - box_.min.y) * perRoot_.y;
    const double column = std::min(std::floor(x), countX_ - 1.0);
    const double row = std::min(std::floor(y), countY_ - 1.0);
    x = std::min(x - column, 1.0);
    y = std::min(y - row, 1.0);
    std::uint32_t cell = cells_[static_cast<std::size_t>(row * countX_ + column)];
    while ((cell & kSplit) != 0) {
        const bool right = x >= 0.5;
        const bool upper = y >= 0.5;
        cell = cells_[(cell & ~kSplit) + (right ? 1U : 0U) + (upper ? 2U : 0U)];
        x = 2.0 * x - (right ? 1.0 : 0.0);
        y = 2.0 * y - (upper ? 1.0 : 0.0);
    }
    const double* at = &values_[cell];
    return (1.0 - y) * ((1.0 - x) * at[0] + x * at[1]) + y * ((1.0 - x) * at[2] + x * at[3]);
}

} // namespace tessera
