// SPDX-License-Identifier: MIT
#include "io/read_poly.h"
#include "io/read_wkt.h"
#include "property/corpora.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace tessera
{
namespace
{

using test::corpora;
using test::readPacked;

TEST(Corpora, EveryPolyHasTheCountsOfTheManifest)
{
    TESSERA_NEEDS_CORPORA();
    const auto manifest = nlohmann::json::parse(std::ifstream(corpora() / "MANIFEST.json"));
    std::size_t checked = 0;
    for (const auto& [name, entry] : manifest.items()) {
        if (entry["kind"] != "pslg") {
            continue;
        }
        SCOPED_TRACE(name);
        const CurveNetwork network = parsePoly(readPacked(corpora() / name), name);
        EXPECT_EQ(network.points.size(), entry["points"].get<std::size_t>());
        EXPECT_EQ(network.curves.size(), entry["segments"].get<std::size_t>());
        EXPECT_EQ(network.holes.size(), entry["holes"].get<std::size_t>());
        ++checked;
    }
    EXPECT_GT(checked, 200U);
}

TEST(Corpora, EveryWktIsRead)
{
    TESSERA_NEEDS_CORPORA();
    std::size_t checked = 0;
    for (const auto& file : std::filesystem::directory_iterator(corpora() / "geo/wkt")) {
        SCOPED_TRACE(file.path().string());
        const CurveNetwork network = parseWkt(readPacked(file.path()), file.path().string());
        EXPECT_FALSE(network.curves.empty());
        ++checked;
    }
    EXPECT_GE(checked, 14U);
}

TEST(Corpora, WktPointsOfOneFileOneByOne)
{
    TESSERA_NEEDS_CORPORA();
    const auto path = corpora() / "geo/wkt/geos_regression6.wkt";
    const CurveNetwork network = readWkt(path);
    EXPECT_EQ(network.points.front(), (Vec2 {146.375, -33.475}));
    EXPECT_EQ(network.points.size(), network.curves.size()); // closed rings
}

} // namespace
} // namespace tessera
