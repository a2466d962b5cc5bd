// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "io/canvas.h"
#include "mesh/mesh.h"

#include <optional>
#include <string>

namespace tessera
{

struct PictureOptions
{
    PictureFormat format = PictureFormat::Svg;
    std::string caption;      ///< empty: none
    std::optional<Box2> view; ///< what to show; none: the whole mesh
    bool triangleSides = true; ///< false: regions and curves only
};

/// A picture of the mesh as the content of an .svg or .png file: regions in colors, the outline
/// and other constraints as thicker lines, named points as dots. Second-order edges are curved.
std::string drawMesh(const Mesh& mesh, const PictureOptions& options);

/// The same on a canvas that is there.
void drawMesh(Canvas& canvas, const Mesh& mesh, bool triangleSides = true);

/// Box of all nodes.
Box2 boundsOf(const Mesh& mesh);

} // namespace tessera
