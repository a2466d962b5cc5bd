// SPDX-License-Identifier: MIT
#pragma once

#include "cli/run_options.h"

#include <memory>
#include <string>

namespace tessera::cli
{

/// Whether a file with this extension holds faces: .brep, .brp, .step, .stp.
bool isFaceExtension(const std::string& extension);

/// Lets the command refuse names of outputs that are for no result of an overlay: neither polygons,
/// faces nor triangles.
void requireOverlayOutput(CLI::App& command, std::shared_ptr<const RunOptions> arguments);

} // namespace tessera::cli
