// SPDX-License-Identifier: MIT
#include "io/system_memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

namespace tessera
{

namespace
{

/// A number that is all of a small system file.
std::optional<std::uint64_t> readCount(const char* path)
{
    std::ifstream file(path);
    std::uint64_t value = 0;
    return file >> value ? std::optional(value) : std::nullopt;
}

/// A line "Name:   123 kB" of a system file, in bytes.
std::optional<std::uint64_t> readKibibytes(const char* path, const std::string& name)
{
    std::ifstream file(path);
    for (std::string word; file >> word;) {
        std::uint64_t value = 0;
        if (word == name && file >> value) {
            return 1024 * value;
        }
    }
    return std::nullopt;
}

} // namespace

std::uint64_t peakMemoryBytes()
{
    rusage usage {};
    if (getrusage(RUSAGE_SELF, &usage) != 0) {
        return 0;
    }
    return 1024 * static_cast<std::uint64_t>(usage.ru_maxrss); // Linux counts KiB
}

std::uint64_t availableMemoryBytes()
{
    std::uint64_t available = readKibibytes("/proc/meminfo", "MemAvailable:").value_or(0);
    const auto restrict = [&available](std::uint64_t limit, std::uint64_t used) {
        available = std::min(available, limit > used ? limit - used : 0);
    };
    const auto limit = readCount("/sys/fs/cgroup/memory.max");
    const auto used = readCount("/sys/fs/cgroup/memory.current");
    if (limit && used) {
        restrict(*limit, *used);
    }
    rlimit space {};
    if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) {
        restrict(space.rlim_cur, readKibibytes("/proc/self/status", "VmSize:").value_or(0));
    }
    return available;
}

} // namespace tessera
