// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "delaunay/triangulation.h"
#include "region/region.h"
#include "sizing/local_sizes.h"

namespace tessera
{

/// What is inside, and inside which operand, before anything is meshed: the arranged curves
/// coarsely sampled (48 pieces for a full turn), triangulated and colored. Serves size fields, which
/// may differ from region to region.
class ColoredPlane
{
public:
    /// Precondition: the network is arranged.
    ColoredPlane(const CurveNetwork& network, FillRule fill, Execution& execution);

    /// The region around p; the outer one outside of the convex hull. Not thread-safe.
    const Region& regionAt(Vec2 p) const { return regions_.regions[regionIndexAt(p)]; }

    /// The size where the operand covers, or in the region around the position. Throws
    /// Error(InvalidOption) for a size that is no number above 0, an operand that does not exist or
    /// is nowhere inside, a position that is not inside.
    AreaSource areaSource(const RegionSize& region) const;

private:
    std::size_t regionIndexAt(Vec2 p) const;

    Triangulation triangulation_;
    RegionMap regions_;
    std::size_t operands_;
    mutable HalfEdge hint_ = 0; ///< where the last point was
};

} // namespace tessera
