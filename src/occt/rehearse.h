// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace tessera
{

/// Calls read() in a copy of this process and tells whether it came back: not if it crashed, never
/// ended or took all memory. OpenCASCADE's readers do all three on damaged files. An exception
/// counts as coming back. Limits of the copy: 5 s of processor time and 2 GB, more for large files.
bool comesBack(const std::function<void()>& read, std::size_t fileSize);

} // namespace tessera
