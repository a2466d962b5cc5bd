// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tessera
{

/// Roles that the user gives by number: markers (.poly), line numbers (.wkt), edge numbers (CAD).
/// Of several lists that have a number the last one counts.
struct RoleLists
{
    std::vector<std::int32_t> boundary;
    std::vector<std::int32_t> constraint;
    std::vector<std::int32_t> ignored;

    /// Gives a curve the role of its number, if it is in a list.
    void apply(NetworkCurve& curve, std::int64_t number) const
    {
        if (std::ranges::find(boundary, number) != boundary.end()) {
            curve.role = Role::Boundary;
        }
        if (std::ranges::find(constraint, number) != constraint.end()) {
            curve.role = Role::Constraint;
        }
        if (std::ranges::find(ignored, number) != ignored.end()) {
            curve.role = Role::Ignored;
        }
    }
    /// All numbers of all lists.
    std::vector<std::int32_t> all() const
    {
        std::vector<std::int32_t> numbers = boundary;
        numbers.insert(numbers.end(), constraint.begin(), constraint.end());
        numbers.insert(numbers.end(), ignored.begin(), ignored.end());
        return numbers;
    }
};

} // namespace tessera
