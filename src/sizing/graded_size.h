// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "base/execution.h"
#include "sizing/size_field.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// Asks for a size along the straight segment from a to b (a point if they are equal).
struct SizeSource
{
    Vec2 a;
    Vec2 b;
    double size;
};

/// Gradation-limited field of any number of sources: the largest field with |grad h| <= growth that
/// exceeds neither the largest size nor any source's size on the source:
///
///     h(p) = max(minSize, min(maxSize, min over i of (size_i + growth |p - source_i|)))
///
/// to within 0.01 growth relative, and never steeper than growth between points farther apart than
/// about half their size. size() costs well below 100 ns.
class GradedSize final: public SizeField
{
public:
    struct Options
    {
        double maxSize;
        double minSize = 0.0;
        double growth = 0.3; ///< 0 < growth
    };

    /// box: where the field is evaluated exactly; outside, the value at the nearest point of it
    /// holds.
    GradedSize(const Box2& box, std::span<const SizeSource> sources, const Options& options,
               const Execution& execution);

    double size(Vec2 p) const override;
    double gradientBound() const override { return growth_; }

private:
    friend class GradedSizeBuilder;

    enum class Kind : std::uint16_t
    {
        Constant, ///< values_[index]
        List,     ///< the minimum over nearSources_[index .. index + count)
        Bilinear, ///< between values_[index .. index + 4), the cell's corners
        Split,    ///< four cells from index on
    };
    struct Cell
    {
        std::uint32_t index;
        Kind kind;
        std::uint16_t count;
    };

    double clamped(double h) const;

    Box2 box_;
    Vec2 origin_;
    double side_;
    double growth_;
    double slope_; ///< a little less than growth_, which leaves room for interpolation
    double minSize_;
    double maxSize_;
    std::vector<Cell> cells_;
    std::vector<double> values_;
    std::vector<SizeSource> nearSources_;
};

/// Distance from p to the source's segment.
double distanceTo(const SizeSource& source, Vec2 p);

} // namespace tessera
