// SPDX-License-Identifier: MIT
#include "io/expect_error.h"
#include "io/read_poly.h"
#include "io/read_wkt.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <string>

namespace tessera
{
namespace
{

using testing::corpora;

/// The file's text; a .gz is unpacked.
std::string unpacked(const std::filesystem::path& path)
{
    if (path.extension() != ".gz") {
        return testing::readAll(path);
    }
    std::FILE* pipe = popen(("gzip -dc '" + path.string() + "'").c_str(), "r");
    std::string text;
    char block[4096];
    while (const std::size_t got = std::fread(block, 1, sizeof block, pipe)) {
        text.append(block, got);
    }
    EXPECT_EQ(pclose(pipe), 0) << path;
    return text;
}

TEST(Corpora, EveryPolyHasTheCountsOfTheManifest)
{
    if (!std::filesystem::exists(corpora() / "MANIFEST.json")) {
        GTEST_SKIP() << "the corpora are not at " << corpora() << "; set TESSERA_CORPORA";
    }
    const auto manifest = nlohmann::json::parse(std::ifstream(corpora() / "MANIFEST.json"));
    std::size_t checked = 0;
    for (const auto& [name, entry] : manifest.items()) {
        if (entry["kind"] != "pslg") {
            continue;
        }
        SCOPED_TRACE(name);
        const CurveNetwork network = parsePoly(unpacked(corpora() / name), name);
        EXPECT_EQ(network.points.size(), entry["points"].get<std::size_t>());
        EXPECT_EQ(network.curves.size(), entry["segments"].get<std::size_t>());
        EXPECT_EQ(network.holes.size(), entry["holes"].get<std::size_t>());
        ++checked;
    }
    EXPECT_GT(checked, 200U);
}

TEST(Corpora, EveryWktIsRead)
{
    if (!std::filesystem::exists(corpora() / "geo/wkt")) {
        GTEST_SKIP() << "the corpora are not at " << corpora() << "; set TESSERA_CORPORA";
    }
    std::size_t checked = 0;
    for (const auto& file : std::filesystem::directory_iterator(corpora() / "geo/wkt")) {
        SCOPED_TRACE(file.path().string());
        const CurveNetwork network = parseWkt(unpacked(file.path()), file.path().string());
        EXPECT_FALSE(network.curves.empty());
        ++checked;
    }
    EXPECT_GE(checked, 14U);
}

TEST(Corpora, WktPointsOfOneFileOneByOne)
{
    const auto path = corpora() / "geo/wkt/geos_regression6.wkt";
    if (!std::filesystem::exists(path)) {
        GTEST_SKIP() << "the corpora are not at " << corpora() << "; set TESSERA_CORPORA";
    }
    const CurveNetwork network = readWkt(path);
    EXPECT_EQ(network.points.front(), (Vec2 {146.375, -33.475}));
    EXPECT_EQ(network.points.size(), network.curves.size()); // closed rings
}

} // namespace
} // namespace tessera
