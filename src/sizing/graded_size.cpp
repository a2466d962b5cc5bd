// SPDX-License-Identifier: MIT
//
// A minimum of cones over segments, kept in a quadtree. On the way down each cell passes on only
// the sources that can be the least somewhere in it. A cell is finished when nothing is below the
// largest size, when few sources are left (then it keeps them and is exact), or when bilinear
// interpolation of its corners meets the exact values at its test points; else it is split. Along
// the lines where two far sources are equally strong, cells end as short lists, so that the tree
// grows with the number of sources and not with the precision.
#include "sizing/graded_size.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tessera
{

namespace
{

constexpr std::size_t kShortList = 8;
/// Cells of this depth are far smaller than any size that doubles can tell apart in the box.
constexpr int kMaxDepth = 45;
/// slope_ / growth_, and the interpolation error allowed, as a part of growth and size: two points
/// d apart then differ by at most growth (0.97 d + 0.02 h) <= growth d once d >= 2/3 h.
constexpr double kSlopeShare = 0.97;
constexpr double kErrorShare = 0.01;
/// Change of the sizes over a cell, as a part of them: above the first, five tests cannot vouch for
/// a surface; below the second, a source that wins at no test can hardly win between them.
constexpr double kCoarseCell = 0.5;
constexpr double kSmallCell = 0.06;

double bilinear(const double* at, double x, double y)
{
    return (1.0 - y) * ((1.0 - x) * at[0] + x * at[1]) + y * ((1.0 - x) * at[2] + x * at[3]);
}

} // namespace

class GradedSizeBuilder
{
public:
    GradedSizeBuilder(GradedSize& field, const Execution& execution)
        : field_(field)
        , sources_(field.sources_)
        , execution_(execution)
    {}

    void run()
    {
        for (std::uint32_t i = 0; i < sources_.size(); ++i) {
            if (sources_[i].size < field_.maxSize_) {
                candidates_.push_back(i);
            }
        }
        field_.cells_.resize(1);
        const Square whole {field_.origin_, field_.side_};
        const Range all {0, candidates_.size()};
        Corners corners {};
        for (std::uint32_t i = 0; i < 4; ++i) {
            corners[i] = exact(whole.at(i % 2, i / 2), all);
        }
        build(0, whole, all, corners, 0);
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    /// A value of the field and the source that makes it; none if a bound does.
    struct Winner
    {
        double value;
        std::uint32_t source;
    };
    /// Of a cell: lower left, lower right, upper left, upper right.
    using Corners = std::array<Winner, 4>;

    struct Square
    {
        Vec2 corner;
        double side;

        Vec2 at(double x, double y) const { return {corner.x + x * side, corner.y + y * side}; }
    };

    /// Of candidates_.
    struct Range
    {
        std::size_t begin;
        std::size_t end;

        std::size_t size() const { return end - begin; }
    };

    Winner exact(Vec2 p, Range candidates) const
    {
        Winner least {field_.maxSize_, kNone};
        for (std::size_t k = candidates.begin; k < candidates.end; ++k) {
            const double value = sources_[candidates_[k]].sizeAt(p);
            least = value < least.value ? Winner {value, candidates_[k]} : least;
        }
        least.value = field_.clamped(least.value);
        return least;
    }

    /// Appends the sources that can be the least in the cell, and below the largest size. Fills in
    /// the field's value in the middle.
    Range filter(const Square& square, Range from, Winner& middle)
    {
        const Vec2 center = square.at(0.5, 0.5);
        const double reach = field_.slope_ * square.side * 0.70710678118654757;
        atCenter_.resize(from.size());
        middle = {field_.maxSize_, kNone};
        for (std::size_t k = 0; k < from.size(); ++k) {
            const std::uint32_t i = candidates_[from.begin + k];
            atCenter_[k] = sources_[i].sizeAt(center);
            middle = atCenter_[k] < middle.value ? Winner {atCenter_[k], i} : middle;
        }
        const double limit = std::min(field_.maxSize_, middle.value + reach);
        middle.value = field_.clamped(middle.value);
        const std::size_t begin = candidates_.size();
        for (std::size_t k = 0; k < from.size(); ++k) {
            if (atCenter_[k] - reach < limit) {
                candidates_.push_back(candidates_[from.begin + k]);
            }
        }
        return {begin, candidates_.size()};
    }

    void build(std::uint32_t cell, const Square& square, Range fromParent, const Corners& corners,
               int depth)
    {
        if ((++visited_ & 0xffU) == 0) {
            execution_.checkpoint();
        }
        Winner middle {};
        const Range candidates = filter(square, fromParent, middle);
        if (candidates.size() == 0) {
            storeConstant(cell, field_.maxSize_);
        }
        else if (candidates.size() <= kShortList) {
            storeList(cell, {candidates_.data() + candidates.begin, candidates.size()});
        }
        else if (depth == kMaxDepth) {
            storeConstant(cell, middle.value);
        }
        else {
            buildTested(cell, square, candidates, corners, middle, depth);
        }
        candidates_.resize(candidates.begin);
    }

    /// Exact values in the middle of the cell and of its sides: good enough if the bilinear surface
    /// through the corners meets them, or, in a small cell, if few sources make them. Else split.
    void buildTested(std::uint32_t cell, const Square& square, Range candidates,
                     const Corners& corners, const Winner& middle, int depth)
    {
        const std::array<Winner, 4> sides {
            exact(square.at(0.5, 0.0), candidates), exact(square.at(0.0, 0.5), candidates),
            exact(square.at(1.0, 0.5), candidates), exact(square.at(0.5, 1.0), candidates)};
        if (storeBilinear(cell, square.side, corners, sides, middle)
            || storeWinners(cell, square.side, corners, sides, middle)) {
            return;
        }
        const auto first = static_cast<std::uint32_t>(field_.cells_.size());
        field_.cells_.resize(first + 4);
        field_.cells_[cell] = {first, GradedSize::Kind::Split, 0};
        const Corners inner[4] = {{corners[0], sides[0], sides[1], middle},
                                  {sides[0], corners[1], middle, sides[2]},
                                  {sides[1], middle, corners[2], sides[3]},
                                  {middle, sides[2], sides[3], corners[3]}};
        for (std::uint32_t child = 0; child < 4; ++child) {
            const Square quarter {square.at(0.5 * (child % 2), 0.5 * (child / 2)),
                                  0.5 * square.side};
            build(first + child, quarter, candidates, inner[child], depth + 1);
        }
    }

    void storeConstant(std::uint32_t cell, double value)
    {
        field_.cells_[cell] = {static_cast<std::uint32_t>(field_.values_.size()),
                               GradedSize::Kind::Constant, 0};
        field_.values_.push_back(value);
    }

    void storeList(std::uint32_t cell, std::span<const std::uint32_t> list)
    {
        field_.cells_[cell] = {static_cast<std::uint32_t>(field_.nearSources_.size()),
                               GradedSize::Kind::List, static_cast<std::uint16_t>(list.size())};
        field_.nearSources_.insert(field_.nearSources_.end(), list.begin(), list.end());
    }

    static double leastOf(const Corners& corners, const Winner& middle)
    {
        double least = middle.value;
        for (const Winner& corner : corners) {
            least = std::min(least, corner.value);
        }
        return least;
    }

    bool storeBilinear(std::uint32_t cell, double side, const Corners& corners,
                       const std::array<Winner, 4>& sides, const Winner& middle)
    {
        const double least = leastOf(corners, middle);
        if (field_.slope_ * side > kCoarseCell * least) {
            return false;
        }
        const double at[4] = {corners[0].value, corners[1].value, corners[2].value,
                              corners[3].value};
        const double allowed = kErrorShare * field_.growth_ * least;
        constexpr double kX[] = {0.5, 0.0, 1.0, 0.5};
        constexpr double kY[] = {0.0, 0.5, 0.5, 1.0};
        if (std::abs(bilinear(at, 0.5, 0.5) - middle.value) > allowed) {
            return false;
        }
        for (std::size_t i = 0; i < sides.size(); ++i) {
            if (std::abs(bilinear(at, kX[i], kY[i]) - sides[i].value) > allowed) {
                return false;
            }
        }
        field_.cells_[cell] = {static_cast<std::uint32_t>(field_.values_.size()),
                               GradedSize::Kind::Bilinear, 0};
        field_.values_.insert(field_.values_.end(), at, at + 4);
        return true;
    }

    bool storeWinners(std::uint32_t cell, double side, const Corners& corners,
                      const std::array<Winner, 4>& sides, const Winner& middle)
    {
        if (field_.slope_ * side > kSmallCell * leastOf(corners, middle)) {
            return false;
        }
        std::array<std::uint32_t, kShortList> list {};
        std::size_t count = 0;
        const auto add = [&list, &count](const Winner& winner) {
            const auto end = list.begin() + static_cast<std::ptrdiff_t>(count);
            if (winner.source == kNone || std::find(list.begin(), end, winner.source) != end) {
                return true;
            }
            if (count == kShortList) {
                return false;
            }
            list[count++] = winner.source;
            return true;
        };
        const bool few = std::all_of(corners.begin(), corners.end(), add)
            && std::all_of(sides.begin(), sides.end(), add) && add(middle);
        if (few) {
            storeList(cell, {list.data(), count});
        }
        return few;
    }

    GradedSize& field_;
    std::span<const GradedSize::Segment> sources_;
    const Execution& execution_;
    std::vector<std::uint32_t> candidates_; ///< of the cells from the root down to the one in hand
    std::vector<double> atCenter_;
    std::uint64_t visited_ = 0;
};

GradedSize::GradedSize(const Box2& box, std::span<const SizeSource> sources,
                       const Options& options, const Execution& execution)
    : box_(box)
    , origin_(box.min)
    , side_(std::max(box.max.x - box.min.x, box.max.y - box.min.y))
    , growth_(options.growth)
    , slope_(kSlopeShare * options.growth)
    , minSize_(options.minSize)
    , maxSize_(options.maxSize)
{
    for (const SizeSource& source : withoutDominated(sources, slope_)) {
        const Vec2 along = source.b - source.a;
        const double square = squaredLength(along);
        sources_.push_back({source.a, along, square > 1e-300 ? 1.0 / square : 0.0, source.size,
                            source.radius, std::min(slope_, source.slope), source.most});
    }
    GradedSizeBuilder(*this, execution).run();
    plantRoots();
}

void GradedSize::plantRoots()
{
    roots_.reserve(kRoots * kRoots);
    for (std::uint32_t row = 0; row < kRoots; ++row) {
        for (std::uint32_t column = 0; column < kRoots; ++column) {
            Root root {0, 1};
            for (std::uint32_t bit = kRoots / 2; bit > 0 && cells_[root.cell].kind == Kind::Split;
                 bit /= 2) {
                root.cell = cells_[root.cell].index + ((column & bit) != 0 ? 1U : 0U)
                    + ((row & bit) != 0 ? 2U : 0U);
                root.perSide *= 2;
            }
            roots_.push_back(root);
        }
    }
}

double GradedSize::clamped(double h) const
{
    return std::max(minSize_, std::min(maxSize_, h));
}

double GradedSize::size(Vec2 p) const
{
    const Vec2 inside {std::clamp(p.x, box_.min.x, box_.max.x),
                       std::clamp(p.y, box_.min.y, box_.max.y)};
    double x = side_ > 0.0 ? (inside.x - origin_.x) / side_ : 0.0;
    double y = side_ > 0.0 ? (inside.y - origin_.y) / side_ : 0.0;
    const auto column = std::min(static_cast<std::uint32_t>(kRoots * x), kRoots - 1);
    const auto row = std::min(static_cast<std::uint32_t>(kRoots * y), kRoots - 1);
    const Root root = roots_[row * kRoots + column];
    const Cell* cell = &cells_[root.cell];
    // From here on x and y are relative to the cell in hand, whose side is 1.
    x *= root.perSide;
    y *= root.perSide;
    x -= std::min(std::floor(x), root.perSide - 1.0);
    y -= std::min(std::floor(y), root.perSide - 1.0);
    while (cell->kind == Kind::Split) {
        const bool right = x >= 0.5;
        const bool upper = y >= 0.5;
        cell = &cells_[cell->index + (right ? 1U : 0U) + (upper ? 2U : 0U)];
        x = 2.0 * x - (right ? 1.0 : 0.0);
        y = 2.0 * y - (upper ? 1.0 : 0.0);
    }
    if (cell->kind == Kind::Constant) {
        return clamped(values_[cell->index]);
    }
    if (cell->kind == Kind::Bilinear) {
        return bilinear(&values_[cell->index], x, y);
    }
    double least = maxSize_;
    for (std::uint32_t i = 0; i < cell->count; ++i) {
        least = std::min(least, sources_[nearSources_[cell->index + i]].sizeAt(inside));
    }
    return clamped(least);
}

} // namespace tessera
