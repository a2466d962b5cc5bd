// SPDX-License-Identifier: MIT
#pragma once

#include "arrange/arcs.h"
#include "arrange/arrange.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace tessera
{

/// Tells whether curves run along each other within a tolerance. The curves must outlive it. Not
/// thread-safe.
class AlongTest
{
public:
    /// rounding: curves closer than that touch.
    AlongTest(const CurveSet& curves, double tolerance, double rounding)
        : curves_(curves)
        , tolerance_(tolerance)
        , rounding_(rounding)
    {}

    /// How far apart the curves are at most, if they stay within the tolerance of each other all
    /// along; decided at several points of each of their arcs, whose tangents turn by less than a
    /// right angle. Curves that wind more than the other one do not run along it.
    std::optional<double> distanceBetween(std::uint32_t a, std::uint32_t b);
    /// Both closed: whether they are one ring drawn twice. They run along each other and cross or
    /// touch; a ring however thin encloses an area.
    bool areOneRing(std::uint32_t a, std::uint32_t b);
    /// Whether part of a curve stays within the tolerance of another curve.
    bool follows(std::uint32_t curve, double from, double to, std::uint32_t other);
    /// Both closed, with a common seam: whether they run the same way.
    bool runAlike(std::uint32_t a, std::uint32_t b);

private:
    struct Cut
    {
        std::vector<Arc> arcs;
        double length = 0.0;
    };
    struct Nearest
    {
        double t;
        double distance; ///< infinite: farther than the tolerance
    };

    const Cut& cutOf(std::uint32_t curve);
    Nearest nearest(const Cut& cut, Vec2 p) const;
    double greatestDistance(const Cut& from, const Cut& to) const;
    bool meet(const Cut& a, const Cut& b) const;

    const CurveSet& curves_;
    double tolerance_;
    double rounding_;
    std::map<std::uint32_t, Cut> cuts_;
};

/// Curves with the same two ends that run along each other within the weld tolerance become one
/// curve: all get the geometry of the first of them, straight if one is. Closed curves along each
/// other that cross or touch, and curves along a seam, are cut at each other's seams for that. So a
/// circle and a spline that approximates it enclose nothing between them. Does nothing without a
/// tolerance. Fills report.weldedAlong and report.greatestGap. Precondition: ends are welded, to each
/// other and onto curves; wasSeam says by point which were seams before.
void weldOverlaps(CurveNetwork& network, std::span<const std::uint8_t> wasSeam,
                  const ArrangeOptions& options, ArrangeReport& report, Execution& execution);

/// Gives b the geometry of a: both have the same ends, alike or opposed. Straight if one is.
void shareGeometry(NetworkCurve& a, NetworkCurve& b, bool alike);

} // namespace tessera
