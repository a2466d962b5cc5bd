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

/// What CLI11 found wrong, in plain words.
std::string explain(const CLI::App& program, const CLI::ParseError& error, const char* firstWord)
{
    if (program.get_subcommands().empty() && firstWord != nullptr) {
        std::string names;
        for (const CLI::App* command : program.get_subcommands({})) {
            names += (names.empty() ? "" : ", ") + command->get_name();
        }
        return fmt::format("There is no {} {}; the commands are {}.",
                           *firstWord == '-' ? "option" : "command", firstWord, names);
    }
    const std::string text = error.what();
    const std::string conversion = "Could not convert: ";
    const std::size_t equals = text.find(" = ");
    if (text.starts_with(conversion) && equals != std::string::npos) {
        return fmt::format("{}: '{}' is not a number.",
                           text.substr(conversion.size(), equals - conversion.size()),
                           text.substr(equals + 3));
    }
    const std::string option = text.substr(0, text.find(": "));
    if (text.find(" missing") != std::string::npos) {
        return option + " needs a value.";
    }
    if (text.find("At Most 1 required") != std::string::npos) {
        return option + " is given more than once.";
    }
    return text.ends_with('.') ? text : text + '.';
}

/// Help and version are no errors; everything else is one line and status 2.
int endOfParsing(const CLI::App& program, const CLI::ParseError& error, const char* firstWord)
{
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        return program.exit(error) == 0 ? kDone : kUsage;
    }
    std::string name = "tessera";
    for (const CLI::App* command : program.get_subcommands()) {
        name += ' ' + command->get_name();
    }
    complain(fmt::format("{} Try {} --help.", explain(program, error, firstWord), name));
    return kUsage;
}

/// CLI11 takes an empty value (of an unset variable in a script, say) for no value at all.
void refuseEmptyValues(CLI::App& program)
{
    const CLI::Validator isGiven(
        [](std::string& value) { return std::string(value.empty() ? "the value is empty" : ""); },
        "");
    for (CLI::App* command : program.get_subcommands({})) {
        for (CLI::Option* option : command->get_options()) {
            if (option->get_items_expected_max() > 0) {
                option->check(isGiven);
            }
        }
    }
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
        {"imprint", addImprintCommand(program)},
        {"check", addCheckCommand(program)}};
    refuseEmptyValues(program);
    try {
        program.parse(argc, argv);
    }
    catch (const CLI::ParseError& error) {
        return endOfParsing(program, error, argc > 1 ? argv[1] : nullptr);
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
