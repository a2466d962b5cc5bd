// SPDX-License-Identifier: MIT

// Any text is a .msh file: refused, or a mesh that can be checked.

#include "readers.h"

#include "io/read_text_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace tessera;
    return fuzz::refuseOrCheck(data, size, [](std::string_view text) {
        fuzz::requireGood(parseMsh(text, "file"));
    });
}
