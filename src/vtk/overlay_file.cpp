// SPDX-License-Identifier: MIT
#include "vtk/overlay_file.h"

#include "imprint/overlay_mesh.h"
#include "io/atomic_file.h"
#include "io/mesh_picture.h"
#include "io/overlay_files.h"
#include "io/read_network.h"
#include "vtk/mesh_file.h"

#include <string>

namespace tessera
{

namespace
{

/// Without the sides of the triangles, of which curves have many.
std::string pictureOf(const OverlayResult& result, PictureFormat format)
{
    PictureOptions options;
    options.format = format;
    options.triangleSides = false;
    return drawMesh(meshOf(result), options);
}

} // namespace

void writeOverlay(const OverlayResult& result, BooleanOperation operation,
                  const std::filesystem::path& path)
{
    const std::string extension = extensionOf(path);
    const bool svg = extension == ".svg";
    if (extension != ".wkt" && !isMeshExtension(extension)) {
        throw Error(ErrorKind::Unwritable,
                    path.string() + ": results are written as .wkt, .brep, .step, "
                        + meshExtensions() + ".");
    }
    if (extension != ".wkt" && extension != ".poly" && !svg && extension != ".png") {
        writeMesh(meshOf(result), path, &result.input);
        return;
    }
    AtomicFile file(path);
    file.write(extension == ".wkt"    ? formatWkt(result, operation)
                   : extension == ".poly" ? formatPoly(result)
                   : pictureOf(result, svg ? PictureFormat::Svg : PictureFormat::Png));
    file.commit();
}

} // namespace tessera
