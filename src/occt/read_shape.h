// SPDX-License-Identifier: MIT
#pragma once

#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <string>

namespace tessera
{

/// The shape in a .brep, .brp, .step or .stp file, with the care and the errors of readCad().
TopoDS_Shape shapeFromFile(const std::filesystem::path& path);

/// The shape in the text of a .brep file, as readBrepText() takes it.
TopoDS_Shape shapeFromBrep(const std::string& text, const std::string& name = "shape");

} // namespace tessera
