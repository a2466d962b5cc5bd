// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "cli/commands.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace tessera;
using namespace tessera::cli;

int statusOf(const Error& error)
{
    const bool stopped =
        error.kind() == ErrorKind::Cancelled || error.kind() == ErrorKind::TimeLimit;
    return stopped ? kStopped : kRefused;
}

/// One line on stderr, whatever the message has in it.
void complain(std::string message)
{
    for (char& c : message) {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    fmt::print(stderr, "tessera: {}\n", message);
}

/// Help and version are no errors; everything else is one line and status 2.
int endOfParsing(const CLI::App& program, const CLI::ParseError& error)
{
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        return program.exit(error) == 0 ? kDone : kUsage;
    }
    std::string name = "tessera";
    for (const CLI::App* command : program.get_subcommands()) {
        name += ' ' + command->get_name();
    }
    std::string message = error.what();
    if (!message.empty() && message.back() != '.') {
        message += '.';
    }
    complain(fmt::format("{} Try {} --help.", message, name));
    return kUsage;
}

int runProgram(int argc, char** argv)
{
    CLI::App program("Tessera meshes plane shapes, however their curves cross, overlap or touch.",
                     "tessera");
    program.set_version_flag("--version", "tessera " TESSERA_VERSION);
    program.require_subcommand(1);
    const std::vector<std::pair<std::string, Command>> commands {
        {"mesh", addMeshCommand(program)},
        {"overlay", addOverlayCommand(program)},
        {"check", addCheckCommand(program)}};
    try {
        program.parse(argc, argv);
    }
    catch (const CLI::ParseError& error) {
        return endOfParsing(program, error);
    }
    for (const auto& [name, run] : commands) {
        if (program.got_subcommand(name)) {
            return run();
        }
    }
    return kUsage;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return runProgram(argc, argv);
    }
    catch (const Error& error) {
        complain(error.what());
        return statusOf(error);
    }
    catch (const std::bad_alloc&) {
        complain("There is not enough memory; choose a larger size.");
    }
    catch (const std::exception& error) {
        complain(fmt::format("Internal error: {}; please report it.", error.what()));
    }
    return kRefused;
}
