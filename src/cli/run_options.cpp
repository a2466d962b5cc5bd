// SPDX-License-Identifier: MIT
#include "cli/run_options.h"

#include "base/error.h"
#include "cli/choices.h"

#include <fmt/format.h>

#include <cmath>

namespace tessera::cli
{

void addFileOptions(CLI::App& command, RunOptions& options, const std::string& outputs)
{
    command.add_option("INPUT", options.inputs,
                       ".poly, .wkt, .brep or .step files; their operands in order")
        ->required();
    command.add_option("-o,--output", options.output, outputs)->required();
}

void addFillOption(CLI::App& command, RunOptions& options, const std::string& rules,
                   bool isOverlay)
{
    command.add_option("--fill", options.fill, rules)
        ->transform(namesOnly(kFillRules, isOverlay ? kBooleanFillRules : kFillRules))
        ->type_name("RULE");
}

void addControlOptions(CLI::App& command, RunOptions& options)
{
    command
        .add_option("--recovery", options.recovery,
                    "How boundaries are recovered: cavity (default) or steiner")
        ->transform(namesOnly(kStrategies))
        ->type_name("STRATEGY");
    command.add_option("--time-limit", options.timeLimit, "Seconds after which to give up");
    command.add_option("--report", options.report, "File for the report, JSON");
    command.add_flag("--quiet", options.quiet, "Print nothing but errors");
}

void addRunOptions(CLI::App& command, RunOptions& options)
{
    command.add_option("--weld", options.weld,
                       "End points nearer than this are one; default: 0, for CAD its tolerance");
    command.add_option("--stages", options.stages, "Folder for a picture of each stage")
        ->type_name("DIR");
    addControlOptions(command, options);
}

double positive(const std::optional<double>& value, const char* option, double otherwise)
{
    if (value && !(*value > 0.0 && std::isfinite(*value))) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("{} is {}; it must be a finite number greater than 0.", option,
                                *value));
    }
    return value.value_or(otherwise);
}

double notNegative(const std::optional<double>& value, const char* option, double otherwise)
{
    if (value && !(*value >= 0.0 && std::isfinite(*value))) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("{} is {}; it must be a finite number of 0 or more.", option,
                                *value));
    }
    return value.value_or(otherwise);
}

void requireValidWeld(const RunOptions& options)
{
    if (options.weld && !(*options.weld >= 0.0 && std::isfinite(*options.weld))) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("--weld is {}; it must be a length of 0 or more.", *options.weld));
    }
}

void setTimeLimit(Execution& execution, const RunOptions& options)
{
    if (options.timeLimit) {
        execution.setTimeLimit(positive(options.timeLimit, "--time-limit"));
    }
}

} // namespace tessera::cli
