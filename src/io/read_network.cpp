// SPDX-License-Identifier: MIT
#include "io/read_network.h"

#include "base/error.h"
#include "io/read_poly.h"
#include "io/read_wkt.h"

#include <fmt/format.h>

namespace tessera
{

std::string extensionOf(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    for (char& c : extension) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return extension;
}

CurveNetwork readNetwork(const std::filesystem::path& path, const RoleLists& roles)
{
    const std::string extension = extensionOf(path);
    if (extension == ".poly") {
        return readPoly(path, roles);
    }
    if (extension == ".wkt") {
        return readWkt(path, roles);
    }
    throw Error(ErrorKind::Unreadable,
                fmt::format("{}: files of this kind cannot be read; give a .poly or .wkt file.",
                            path.string()));
}

} // namespace tessera
