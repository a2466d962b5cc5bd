// SPDX-License-Identifier: MIT
#include "io/atomic_file.h"

#include "base/error.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace tessera
{

namespace
{

/// Where the file really is, so that a link to it stays a link.
std::filesystem::path resolved(const std::filesystem::path& path)
{
    std::error_code error;
    std::filesystem::path real = std::filesystem::canonical(path, error);
    return error ? path : real;
}

/// Writes all of it; false with errno set if that fails.
bool writeAll(int file, std::string_view content)
{
    while (!content.empty()) {
        const ssize_t written = ::write(file, content.data(), content.size());
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            return false;
        }
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

} // namespace

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(resolved(path))
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path_, ignored)) {
        fail(EISDIR);
    }
    // A device or pipe (/dev/null, /dev/stdout) is written to, never replaced by a file.
    if (std::filesystem::is_other(path_, ignored)) {
        temporary_ = path_;
        if (::access(path_.c_str(), W_OK) != 0) {
            fail(errno);
        }
        return;
    }
    // A name that is too long shows now, not when the file is renamed.
    struct ::stat status = {};
    if (::lstat(path_.c_str(), &status) != 0 && errno != ENOENT) {
        fail(errno);
    }
    for (int attempt = 0; attempt < 100; ++attempt) {
        temporary_ = path_.parent_path()
            / fmt::format(".tessera-{}-{}.part{}", ::getpid(), attempt,
                          path_.extension().string());
        const int file = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            pending_ = true;
            return;
        }
        if (errno != EEXIST) {
            break;
        }
    }
    fail(errno);
}

AtomicFile::~AtomicFile()
{
    if (pending_) {
        ::unlink(temporary_.c_str());
    }
}

void AtomicFile::write(std::string_view content) const
{
    const int file = ::open(temporary_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (file < 0) {
        fail(errno);
    }
    if (!writeAll(file, content)) {
        const int reason = errno;
        ::close(file);
        fail(reason);
    }
    if (::close(file) != 0) {
        fail(errno);
    }
}

void AtomicFile::commit()
{
    if (pending_ && ::rename(temporary_.c_str(), path_.c_str()) != 0) {
        fail(errno);
    }
    pending_ = false;
}

void AtomicFile::fail(int reason) const
{
    std::error_code ignored;
    const std::filesystem::path folder = path_.parent_path();
    if (reason == ENOENT && !folder.empty() && !std::filesystem::exists(folder, ignored)) {
        throw Error(ErrorKind::Unwritable,
                    fmt::format("{}: cannot be written: there is no folder {}; make it first.",
                                path_.string(), folder.string()));
    }
    throw Error(ErrorKind::Unwritable,
                fmt::format("{}: cannot be written: {}.", path_.string(), std::strerror(reason)));
}

void requireWritable(const std::filesystem::path& path)
{
    const AtomicFile probe(path);
}

} // namespace tessera
