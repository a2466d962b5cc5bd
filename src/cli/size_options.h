// SPDX-License-Identifier: MIT
#pragma once

#include "cli/inputs.h"
#include "sizing/local_sizes.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace tessera::cli
{

/// The options that ask for sizes, as they were read.
struct SizeArguments
{
    std::optional<double> curvature;
    std::optional<double> chordError;
    std::optional<double> gap;
    std::vector<std::string> at;   ///< X,Y,H[,R[,FAR_H,FAR_R]]
    std::vector<std::string> on;   ///< LIST:H[,R[,FAR_H,FAR_R]]
    std::vector<std::string> in;   ///< LIST:H or X,Y,H
    std::vector<std::string> expressions;
    std::vector<std::string> files; ///< FILE.vtu:ARRAY
};

void addSizeOptions(CLI::App& command, SizeArguments& arguments);

/// What they ask for. Throws Error.
LocalSizes localSizes(const SizeArguments& arguments, const Inputs& inputs);

} // namespace tessera::cli
