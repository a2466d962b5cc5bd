// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/overlay.h"
#include "mesh/mesh.h"

namespace tessera
{

/// The triangles of the result with its constraint edges: a region for each part, groups by part,
/// operand (with cells or a priority), curve name and marker.
Mesh meshOf(const OverlayResult& result);

} // namespace tessera
