// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace CLI
{
class App;
}

namespace tessera::cli
{

/// What the program returns to its caller.
enum ExitStatus
{
    kDone = 0,
    kRefused = 1,  ///< input that cannot be meshed, an invalid mesh, a file that cannot be written
    kUsage = 2,    ///< the command line is wrong
    kStopped = 3,  ///< cancelled, or the time limit ran out
};

/// Runs a command after its options have been read; returns the exit status or throws Error.
using Command = std::function<int()>;

/// Each adds its command and options and returns what runs it.
Command addMeshCommand(CLI::App& program);
Command addOverlayCommand(CLI::App& program);
Command addImprintCommand(CLI::App& program);
Command addCheckCommand(CLI::App& program);

} // namespace tessera::cli
