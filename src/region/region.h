// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"
#include "curve/curve_network.h"
#include "recover/recover.h"
#include "sample/pslg.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tessera
{

/// A maximal set of triangles that no subsegment of a boundary separates.
struct Region
{
    double area = 0.0;
    bool inside = false;                ///< kept: inside any operand
    std::vector<OperandId> operands;    ///< the operands that cover it, ascending
    double attribute = 0.0;             ///< from a region point
    double maxArea = 0.0;               ///< from a region point; 0: none
};

/// The colored triangulation.
struct RegionMap
{
    std::vector<RegionId> regionOfTriangle; ///< invalid for ghost and dead triangles
    /// By place (see region_order.h), but [0], always there, is the outer one: its triangles lie
    /// between the outlines and the convex hull.
    std::vector<Region> regions;
    /// By subsegment: it separates (Role::Boundary after Outline has been resolved).
    std::vector<std::uint8_t> isBoundary;
    /// By subsegment: nothing on either side of it is inside.
    std::vector<std::uint8_t> isOutside;
    std::size_t keptRegions = 0;       ///< connected kept faces
    /// Loops inside others, or parts where loops overlap, that even-odd turned into holes although
    /// neither the operand (declaresHoles) nor a hole point said so.
    std::size_t loopsMadeHoles = 0;
    std::vector<std::string> messages; ///< for the user
};

/// Marks the elements at the initial rectangle's corners as outer (paper, section 3, step 1): with
/// the corners at infinity these are the ghost triangles.
std::vector<std::uint32_t> outerSeeds(const Triangulation& triangulation);

/// Colors all triangles by flood fill from the outer seeds (paper, section 3, rules 1 and 2;
/// section 4), with winding numbers per operand, and decides by the fill rule what is inside.
RegionMap colorRegions(const RecoveryResult& recovered, const CurveNetwork& network,
                       const Pslg& pslg, FillRule fill, Execution& execution);

} // namespace tessera
