// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"
#include "base/execution.h"
#include "curve/curve_network.h"
#include "recover/recover.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tessera
{

struct ArrangeOptions
{
    /// End points closer than this become one, in the input's unit; >= 0. 0: none are moved, except
    /// by rounding (1e-12 of the greatest coordinate) if some curve is not straight.
    double weld = 0.0;
    /// Split straight curves where they cross, see cross_straight.h; false leaves all crossings to
    /// the recovery of the constraints.
    bool crossStraight = false;
    RecoveryStrategy recovery = RecoveryStrategy::Cavity;
    RecoveryObserver* observer = nullptr; ///< of that recovery
};

struct ArrangeReport
{
    /// Points that were joined to another one, or to the inside of a curve, by more than rounding.
    std::size_t welded = 0;
    std::size_t weldedOnto = 0; ///< of these, those that it moved, or that bent a curve, by more than
                                ///< rounding
    double greatestBend = 0.0;  ///< farthest that a curve was bent, or an end moved
    std::size_t weldedAlong = 0; ///< curves that became one with another one that they run along
    double greatestGap = 0.0;    ///< farthest apart that such curves were
    std::size_t swallowed = 0;  ///< curves too short for the tolerance, whose ends became one
    /// Chains of points within the tolerance that reach farther than twice the tolerance and were
    /// therefore left alone; one place each.
    std::vector<ErrorPlace> chainsLeft;
    /// By curve of the result: the input curve it is (a piece of).
    std::vector<CurveId> parent;
    /// By point of the input: its point in the result, invalid if nothing uses it.
    std::vector<PointId> pointOf;
    /// Points of the result from here on were made at crossings.
    std::size_t firstCrossing = 0;
    /// Of crossing the curves: crossings are new points, touches are points on a curve's inside.
    RecoveryReport crossed;
    std::vector<std::string> messages; ///< for the user
};

/// Welds end points to each other and onto curves, settles Role::Chain, cuts curves where they
/// cross, touch and overlap (straight ones among themselves if asked), and leaves out the points
/// that no curve of a role other than Ignored and no embedded point uses. Validates the network
/// first: throws Error(InvalidInput); Error(InvalidOption) for a tolerance that is negative or not
/// finite.
CurveNetwork arrange(const CurveNetwork& network, const ArrangeOptions& options,
                     ArrangeReport& report, Execution& execution);

} // namespace tessera
