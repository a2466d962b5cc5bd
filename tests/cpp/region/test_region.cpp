// SPDX-License-Identifier: MIT
#include "curve/arc.h"
#include "curve/default_roles.h"
#include "region/colored.h"
#include "region/fill_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

constexpr FillRule kWindingRules[] = {FillRule::EvenOdd, FillRule::NonZero, FillRule::Positive,
                                      FillRule::Negative};

TEST(PaperRules, Rule1AndRule2)
{
    EXPECT_TRUE(rule1Outer(false));
    EXPECT_FALSE(rule1Outer(true));
    EXPECT_TRUE(rule2Outer(true));
    EXPECT_FALSE(rule2Outer(false));
    EXPECT_FALSE(outerAcross(true, 1));
    EXPECT_TRUE(outerAcross(true, 2));
    EXPECT_FALSE(outerAcross(true, 3));
    EXPECT_TRUE(outerAcross(true, 0));
}

TEST(PaperRules, FillRulesOfWindingNumbers)
{
    for (int w = -3; w <= 3; ++w) {
        EXPECT_EQ(isInside(FillRule::EvenOdd, w), w % 2 != 0);
        EXPECT_EQ(isInside(FillRule::NonZero, w), w != 0);
        EXPECT_EQ(isInside(FillRule::Positive, w), w > 0);
        EXPECT_EQ(isInside(FillRule::Negative, w), w < 0);
        EXPECT_EQ(isInside(FillRule::All, w), w != 0);
    }
}

TEST(OuterSeeds, AreTheGhostTrianglesOfTheHull)
{
    Execution execution;
    const std::vector<Vec2> points {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
    const DelaunayResult result = triangulate(points, execution);
    const auto seeds = outerSeeds(result.triangulation);
    EXPECT_EQ(seeds.size(), 4U);
    for (const std::uint32_t t : seeds) {
        EXPECT_TRUE(result.triangulation.isGhost(t));
    }
    EXPECT_TRUE(outerSeeds(Triangulation {}).empty());
}

/// The paper's flood fill, literally: from the outer seeds over the edges of triangles, rule 1
/// across boundary borders, rule 2 across all others.
std::vector<int> paperFloodFill(const Triangulation& t, const std::vector<bool>& isBoundaryEdge)
{
    std::vector<int> outer(t.triangles.size(), -1);
    std::vector<std::uint32_t> stack;
    for (const std::uint32_t seed : outerSeeds(t)) {
        outer[seed] = 1;
        stack.push_back(seed);
    }
    while (!stack.empty()) {
        const std::uint32_t triangle = stack.back();
        stack.pop_back();
        for (std::uint32_t i = 0; i < 3; ++i) {
            const HalfEdge h = Topology::halfEdge(triangle, i);
            const std::uint32_t next = Topology::triangleOf(t.twin(h));
            const bool here = outer[triangle] == 1;
            const bool there = isBoundaryEdge[h] ? rule1Outer(here) : rule2Outer(here);
            if (outer[next] == -1) {
                outer[next] = there ? 1 : 0;
                stack.push_back(next);
            }
            EXPECT_EQ(outer[next] == 1, there);
        }
    }
    return outer;
}

Ring randomRing(std::mt19937& random, std::size_t corners)
{
    std::uniform_real_distribution<double> uniform(0.0, 10.0);
    Ring ring(corners);
    for (Vec2& p : ring) {
        p = {uniform(random), uniform(random)};
    }
    return ring;
}

Ring randomGridRing(std::mt19937& random, std::size_t corners)
{
    Ring ring(corners);
    for (Vec2& p : ring) {
        p = {static_cast<double>(random() % 6), static_cast<double>(random() % 6)};
    }
    return ring;
}

TEST(ColorRegions, AgreesWithThePapersFloodFillOnCrossingRings)
{
    std::mt19937 random(12);
    for (int round = 0; round < 60; ++round) {
        CurveNetwork network = emptyNetwork(1);
        for (std::size_t i = 0; i < 1 + random() % 3; ++i) {
            addRing(network, randomRing(random, 3 + random() % 8));
        }
        const Colored colored = color(network, FillRule::EvenOdd);
        const Triangulation& t = colored.recovered.triangulation;
        std::vector<bool> isBoundaryEdge(4 * t.triangles.size(), false);
        for (const Subsegment& s : colored.recovered.constraints.subsegments) {
            const HalfEdge h = t.findEdge(s.a, s.b);
            isBoundaryEdge[h] = isBoundaryEdge[t.twin(h)] = true;
        }
        const std::vector<int> outer = paperFloodFill(t, isBoundaryEdge);
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            const RegionId region = colored.map.regionOfTriangle[i];
            EXPECT_EQ(region.valid(), t.isFinite(i));
            if (region.valid()) {
                EXPECT_EQ(colored.map.regions[region.index()].inside, outer[i] == 0);
            }
        }
    }
}

/// Every triangle's operands against winding numbers of the rings around its centroid.
void expectCoverMatchesRings(const Colored& colored, const std::vector<std::vector<Ring>>& rings,
                             FillRule fill, double least)
{
    const Triangulation& t = colored.recovered.triangulation;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (!t.isFinite(i)) {
            continue;
        }
        const auto& v = t.triangles[i].v;
        const Vec2 a = t.points[v[0]];
        const Vec2 b = t.points[v[1]];
        const Vec2 c = t.points[v[2]];
        if (cross(b - a, c - a) < least) {
            continue; // thinner than the rounding of its crossings
        }
        const Vec2 center = (1.0 / 3.0) * (a + b + c);
        std::vector<OperandId> expected;
        for (std::size_t o = 0; o < rings.size(); ++o) {
            int winding = 0;
            for (const Ring& ring : rings[o]) {
                winding += windingAround(ring, center);
            }
            if (isInside(fill, winding)) {
                expected.emplace_back(o);
            }
        }
        const Region& region = colored.map.regions[colored.map.regionOfTriangle[i].index()];
        EXPECT_EQ(region.operands, expected);
        EXPECT_EQ(region.inside, !expected.empty());
    }
}

TEST(ColorRegions, WindingNumbersOfManyOperandsAgreeWithRayCounting)
{
    std::mt19937 random(13);
    for (int round = 0; round < 80; ++round) {
        const bool onGrid = round % 2 == 0;
        std::vector<std::vector<Ring>> rings(1 + random() % 4);
        CurveNetwork network = emptyNetwork(rings.size());
        for (std::uint32_t o = 0; o < rings.size(); ++o) {
            for (std::size_t i = 0; i < 1 + random() % 3; ++i) {
                const std::size_t corners = 3 + random() % 9;
                rings[o].push_back(onGrid ? randomGridRing(random, corners)
                                          : randomRing(random, corners));
                addRing(network, rings[o].back(), o);
            }
        }
        Colored colored = color(network, FillRule::EvenOdd);
        for (const FillRule fill : kWindingRules) {
            recolor(colored, fill);
            expectCoverMatchesRings(colored, rings, fill, 1e-9);
        }
    }
}

TEST(ColorRegions, RegionsAreConnectedAndSeparatedByWhatIsMarked)
{
    std::mt19937 random(14);
    for (int round = 0; round < 30; ++round) {
        CurveNetwork network = emptyNetwork(3);
        for (std::uint32_t o = 0; o < 3; ++o) {
            addRing(network, randomGridRing(random, 7), o);
        }
        const Colored colored = color(network, FillRule::EvenOdd);
        const Triangulation& t = colored.recovered.triangulation;
        const auto& subsegments = colored.recovered.constraints.subsegments;
        std::vector<std::uint8_t> isMarked(4 * t.triangles.size(), 0);
        for (std::size_t s = 0; s < subsegments.size(); ++s) {
            const HalfEdge h = t.findEdge(subsegments[s].a, subsegments[s].b);
            isMarked[h] = isMarked[t.twin(h)] = colored.map.isBoundary[s];
        }
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            for (std::uint32_t side = 0; t.isFinite(i) && side < 3; ++side) {
                const HalfEdge h = Topology::halfEdge(i, side);
                const std::uint32_t next = Topology::triangleOf(t.twin(h));
                if (t.isFinite(next)) {
                    EXPECT_EQ(isMarked[h] == 0, colored.map.regionOfTriangle[i]
                                                    == colored.map.regionOfTriangle[next]);
                }
                else if (isMarked[h] == 0) {
                    EXPECT_EQ(colored.map.regionOfTriangle[i], RegionId(0U));
                }
            }
        }
    }
}

TEST(ColorRegions, BoundaryDrawnTwiceCancelsWithinAnOperandOnly)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 1, 1));
    addRing(network, rectangle(1, 0, 2, 1));
    Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 2.0);
    EXPECT_EQ(colored.map.keptRegions, 1U);
    addRing(network, rectangle(0, 0, 1, 1));
    colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 1.0);
    recolor(colored, FillRule::NonZero);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 2.0);

    CurveNetwork two = emptyNetwork(2);
    addRing(two, rectangle(0, 0, 1, 1), 0);
    addRing(two, rectangle(0, 0, 1, 1), 1);
    colored = color(two, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 1.0);
    EXPECT_EQ(colored.map.keptRegions, 1U);
    EXPECT_EQ(colored.map.regions[1].operands.size(), 2U);
}

TEST(ColorRegions, NestedLoopsAndWhatIsToldAboutThem)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 9, 9));
    addRing(network, rectangle(1, 1, 4, 4));
    addRing(network, rectangle(5, 5, 8, 8));
    addRing(network, rectangle(2, 2, 3, 3));
    Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 81 - 9 - 9 + 1);
    EXPECT_EQ(colored.map.keptRegions, 2U);
    EXPECT_EQ(colored.map.loopsMadeHoles, 2U);
    ASSERT_EQ(colored.map.messages.size(), 1U);
    EXPECT_EQ(colored.map.messages[0],
              "2 loops inside others became holes; the fill rule 'all' keeps them.");
    recolor(colored, FillRule::All);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 81.0);
    EXPECT_EQ(colored.map.keptRegions, 4U);
    EXPECT_EQ(colored.map.loopsMadeHoles, 0U);

    network.holes.push_back({{1.5, 1.5}, OperandId(0U)});
    EXPECT_EQ(color(network, FillRule::EvenOdd).map.loopsMadeHoles, 1U);
    network.operands[0].declaresHoles = true;
    EXPECT_EQ(color(network, FillRule::EvenOdd).map.loopsMadeHoles, 0U);
}

TEST(ColorRegions, OverlappingLoopsMakeOneHole)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 2, 2));
    addRing(network, rectangle(1, 1, 3, 3));
    const Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 6.0);
    EXPECT_EQ(colored.map.loopsMadeHoles, 1U);
    EXPECT_EQ(color(network, FillRule::NonZero).areaInside(), 7.0);
}

TEST(ColorRegions, SketchEdgesInAnyDirectionAreTurnedHeadToTail)
{
    // Two nested squares; every edge of the drawing may run either way.
    std::mt19937 random(15);
    for (int round = 0; round < 20; ++round) {
        CurveNetwork network = emptyNetwork(1);
        addRing(network, rectangle(0, 0, 4, 4));
        addRing(network, rectangle(1, 1, 2, 2));
        for (NetworkCurve& curve : network.curves) {
            if (random() % 2 == 0) {
                std::swap(curve.start, curve.end);
            }
        }
        EXPECT_DOUBLE_EQ(color(network, FillRule::EvenOdd).areaInside(), 15.0);
        const double nonZero = color(network, FillRule::NonZero).areaInside();
        const double positive = color(network, FillRule::Positive).areaInside();
        const double negative = color(network, FillRule::Negative).areaInside();
        // The two loops run alike (16) or against each other (15); the other sign finds nothing.
        EXPECT_TRUE(nonZero == 16.0 || nonZero == 15.0);
        EXPECT_EQ(nonZero, std::max(positive, negative));
        EXPECT_EQ(0.0, std::min(positive, negative));
    }
}

TEST(ColorRegions, ConsistentDirectionsAreLeftAlone)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 4, 4));
    addRing(network, reversed(rectangle(1, 1, 2, 2)));
    EXPECT_DOUBLE_EQ(color(network, FillRule::NonZero).areaInside(), 15.0);
    EXPECT_DOUBLE_EQ(color(network, FillRule::Positive).areaInside(), 15.0);
    EXPECT_DOUBLE_EQ(color(network, FillRule::Negative).areaInside(), 0.0);
}

TEST(ColorRegions, ConstraintsDoNotSeparateUnlessAllIsAsked)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 4, 4));
    addRing(network, rectangle(1, 1, 2, 2), 0, Role::Constraint);
    const Ring diagonal {{-1, -1}, {5, 5}};
    addPolyline(network, diagonal, false, OperandId(0U), Role::Constraint);
    Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_EQ(colored.map.keptRegions, 1U);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 16.0);
    recolor(colored, FillRule::All);
    EXPECT_EQ(colored.map.keptRegions, 4U);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 16.0);
}

TEST(ColorRegions, HullTakesEverything)
{
    CurveNetwork network = emptyNetwork(1);
    for (const Vec2 p : {Vec2 {0, 0}, Vec2 {4, 0}, Vec2 {4, 4}, Vec2 {0, 4}, Vec2 {1, 2}}) {
        network.embedded.push_back({network.addPoint(p), OperandId(0U), ""});
    }
    Colored colored = color(network, FillRule::Hull);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 16.0);
    EXPECT_EQ(colored.map.keptRegions, 1U);
    EXPECT_EQ(colored.map.regions[1].operands, std::vector<OperandId> {OperandId(0U)});
    addRing(network, rectangle(2, 2, 3, 3));
    colored = color(network, FillRule::Hull);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 16.0);
    EXPECT_EQ(colored.map.keptRegions, 2U);
    recolor(colored, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 1.0);
}

TEST(ColorRegions, RegionsAreNumberedByTheirLeastCorner)
{
    // Three triangles around (0, 0), from below counter-clockwise, and two squares further on, in
    // every order.
    std::vector<Ring> rings {{{0, 0}, {0, -4}, {2, -3}},
                             {{0, 0}, {2, -1}, {2, 1}},
                             {{0, 0}, {3, 3}, {0, 5}},
                             rectangle(5, -2, 6, -1),
                             rectangle(5, 0, 7, 2)};
    const std::vector<double> areas {4.0, 2.0, 7.5, 1.0, 4.0};
    std::vector<std::size_t> order {0, 1, 2, 3, 4};
    do {
        CurveNetwork network = emptyNetwork(1);
        for (const std::size_t i : order) {
            addRing(network, rings[i]);
        }
        const Colored colored = color(network, FillRule::EvenOdd);
        ASSERT_EQ(colored.map.regions.size(), 6U);
        for (std::size_t r = 0; r < areas.size(); ++r) {
            EXPECT_DOUBLE_EQ(colored.map.regions[r + 1].area, areas[r]);
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(ColorRegions, OutlineOfAComponentIsItsOuterContour)
{
    // A square with a cross inside, a tail outside and an island not joined to it.
    CurveNetwork network = emptyNetwork(1);
    const std::vector<std::pair<Vec2, Vec2>> lines {
        {{0, 0}, {2, 0}}, {{2, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {2, 4}}, {{2, 4}, {0, 4}},
        {{0, 4}, {0, 0}}, {{2, 0}, {2, 4}}, {{4, 4}, {6, 6}}, {{1, 1}, {1.5, 1}},
        {{1.5, 1}, {1, 1.5}}, {{1, 1.5}, {1, 1}}};
    const auto pointAt = [&network](Vec2 p) {
        const auto found = std::find(network.points.begin(), network.points.end(), p);
        return found == network.points.end()
            ? network.addPoint(p)
            : PointId(static_cast<std::size_t>(found - network.points.begin()));
    };
    for (const auto& [a, b] : lines) {
        const PointId start = pointAt(a);
        const PointId end = pointAt(b);
        network.curves.push_back({nullptr, start, end, OperandId(0U)});
    }
    assignPolyRoles(network, OperandId(0U));
    EXPECT_EQ(network.curves[6].role, Role::Outline);
    EXPECT_EQ(network.curves[7].role, Role::Constraint);
    EXPECT_EQ(network.curves[8].role, Role::Boundary);
    const Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 16.0 - 0.125);
    EXPECT_EQ(colored.map.keptRegions, 1U);
    for (const FillRule fill : {FillRule::NonZero, FillRule::Positive}) {
        EXPECT_DOUBLE_EQ(color(network, fill).areaInside(), 16.0);
    }
}

TEST(ColorRegions, OutlineWithABridgeLeavesTheBridgeOut)
{
    // Two squares joined by a bar, all in one component with odd degrees.
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 1, 1), 0, Role::Outline);
    addRing(network, rectangle(3, 0, 4, 1), 0, Role::Outline);
    network.curves.push_back({nullptr, PointId(1U), PointId(4U), OperandId(0U), Role::Outline});
    const Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 2.0);
    EXPECT_EQ(colored.map.keptRegions, 2U);
}

TEST(ColorRegions, OutlinesOfDifferentComponentsStayApart)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 2, 2), 0, Role::Outline);
    addRing(network, rectangle(1, 1, 3, 3), 0, Role::Outline);
    EXPECT_DOUBLE_EQ(color(network, FillRule::EvenOdd).areaInside(), 7.0);
    for (std::size_t c = 4; c < 8; ++c) {
        network.curves[c].component = 1;
    }
    EXPECT_DOUBLE_EQ(color(network, FillRule::EvenOdd).areaInside(), 6.0);
}

TEST(ColorRegions, ABoundaryThatDoesNotCloseIsReadLikeAPoly)
{
    CurveNetwork network = emptyNetwork(1);
    network.operands[0].name = "plate";
    addRing(network, rectangle(0, 0, 4, 4));
    const Ring open {{1, 1}, {7, 1}};
    addPolyline(network, open, false, OperandId(0U), Role::Boundary);
    network.curves.push_back({nullptr, PointId(0U), PointId(2U), OperandId(0U)});
    const Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 16.0);
    EXPECT_EQ(colored.map.keptRegions, 1U);
    ASSERT_EQ(colored.map.messages.size(), 1U);
    EXPECT_NE(colored.map.messages[0].find("plate"), std::string::npos);
    EXPECT_DOUBLE_EQ(color(network, FillRule::NonZero).areaInside(), 16.0);
    EXPECT_DOUBLE_EQ(color(network, FillRule::Negative).areaInside(), 16.0);
}

TEST(ColorRegions, AllCoversEveryBoundedFaceOfEachOperand)
{
    std::mt19937 random(16);
    for (int round = 0; round < 40; ++round) {
        // Open polylines that cross themselves: what they enclose is inside.
        CurveNetwork network = emptyNetwork(2);
        std::vector<Ring> lines;
        for (std::uint32_t o = 0; o < 2; ++o) {
            lines.push_back(randomRing(random, 8));
            addPolyline(network, lines.back(), false, OperandId(o), Role::Constraint);
        }
        const Colored both = color(network, FillRule::All);
        for (std::uint32_t o = 0; o < 2; ++o) {
            CurveNetwork alone = emptyNetwork(1);
            addPolyline(alone, lines[o], false, OperandId(0U), Role::Boundary);
            const Colored one = color(alone, FillRule::All);
            EXPECT_NEAR(both.areaOf(OperandId(o)), one.areaInside(), 1e-9);
            // Euler: faces = edges - vertices + components, here without the unbounded one.
            const auto& map = one.recovered.constraints;
            EXPECT_EQ(one.map.keptRegions,
                      map.subsegments.size() - (one.recovered.triangulation.vertexCount()) + 1);
        }
    }
}

TEST(HolePoints, RemoveTheFaceAroundThemFromTheirOperand)
{
    CurveNetwork network = emptyNetwork(2);
    addRing(network, rectangle(0, 0, 4, 4), 0);
    addRing(network, rectangle(1, 1, 3, 3), 0, Role::Constraint);
    addRing(network, rectangle(2, -1, 5, 5), 1);
    network.holes.push_back({{1.5, 1.5}, OperandId(0U)});
    const Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaOf(OperandId(0U)), 12.0);
    EXPECT_DOUBLE_EQ(colored.areaOf(OperandId(1U)), 18.0);
    EXPECT_TRUE(colored.map.messages.empty());
    EXPECT_DOUBLE_EQ(color(network, FillRule::All).areaOf(OperandId(0U)), 16.0);
}

TEST(HolePoints, OnACurveAreToldAndDoNothing)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 4, 4));
    network.holes.push_back({{2, 0}, OperandId(0U)});
    network.holes.push_back({{4, 4}, OperandId(0U)});
    network.holes.push_back({{9, 9}, OperandId(0U)});
    const Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_DOUBLE_EQ(colored.areaInside(), 16.0);
    ASSERT_EQ(colored.map.messages.size(), 2U);
    EXPECT_NE(colored.map.messages[0].find("(2, 0)"), std::string::npos);
}

TEST(HolePoints, ExactlyOnAnInnerEdgeOrVertexOfTheMeshTheyWork)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 4, 4));
    network.embedded.push_back({network.addPoint({1, 2}), OperandId(0U), ""});
    network.holes.push_back({{2, 2}, OperandId(0U)});
    EXPECT_DOUBLE_EQ(color(network, FillRule::EvenOdd).areaInside(), 0.0);
    network.holes[0].position = {1, 2};
    EXPECT_DOUBLE_EQ(color(network, FillRule::EvenOdd).areaInside(), 0.0);
}

TEST(RegionPoints, GiveFacesTheirAttributeAndSeparateThem)
{
    CurveNetwork network = emptyNetwork(1);
    addRing(network, rectangle(0, 0, 4, 4));
    const Ring middle {{1, 0}, {1, 4}};
    addPolyline(network, middle, false, OperandId(0U), Role::Constraint);
    Colored colored = color(network, FillRule::EvenOdd);
    EXPECT_EQ(colored.map.keptRegions, 1U);
    network.regions.push_back({{0.5, 1}, OperandId(0U), 7.0, 0.1});
    network.regions.push_back({{3, 1}, OperandId(0U), 8.0, 0.2});
    network.regions.push_back({{3, 2}, OperandId(0U), 9.0, 0.3});
    network.regions.push_back({{9, 9}, OperandId(0U), 9.0, 0.3});
    colored = color(network, FillRule::EvenOdd);
    EXPECT_EQ(colored.map.keptRegions, 2U);
    EXPECT_EQ(colored.map.messages.size(), 1U);
    for (const Region& region : colored.map.regions) {
        if (region.inside) {
            EXPECT_DOUBLE_EQ(region.area, region.attribute == 7.0 ? 4.0 : 12.0);
            EXPECT_EQ(region.maxArea, region.attribute == 7.0 ? 0.1 : 0.2);
        }
    }
}

TEST(ColorRegions, CurvedBoundariesColorTheirChords)
{
    CurveNetwork network = emptyNetwork(1);
    const PointId p = network.addPoint({2, 0});
    const double turn = 2 * std::numbers::pi;
    network.curves.push_back({makeCircleArc({0, 0}, 2, 0, turn), p, p, OperandId(0U)});
    const Colored colored = color(network, FillRule::EvenOdd, 0.01);
    EXPECT_NEAR(colored.areaInside(), 4 * std::numbers::pi, 1e-4);
}

TEST(ColorRegions, NothingAndAlmostNothing)
{
    for (const FillRule fill : {FillRule::EvenOdd, FillRule::NonZero, FillRule::Positive,
                                FillRule::Negative, FillRule::All, FillRule::Hull}) {
        CurveNetwork network = emptyNetwork(1);
        Colored colored = color(network, fill);
        EXPECT_EQ(colored.map.keptRegions, 0U);
        EXPECT_EQ(colored.map.regions.size(), 1U);
        const Ring flat {{0, 0}, {1, 1}, {3, 3}};
        addRing(network, flat);
        network.holes.push_back({{1, 0}, OperandId(0U)});
        network.regions.push_back({{1, 0}, OperandId(0U)});
        colored = color(network, fill);
        EXPECT_EQ(colored.map.keptRegions, 0U);
        EXPECT_EQ(colored.map.isBoundary,
                  std::vector<std::uint8_t>(colored.recovered.constraints.subsegments.size(), 0));
    }
}

TEST(ColorRegions, TenThousandOperands)
{
    const int side = 100;
    CurveNetwork network = emptyNetwork(side * side);
    for (int i = 0; i < side * side; ++i) {
        const double x = i % side;
        const double y = static_cast<double>(i / side);
        addRing(network, rectangle(x, y, x + 1.5, y + 1.5), static_cast<std::uint32_t>(i));
    }
    Colored colored = color(network, FillRule::EvenOdd);
    const auto begin = std::clock();
    recolor(colored, FillRule::NonZero);
    std::printf("10,000 operands, %zu regions: %.3f s\n", colored.map.keptRegions,
                static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    double sum = 0.0;
    for (const Region& region : colored.map.regions) {
        sum += region.area * static_cast<double>(region.operands.size());
    }
    EXPECT_NEAR(sum, 10000 * 2.25, 1e-9);
    EXPECT_NEAR(colored.areaInside(), 100.5 * 100.5, 1e-9);
}

} // namespace
} // namespace tessera
