// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace tessera::cli
{

/// A file that the command line names, and by which option; an empty name stands for no file.
struct NamedFile
{
    std::string option; ///< "-o", "--report"
    std::string path;
};

/// Throws Error(InvalidOption) if an output is one of the inputs or another output, under whatever
/// name: what is written would replace it. Devices and pipes may be shared.
void requireDistinct(const std::vector<std::string>& inputs, const std::vector<NamedFile>& outputs);

/// Throws Error(InvalidOption) if an output lies where --stages draws pictures and could be one.
void requireOutsideOf(const std::string& stagesFolder, const std::vector<NamedFile>& outputs);

} // namespace tessera::cli
