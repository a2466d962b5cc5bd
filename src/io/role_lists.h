// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tessera
{

/// Roles that the user gives by number: markers (.poly), line numbers (.wkt), edge numbers (CAD).
/// A number in both lists is a constraint.
struct RoleLists
{
    std::vector<std::int32_t> boundary;
    std::vector<std::int32_t> constraint;

    /// Gives a curve the role of its number, if it is in a list.
    void apply(NetworkCurve& curve, std::int64_t number) const
    {
        if (std::ranges::find(boundary, number) != boundary.end()) {
            curve.role = Role::Boundary;
        }
        if (std::ranges::find(constraint, number) != constraint.end()) {
            curve.role = Role::Constraint;
        }
    }
    /// All numbers of both lists.
    std::vector<std::int32_t> all() const
    {
        std::vector<std::int32_t> numbers = boundary;
        numbers.insert(numbers.end(), constraint.begin(), constraint.end());
        return numbers;
    }
};

} // namespace tessera
