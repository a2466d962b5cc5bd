// SPDX-License-Identifier: MIT
#pragma once

#include "io/canvas.h"
#include "mesh/mesh.h"
#include "mesh/quality.h"

#include <string>

namespace tessera
{

/// A picture of how good a mesh is, as the content of an .svg or .png file: the triangles colored by
/// their smallest angle, red below 5 degrees to green at 60, rings around the worst ones, and beside
/// it how many triangles have which angles and qualities. Precondition: mesh has triangles, and
/// quality was measured on it.
std::string drawQuality(const Mesh& mesh, const QualityReport& quality, PictureFormat format,
                        const std::string& caption);

} // namespace tessera
