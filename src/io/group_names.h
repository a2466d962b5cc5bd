// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tessera
{

/// Set names for an input deck: letters, digits, '_' and '-', a letter first, at most 80
/// characters, and all different (and different from the reserved ones) even if case is ignored.
std::vector<std::string> deckNames(const std::vector<std::string_view>& names,
                                   const std::vector<std::string_view>& reserved);

} // namespace tessera
