// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"
#include "occt/cad_input.h"

#include <pybind11/pybind11.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tessera::python
{

/// What a place of an error is called on the Python side.
struct PlaceName
{
    std::string curve;   ///< name of the curve's edge group; empty: none
    std::string element; ///< "Edge7", "Geometry3", "Segment12"; empty: none
    std::int64_t source = -1;
    std::optional<std::array<double, 3>> point {}; ///< in space, if not in the plane
};

/// Raises the class of tessera.errors that belongs to the error's kind, with its places; names goes
/// with error.places(). The GIL must be held.
[[noreturn]] void raise(const Error& error, const std::vector<PlaceName>& names,
                        const PlaneFrame& frame);

} // namespace tessera::python
