// SPDX-License-Identifier: MIT
#include "vtk/mesh_file.h"

#include "base/error.h"
#include "io/atomic_file.h"
#include "io/mesh_picture.h"
#include "io/read_network.h"
#include "io/read_text_mesh.h"
#include "io/text_file.h"
#include "io/write_text_mesh.h"
#include "vtk/vtk_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace tessera
{

namespace
{

constexpr std::array<std::string_view, 7> kExtensions {".vtu", ".vtk", ".msh", ".inp",
                                                       ".poly", ".svg", ".png"};

std::string formatMesh(const Mesh& mesh, const std::string& extension, const CurveNetwork* network)
{
    if (extension == ".msh") {
        return formatMsh(mesh);
    }
    if (extension == ".inp") {
        return formatInp(mesh);
    }
    if (extension == ".poly") {
        return formatPoly(mesh, network);
    }
    PictureOptions options;
    options.format = extension == ".svg" ? PictureFormat::Svg : PictureFormat::Png;
    return drawMesh(mesh, options);
}

} // namespace

std::string meshExtensions()
{
    std::string list;
    for (std::size_t i = 0; i < kExtensions.size(); ++i) {
        list += i == 0 ? "" : i + 1 == kExtensions.size() ? " or " : ", ";
        list += kExtensions[i];
    }
    return list;
}

bool isMeshExtension(const std::string& extension)
{
    return std::ranges::find(kExtensions, extension) != kExtensions.end();
}

void writeMesh(const Mesh& mesh, const std::filesystem::path& path, const CurveNetwork* network)
{
    const std::string extension = extensionOf(path);
    if (!isMeshExtension(extension)) {
        throw Error(ErrorKind::Unwritable, fmt::format("{}: meshes are written as {}.",
                                                       path.string(), meshExtensions()));
    }
    if (extension == ".vtu" || extension == ".vtk") {
        writeVtk(mesh, path);
        return;
    }
    AtomicFile file(path);
    file.write(formatMesh(mesh, extension, network));
    file.commit();
}

RawMesh readMesh(const std::filesystem::path& path)
{
    const std::string extension = extensionOf(path);
    if (extension == ".vtu") {
        return parseVtu(readTextFile(path), path.string());
    }
    if (extension == ".msh") {
        return parseMsh(readTextFile(path), path.string());
    }
    if (extension == ".inp") {
        return parseInp(readTextFile(path), path.string());
    }
    throw Error(ErrorKind::Unreadable,
                fmt::format("{}: meshes are read from .vtu, .msh and .inp files.",
                            path.string()));
}

} // namespace tessera
