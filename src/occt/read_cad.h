// SPDX-License-Identifier: MIT
#pragma once

#include "occt/cad_input.h"

#include <filesystem>
#include <string>

namespace tessera
{

/// Reads planar faces, wires, edges and vertices from a .brep, .brp, .step or .stp file (by
/// extension, any case). Lengths in mm. Throws Error: Unreadable if the file does not exist, is cut
/// off or is not in its format; InvalidInput if the shape is empty, not planar (with the distance)
/// or not finite.
CadInput readCad(const std::filesystem::path& path, const CadOptions& options = {});

/// The same from the text of a .brep file; name is used in messages.
CadInput readBrepText(const std::string& text, const CadOptions& options = {},
                      const std::string& name = "shape");

} // namespace tessera
