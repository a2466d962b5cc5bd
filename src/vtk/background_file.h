// SPDX-License-Identifier: MIT
#pragma once

#include "sizing/background_size.h"

#include <string>

namespace tessera
{

/// Reads a mesh with sizes from "FILE.vtu:ARRAY": the triangles, and quadrangles as two of them,
/// with the point data of that name. x and y count, z does not. Throws Error(InvalidOption) if the
/// text has no such form, Error(Unreadable) if the file is not as it should be.
BackgroundMesh readBackground(const std::string& fileAndArray);

} // namespace tessera
