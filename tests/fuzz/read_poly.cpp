// SPDX-License-Identifier: MIT

// Any text is a .poly file: refused, or a valid network.

#include "bytes.h"

#include "base/error.h"
#include "curve/network_check.h"
#include "io/read_poly.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace tessera;
    try {
        const CurveNetwork network = parsePoly(fuzz::asText(data, size), "file");
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
