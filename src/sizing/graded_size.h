// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "base/execution.h"
#include "sizing/size_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tessera
{

/// Asks for a size along the straight segment from a to b (a point if they are equal), up to a
/// distance from it, and beyond for sizes that grow with the distance, up to a most.
struct SizeSource
{
    Vec2 a;
    Vec2 b;
    double size;
    double radius = 0.0; ///< up to this distance the size holds
    /// Growth beyond the radius; never more than the field's.
    double slope = std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity(); ///< the source asks for no more

    /// Nothing but a size on the segment, growing as the field does.
    bool isPlain() const
    {
        constexpr double kInfinite = std::numeric_limits<double>::infinity();
        return radius == 0.0 && slope == kInfinite && most == kInfinite;
    }
};

/// Gradation-limited field of any number of sources: the largest field with |grad h| <= growth that
/// exceeds neither the largest size nor what any source asks for:
///
///     h(p) = max(minSize, min(maxSize, min over i of
///                min(most_i, size_i + slope_i max(0, |p - source_i| - radius_i))))
///
/// to within 0.01 growth relative and 0.97 of the slope, and never steeper than growth between
/// points farther apart than about half their size. size() costs well below 100 ns.
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
        List,     ///< the minimum over the nearSources_[index .. index + count)
        Bilinear, ///< between values_[index .. index + 4), the cell's corners
        Split,    ///< four cells from index on
    };
    struct Cell
    {
        std::uint32_t index;
        Kind kind;
        std::uint16_t count;
    };

    /// A source ready for measuring distances.
    struct Segment
    {
        Vec2 a;
        Vec2 along;
        double inverseSquare; ///< of its length; 0 for a point
        double size;
        double radius;
        double slope;
        double most;

        double sizeAt(Vec2 p) const
        {
            const Vec2 offset = p - a;
            const double s = std::clamp(dot(offset, along) * inverseSquare, 0.0, 1.0);
            const double away = std::sqrt(squaredLength(offset - s * along)) - radius;
            return std::min(most, size + slope * std::max(0.0, away));
        }
    };

    /// Where a walk down begins, by the place's column and row among kRoots x kRoots.
    struct Root
    {
        std::uint32_t cell;
        std::uint32_t perSide; ///< such cells fit along a side of the square
    };
    static constexpr std::uint32_t kRoots = 128;

    double clamped(double h) const;
    void plantRoots();

    Box2 box_;
    Vec2 origin_;
    double side_;
    double growth_;
    double slope_; ///< a little less than growth_, which leaves room for interpolation
    double minSize_;
    double maxSize_;
    std::vector<Cell> cells_;
    std::vector<Root> roots_; ///< row by row
    std::vector<double> values_;
    std::vector<Segment> sources_;
    std::vector<std::uint32_t> nearSources_; ///< indices of sources_
};

/// The sources that matter when sizes grow at most by growth: a source is left out if along its
/// neighbors (sources that share an end) there comes so small a size that nowhere on the source
/// more than tolerance times its own size results without it. Only plain sources are left out. With
/// tolerance 1 the field of the rest is the same. O(n log n).
std::vector<SizeSource> withoutDominated(std::span<const SizeSource> sources, double growth,
                                         double tolerance = 1.0);

} // namespace tessera
