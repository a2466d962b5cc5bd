// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace tessera::test
{

/// Folder of other projects' inputs; may not exist.
inline std::filesystem::path corpora()
{
    const char* given = std::getenv("TESSERA_CORPORA");
    return given != nullptr ? std::filesystem::path(given)
                            : std::filesystem::path(TESSERA_SOURCE_DIR) / "../shared/corpora";
}

} // namespace tessera::test

/// For the beginning of a test, or of SetUp(). The corpora belong to other projects and are never
/// copied into this one, so a clone alone lacks them: then, and only then, the test is skipped. Where
/// they are, everything that a test names must be there.
#define TESSERA_NEEDS_CORPORA()                                                                    \
    if (!std::filesystem::is_directory(tessera::test::corpora())) {                                \
        GTEST_SKIP() << "the corpora are not at " << tessera::test::corpora()                      \
                     << "; set TESSERA_CORPORA to their folder";                                   \
    }                                                                                              \
    static_cast<void>(0)
