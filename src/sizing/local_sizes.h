// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"
#include "base/vec2.h"
#include "sizing/area_size.h"

#include <vector>

namespace tessera
{

/// A size near a place, and how it grows with the distance from it. Lengths in the input's unit.
struct SizeLaw
{
    double size;          ///< > 0
    double radius = 0.0;  ///< up to this distance the size holds; >= 0
    /// From the radius on the size grows linearly to farSize at the distance farRadius, and stays
    /// so beyond, but nowhere faster than the growth rate. 0: it grows by the growth rate.
    double farSize = 0.0;
    double farRadius = 0.0; ///< > radius, if farSize is given
};

struct PointSize
{
    Vec2 position;
    SizeLaw law;
};

struct CurveSize
{
    std::vector<CurveId> curves;
    SizeLaw law;
};

/// A size inside an operand, or in the region around a point.
struct RegionSize
{
    OperandId operand; ///< invalid: position counts
    Vec2 position;
    double size;
};

/// All that asks for sizes besides the general size. The smallest one counts.
struct LocalSizes
{
    double piecesPerTurn = 20.0; ///< pieces for a full turn of a curve; 3 .. 10000
    double chordError = 0.0;    ///< greatest distance of a piece from its curve; 0: no bound
    double gap = 0.0;           ///< elements across the gap between facing curves; 0: none asked
    std::vector<PointSize> points {};
    std::vector<CurveSize> curves {};
    std::vector<AreaSource> areas {};
    std::vector<RegionSize> regions {}; ///< of the pipeline only: needs the colored regions
};

} // namespace tessera
