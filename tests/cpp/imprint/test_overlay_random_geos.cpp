// SPDX-License-Identifier: MIT

// Random self-intersecting polygons: no exception, no invalid polygon (GEOS), and the areas that
// identities between operations demand. TESSERA_RANDOM_CASES says how many (default 1000).

#include "imprint/geos.h"
#include "imprint/overlay.h"
#include "io/overlay_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace tessera
{
namespace
{

constexpr BooleanOperation kOperations[] = {
    BooleanOperation::Union, BooleanOperation::Intersection, BooleanOperation::Difference,
    BooleanOperation::SymmetricDifference, BooleanOperation::Cells};
constexpr FillRule kRules[] = {FillRule::EvenOdd, FillRule::NonZero, FillRule::Positive,
                               FillRule::Negative};

/// 3 to 300 vertices, log-uniform. Where they lie: anywhere, on a coarse grid (touches and
/// overlaps), or far from the origin in a small square (coarse doubles).
CurveNetwork randomCase(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const std::size_t count =
        static_cast<std::size_t>(std::lround(3.0 * std::pow(100.0, unit(random))));
    const std::size_t kind = random() % 4;
    CurveNetwork network;
    network.operands.resize(1 + random() % 3);
    const std::size_t operands = network.operands.size();
    for (std::size_t o = 0; o < operands; ++o) {
        const std::size_t ring = std::max<std::size_t>(3, count / operands);
        const std::size_t first = network.points.size();
        for (std::size_t i = 0; i < ring; ++i) {
            Vec2 p {unit(random), unit(random)};
            if (kind == 1) {
                p = {std::floor(12.0 * p.x), std::floor(12.0 * p.y)};
            }
            else if (kind == 2) {
                p = {1e6 + 1e-6 * p.x, -3e5 + 1e-6 * p.y};
            }
            network.addPoint(p);
        }
        for (std::size_t i = 0; i < ring; ++i) {
            network.curves.push_back({nullptr, PointId(first + i),
                                      PointId(first + (i + 1) % ring), OperandId(o)});
        }
    }
    return network;
}

std::size_t caseCount()
{
    const char* given = std::getenv("TESSERA_RANDOM_CASES");
    return given != nullptr ? std::strtoull(given, nullptr, 10) : 1000;
}

TEST(OverlayRandom, SelfIntersectingPolygonsGiveValidPolygons)
{
    const test::Geos geos;
    std::mt19937_64 random(66);
    const std::size_t cases = caseCount();
    for (std::size_t c = 0; c < cases; ++c) {
        SCOPED_TRACE(c);
        const CurveNetwork network = randomCase(random);
        OverlayOptions options;
        options.fill = kRules[random() % 4];
        double area[5] = {};
        const bool all = c % 10 == 0;
        for (std::size_t i = all ? 0 : c % 5; i < (all ? 5 : c % 5 + 1); ++i) {
            options.operation = kOperations[i];
            Execution execution;
            OverlayResult result;
            ASSERT_NO_THROW(result = overlayNetwork(network, options, execution));
            area[i] = result.report.area;
            if (result.parts.parts.empty()) {
                EXPECT_EQ(area[i], 0.0);
                continue;
            }
            // Cells one by one would take GEOS long; the first few will do.
            const std::string text = formatWkt(result, options.operation);
            std::size_t begin = 0;
            for (int line = 0; line < 20 && begin < text.size(); ++line) {
                const std::size_t end = text.find('\n', begin);
                const auto geometry = geos.read(text.substr(begin, end - begin));
                ASSERT_NE(geometry, nullptr);
                ASSERT_EQ(geos.whyInvalid(geometry.get()), "");
                begin = end + 1;
            }
        }
        if (!all) {
            continue;
        }
        EXPECT_NEAR(area[4], area[0], 1e-9 * area[0]);
        if (network.operands.size() == 2) {
            EXPECT_NEAR(area[3] + area[1], area[0], 1e-9 * area[0]);
        }
    }
}

} // namespace
} // namespace tessera
