// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"
#include "base/vec2.h"
#include "curve/curve_network.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tessera
{

/// One straight piece of a sampled curve: a constraint of the triangulation. Its index is its
/// ConstraintId.
struct PslgSegment
{
    PointId a;
    PointId b;
    CurveId curve;
    double ta = 0.0; ///< parameters of a and b on the curve's geometry; unused for a null geometry
    double tb = 0.0;
};

/// A gap between curves that is narrow compared to the sagitta of the pieces beside it.
struct CoarseGap
{
    Vec2 place;
    double share; ///< sagitta as a part of the gap's width
};

/// Planar straight-line graph, raw: its segments may still cross, overlap and touch. Points
/// 0 .. network.points.size() - 1 are the network's, in order; samples follow.
struct Pslg
{
    std::vector<Vec2> points;
    std::vector<PslgSegment> segments;
    /// Gaps whose width and area the pieces beside them do not show (SampleOptions::gapShare).
    std::vector<CoarseGap> coarseGaps;
    std::vector<std::string> messages; ///< for the user: curves that were dropped, coarse gaps
};

} // namespace tessera
