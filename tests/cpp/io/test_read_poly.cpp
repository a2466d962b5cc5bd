// SPDX-License-Identifier: MIT
#include "io/expect_error.h"
#include "io/read_poly.h"
#include "io/text_file.h"

#include <gtest/gtest.h>

#include <string>

namespace tessera
{
namespace
{

using testing::expectError;
using testing::TemporaryFolder;
using testing::writeAll;

const std::string kSquare = R"(# a square with a hole, a diagonal stub and a loose point
10 2 1 1
1 0 0 7.5 1
2 4 0 7.5 1
3 4 4 7.5 1
4 0 4 7.5 1

5 1 1 0 0   # the hole
6 2 1 0 0
7 2 2 0 0
8 1 2 0 0
9 3 3 0 0
10 3.5 3.5 0 5
9 1
1 1 2 11
2 2 3 12
3 3 4 11
4 4 1 12
5 5 6 20
6 6 7 20
7 7 8 20
8 8 5 20
9 3 9 30
1
1 1.5 1.5
2
1 0.5 0.5 3.25 0.125
2 3 1 4
)";

TEST(ReadPoly, TakesAllSections)
{
    const CurveNetwork network = parsePoly(kSquare, "folder/square.poly");
    ASSERT_EQ(network.points.size(), 10U);
    EXPECT_EQ(network.points[9], (Vec2 {3.5, 3.5}));
    ASSERT_EQ(network.curves.size(), 9U);
    EXPECT_EQ(network.curves[8].start, PointId(2U));
    EXPECT_EQ(network.curves[8].end, PointId(8U));
    EXPECT_EQ(network.curves[8].marker, 30);
    EXPECT_EQ(network.curves[8].source, 9U);
    ASSERT_EQ(network.operands.size(), 1U);
    EXPECT_EQ(network.operands[0].name, "square");
    ASSERT_EQ(network.holes.size(), 1U);
    EXPECT_EQ(network.holes[0].position, (Vec2 {1.5, 1.5}));
    ASSERT_EQ(network.regions.size(), 2U);
    EXPECT_EQ(network.regions[0].attribute, 3.25);
    EXPECT_EQ(network.regions[0].maxArea, 0.125);
    EXPECT_EQ(network.regions[1].attribute, 4.0);
    EXPECT_EQ(network.regions[1].maxArea, 0.0);
}

TEST(ReadPoly, GivesDefaultRoles)
{
    const CurveNetwork network = parsePoly(kSquare, "square.poly");
    for (std::size_t c = 0; c < 8; ++c) {
        EXPECT_EQ(network.curves[c].role, Role::Boundary) << c;
    }
    EXPECT_EQ(network.curves[8].role, Role::Constraint); // hangs loose
}

TEST(ReadPoly, RolesByMarkerComeFirst)
{
    RoleLists roles;
    roles.constraint = {20};
    roles.boundary = {30};
    const CurveNetwork network = parsePoly(kSquare, "square.poly", {}, roles);
    EXPECT_EQ(network.curves[0].role, Role::Boundary);
    EXPECT_EQ(network.curves[5].role, Role::Constraint);
    EXPECT_EQ(network.curves[8].role, Role::Boundary);
}

TEST(ReadPoly, DefaultRolesAreDecidedWithoutSettledSegments)
{
    // A square with a diagonal: with it every component has an odd vertex, without it none.
    const std::string text = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n"
                             "5 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 1 3 2\n0\n";
    EXPECT_EQ(parsePoly(text, "a.poly").curves[0].role, Role::Outline);
    RoleLists roles;
    roles.constraint = {2};
    const CurveNetwork network = parsePoly(text, "a.poly", {}, roles);
    EXPECT_EQ(network.curves[0].role, Role::Boundary);
    EXPECT_EQ(network.curves[4].role, Role::Constraint);
}

TEST(ReadPoly, EmbedsLooseAndMarkedPoints)
{
    const CurveNetwork network = parsePoly(kSquare, "square.poly");
    ASSERT_EQ(network.embedded.size(), 5U);
    EXPECT_EQ(network.embedded[0].point, PointId(0U));
    EXPECT_EQ(network.embedded[0].name, "PointMarker1");
    EXPECT_EQ(network.embedded[4].point, PointId(9U));
    EXPECT_EQ(network.embedded[4].name, "PointMarker5");
}

TEST(ReadPoly, NumbersFromZeroOrOne)
{
    const CurveNetwork zero =
        parsePoly("3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n", "a.poly");
    const CurveNetwork one =
        parsePoly("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n", "a.poly");
    ASSERT_EQ(zero.curves.size(), one.curves.size());
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(zero.curves[c].start, one.curves[c].start);
        EXPECT_EQ(zero.curves[c].end, one.curves[c].end);
    }
}

TEST(ReadPoly, MissingColumnsOfTheHeadersAndMarkers)
{
    // Only the counts; segments announce markers, and one lacks its own.
    const CurveNetwork network =
        parsePoly("3\n1 0 0\n2 1 0\n3 0 1\n3 1\n1 1 2 5\n2 2 3\n3 3 1 -6\n0", "a.poly");
    EXPECT_EQ(network.curves[0].marker, 5);
    EXPECT_EQ(network.curves[1].marker, 0);
    EXPECT_EQ(network.curves[2].marker, -6);
}

TEST(ReadPoly, LineEndsTabsAndNotations)
{
    const CurveNetwork network =
        parsePoly("2\r\n1 +1.5e+2 -.5\r\n2\t1E-3\t2.\r\n0\r\n0\r\n", "a.poly");
    EXPECT_EQ(network.points[0], (Vec2 {150.0, -0.5}));
    EXPECT_EQ(network.points[1], (Vec2 {0.001, 2.0}));
}

TEST(ReadPoly, PointsFromNodeFile)
{
    const TemporaryFolder folder;
    writeAll(folder / "part.node", "3 2 0 1\n0 0 0 1\n1 2 0 1\n2 0 2 4\n# end\n");
    writeAll(folder / "part.poly", "0 2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n");
    const CurveNetwork network = readPoly(folder / "part.poly");
    ASSERT_EQ(network.points.size(), 3U);
    EXPECT_EQ(network.points[1], (Vec2 {2.0, 0.0}));
    EXPECT_EQ(network.embedded.size(), 3U);
    std::filesystem::remove(folder / "part.node");
    expectError(ErrorKind::Unreadable, "part.node", [&] { readPoly(folder / "part.poly"); });
}

TEST(ReadPoly, SaysFileLineAndReason)
{
    const auto refuse = [](const std::string& text, const std::string& expected) {
        expectError(ErrorKind::Unreadable, expected, [&] { parsePoly(text, "bad.poly"); });
    };
    refuse("", "bad.poly: the file ends before the number of points");
    refuse("three 2 0 0\n", "bad.poly:1: 'three' is not a whole number");
    refuse("-1 2 0 0\n", "bad.poly:1: the number of points is -1");
    refuse("1 3 0 0\n1 0 0\n", "the dimension is 3");
    refuse("2 2 0 0\n1 0 0\n", "bad.poly:2: the file ends before point 2 of 2");
    refuse("2 2 0 0\n1 0 0\n2 0\n", "bad.poly:3: the y coordinate is missing");
    refuse("2 2 0 0\n1 0 0\n2 0 1..5\n", "bad.poly:3: '1..5' is not a finite number");
    refuse("1 2 0 0\n1 nan 0\n", "bad.poly:2: 'nan' is not a finite number");
    refuse("1 2 0 0\n1 0 1e999\n", "'1e999' is not a finite number");
    refuse("2 2 0 0\n1 0 0\n3 1 1\n", "point 3 stands where 2 was expected");
    refuse("1 2 0 0\n1 0 0\n", "before the number of segments");
    refuse("1 2 0 0\n1 0 0\n1 0\n1 1 2\n0\n",
           "bad.poly:4: there is no point 2; the points are 1 to 1");
    refuse("1 2 0 0\n1 0 0\n1 1\n1 1 1 x\n0\n", "bad.poly:4: 'x' is not a whole number");
    refuse("1 2 0 0\n1 0 0\n0 0\n", "before the number of holes");
    refuse("1 2 0 0\n1 0 0\n0 0\n1\n1 5\n", "bad.poly:5: the y coordinate is missing");
    refuse("1 2 0 0\n1 0 0\n0 0\n0\n0\n1 2 3\n", "bad.poly:6: the file should end here");
    expectError(ErrorKind::Unreadable, "no-such.poly: cannot be read: No such file",
                [] { readPoly("no-such.poly"); });
    expectError(ErrorKind::Unreadable, "it is a folder", [] { readPoly("."); });
}

TEST(ReadPoly, HugeCountsAreRefusedBeforeMemoryIsTaken)
{
    expectError(ErrorKind::Unreadable, "before point 2 of 4000000000",
                [] { parsePoly("4000000000 2 1 1\n1 0 0 0 1\n", "a.poly"); });
    expectError(ErrorKind::Unreadable, "must be 0 to",
                [] { parsePoly("99999999999 2 0 0\n", "a.poly"); });
}

TEST(ReadPoly, TruncatedAnywhereIsRefusedOrRead)
{
    std::size_t read = 0;
    for (std::size_t length = 0; length < kSquare.size(); ++length) {
        const std::string text = kSquare.substr(0, length);
        read += testing::succeedsOrIsRefused([&] { parsePoly(text, "cut.poly"); }) ? 1 : 0;
    }
    // Only within the region section or its last numbers does a cut file still look whole.
    EXPECT_LT(read, 40U);
}

TEST(ParseNumber, ReadsWhatCWrites)
{
    double value = 0.0;
    const auto reads = [&value](std::string_view word, double expected) {
        return parseNumber(word, value) && value == expected;
    };
    EXPECT_TRUE(reads("+1.5e+2", 150.0));
    EXPECT_TRUE(reads("-.5", -0.5));
    EXPECT_TRUE(reads("2.", 2.0));
    EXPECT_TRUE(reads("1E-3", 0.001));
    EXPECT_TRUE(reads("1e-400", 0.0));
    EXPECT_TRUE(reads("4.9406564584124654e-324", 4.9406564584124654e-324));
    EXPECT_TRUE(reads("0.1000000000000000055511151231257827021181583404541015625", 0.1));
    for (const char* word :
         {"", "+", "-", "+-1", "1,5", "0x10", "1e", "1e999", "inf", "NaN", "1 2"}) {
        EXPECT_FALSE(parseNumber(word, value)) << word;
    }
}

} // namespace
} // namespace tessera
