// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tessera
{

/// Names of curves, each once in the order of the curves; how many have none.
struct NamedCurves
{
    std::vector<std::string> names;
    std::size_t nameless = 0;

    bool empty() const { return names.empty() && nameless == 0; }
};

/// Of the curves c with wanted[c].
NamedCurves namesOf(const CurveNetwork& network, const std::vector<std::uint8_t>& wanted);

/// "Edge3, Edge5, Edge6 and 12 more", "3 curves".
std::string listOf(const NamedCurves& curves);

} // namespace tessera
