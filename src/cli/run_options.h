// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "recover/recover.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace tessera::cli
{

/// What all commands take that run on curves, as it was read. An option that was not given is empty.
struct RunOptions
{
    std::vector<std::string> inputs;
    std::string output;
    FillRule fill = FillRule::EvenOdd;
    RecoveryStrategy recovery = RecoveryStrategy::Cavity;
    std::optional<double> weld;
    std::optional<double> timeLimit;
    std::string stages;
    std::string report;
    bool quiet = false;
};

/// INPUT and -o.
void addFileOptions(CLI::App& command, RunOptions& options, const std::string& outputs);

/// --fill; rules: what it says about the choices, of which an overlay has fewer.
void addFillOption(CLI::App& command, RunOptions& options, const std::string& rules,
                   bool isOverlay = false);

/// --recovery, --time-limit, --report, --quiet.
void addControlOptions(CLI::App& command, RunOptions& options);

/// The same, --weld and --stages.
void addRunOptions(CLI::App& command, RunOptions& options);

/// The value of an option that is a number above 0, else throws Error(InvalidOption); otherwise if it
/// was not given.
double positive(const std::optional<double>& value, const char* option, double otherwise = 0.0);

/// The same of a number that may be 0.
double notNegative(const std::optional<double>& value, const char* option, double otherwise);

/// Error(InvalidOption) if the weld tolerance is negative or not finite.
void requireValidWeld(const RunOptions& options);

/// Lets the run end after --time-limit. Throws Error(InvalidOption).
void setTimeLimit(Execution& execution, const RunOptions& options);

} // namespace tessera::cli
