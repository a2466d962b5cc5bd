// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace tessera
{

/// Greatest amount of memory that this process has held so far, bytes; 0 if not known.
std::uint64_t peakMemoryBytes();

/// Memory that this process may still take without swapping, bytes: what the machine has free, or
/// less if the process's control group or resource limit allows less. 0 if not known.
std::uint64_t availableMemoryBytes();

} // namespace tessera
