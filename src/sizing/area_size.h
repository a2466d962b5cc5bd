// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "base/execution.h"
#include "sizing/size_field.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// A size wanted all over the plane: an expression, the nodal sizes of another mesh, a region. It
/// may be steep, jump and have kinks.
struct AreaSource
{
    /// For messages: "The size expression 'x - 1'".
    std::string name;
    /// Called from one thread. Infinite only where the source asks for nothing.
    std::function<double(Vec2)> size;
    bool asksEverywhere = true; ///< false: infinite values are no mistake
    /// A place that must be looked at this closely, or details might be missed.
    struct Detail
    {
        Vec2 place;
        double scale;
    };
    std::vector<Detail> details {};
};

/// The gradation-limited minimum of area sources over a box:
///
///     h(p) = inf over q in the box of (max(minSize, min(maxSize, min_i size_i(q))) + growth |p - q|)
///
/// to within about 3 %, on a quadtree that is as fine as the field needs: bilinear cells, no longer
/// than 0.15 of the size where the field has a kink. Never steeper than growth between points
/// farther apart than about half their size. What is smaller than 1/256 of the box and named by no
/// detail may be missed.
class AreaSize final: public SizeField
{
public:
    struct Options
    {
        double maxSize;
        double minSize = 0.0;
        double growth = 0.3; ///< 0 < growth
        /// Whether a place is to be meshed. Null: all of the box is. Where a source gives no number
        /// above 0 in a place that is not, no source asks for anything in such places.
        std::function<bool(Vec2)> inside {};
    };

    /// Outside of the box, the value at the nearest point of it holds. Throws Error(InvalidOption)
    /// with the source's name and the place where a size is not a number above 0.
    AreaSize(const Box2& box, std::span<const AreaSource> sources, const Options& options,
             Execution& execution);

    double size(Vec2 p) const override;
    double gradientBound() const override { return growth_; }
    std::size_t cellCount() const { return cells_.size(); }

private:
    friend class AreaSizeBuilder;

    static constexpr std::uint32_t kSplit = 0x80000000U;

    Box2 box_;
    double growth_;
    double countX_ = 1.0; ///< roots in each direction
    double countY_ = 1.0;
    Vec2 perRoot_ {}; ///< roots per length
    /// Roots row by row, then four children together: kSplit and the first child, or four values_.
    std::vector<std::uint32_t> cells_;
    std::vector<double> values_; ///< of the corners, four for each cell that is not split
};

} // namespace tessera
