// SPDX-License-Identifier: MIT
#pragma once

#include "recover/recover.h"

#include <string>

namespace tessera
{

/// What to tell the user about rounding to the grid; empty if there was none.
std::string describeSnapping(const RecoveryReport& report);

} // namespace tessera
