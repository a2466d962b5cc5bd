// SPDX-License-Identifier: MIT
#pragma once

// What holds for any text that a reader is given: refused as unreadable, or good.

#include "bytes.h"

#include "base/error.h"
#include "curve/network_check.h"
#include "io/check_mesh.h"

#include <string_view>

namespace tessera::fuzz
{

/// check(text) may throw Error(Unreadable), nothing else.
template<class Check>
int refuseOrCheck(const std::uint8_t* data, std::size_t size, Check check)
{
    try {
        check(asText(data, size));
    }
    catch (const Error& error) {
        if (error.kind() != ErrorKind::Unreadable) {
            throw;
        }
    }
    return 0;
}

inline void requireGood(const CurveNetwork& network)
{
    for (const NetworkProblem& problem : findProblems(network)) {
        fail(problem.what);
    }
}

inline void requireGood(const RawMesh& mesh)
{
    for (const std::uint32_t node : mesh.cellNodes) {
        require(node < mesh.nodes.size(), "A cell has a node that does not exist.");
    }
    require(checkMesh(mesh).nodes == mesh.nodes.size(), "Nodes are lost.");
}

} // namespace tessera::fuzz
