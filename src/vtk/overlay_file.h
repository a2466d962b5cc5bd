// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/overlay.h"

#include <filesystem>

namespace tessera
{

/// Writes a result by extension: polygons as .wkt or .poly, a picture of the parts as .svg or .png,
/// the triangles in any other format of writeMesh(). The file appears whole or not at all. Throws
/// Error. Precondition unless .wkt: OverlayForm::Triangles.
void writeOverlay(const OverlayResult& result, BooleanOperation operation,
                  const std::filesystem::path& path);

} // namespace tessera
