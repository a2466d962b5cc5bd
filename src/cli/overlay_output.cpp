// SPDX-License-Identifier: MIT
#include "cli/overlay_output.h"

#include "io/read_network.h"
#include "vtk/mesh_file.h"

#include <fmt/format.h>

namespace tessera::cli
{

bool isFaceExtension(const std::string& extension)
{
    return extension == ".brep" || extension == ".brp" || extension == ".step"
        || extension == ".stp";
}

void requireOverlayOutput(CLI::App& command, std::shared_ptr<const RunOptions> arguments)
{
    command.callback([arguments = std::move(arguments)] {
        const std::string extension = extensionOf(arguments->output);
        if (extension != ".wkt" && !isFaceExtension(extension) && !isMeshExtension(extension)) {
            throw CLI::ValidationError("-o", fmt::format("'{}' should end in .wkt, .brep, .step, {}",
                                                         arguments->output, meshExtensions()));
        }
    });
}

} // namespace tessera::cli
