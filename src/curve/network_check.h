// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"
#include "curve/curve_network.h"

#include <string>
#include <vector>

namespace tessera
{

/// One thing that is wrong with a network.
struct NetworkProblem
{
    std::string what; ///< a sentence
    ErrorPlace place;
};

/// Everything that makes a network unusable: coordinates or parameter ranges that are not finite,
/// ids out of range, curves or points of an operand that does not exist. Does not look at the
/// shape.
std::vector<NetworkProblem> findProblems(const CurveNetwork& network);

/// Throws Error(InvalidInput) with the place of every problem, if there is any.
void requireValid(const CurveNetwork& network);

} // namespace tessera
