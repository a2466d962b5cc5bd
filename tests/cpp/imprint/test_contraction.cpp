// SPDX-License-Identifier: MIT

// Overlays without triangles, of which coherent chains are contracted, against the same overlays
// with all their points triangulated.

#include "imprint/contraction.h"
#include "imprint/overlay.h"
#include "recover/constraint_map.h"
#include "region/colored.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

constexpr BooleanOperation kOperations[] = {
    BooleanOperation::Union, BooleanOperation::Intersection, BooleanOperation::Difference,
    BooleanOperation::SymmetricDifference, BooleanOperation::Cells};
constexpr FillRule kRules[] = {FillRule::EvenOdd, FillRule::NonZero, FillRule::Positive,
                               FillRule::Negative, FillRule::All};

/// Loops of a polygon by position, each from its least corner on, the outer one first.
std::vector<Ring> ringsOf(const OverlayResult& result, std::size_t polygon)
{
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < result.polygons.loopCount(polygon); ++i) {
        Ring ring;
        for (const std::uint32_t v : result.polygons.loop(polygon, i)) {
            ring.push_back(result.point(v));
        }
        const auto less = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
        std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), less), ring.end());
        rings.push_back(ring);
    }
    return rings;
}

bool ringLess(const Ring& a, const Ring& b)
{
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [](Vec2 p, Vec2 q) {
                                            return p.x != q.x ? p.x < q.x : p.y < q.y;
                                        });
}

/// Everything that polygons, report and provenance say, in an order that no triangle decides.
struct Part
{
    std::vector<Ring> rings;
    std::vector<std::vector<CurveId>> curves; ///< of the outer ring's edges
    std::vector<VertexOrigin> origins;        ///< of its corners
    double area;
    std::vector<OperandId> operands;
    OperandId owner;
};

std::vector<Part> partsOf(const OverlayResult& result)
{
    std::vector<Part> parts;
    for (std::size_t p = 0; p < result.polygons.size(); ++p) {
        Part part {ringsOf(result, p), {}, {}, result.parts.parts[p].area, {},
                   result.parts.parts[p].owner};
        std::sort(part.rings.begin() + 1, part.rings.end(), ringLess);
        const auto loop = result.polygons.loop(p, 0);
        const auto first = std::find_if(loop.begin(), loop.end(), [&](std::uint32_t v) {
                               return result.point(v) == part.rings[0][0];
                           })
            - loop.begin();
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::uint32_t a = loop[(static_cast<std::size_t>(first) + k) % loop.size()];
            const std::uint32_t b = loop[(static_cast<std::size_t>(first) + k + 1) % loop.size()];
            part.curves.push_back(result.curvesOn(a, b));
            part.origins.push_back(result.origin[a]);
        }
        if (result.parts.parts[p].operands != OperandSets::kEmpty) {
            result.parts.sets.forEach(result.parts.parts[p].operands,
                                      [&](OperandId o) { part.operands.push_back(o); });
        }
        parts.push_back(part);
    }
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
        return ringLess(a.rings[0], b.rings[0]);
    });
    return parts;
}

void expectSameReport(const OverlayReport& found, const OverlayReport& expected)
{
    EXPECT_EQ(found.recovery.crossings, expected.recovery.crossings);
    EXPECT_EQ(found.recovery.touches, expected.recovery.touches);
    EXPECT_EQ(found.recovery.overlaps, expected.recovery.overlaps);
    EXPECT_EQ(found.recovery.maxDisplacement, expected.recovery.maxDisplacement);
    EXPECT_EQ(found.messages, expected.messages);
    EXPECT_NEAR(found.area, expected.area, 1e-12 * expected.area);
    ASSERT_EQ(found.theta.has_value(), expected.theta.has_value());
    if (found.theta) {
        const double scale = 1e-12 * (expected.theta->o + expected.theta->t + expected.theta->s);
        EXPECT_NEAR(found.theta->o, expected.theta->o, scale);
        EXPECT_NEAR(found.theta->t, expected.theta->t, scale);
        EXPECT_NEAR(found.theta->s, expected.theta->s, scale);
    }
}

/// Every step of every constraint's chain is a subsegment that knows the constraint.
void expectSoundMap(const OverlayResult& result)
{
    const ConstraintMap& map = result.recovered.constraints;
    ASSERT_EQ(map.chainStart.size(), result.pslg.segments.size() + 1);
    std::size_t steps = 0;
    for (std::uint32_t c = 0; c < result.pslg.segments.size(); ++c) {
        const auto chain = map.chainOf(ConstraintId(c));
        if (result.report.recovery.snapPixel == 0.0) {
            const PslgSegment& segment = result.pslg.segments[c];
            EXPECT_EQ(result.point(chain.front()), result.pslg.points[segment.a.index()]);
            EXPECT_EQ(result.point(chain.back()), result.pslg.points[segment.b.index()]);
        }
        for (std::size_t i = 1; i < chain.size(); ++i, ++steps) {
            const Subsegment* s = findSubsegment(map, chain[i - 1], chain[i]);
            ASSERT_NE(s, nullptr);
            const auto uses = map.usesOf(*s);
            EXPECT_EQ(std::count_if(uses.begin(), uses.end(), [&](const ConstraintUse& use) {
                          return use.constraint.value == c
                              && use.forward == (chain[i - 1] < chain[i]);
                      }), 1);
        }
    }
    EXPECT_EQ(steps, map.uses.size());
}

/// Whether chains were contracted.
bool compare(const CurveNetwork& network, OverlayOptions options)
{
    Execution execution;
    const OverlayResult expected = overlayNetwork(network, options, execution);
    options.form = OverlayForm::Polygons;
    const OverlayResult found = overlayNetwork(network, options, execution);
    expectSameReport(found.report, expected.report);
    const std::vector<Part> parts = partsOf(found);
    const std::vector<Part> expectedParts = partsOf(expected);
    EXPECT_EQ(parts.size(), expectedParts.size());
    for (std::size_t p = 0; p < std::min(parts.size(), expectedParts.size()); ++p) {
        EXPECT_EQ(parts[p].rings, expectedParts[p].rings);
        EXPECT_EQ(parts[p].curves, expectedParts[p].curves);
        EXPECT_EQ(parts[p].origins, expectedParts[p].origins);
        EXPECT_EQ(parts[p].operands, expectedParts[p].operands);
        EXPECT_EQ(parts[p].owner, expectedParts[p].owner);
        EXPECT_NEAR(parts[p].area, expectedParts[p].area, 1e-12 * expected.report.area);
    }
    expectSoundMap(found);
    return found.recovered.triangulation.triangles.empty();
}

/// All operations and fill rules; how many times chains were contracted.
std::size_t compareAll(const CurveNetwork& network)
{
    std::size_t contracted = 0;
    for (const FillRule rule : kRules) {
        for (const BooleanOperation operation : kOperations) {
            OverlayOptions options;
            options.operation = operation;
            options.fill = rule;
            contracted += compare(network, options) ? 1 : 0;
        }
    }
    return contracted;
}

/// A closed outline around a center whose radius waves.
Ring waves(std::size_t n, Vec2 center, double amplitude, int count, double phase)
{
    Ring ring;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double radius = 1.0 + amplitude * std::sin(count * angle + phase);
        ring.push_back(center + radius * Vec2 {std::cos(angle), std::sin(angle)});
    }
    return ring;
}

/// Every side cut into the given number of pieces.
Ring subdivided(const Ring& corners, int pieces)
{
    Ring ring;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 step = corners[(i + 1) % corners.size()] - corners[i];
        for (int k = 0; k < pieces; ++k) {
            ring.push_back(corners[i] + (double(k) / pieces) * step);
        }
    }
    return ring;
}

TEST(Contraction, SmoothOutlines)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::size_t contracted = 0;
    for (int c = 0; c < 16; ++c) {
        SCOPED_TRACE(c);
        const auto operands = static_cast<std::uint32_t>(1 + random() % 3);
        CurveNetwork network = emptyNetwork(operands);
        // Near the origin, or where doubles are coarse.
        const Vec2 away = c % 3 == 0 ? Vec2 {3e9, -1e9} : Vec2 {};
        for (std::uint32_t i = 0; i < operands + random() % 3; ++i) {
            const Vec2 center = away + Vec2 {unit(random), unit(random)};
            const Ring ring = waves(100 + random() % 900, center, 0.9 * unit(random) * unit(random),
                                    static_cast<int>(random() % 6), 6.0 * unit(random));
            addRing(network, i % 2 == 0 ? ring : reversed(ring), i % operands);
        }
        for (int i = 0; i < 3; ++i) {
            const Vec2 p = away + Vec2 {2.0 * unit(random), unit(random)};
            network.embedded.push_back({network.addPoint(p), OperandId(0U), ""});
            network.holes.push_back(
                {away + Vec2 {unit(random), 2.0 * unit(random)}, OperandId(0U)});
        }
        contracted += compareAll(network);
    }
    EXPECT_GT(contracted, 16U * 25U / 2U);
}

/// Runs along the axes and diagonals that touch, overlap and end on each other.
TEST(Contraction, OutlinesOnAGrid)
{
    std::mt19937_64 random(6);
    std::size_t contracted = 0;
    for (int c = 0; c < 32; ++c) {
        SCOPED_TRACE(c);
        CurveNetwork network = emptyNetwork(2);
        const int pieces = 16 << (random() % 3);
        for (std::uint32_t i = 0; i < 2 + random() % 3; ++i) {
            Ring corners;
            for (std::size_t k = 0; k < 3 + random() % 3; ++k) {
                corners.push_back({double(random() % 9), double(random() % 9)});
            }
            if (i % 2 == 0) {
                corners = rectangle(corners[0].x, corners[0].y, corners[1].x + 1.0,
                                    corners[1].y + 1.0);
            }
            addRing(network, subdivided(corners, pieces), i % 2);
        }
        contracted += compareAll(network);
    }
    EXPECT_GT(contracted, 80U);
}

/// A spiral comes near itself everywhere; its open relatives bound nothing.
TEST(Contraction, SpiralsAndOpenChains)
{
    Ring out;
    Ring in;
    for (int i = 0; i < 4000; ++i) {
        const double angle = 0.005 * i;
        const Vec2 direction {std::cos(angle), std::sin(angle)};
        out.push_back((1.0 + 0.1 * angle) * direction);
        in.push_back((0.8 + 0.1 * angle) * direction);
    }
    Ring spiral = out;
    spiral.insert(spiral.end(), in.rbegin(), in.rend());
    CurveNetwork network = emptyNetwork(3);
    addRing(network, spiral, 0);
    addRing(network, waves(700, {0.5, 0.1}, 0.2, 3, 0.0), 1);
    Ring line = subdivided({{-5.0, 0.25}, {5.0, 0.25}}, 80);
    line.resize(80);
    addPolyline(network, line, false, OperandId(1U), Role::Constraint);
    addPolyline(network, waves(300, {2.0, 0.3}, 0.1, 2, 1.0), false, OperandId(2U),
                Role::Boundary);
    EXPECT_EQ(compareAll(network), 25U);
}

/// Runs that part at a common end and meet again in the same quadrant, or on the line between two.
TEST(Contraction, NeighborsThatTurnBack)
{
    // Down the same side by a straight run and by one that waves around it.
    Ring straight {{10.0, -10.0}};
    Ring waving {{-10.0, 10.0}};
    for (int i = 0; i <= 400; ++i) {
        const double t = i / 40.0;
        straight.push_back({t, t});
        waving.push_back({t, t + (i == 400 ? 0.0 : 1.5 * std::sin(0.2 * std::numbers::pi * t))});
    }
    CurveNetwork network = emptyNetwork(2);
    addRing(network, straight, 0);
    addRing(network, reversed(waving), 1);
    EXPECT_EQ(compareAll(network), 25U);

    // Up to a horizontal stretch, back along a part of it, and on upwards; then mirrored at the
    // diagonal.
    Ring hook;
    for (int i = 0; i < 160; ++i) {
        hook.push_back({-16.0 + 0.1 * i, -16.0 + 0.1 * i});
    }
    for (int i = 0; i < 80; ++i) {
        hook.push_back({0.125 * i, 0.0});
    }
    for (int i = 0; i < 40; ++i) {
        hook.push_back({10.0 - 0.125 * i, 0.0});
    }
    for (int i = 0; i < 160; ++i) {
        hook.push_back({5.0 - 0.05 * i, 0.1 * i});
    }
    hook.push_back({-20.0, 0.0});
    for (const bool mirrored : {false, true}) {
        SCOPED_TRACE(mirrored);
        CurveNetwork hooked = emptyNetwork(2);
        for (Vec2& p : hook) {
            p = mirrored ? Vec2 {p.y, p.x} : p;
        }
        addRing(hooked, hook, 0);
        addRing(hooked, waves(200, {-30.0, -30.0}, 0.0, 0, 0.0), 1);
        EXPECT_EQ(compareAll(hooked), 25U);
    }
}

/// What meets the middle of a run keeps it from being one chord.
TEST(Contraction, NothingMeetsAChord)
{
    CurveNetwork network = emptyNetwork(2);
    addRing(network, waves(400, {}, 0.0, 0, 0.0), 0);
    addRing(network, {{0.5, 0.0}, {2.0, -0.5}, network.points[17], {2.0, 0.5}}, 1);
    network.holes.push_back({midpoint(network.points[60], network.points[61]), OperandId(0U)});
    const PointId alone = network.addPoint(network.points[140]);
    Pslg pslg;
    pslg.points = network.points;
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        const NetworkCurve& curve = network.curves[c];
        pslg.segments.push_back({curve.start, curve.end, CurveId(c), 0.0, 1.0});
    }
    Execution execution;
    const auto contraction = contract(pslg, network, execution);
    ASSERT_TRUE(contraction.has_value());
    EXPECT_LT(contraction->pieceCount(), 120U);
    const auto begins = [&](std::uint32_t segment) {
        return std::binary_search(contraction->firstSegment.begin(),
                                  contraction->firstSegment.end(), segment);
    };
    EXPECT_TRUE(begins(16) || begins(17));
    EXPECT_TRUE(begins(17));
    EXPECT_TRUE(begins(60) && begins(61));
    EXPECT_TRUE(begins(140));
    EXPECT_TRUE(std::count(contraction->point.begin(), contraction->point.end(), alone.value));
    EXPECT_EQ(compareAll(network), 25U);
}

/// Rough outlines and small ones are triangulated whole.
TEST(Contraction, LeavesWhatIsNotCoherent)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    CurveNetwork rough = emptyNetwork(1);
    Ring ring = waves(500, {}, 0.0, 0, 0.0);
    for (Vec2& p : ring) {
        p = (1.0 + 0.1 * unit(random)) * p;
    }
    addRing(rough, ring);
    EXPECT_EQ(compareAll(rough), 0U);
    CurveNetwork equal = emptyNetwork(2);
    addRing(equal, waves(500, {}, 0.1, 3, 0.0), 0);
    addRing(equal, waves(500, {}, 0.1, 3, 0.0), 1);
    EXPECT_EQ(compareAll(equal), 0U);
}

} // namespace
} // namespace tessera
