// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tessera
{

/// An output file that appears whole or not at all: written under another name in the same folder,
/// renamed by commit(). Without commit() the destructor removes it and an older file of that name
/// stays as it was. A device or pipe is written to directly. All functions throw Error(Unwritable).
class AtomicFile
{
public:
    /// Creates the file beside, so that a folder that cannot be written to shows at once.
    explicit AtomicFile(std::filesystem::path path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// The name to write to; has the extension of the final name.
    const std::filesystem::path& temporary() const { return temporary_; }
    /// Replaces the content of the temporary file.
    void write(std::string_view content) const;
    void commit();

private:
    [[noreturn]] void fail(int reason) const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    bool pending_ = false;
};

/// Throws Error(Unwritable) if a file of that name could not be created. Leaves nothing behind.
void requireWritable(const std::filesystem::path& path);

} // namespace tessera
