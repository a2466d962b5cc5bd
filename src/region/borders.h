// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "recover/recover.h"
#include "region/subsegment_graph.h"
#include "sample/pslg.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// What one subsegment does to one operand's winding number.
struct BorderCrossing
{
    std::uint32_t operand;
    std::int32_t leftMinusRight; ///< left and right of the way from the subsegment's a to its b
};

/// The crossings of all subsegments; those that change nothing under the fill rule are left out.
struct Borders
{
    std::vector<std::uint32_t> start; ///< by subsegment, one more at the end
    std::vector<BorderCrossing> crossings;
    std::vector<std::string> messages; ///< boundaries that do not close

    std::span<const BorderCrossing> of(std::uint32_t subsegment) const
    {
        return {crossings.data() + start[subsegment], start[subsegment + 1] - start[subsegment]};
    }
};

/// Turns roles and directions into winding numbers' steps that agree on every way around:
///
/// - A boundary that does not close is read like a .poly: its dangling trees become constraints,
///   its components with a vertex of odd degree keep only their outline; the user is told.
/// - Where the winding number counts and an operand's boundary curves do not run head to tail
///   (edges of a sketch), they are turned so that they do, starting with each loop's first curve.
/// - Role::Outline becomes the outer contour of each component, counted as covering under every
///   rule; under FillRule::All all curves of an operand are treated so.
Borders findBorders(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
                    FillRule fill, const SubsegmentGraph& graph);

} // namespace tessera
