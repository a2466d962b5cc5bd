// SPDX-License-Identifier: MIT
#pragma once

#include "occt/cad_input.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// Reads planar faces, wires, edges and vertices from a .brep, .brp, .step or .stp file (by
/// extension, any case). Lengths in mm. Throws Error: Unreadable if the file does not exist, is cut
/// off or is not in its format; InvalidInput if the shape is empty, not planar (with the distance)
/// or not finite. Reads twice, at first in a copy of the process, because OpenCASCADE's readers
/// crash on damaged files.
CadInput readCad(const std::filesystem::path& path, const CadOptions& options = {});

/// The same from the text of a .brep file that OpenCASCADE wrote just now: damage that ends in a
/// crash of its reader is not caught here. name is used in messages.
CadInput readBrepText(const std::string& text, const CadOptions& options = {},
                      const std::string& name = "shape");

/// One of several shapes: the text of a .brep file, how to take it, and its name in messages.
struct BrepText
{
    std::string text;
    CadOptions options;
    std::string name = "shape";
};

/// Several shapes in one plane: options.plane of the first, else the plane of them all together.
/// All results have the same frame. Throws as above; CadError::shape() says which shape it was.
std::vector<CadInput> readBrepTexts(std::span<const BrepText> shapes);

} // namespace tessera
