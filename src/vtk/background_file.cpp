// SPDX-License-Identifier: MIT
#include "vtk/background_file.h"

#include "base/error.h"
#include "io/read_network.h"
#include "io/text_file.h"
#include "vtk/vtk_mesh.h"

#include <fmt/format.h>

#include <utility>

namespace tessera
{

BackgroundMesh readBackground(const std::string& fileAndArray)
{
    const std::size_t colon = fileAndArray.rfind(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == fileAndArray.size()) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("Sizes are read from FILE.vtu:ARRAY, the name of a file and of its "
                                "point data; '{}' is not of that form.",
                                fileAndArray));
    }
    const std::string path = fileAndArray.substr(0, colon);
    if (extensionOf(path) != ".vtu") {
        throw Error(ErrorKind::Unreadable,
                    fmt::format("{}: sizes are read from .vtu files.", path));
    }
    NodalField field = parseVtu(readTextFile(path), path, fileAndArray.substr(colon + 1));
    BackgroundMesh mesh {path, {}, {}, std::move(field.values)};
    mesh.nodes.reserve(field.mesh.nodes.size());
    for (const auto& node : field.mesh.nodes) {
        mesh.nodes.push_back({node[0], node[1]});
    }
    for (const RawMesh::Cell& cell : field.mesh.cells) {
        const auto nodes = field.mesh.nodesOfCell(cell);
        for (std::size_t i = 2; i < cornersOf(cell.kind); ++i) {
            mesh.triangles.push_back({nodes[0], nodes[i - 1], nodes[i]});
        }
    }
    return mesh;
}

} // namespace tessera
