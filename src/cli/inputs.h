// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "io/role_lists.h"
#include "occt/imprint_faces.h"
#include "occt/plane_frame.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tessera::cli
{

/// All inputs of a run as one network.
struct Inputs
{
    CurveNetwork network;
    double defaultWeld = 0.0; ///< the greatest of the inputs'
    PlaneFrame frame;         ///< of the CAD files; else the global one
    /// By curve: its marker (.poly), line (.wkt) or edge number (CAD).
    std::vector<std::int64_t> numberOfCurve;
};

/// Reads the files, .poly, .wkt and CAD, their operands in order. CAD files after the first take
/// the plane of the first. The lists' numbers apply to every file; one that no file has is refused.
/// Throws Error.
Inputs readInputs(const std::vector<std::string>& paths, const RoleLists& roles);

/// Sources and targets of an imprint, all CAD files or all .wkt and .poly; those lie in one plane.
/// Throws Error.
ImprintInput readImprint(const std::vector<std::string>& sources,
                         const std::vector<std::string>& targets,
                         const std::optional<Vec3>& direction);

} // namespace tessera::cli
