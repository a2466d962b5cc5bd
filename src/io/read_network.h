// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve_network.h"
#include "io/role_lists.h"

#include <filesystem>
#include <string>

namespace tessera
{

/// The extension in lower case, with the dot; empty if there is none.
std::string extensionOf(const std::filesystem::path& path);

/// Reads a .poly or .wkt file, by extension in any case. Throws Error(Unreadable).
CurveNetwork readNetwork(const std::filesystem::path& path, const RoleLists& roles = {});

} // namespace tessera
