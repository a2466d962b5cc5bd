// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace tessera::testing
{

/// run() throws Error of this kind, whose message contains text.
template<class Run>
void expectError(ErrorKind kind, const std::string& text, Run&& run)
{
    try {
        run();
        ADD_FAILURE() << "no error; expected one with: " << text;
    }
    catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind) << error.what();
        EXPECT_NE(std::string(error.what()).find(text), std::string::npos)
            << "message: " << error.what() << "\nexpected in it: " << text;
    }
}

/// run() returns or throws Error(Unreadable) with a message: never anything else.
template<class Run>
bool succeedsOrIsRefused(Run&& run)
{
    try {
        run();
        return true;
    }
    catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Unreadable) << error.what();
        EXPECT_FALSE(std::string(error.what()).empty());
        return false;
    }
}

/// A folder that is removed with all its files at the end of the test.
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "tessera-XX" "XXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    /// Names of what lies in the folder.
    std::size_t fileCount() const
    {
        const std::filesystem::directory_iterator files(path_);
        return static_cast<std::size_t>(std::distance(begin(files), end(files)));
    }

private:
    std::filesystem::path path_;
};

inline std::string readAll(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

inline void writeAll(const std::filesystem::path& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

} // namespace tessera::testing
