// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"

namespace tessera
{

/// Runs what has no size that the user could choose larger when the time limit runs out.
template<class Run>
auto withoutAdvice(Run&& run)
{
    try {
        return run();
    }
    catch (const Error& error) {
        if (error.kind() != ErrorKind::TimeLimit) {
            throw;
        }
        throw Error(ErrorKind::TimeLimit, "The time limit ran out; raise it.", error.places());
    }
}

} // namespace tessera
