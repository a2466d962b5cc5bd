// SPDX-License-Identifier: MIT

// Any text is a .vtu file: refused, or a mesh that can be checked.

#include "bytes.h"

#include "base/error.h"
#include "io/check_mesh.h"
#include "vtk/vtk_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace tessera;
    try {
        const RawMesh mesh = parseVtu(fuzz::asText(data, size), "file");
        for (const std::uint32_t node : mesh.cellNodes) {
            fuzz::require(node < mesh.nodes.size(), "A cell has a node that does not exist.");
        }
        const MeshCheck check = checkMesh(mesh);
        fuzz::require(check.nodes == mesh.nodes.size(), "Nodes are lost.");
    }
    catch (const Error& error) {
        if (error.kind() != ErrorKind::Unreadable) {
            throw;
        }
    }
    return 0;
}
