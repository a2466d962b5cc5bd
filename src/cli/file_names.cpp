// SPDX-License-Identifier: MIT
#include "cli/file_names.h"

#include "base/error.h"

#include <fmt/format.h>

#include <filesystem>

namespace tessera::cli
{

namespace
{

namespace fs = std::filesystem;

/// Whether both names mean one file, which need not exist yet.
bool isSame(const fs::path& a, const fs::path& b)
{
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) {
        return true;
    }
    const fs::path canonicalA = fs::weakly_canonical(fs::absolute(a, error), error);
    const fs::path canonicalB = fs::weakly_canonical(fs::absolute(b, error), error);
    return !error && canonicalA == canonicalB;
}

/// A device or a pipe.
bool isOther(const fs::path& path)
{
    std::error_code error;
    return fs::is_other(path, error);
}

} // namespace

void requireDistinct(const std::vector<std::string>& inputs, const std::vector<NamedFile>& outputs)
{
    for (auto output = outputs.begin(); output != outputs.end(); ++output) {
        if (output->path.empty() || isOther(output->path)) {
            continue;
        }
        for (const std::string& input : inputs) {
            if (isSame(input, output->path)) {
                throw Error(ErrorKind::InvalidOption,
                            fmt::format("{} {} would replace the input {}; choose another name.",
                                        output->option, output->path, input));
            }
        }
        for (auto other = outputs.begin(); other != output; ++other) {
            if (!other->path.empty() && isSame(other->path, output->path)) {
                throw Error(ErrorKind::InvalidOption,
                            fmt::format("{} {} and {} {} are one file; choose different names.",
                                        other->option, other->path, output->option, output->path));
            }
        }
    }
}

void requireOutsideOf(const std::string& stagesFolder, const std::vector<NamedFile>& outputs)
{
    for (const NamedFile& output : outputs) {
        const fs::path path(output.path);
        const bool isPicture = path.extension() == ".svg" || path.extension() == ".png";
        if (!stagesFolder.empty() && isPicture
            && isSame(fs::absolute(path).parent_path(), stagesFolder)) {
            throw Error(ErrorKind::InvalidOption,
                        fmt::format("{} {} lies in the folder of --stages, among pictures that could "
                                    "replace it; choose another folder.",
                                    output.option, output.path));
        }
    }
}

} // namespace tessera::cli
