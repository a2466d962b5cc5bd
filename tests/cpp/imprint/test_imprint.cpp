// SPDX-License-Identifier: MIT
#include "imprint/imprint_cases.h"
#include "imprint/inscribed_circle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tessera
{
namespace
{

using Numbers = std::vector<std::uint32_t>;

double sumOfAreas(const ImprintResult& result)
{
    double sum = 0.0;
    for (const ImprintCell& cell : result.cells) {
        sum += cell.area;
    }
    return sum;
}

/// Every edge of a cell is an edge of another one or of none, never a part of one.
void expectConforming(const ImprintResult& result)
{
    const Polygons& polygons = result.overlay.polygons;
    std::vector<Vec2> corners;
    for (const std::uint32_t v : polygons.vertices) {
        corners.push_back(result.overlay.point(v));
    }
    for (std::size_t p = 0; p < polygons.size(); ++p) {
        for (std::size_t i = 0; i < polygons.loopCount(p); ++i) {
            const auto loop = polygons.loop(p, i);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Vec2 a = result.overlay.point(loop[k]);
                const Vec2 b = result.overlay.point(loop[(k + 1) % loop.size()]);
                for (const Vec2 c : corners) {
                    const bool inside = cross(b - a, c - a) == 0.0 && dot(c - a, b - a) > 0.0
                        && dot(c - b, a - b) > 0.0;
                    EXPECT_FALSE(inside) << c.x << ", " << c.y;
                }
            }
        }
    }
}

TEST(Imprint, CellsKnowTheirSourceAndTheirTarget)
{
    ImprintCase c;
    addSource(c, rectangle(0, 0, 2, 2));
    addSource(c, rectangle(2, 0, 5, 2));
    addTarget(c, rectangle(0, 0, 3, 2));
    addTarget(c, rectangle(3, 0, 5, 2));
    const ImprintResult result = imprint(c);
    ASSERT_EQ(result.cells.size(), 3U);
    EXPECT_TRUE(result.closed.empty());
    EXPECT_TRUE(result.left.empty());
    EXPECT_EQ(sumOfAreas(result), 10.0);
    EXPECT_EQ(result.cellsOfSource[0].size(), 1U);
    EXPECT_EQ(result.cellsOfSource[1].size(), 2U);
    EXPECT_EQ(result.cellsOfTarget[0].size(), 2U);
    EXPECT_EQ(result.cellsOfTarget[1].size(), 1U);
    const ImprintCell& first = result.cells[result.cellsOfSource[0][0]];
    EXPECT_EQ(first.sources, Numbers {0});
    EXPECT_EQ(first.targets, Numbers {0});
    EXPECT_EQ(first.area, 4.0);
    expectConforming(result);
}

TEST(Imprint, AreasAreThoseOfTheTrueCurves)
{
    const ImprintResult result = imprint(plateAndDisk());
    EXPECT_EQ(result.cells.size(), 10U);
    EXPECT_TRUE(result.left.empty());
    EXPECT_NEAR(sumOfAreas(result), 96.0, 1e-12);
    double disk = 0.0;
    for (const std::uint32_t cell : result.cellsOfTarget[0]) {
        disk += result.cells[cell].area;
    }
    EXPECT_NEAR(disk, std::numbers::pi * 6.25, 1e-12);
    expectConforming(result);
}

TEST(Imprint, OverlapsAndGapsWithinTheToleranceAreClosedWiderOnesLeft)
{
    // The sources leave a gap of 0.01, the targets overlap by 0.01, elsewhere.
    ImprintCase c;
    addSource(c, rectangle(0, 0, 2, 2));
    addSource(c, rectangle(2.01, 0, 5, 2));
    addTarget(c, rectangle(0, 0, 3.01, 2));
    addTarget(c, rectangle(3, 0, 5, 2));
    ImprintOptions options;

    const ImprintResult left = imprint(c, options);
    EXPECT_TRUE(left.closed.empty());
    ASSERT_EQ(left.left.size(), 2U);
    for (const Mismatch& mismatch : left.left) {
        const bool gap = mismatch.kind == MismatchKind::TargetOnly;
        EXPECT_TRUE(gap || mismatch.kind == MismatchKind::TargetOverlap);
        EXPECT_NEAR(mismatch.width, 0.01, 2e-4);
        EXPECT_NEAR(mismatch.area, 0.02, 1e-12);
        EXPECT_EQ(mismatch.sources, gap ? Numbers {} : Numbers {1});
        EXPECT_EQ(mismatch.targets, gap ? Numbers {0} : (Numbers {0, 1}));
        EXPECT_NEAR(mismatch.at.x, gap ? 2.005 : 3.005, 1e-3);
    }

    options.tolerance = 0.02;
    const ImprintResult closed = imprint(c, options);
    EXPECT_TRUE(closed.left.empty());
    ASSERT_EQ(closed.closed.size(), 2U);
    EXPECT_EQ(closed.cells.size(), 3U);
    EXPECT_NEAR(sumOfAreas(closed), 10.0, 1e-9);
    for (const ImprintCell& cell : closed.cells) {
        EXPECT_EQ(cell.sources.size(), 1U);
        EXPECT_EQ(cell.targets.size(), 1U);
    }
    expectConforming(closed);
}

TEST(Imprint, TheToleranceIsExact)
{
    // Three sources in a row: the gaps are 0.0100001 and 0.01 wide. Turned, nothing is exact.
    for (const double angle : {0.0, 0.3}) {
        const auto turned = [angle](Ring ring) {
            for (Vec2& p : ring) {
                p = {std::cos(angle) * p.x - std::sin(angle) * p.y,
                     std::sin(angle) * p.x + std::cos(angle) * p.y};
            }
            return ring;
        };
        ImprintCase c;
        addSource(c, turned(rectangle(0, 0, 2, 2)));
        addSource(c, turned(rectangle(2.0100001, 0, 4, 2)));
        addSource(c, turned(rectangle(4.01, 0, 6, 2)));
        addTarget(c, turned(rectangle(0, 0, 6, 2)));
        ImprintOptions options;
        options.tolerance = 0.01;
        const ImprintResult result = imprint(c, options);
        ASSERT_EQ(result.left.size(), 1U);
        EXPECT_NEAR(result.left[0].width, 0.0100001, 1e-9);
        ASSERT_EQ(result.closed.size(), 1U);
        EXPECT_NEAR(result.closed[0].width, 0.01, 1e-9);
        EXPECT_EQ(result.cells.size(), 4U);
    }
}

TEST(Imprint, CurvedGapsAreClosedToo)
{
    // A disk in a hole that is wider by 0.004 all around; its curve starts elsewhere.
    constexpr double kPi = std::numbers::pi;
    ImprintCase c;
    addOutline(c, ImprintSide::Source, {{1, 0}}, {{0, {{0, 0}, 1.0, 0.0, 2.0 * kPi}}});
    addOutline(c, ImprintSide::Source, {{-1.004, 0}}, {{0, {{0, 0}, 1.004, kPi, 3.0 * kPi}}});
    const std::uint32_t plate = 1;
    addRing(c.network, rectangle(-3, -3, 3, 3), plate);
    addTarget(c, rectangle(-3, -3, 3, 3));
    ImprintOptions options;
    options.tolerance = 0.003;
    const ImprintResult left = imprint(c, options);
    ASSERT_EQ(left.left.size(), 1U);
    EXPECT_EQ(left.left[0].kind, MismatchKind::TargetOnly);
    EXPECT_NEAR(left.left[0].width, 0.004, 1e-4);
    EXPECT_NEAR(left.left[0].area, kPi * (1.004 * 1.004 - 1.0), 1e-9);
    EXPECT_TRUE(left.closed.empty());

    options.tolerance = 0.005;
    const ImprintResult closed = imprint(c, options);
    EXPECT_TRUE(closed.left.empty());
    ASSERT_EQ(closed.closed.size(), 1U);
    EXPECT_NEAR(closed.closed[0].width, 0.004, 1e-4);
    EXPECT_EQ(closed.cells.size(), 2U);
    EXPECT_NEAR(sumOfAreas(closed), 36.0, 1e-9);
}

TEST(Imprint, AGapBetweenFourPartsIsFoundThoughNothingCoversIt)
{
    ImprintCase c;
    addSource(c, {{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 3}, {4, 3}, {4, 4}, {0, 4}});
    addSource(c, {{4, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 3}, {2.1, 3}, {2.1, 1}, {4, 1}});
    for (std::uint32_t o = 0; o < 2; ++o) {
        addTarget(c, o == 0 ? Ring {{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 3}, {4, 3}, {4, 4}, {0, 4}}
                            : Ring {{4, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 3}, {2.1, 3}, {2.1, 1},
                                    {4, 1}});
    }
    ImprintOptions options;
    const ImprintResult left = imprint(c, options);
    ASSERT_EQ(left.left.size(), 1U);
    EXPECT_EQ(left.left[0].kind, MismatchKind::Gap);
    EXPECT_NEAR(left.left[0].width, 0.1, 2e-3);
    EXPECT_EQ(left.left[0].sources, (Numbers {0, 1}));
    options.tolerance = 0.2;
    const ImprintResult closed = imprint(c, options);
    EXPECT_TRUE(closed.left.empty());
    ASSERT_EQ(closed.closed.size(), 1U);
    EXPECT_EQ(closed.closed[0].kind, MismatchKind::Gap);
    EXPECT_NEAR(sumOfAreas(closed), 24.0, 1e-9);
}

TEST(Imprint, PartsWithoutACounterpartAreReported)
{
    ImprintCase c;
    addSource(c, rectangle(0, 0, 2, 2));
    addSource(c, rectangle(10, 0, 12, 2));
    addTarget(c, rectangle(0, 0, 2, 3));
    const ImprintResult result = imprint(c);
    EXPECT_EQ(result.cells.size(), 3U);
    ASSERT_EQ(result.left.size(), 2U);
    for (const Mismatch& mismatch : result.left) {
        const bool source = mismatch.kind == MismatchKind::SourceOnly;
        EXPECT_EQ(mismatch.sources, source ? Numbers {1} : Numbers {});
        EXPECT_EQ(mismatch.targets, source ? Numbers {} : Numbers {0});
        EXPECT_NEAR(mismatch.width, source ? 2.0 : 1.0, 0.02 * mismatch.width);
    }
}

TEST(Imprint, HolesOfOneFaceAreNoGaps)
{
    ImprintCase c;
    addSource(c, rectangle(0, 0, 4, 4));
    addRing(c.network, rectangle(1, 1, 2, 2), 0);
    addTarget(c, rectangle(0, 0, 4, 4));
    addRing(c.network, rectangle(1, 1, 2, 2), 1);
    const ImprintResult result = imprint(c);
    EXPECT_EQ(result.cells.size(), 1U);
    EXPECT_EQ(sumOfAreas(result), 15.0);
    EXPECT_TRUE(result.left.empty());
}

TEST(Imprint, BadInputIsRefused)
{
    ImprintCase c;
    addSource(c, rectangle(0, 0, 1, 1));
    EXPECT_THROW(imprint(c), Error);
    addTarget(c, rectangle(0, 0, 1, 1));
    ImprintOptions options;
    options.tolerance = -1.0;
    EXPECT_THROW(imprint(c, options), Error);
    options.tolerance = NAN;
    EXPECT_THROW(imprint(c, options), Error);
}

TEST(InscribedCircle, OfATriangleAndOfALongStrip)
{
    const std::vector<std::array<Vec2, 3>> triangle {{{{0, 0}, {4, 0}, {0, 3}}}};
    const std::vector<std::array<Vec2, 2>> sides {
        {{{0, 0}, {4, 0}}}, {{{4, 0}, {0, 3}}}, {{{0, 3}, {0, 0}}}};
    const InscribedCircle circle = largestCircleIn(triangle, sides);
    EXPECT_LE(circle.radius, 1.0);
    EXPECT_GE(circle.radius, 0.99);
    EXPECT_NEAR(circle.center.x, 1.0, 0.05);
    EXPECT_NEAR(circle.center.y, 1.0, 0.05);
    const std::vector<std::array<Vec2, 3>> strip {{{{0, 0}, {1e6, 0}, {1e6, 1e-3}}},
                                                  {{{0, 0}, {1e6, 1e-3}, {0, 1e-3}}}};
    const std::vector<std::array<Vec2, 2>> around {{{{0, 0}, {1e6, 0}}},
                                                   {{{1e6, 0}, {1e6, 1e-3}}},
                                                   {{{1e6, 1e-3}, {0, 1e-3}}},
                                                   {{{0, 1e-3}, {0, 0}}}};
    const InscribedCircle inStrip = largestCircleIn(strip, around, 5e-4);
    EXPECT_NEAR(inStrip.radius, 5e-4, 1e-12);
    EXPECT_TRUE(inStrip.isWithin);
    EXPECT_FALSE(largestCircleIn(strip, around, 4.9999e-4).isWithin);
    EXPECT_TRUE(largestCircleIn(triangle, sides, 1.0).isWithin);
    EXPECT_FALSE(largestCircleIn(triangle, sides, 0.99999).isWithin);
    EXPECT_EQ(largestCircleIn({}, {}).radius, 0.0);
}

} // namespace
} // namespace tessera
