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

constexpr std::size_t kShortList = 5;
/// Cells of this depth are far smaller than any size that doubles can tell apart in the box.
constexpr int kMaxDepth = 45;
/// slope_ / growth_, and the interpolation error allowed, as a part of growth and size: two points
/// d apart then differ by at most growth (0.97 d + 0.02 h) <= growth d once d >= 2/3 h.
constexpr double kSlopeShare = 0.97;
constexpr double kErrorShare = 0.01;

} // namespace

double distanceTo(const SizeSource& source, Vec2 p)
{
    const Vec2 along = source.b - source.a;
    const Vec2 offset = p - source.a;
    const double square = squaredLength(along);
    const double s = square > 0.0 ? std::clamp(dot(offset, along) / square, 0.0, 1.0) : 0.0;
    return std::sqrt(squaredLength(offset - s * along));
}

class GradedSizeBuilder
{
public:
    GradedSizeBuilder(GradedSize& field, std::span<const SizeSource> sources,
                      const Execution& execution)
        : field_(field)
        , sources_(sources)
        , execution_(execution)
    {}

    void run()
    {
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < sources_.size(); ++i) {
            if (sources_[i].size < field_.maxSize_) {
                all.push_back(i);
            }
        }
        field_.cells_.resize(1);
        build(0, field_.origin_, field_.side_, all, 0);
    }

private:
    double exact(Vec2 p, const std::vector<std::uint32_t>& candidates) const
    {
        double least = field_.maxSize_;
        for (const std::uint32_t i : candidates) {
            const SizeSource& source = sources_[i];
            least = std::min(least, source.size + field_.slope_ * distanceTo(source, p));
        }
        return field_.clamped(least);
    }

    /// The sources that can be the least in the cell, and below the largest size.
    std::vector<std::uint32_t> filter(Vec2 corner, double side,
                                      const std::vector<std::uint32_t>& candidates)
    {
        const Vec2 center {corner.x + 0.5 * side, corner.y + 0.5 * side};
        const double reach = field_.slope_ * side * 0.70710678118654757;
        atCenter_.resize(candidates.size());
        double least = field_.maxSize_;
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            const SizeSource& source = sources_[candidates[k]];
            atCenter_[k] = source.size + field_.slope_ * distanceTo(source, center);
            least = std::min(least, atCenter_[k] + reach);
        }
        std::vector<std::uint32_t> result;
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            if (atCenter_[k] - reach < least) {
                result.push_back(candidates[k]);
            }
        }
        return result;
    }

    void build(std::uint32_t cell, Vec2 corner, double side,
               const std::vector<std::uint32_t>& fromParent, int depth)
    {
        if ((++visited_ & 0xffU) == 0) {
            execution_.checkpoint();
        }
        const std::vector<std::uint32_t> candidates = filter(corner, side, fromParent);
        if (candidates.empty()) {
            field_.cells_[cell] = {pushValue(field_.maxSize_), GradedSize::Kind::Constant, 0};
        }
        else if (candidates.size() <= kShortList) {
            storeList(cell, candidates);
        }
        else if (depth == kMaxDepth) {
            const double value = exact(corner, candidates);
            field_.cells_[cell] = {pushValue(value), GradedSize::Kind::Constant, 0};
        }
        else if (!storeBilinear(cell, corner, side, candidates)) {
            const auto first = static_cast<std::uint32_t>(field_.cells_.size());
            field_.cells_.resize(first + 4);
            field_.cells_[cell] = {first, GradedSize::Kind::Split, 0};
            const double half = 0.5 * side;
            for (std::uint32_t child = 0; child < 4; ++child) {
                const Vec2 at {corner.x + ((child & 1U) != 0 ? half : 0.0),
                               corner.y + ((child & 2U) != 0 ? half : 0.0)};
                build(first + child, at, half, candidates, depth + 1);
            }
        }
    }

    std::uint32_t pushValue(double value)
    {
        field_.values_.push_back(value);
        return static_cast<std::uint32_t>(field_.values_.size() - 1);
    }

    void storeList(std::uint32_t cell, const std::vector<std::uint32_t>& candidates)
    {
        field_.cells_[cell] = {static_cast<std::uint32_t>(field_.nearSources_.size()),
                               GradedSize::Kind::List,
                               static_cast<std::uint16_t>(candidates.size())};
        for (const std::uint32_t i : candidates) {
            field_.nearSources_.push_back(sources_[i]);
        }
    }

    bool storeBilinear(std::uint32_t cell, Vec2 corner, double side,
                       const std::vector<std::uint32_t>& candidates)
    {
        std::array<double, 4> at {};
        for (std::uint32_t i = 0; i < 4; ++i) {
            at[i] = exact({corner.x + ((i & 1U) != 0 ? side : 0.0),
                           corner.y + ((i & 2U) != 0 ? side : 0.0)},
                          candidates);
        }
        const double least = *std::min_element(at.begin(), at.end());
        if (field_.slope_ * side > 0.5 * least) {
            return false; // too coarse for test points to vouch for it
        }
        const double allowed = kErrorShare * field_.growth_ * least;
        constexpr double kTests[][2] = {{0.5, 0.5},   {0.5, 0.0},   {0.5, 1.0},   {0.0, 0.5},
                                        {1.0, 0.5},   {0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75},
                                        {0.75, 0.75}};
        for (const auto& [x, y] : kTests) {
            const double between = (1 - y) * ((1 - x) * at[0] + x * at[1])
                + y * ((1 - x) * at[2] + x * at[3]);
            const double here = exact({corner.x + x * side, corner.y + y * side}, candidates);
            if (std::abs(between - here) > allowed) {
                return false;
            }
        }
        const auto index = static_cast<std::uint32_t>(field_.values_.size());
        field_.values_.insert(field_.values_.end(), at.begin(), at.end());
        field_.cells_[cell] = {index, GradedSize::Kind::Bilinear, 0};
        return true;
    }

    GradedSize& field_;
    std::span<const SizeSource> sources_;
    const Execution& execution_;
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
    GradedSizeBuilder(*this, sources, execution).run();
}

double GradedSize::clamped(double h) const
{
    return std::max(minSize_, std::min(maxSize_, h));
}

double GradedSize::size(Vec2 p) const
{
    const Vec2 inside {std::clamp(p.x, box_.min.x, box_.max.x),
                       std::clamp(p.y, box_.min.y, box_.max.y)};
    // From here on x and y are relative to the cell in hand, whose side is 1.
    double x = side_ > 0.0 ? (inside.x - origin_.x) / side_ : 0.0;
    double y = side_ > 0.0 ? (inside.y - origin_.y) / side_ : 0.0;
    const Cell* cell = cells_.data();
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
        const double* at = &values_[cell->index];
        return (1 - y) * ((1 - x) * at[0] + x * at[1]) + y * ((1 - x) * at[2] + x * at[3]);
    }
    double least = maxSize_;
    for (std::uint32_t i = 0; i < cell->count; ++i) {
        const SizeSource& source = nearSources_[cell->index + i];
        least = std::min(least, source.size + slope_ * distanceTo(source, inside));
    }
    return clamped(least);
}

} // namespace tessera
