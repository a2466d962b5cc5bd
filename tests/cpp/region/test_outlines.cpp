// SPDX-License-Identifier: MIT
#include "region/colored.h"
#include "region/region_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace tessera
{
namespace
{

constexpr std::uint32_t kNoLabel = 0xffffffffU;

/// One polygon of partOutlines(), with the label of its regions.
struct RegionOutline
{
    std::uint32_t label;
    std::vector<std::vector<std::uint32_t>> loops;
};

/// The polygons of the connected sets of triangles whose regions have the same label.
std::vector<RegionOutline> regionOutlines(const RecoveryResult& recovered, const RegionMap& map,
                                          const std::vector<std::uint32_t>& labelOfRegion)
{
    const Triangulation& t = recovered.triangulation;
    const auto labelAt = [&](std::uint32_t triangle) {
        const RegionId region = map.regionOfTriangle[triangle];
        return region.valid() ? labelOfRegion[region.index()] : kNoLabel;
    };
    std::vector<std::uint32_t> partOf(t.triangles.size(), kNoPart);
    std::vector<RegionOutline> outlines;
    for (std::uint32_t seed = 0; seed < t.triangles.size(); ++seed) {
        if (labelAt(seed) == kNoLabel || partOf[seed] != kNoPart) {
            continue;
        }
        const auto part = static_cast<std::uint32_t>(outlines.size());
        std::vector<std::uint32_t> stack {seed};
        partOf[seed] = part;
        outlines.push_back({labelAt(seed), {}});
        while (!stack.empty()) {
            const std::uint32_t triangle = stack.back();
            stack.pop_back();
            for (std::uint32_t i = 0; i < 3; ++i) {
                const std::uint32_t next =
                    Topology::triangleOf(t.twin(Topology::halfEdge(triangle, i)));
                if (partOf[next] == kNoPart && labelAt(next) == labelAt(seed)) {
                    partOf[next] = part;
                    stack.push_back(next);
                }
            }
        }
    }
    const Polygons polygons = partOutlines(t, partOf, outlines.size());
    EXPECT_EQ(polygons.size(), outlines.size());
    for (std::size_t p = 0; p < polygons.size(); ++p) {
        for (std::size_t i = 0; i < polygons.loopCount(p); ++i) {
            const auto loop = polygons.loop(p, i);
            outlines[p].loops.emplace_back(loop.begin(), loop.end());
        }
    }
    return outlines;
}

std::vector<std::uint32_t> oneLabelForInside(const RegionMap& map)
{
    std::vector<std::uint32_t> labels;
    for (const Region& region : map.regions) {
        labels.push_back(region.inside ? 0 : kNoLabel);
    }
    return labels;
}

std::vector<std::uint32_t> aLabelForEachInside(const RegionMap& map)
{
    std::vector<std::uint32_t> labels;
    for (std::uint32_t r = 0; r < map.regions.size(); ++r) {
        labels.push_back(map.regions[r].inside ? r : kNoLabel);
    }
    return labels;
}

Ring positions(const Colored& colored, const std::vector<std::uint32_t>& loop)
{
    Ring ring;
    for (const std::uint32_t v : loop) {
        ring.push_back(colored.recovered.triangulation.points[v]);
    }
    return ring;
}

double areaOf(const Colored& colored, const RegionOutline& outline)
{
    double sum = 0.0;
    for (const auto& loop : outline.loops) {
        sum += shoelace(positions(colored, loop));
    }
    return sum;
}

/// The rules of OGC Simple Features for a polygon, checked from scratch. That rings do not cross is
/// given, since they consist of mesh edges used once.
void expectValidPolygon(const Colored& colored, const RegionOutline& outline)
{
    ASSERT_FALSE(outline.loops.empty());
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    // Rings and the vertices where they touch form a graph without cycles, or the inside would fall
    // apart; each ring passes a vertex once.
    std::map<std::uint32_t, std::size_t> ringsAtVertex;
    for (std::size_t i = 0; i < outline.loops.size(); ++i) {
        const auto& loop = outline.loops[i];
        ASSERT_GE(loop.size(), 3U);
        const std::set<std::uint32_t> distinct(loop.begin(), loop.end());
        EXPECT_EQ(distinct.size(), loop.size());
        const double area = shoelace(positions(colored, loop));
        EXPECT_TRUE(i == 0 ? area > 0.0 : area < 0.0);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::uint32_t a = loop[k];
            const std::uint32_t b = loop[(k + 1) % loop.size()];
            EXPECT_TRUE(edges.emplace(std::min(a, b), std::max(a, b)).second);
            EXPECT_NE(colored.recovered.triangulation.findEdge(a, b), Topology::kDead);
        }
        for (const std::uint32_t v : distinct) {
            ++ringsAtVertex[v];
        }
    }
    // A forest of rings and touching vertices: incidences <= rings + touching vertices - 1.
    std::size_t touching = 0;
    std::size_t incidences = 0;
    for (const auto& [vertex, rings] : ringsAtVertex) {
        touching += rings > 1 ? 1 : 0;
        incidences += rings > 1 ? rings : 0;
    }
    EXPECT_LT(incidences, outline.loops.size() + touching);
    const Ring outer = positions(colored, outline.loops[0]);
    for (std::size_t i = 1; i < outline.loops.size(); ++i) {
        const Ring hole = positions(colored, outline.loops[i]);
        const bool within = std::any_of(hole.begin(), hole.end(), [&outer](Vec2 p) {
            return windingAround(outer, p) == 1
                || std::find(outer.begin(), outer.end(), p) != outer.end();
        });
        EXPECT_TRUE(within);
    }
}

TEST(RegionOutlines, ASquareWithTwoHoles)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 9, 9));
    addRing(network, rectangle(1, 1, 4, 4));
    addRing(network, rectangle(5, 5, 8, 8));
    const Colored colored = color(network, FillRule::EvenOdd);
    const auto outlines =
        regionOutlines(colored.recovered, colored.map, oneLabelForInside(colored.map));
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].loops.size(), 3U);
    EXPECT_DOUBLE_EQ(areaOf(colored, outlines[0]), 63.0);
    expectValidPolygon(colored, outlines[0]);
}

TEST(RegionOutlines, AHoleThatTouchesItsOutlineStaysARingOfItsOwn)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    addRing(network, {{0, 0}, {2, 1}, {1, 2}});
    const Colored colored = color(network, FillRule::EvenOdd);
    const auto outlines =
        regionOutlines(colored.recovered, colored.map, oneLabelForInside(colored.map));
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].loops.size(), 2U);
    expectValidPolygon(colored, outlines[0]);
}

TEST(RegionOutlines, TwoTouchesCutTheInsideIntoTwoPolygons)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    addRing(network, {{0, 0}, {2, 1}, {4, 4}, {1, 2}});
    const Colored colored = color(network, FillRule::EvenOdd);
    const auto outlines =
        regionOutlines(colored.recovered, colored.map, oneLabelForInside(colored.map));
    ASSERT_EQ(outlines.size(), 2U);
    for (const RegionOutline& outline : outlines) {
        EXPECT_EQ(outline.loops.size(), 1U);
        expectValidPolygon(colored, outline);
    }
}

TEST(RegionOutlines, SquaresThatShareACornerAreTwoPolygons)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 1, 1));
    addRing(network, rectangle(1, 1, 2, 2));
    const Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_EQ(
        regionOutlines(colored.recovered, colored.map, oneLabelForInside(colored.map)).size(), 2U);
}

TEST(RegionOutlines, OneLabelMergesRegionsOfDifferentOperands)
{
    CurveNetwork network = emptyNetwork(2);
    addRing(network, rectangle(0, 0, 2, 2), 0);
    addRing(network, rectangle(1, 1, 3, 3), 1);
    const Colored colored = color(network, FillRule::EvenOdd);
    const auto merged =
        regionOutlines(colored.recovered, colored.map, oneLabelForInside(colored.map));
    ASSERT_EQ(merged.size(), 1U);
    EXPECT_DOUBLE_EQ(areaOf(colored, merged[0]), 7.0);
    const auto cells =
        regionOutlines(colored.recovered, colored.map, aLabelForEachInside(colored.map));
    ASSERT_EQ(cells.size(), 3U);
    for (const RegionOutline& cell : cells) {
        EXPECT_DOUBLE_EQ(areaOf(colored, cell), colored.map.regions[cell.label].area);
    }
}

TEST(RegionOutlines, RandomCrossingRingsGiveValidPolygonsOfTheRightArea)
{
    std::mt19937 random(21);
    for (int round = 0; round < 300; ++round) {
        const std::size_t operands = 1 + random() % 3;
        CurveNetwork network = emptyNetwork(operands);
        for (std::uint32_t o = 0; o < operands; ++o) {
            for (std::size_t i = 0; i < 1 + random() % 3; ++i) {
                Ring ring(3 + random() % 12);
                for (Vec2& p : ring) {
                    p = {static_cast<double>(random() % 9), static_cast<double>(random() % 9)};
                }
                addRing(network, ring, o);
            }
        }
        const Colored colored = color(network, FillRule::EvenOdd);
        for (const auto& labels :
             {oneLabelForInside(colored.map), aLabelForEachInside(colored.map)}) {
            const auto outlines = regionOutlines(colored.recovered, colored.map, labels);
            double sum = 0.0;
            for (const RegionOutline& outline : outlines) {
                expectValidPolygon(colored, outline);
                sum += areaOf(colored, outline);
            }
            EXPECT_NEAR(sum, colored.areaInside(), 1e-9);
        }
        const auto cells =
            regionOutlines(colored.recovered, colored.map, aLabelForEachInside(colored.map));
        EXPECT_EQ(cells.size(), colored.map.keptRegions);
    }
}

TEST(RegionOutlines, NothingSelected)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 1, 1));
    const Colored colored = color(network, FillRule::EvenOdd);
    const std::vector<std::uint32_t> none(colored.map.regions.size(), kNoLabel);
    EXPECT_TRUE(regionOutlines(colored.recovered, colored.map, none).empty());
    const Colored empty = color(emptyNetwork(1), FillRule::EvenOdd);
    EXPECT_TRUE(
        regionOutlines(empty.recovered, empty.map, std::vector<std::uint32_t> {kNoLabel}).empty());
}

} // namespace
} // namespace tessera
