// SPDX-License-Identifier: MIT
#pragma once

#include "imprint/overlay.h"
#include "occt/plane_frame.h"

#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <string>

namespace tessera
{

/// The polygons of a result as faces in the frame's plane, bounded by the original curves trimmed
/// where they meet others: an arc stays an arc. Neighboring faces share their edges and vertices, so
/// the compound conforms without sewing. Curves without a counterpart in OpenCASCADE (polylines)
/// become straight edges. O(edges).
TopoDS_Compound facesOf(const OverlayResult& result, const PlaneFrame& frame);

/// Writes the faces as .brep or .step, by extension. The file appears whole or not at all. Throws
/// Error(Unwritable).
void writeFaces(const OverlayResult& result, const PlaneFrame& frame,
                const std::filesystem::path& path);

/// The text of a .brep file with a shape.
std::string brepOf(const TopoDS_Shape& shape);

/// Writes any shape so.
void writeShape(const TopoDS_Shape& shape, const std::filesystem::path& path);

} // namespace tessera
