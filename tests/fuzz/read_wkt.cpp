// SPDX-License-Identifier: MIT

// Any text is a .wkt file: refused, or a valid network.

#include "readers.h"

#include "io/read_wkt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace tessera;
    return fuzz::refuseOrCheck(data, size, [](std::string_view text) {
        fuzz::requireGood(parseWkt(text, "file"));
    });
}
