// SPDX-License-Identifier: MIT
#include "io/append_network.h"
#include "io/expect_error.h"
#include "io/read_network.h"
#include "io/read_poly.h"
#include "io/read_wkt.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace tessera
{
namespace
{

using testing::expectError;

TEST(ReadWkt, PolygonWithHole)
{
    const CurveNetwork network =
        parseWkt("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 2,2 1,1 1))", "a.wkt");
    ASSERT_EQ(network.points.size(), 8U);
    ASSERT_EQ(network.curves.size(), 8U);
    EXPECT_EQ(network.curves[3].start, PointId(3U));
    EXPECT_EQ(network.curves[3].end, PointId(0U)); // closed on the first point
    EXPECT_EQ(network.curves[7].end, PointId(4U));
    for (const NetworkCurve& curve : network.curves) {
        EXPECT_EQ(curve.role, Role::Boundary);
        EXPECT_EQ(curve.operand, OperandId(0U));
        EXPECT_EQ(curve.source, 1U);
    }
    ASSERT_EQ(network.operands.size(), 1U);
    EXPECT_EQ(network.operands[0].name, "Line1");
    EXPECT_TRUE(network.operands[0].declaresHoles);
}

TEST(ReadWkt, EveryTypeInAnyCaseAndSpacing)
{
    const std::string text = "point ( 1\t2 )\n"
                             "MultiPoint((1 2), (3 4))\n"
                             "MULTIPOINT(1 2,3 4, EMPTY)\n"
                             "  LineString ( 0 0 , 1 0 , 1 1 )  \n"
                             "LINEARRING(0 0,1 0,1 1,0 0)\n"
                             "MULTILINESTRING((0 0,1 1),(2 2,3 3,4 5))\n"
                             "MULTIPOLYGON(((0 0,1 0,0 1,0 0)),((5 5,6 5,5 6,5 5)))\n"
                             "GEOMETRYCOLLECTION(POINT(9 9),LINESTRING(0 0,1e3 -2.5E-1),"
                             "GEOMETRYCOLLECTION(POLYGON((0 0,1 0,0 1,0 0))))\n";
    const CurveNetwork network = parseWkt(text, "a.wkt");
    ASSERT_EQ(network.operands.size(), 8U);
    std::vector<std::size_t> curves(8, 0);
    std::vector<std::size_t> embedded(8, 0);
    for (const NetworkCurve& curve : network.curves) {
        ++curves[curve.operand.index()];
    }
    for (const EmbeddedPoint& point : network.embedded) {
        ++embedded[point.operand.index()];
    }
    EXPECT_EQ(curves, (std::vector<std::size_t> {0, 0, 0, 2, 3, 3, 6, 4}));
    EXPECT_EQ(embedded, (std::vector<std::size_t> {1, 2, 2, 0, 0, 0, 0, 1}));
    EXPECT_EQ(network.curves[2].role, Role::Constraint); // closed lines, too
    EXPECT_EQ(network.points.back(), (Vec2 {0.0, 1.0}));
    EXPECT_FALSE(network.operands[6].declaresHoles);
}

TEST(ReadWkt, LinesNumberOperandsThroughCommentsAndBlankLines)
{
    const CurveNetwork network =
        parseWkt("# first\n\nPOINT(1 1)  # with a comment\r\n   \n#\nPOINT(2 2)", "a.wkt");
    ASSERT_EQ(network.operands.size(), 2U);
    EXPECT_EQ(network.operands[0].name, "Line3");
    EXPECT_EQ(network.operands[1].name, "Line6");
    EXPECT_EQ(network.embedded[1].name, "Line6_Points");
}

TEST(ReadWkt, GeometryOverSeveralLines)
{
    const CurveNetwork network =
        parseWkt("POLYGON\n(\n(0 0,\n1 0,\n0 1,0 0)\n)\nPOINT(3 3)\n", "a.wkt");
    ASSERT_EQ(network.operands.size(), 2U);
    EXPECT_EQ(network.operands[1].name, "Line7");
}

TEST(ReadWkt, DropsHeightsMeasuresAndSrid)
{
    const std::string text = "POINT Z (1 2 3)\nPOINTZ(1 2 3)\nPOINT ZM (1 2 3 4)\nPOINTM(1 2 7)\n"
                             "POINT(1 2 3)\nSRID=4326;POINT(1 2)\nPOINT M(1 2 3)\n";
    const CurveNetwork network = parseWkt(text, "a.wkt");
    ASSERT_EQ(network.points.size(), 7U);
    for (Vec2 p : network.points) {
        EXPECT_EQ(p, (Vec2 {1.0, 2.0}));
    }
}

TEST(ReadWkt, ByteOrderMarkOfAFile)
{
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "marked.wkt";
    std::ofstream(path) << "\xEF\xBB\xBFPOINT (1 2)\n";
    EXPECT_EQ(readWkt(path).points.size(), 1U);
    std::filesystem::remove(path);
}

TEST(ReadWkt, EmptyGeometriesAreOperands)
{
    const CurveNetwork network = parseWkt("POLYGON EMPTY\nGEOMETRYCOLLECTION EMPTY\n"
                                          "MULTIPOLYGON(EMPTY,((0 0,1 0,0 1,0 0)))\nPOINT Z EMPTY\n"
                                          "POLYGON(EMPTY)\nGEOMETRYCOLLECTION(POINT EMPTY)\n",
                                          "a.wkt");
    EXPECT_EQ(network.operands.size(), 6U);
    EXPECT_EQ(network.curves.size(), 3U);
    EXPECT_TRUE(network.embedded.empty());
    EXPECT_TRUE(parseWkt("", "a.wkt").operands.empty());
    EXPECT_TRUE(parseWkt("\n# nothing\n", "a.wkt").operands.empty());
}

TEST(ReadWkt, RepeatedPointsAreTakenOnceDegenerateRingsStay)
{
    EXPECT_EQ(parseWkt("POLYGON((0 0,0 0,1 0,1 0,0 1,0 0,0 0))", "a").curves.size(), 3U);
    const CurveNetwork point = parseWkt("POLYGON((1 1,1 1))", "a");
    ASSERT_EQ(point.curves.size(), 1U);
    EXPECT_EQ(point.curves[0].start, point.curves[0].end);
    EXPECT_EQ(parseWkt("POLYGON((0 0,1 1,0 0))", "a").curves.size(), 2U);
}

TEST(ReadWkt, RolesByLine)
{
    RoleLists roles;
    roles.boundary = {2};
    roles.constraint = {1};
    const CurveNetwork network =
        parseWkt("POLYGON((0 0,1 0,0 1,0 0))\nLINESTRING(5 5,6 5,5 6,5 5)\n", "a.wkt", roles);
    EXPECT_EQ(network.curves[0].role, Role::Constraint);
    EXPECT_EQ(network.curves[3].role, Role::Boundary);
}

TEST(ReadWkt, SaysFileLineAndReason)
{
    const auto refuse = [](const std::string& text, const std::string& expected) {
        expectError(ErrorKind::Unreadable, expected, [&] { parseWkt(text, "bad.wkt"); });
    };
    refuse("HELLO(1 2)", "bad.wkt:1: a geometry type such as POLYGON was expected, not 'HELLO");
    refuse("POINT(1 2)\n(1 2)", "bad.wkt:2: a geometry type");
    refuse("\n\nPOINT(1)", "bad.wkt:3: a finite number is missing before ')'");
    refuse("POINT(1 2 3 4 5)", "')' is missing before '5)'");
    refuse("POINT(1 nan)", "a finite number is missing before 'nan)'");
    refuse("POINT(1 1e999)", "a finite number is missing");
    refuse("POLYGON((0 0,1 0,0 1))", "bad.wkt:1: the ring is not closed");
    refuse("POLYGON((0 0,1 0,0 1,0 0)", "')' is missing before the end of the file");
    refuse("POLYGON(0 0,1 0,0 1,0 0)", "'(' is missing before '0 0");
    refuse("POLYGON FULL", "'(' or EMPTY was expected, not 'FULL'");
    refuse("POINT(1 2) POINT(3 4)", "write one geometry a line");
    refuse("POINT(1 2);", "write one geometry a line");
    refuse("CIRCULARSTRING(0 0,1 1,2 0)", "CIRCULARSTRING is not supported");
    refuse("TIN Z(((0 0 0,1 0 0,0 1 0,0 0 0)))", "TIN is not supported");
    refuse("CURVEPOLYGONZ((0 0,1 1,2 0))", "CURVEPOLYGON is not supported");
    refuse("SRID=12 POINT(1 2)", "';' is missing after the SRID");
    std::string deep;
    for (int i = 0; i < 100000; ++i) {
        deep += "GEOMETRYCOLLECTION(";
    }
    refuse(deep, "nested deeper than");
    expectError(ErrorKind::Unreadable, "cannot be read", [] { readWkt("no-such.wkt"); });
}

TEST(ReadWkt, TruncatedAnywhereIsRefusedOrRead)
{
    const std::string text = "GEOMETRYCOLLECTION Z(POINT(1 2 3),POLYGON((0 0,4 0,4 4,0 0),(1 1,2 1,"
                             "2 2,1 1)),MULTIPOINT(1 2,(3 4)),LINESTRING EMPTY)";
    ASSERT_TRUE(testing::succeedsOrIsRefused([&] { parseWkt(text, "whole.wkt"); }));
    for (std::size_t length = 1; length < text.size(); ++length) {
        EXPECT_FALSE(testing::succeedsOrIsRefused(
            [&] { parseWkt(text.substr(0, length), "cut.wkt"); }))
            << text.substr(0, length);
    }
}

TEST(AppendNetwork, ShiftsAllIds)
{
    CurveNetwork network = parseWkt("POLYGON((0 0,1 0,0 1,0 0))\nPOINT(5 5)", "a.wkt");
    appendNetwork(network,
                  parsePoly("3 2 0 1\n1 8 8 1\n2 9 8 0\n3 8 9 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n"
                            "1\n1 8.1 8.1\n1\n1 8.2 8.2 5 6\n",
                            "b.poly"));
    EXPECT_EQ(network.points.size(), 7U);
    EXPECT_EQ(network.operands.size(), 3U);
    EXPECT_EQ(network.curves[3].start, PointId(4U));
    EXPECT_EQ(network.curves[3].operand, OperandId(2U));
    EXPECT_EQ(network.embedded[1].point, PointId(4U));
    EXPECT_EQ(network.holes[0].operand, OperandId(2U));
    EXPECT_EQ(network.regions[0].operand, OperandId(2U));
    ASSERT_EQ(network.curveNames.size(), 6U);
    EXPECT_EQ(network.curveNames[0], "Line1_Edges");
    EXPECT_EQ(network.curveNames[3], "");
}

TEST(ReadNetwork, GoesByExtension)
{
    const testing::TemporaryFolder folder;
    testing::writeAll(folder / "a.WKT", "POINT(1 2)");
    EXPECT_EQ(readNetwork(folder / "a.WKT").points.size(), 1U);
    expectError(ErrorKind::Unreadable, "files of this kind cannot be read",
                [] { readNetwork("a.dxf"); });
    EXPECT_EQ(extensionOf("folder.d/name"), "");
}

} // namespace
} // namespace tessera
