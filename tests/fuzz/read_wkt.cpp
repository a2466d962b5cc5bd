// SPDX-License-Identifier: MIT

// Any text is a .wkt file: refused, or a valid network.

#include "bytes.h"

#include "base/error.h"
#include "curve/network_check.h"
#include "io/read_wkt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace tessera;
    try {
        const CurveNetwork network = parseWkt(fuzz::asText(data, size), "file");
        for (const NetworkProblem& problem : findProblems(network)) {
            fuzz::fail(problem.what);
        }
    }
    catch (const Error& error) {
        if (error.kind() != ErrorKind::Unreadable) {
            throw;
        }
    }
    return 0;
}
