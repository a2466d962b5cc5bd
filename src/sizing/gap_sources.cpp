// SPDX-License-Identifier: MIT
//
// From places on each curve a ray goes to both sides, to the first chord of a curve in its way, as
// far as a gap can matter. Places lie at most a size apart, and where a gap is found, half of the
// size that it asks for, so that sizes between them are hardly larger; a narrow place between two
// of them lies opposite a stretch that bends, whose own places find it.
//
// Complexity: O(log n + chords near the ray) for a place; places are fewer than the pieces that the
// result asks for times two, or than the length of all curves by the size.
#include "sizing/gap_sources.h"

#include "arrange/box_tree.h"
#include "curve/curve_tools.h"
#include "curve/line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera
{

namespace
{

/// Cosine of the greatest angle between the line across a gap and the normals of its sides.
constexpr double kFacing = 0.70710678118654757;
/// A gap matters if it asks for clearly less than the size in place; see curve_sources.cpp.
constexpr double kClearlyShorter = 0.7;
/// Greatest turn of a curve along one of the chords that rays meet, in radians, about.
constexpr double kChordTurn = 0.1;
constexpr int kMostHalvings = 14;
/// A ray starts this part of its length away from its own curve.
constexpr double kStart = 1e-5;

/// A chord that rays can meet.
struct Side
{
    Vec2 a;
    Vec2 b;
    std::uint32_t curve;
    double ta = 0.0; ///< parameters of a and b; unused on a straight curve
    double tb = 1.0;
};

class GapFinder
{
public:
    GapFinder(const CurveNetwork& network, const SizeField& base, const GapOptions& options,
              const Execution& execution)
        : network_(network)
        , base_(base)
        , options_(options)
        , execution_(execution)
        , sides_(makeSides(network))
        , tree_(boxesOf(sides_))
    {}

    std::vector<SizeSource> run()
    {
        for (std::uint32_t c = 0; c < network_.curves.size(); ++c) {
            const NetworkCurve& curve = network_.curves[c];
            if (curve.role == Role::Ignored) {
                continue;
            }
            curve_ = c;
            if (curve.geometry) {
                const std::vector<double> ends = smoothIntervals(*curve.geometry);
                for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
                    lookAlong(*curve.geometry, ends[i], ends[i + 1]);
                }
            }
            else {
                const LineCurve line(network_.points[curve.start.index()],
                                     network_.points[curve.end.index()]);
                lookAlong(line, 0.0, 1.0);
            }
        }
        return std::move(sources_);
    }

private:
    static std::vector<Side> makeSides(const CurveNetwork& network)
    {
        std::vector<Side> sides;
        for (std::uint32_t c = 0; c < network.curves.size(); ++c) {
            const NetworkCurve& curve = network.curves[c];
            if (curve.role == Role::Ignored) {
                continue;
            }
            if (!curve.geometry) {
                sides.push_back({network.points[curve.start.index()],
                                 network.points[curve.end.index()], c});
                continue;
            }
            const std::vector<double> ends = smoothIntervals(*curve.geometry);
            for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
                addSides(*curve.geometry, ends[i], ends[i + 1], c, kMostHalvings, sides);
            }
        }
        return sides;
    }

    static void addSides(const Curve& curve, double a, double b, std::uint32_t c, int depth,
                         std::vector<Side>& sides)
    {
        const double t = 0.5 * (a + b);
        const double turn = (b - a)
            * std::max({turningRate(curve, a), turningRate(curve, t), turningRate(curve, b)});
        if ((turn > kChordTurn || depth > kMostHalvings - 2) && depth > 0) {
            addSides(curve, a, t, c, depth - 1, sides);
            addSides(curve, t, b, c, depth - 1, sides);
            return;
        }
        sides.push_back({curve.point(a), curve.point(b), c, a, b});
    }

    static std::vector<Box2> boxesOf(const std::vector<Side>& sides)
    {
        std::vector<Box2> boxes;
        boxes.reserve(sides.size());
        for (const Side& side : sides) {
            Box2 box;
            box.add(side.a);
            box.add(side.b);
            boxes.push_back(box);
        }
        return boxes;
    }

    void lookAlong(const Curve& curve, double a, double b)
    {
        lookAt(curve, a);
        lookAt(curve, b);
        lookBetween(curve, a, b, kMostHalvings);
    }

    /// Between two places that have been looked at.
    void lookBetween(const Curve& curve, double a, double b, int depth)
    {
        const double t = 0.5 * (a + b);
        const double length = distance(curve.point(a), curve.point(t))
            + distance(curve.point(t), curve.point(b));
        const double asked = lookAt(curve, t);
        const double size = base_.size(curve.point(t));
        if (depth > 0 && length > std::min(2.0 * size, asked)) {
            lookBetween(curve, a, t, depth - 1);
            lookBetween(curve, t, b, depth - 1);
        }
    }

    /// Returns the size that is asked for, infinite if there is no gap.
    double lookAt(const Curve& curve, double t)
    {
        if ((++looks_ & 0xffU) == 0) {
            execution_.checkpoint();
        }
        const Vec2 p = curve.point(t);
        const Vec2 d = curve.derivative(t);
        const double speed = length(d);
        double asked = std::numeric_limits<double>::infinity();
        if (speed > 0.0) {
            const Vec2 normal {-d.y / speed, d.x / speed};
            asked = std::min(lookTo(p, normal, t), lookTo(p, -1.0 * normal, t));
        }
        return asked;
    }

    double lookTo(Vec2 p, Vec2 direction, double t)
    {
        const double size = base_.size(p);
        const double reach = kClearlyShorter * options_.elements * size;
        const Vec2 end = p + reach * direction;
        Box2 box;
        box.add(p);
        box.add(end);
        double nearest = std::numeric_limits<double>::infinity();
        std::uint32_t found = 0;
        tree_.forEachOverlap(box, [&](std::uint32_t i) {
            const double way = isBeside(sides_[i], t) ? -1.0 : meet(sides_[i], p, direction);
            if (way > kStart * reach && (way < nearest || (way == nearest && i < found))) {
                nearest = way;
                found = i;
            }
        });
        if (!(nearest < reach)) {
            return std::numeric_limits<double>::infinity();
        }
        const Vec2 q = p + nearest * direction;
        const Vec2 along = sides_[found].b - sides_[found].a;
        const double facing = std::abs(cross(along, direction)) / length(along);
        if (facing < kFacing || isAtCorner(sides_[found].curve, p, q, size)
            || (options_.inside && !options_.inside(midpoint(p, q)))) {
            return std::numeric_limits<double>::infinity();
        }
        const double least = options_.minSize > 0.0 ? options_.minSize : 1e-3 * size;
        const double asked = std::max(nearest / options_.elements, std::min(least, size));
        sources_.push_back({p, q, asked});
        return asked;
    }

    /// A chord of the curve that is looked along, at the parameter t.
    bool isBeside(const Side& side, double t) const
    {
        const double margin = 0.5 * (side.tb - side.ta);
        return side.curve == curve_ && side.ta - margin <= t && t <= side.tb + margin;
    }

    /// How far along the ray the curve behind the side is; negative if it is not met.
    double meet(const Side& side, Vec2 p, Vec2 direction) const
    {
        const Vec2 along = side.b - side.a;
        const double slant = cross(direction, along);
        const double share = cross(side.a - p, direction); // the side is met at share / slant
        if (slant == 0.0 || share * slant < 0.0 || std::abs(share) > std::abs(slant)) {
            return -1.0;
        }
        const Curve* curve = network_.curves[side.curve].geometry.get();
        if (curve == nullptr) {
            return cross(side.a - p, along) / slant;
        }
        double t = side.ta + share / slant * (side.tb - side.ta);
        for (int i = 0; i < 4; ++i) {
            const double slope = cross(curve->derivative(t), direction);
            const double next = t - cross(curve->point(t) - p, direction) / slope;
            if (!(next >= side.ta && next <= side.tb)) {
                break;
            }
            t = next;
        }
        return dot(curve->point(t) - p, direction);
    }

    bool isAtCorner(std::uint32_t other, Vec2 p, Vec2 q, double size) const
    {
        const NetworkCurve& here = network_.curves[curve_];
        const NetworkCurve& there = network_.curves[other];
        if (curve_ == other) {
            return false;
        }
        for (const PointId v : {here.start, here.end}) {
            if (v == there.start || v == there.end) {
                const Vec2 corner = network_.points[v.index()];
                if (std::max(distance(p, corner), distance(q, corner)) < size) {
                    return true;
                }
            }
        }
        return false;
    }

    const CurveNetwork& network_;
    const SizeField& base_;
    const GapOptions& options_;
    const Execution& execution_;
    std::vector<Side> sides_;
    BoxTree tree_;
    std::uint32_t curve_ = 0; ///< that is looked along
    std::uint64_t looks_ = 0;
    std::vector<SizeSource> sources_;
};

} // namespace

std::vector<SizeSource> gapSources(const CurveNetwork& network, const SizeField& base,
                                   const GapOptions& options, const Execution& execution)
{
    return GapFinder(network, base, options, execution).run();
}

} // namespace tessera
