// SPDX-License-Identifier: MIT
#pragma once

#include "arrange/arc_pairs.h"
#include "arrange/arcs.h"
#include "base/execution.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tessera
{

/// All places where the curves of a network meet, other than at ends that they share.
struct CurveContacts
{
    std::vector<Contact> points;    ///< crossings and touches
    std::vector<Stretch> overlaps;  ///< lengths on both curves, from end to end of one of them
    std::vector<Vec2> unresolved;   ///< places of pairs given up, see ArcPairFinder
};

/// Looks at all pairs of curves of which at least one is not straight, and at each such curve with
/// itself. near: distance within which curves count as meeting. Where two curves share an end and
/// run along each other from there within the tolerance (tangent arcs), that is no contact.
CurveContacts findContacts(const CurveSet& curves, std::span<const Arc> arcs, double near,
                           Execution& execution);

} // namespace tessera
