// SPDX-License-Identifier: MIT
#include "io/expect_error.h"
#include "io/group_names.h"
#include "io/hole_points.h"
#include "io/read_poly.h"
#include "io/read_text_mesh.h"
#include "io/sample_meshes.h"
#include "io/write_text_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

namespace tessera
{
namespace
{

using samples::PlateMesh;
using samples::secondOrderPlate;
using testing::expectError;

/// The cells of one kind as sets of positions, so that numbering does not matter.
std::multiset<std::vector<std::pair<double, double>>> cellsOf(const RawMesh& raw, CellKind kind)
{
    std::multiset<std::vector<std::pair<double, double>>> cells;
    for (const RawMesh::Cell& cell : raw.cells) {
        if (cell.kind == kind) {
            std::vector<std::pair<double, double>> places;
            for (std::uint32_t node : raw.nodesOfCell(cell)) {
                places.emplace_back(raw.nodes[node][0], raw.nodes[node][1]);
            }
            cells.insert(places);
        }
    }
    return cells;
}

std::multiset<std::vector<std::pair<double, double>>> trianglesOf(const Mesh& mesh)
{
    std::multiset<std::vector<std::pair<double, double>>> cells;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::vector<std::uint32_t> nodes(mesh.triangles[t].begin(), mesh.triangles[t].end());
        if (mesh.order() == 2) {
            const auto& middle = mesh.triangleMidNodes[t];
            nodes.insert(nodes.end(), {middle[2], middle[0], middle[1]});
        }
        std::vector<std::pair<double, double>> places;
        for (std::uint32_t node : nodes) {
            places.emplace_back(mesh.nodes[node].x, mesh.nodes[node].y);
        }
        cells.insert(places);
    }
    return cells;
}

TEST(WriteMsh, RoundTrip)
{
    const Mesh mesh = PlateMesh(9).mesh;
    const RawMesh raw = parseMsh(formatMsh(mesh), "a.msh");
    EXPECT_EQ(raw.nodes.size(), mesh.nodes.size());
    EXPECT_EQ(cellsOf(raw, CellKind::Triangle3), trianglesOf(mesh));
    EXPECT_EQ(cellsOf(raw, CellKind::Edge2).size(), mesh.edges.size());
}

TEST(WriteMsh, RoundTripOfOrderTwo)
{
    const Mesh mesh = secondOrderPlate(9);
    const RawMesh raw = parseMsh(formatMsh(mesh), "a.msh");
    EXPECT_EQ(raw.nodes.size(), mesh.nodes.size());
    EXPECT_EQ(cellsOf(raw, CellKind::Triangle6), trianglesOf(mesh));
    EXPECT_EQ(cellsOf(raw, CellKind::Edge3).size(), mesh.edges.size());
}

/// The lines between $Name and $EndName.
std::vector<std::string> section(const std::string& text, const std::string& name)
{
    std::istringstream lines(text.substr(text.find("$" + name + "\n") + name.size() + 2));
    std::vector<std::string> result;
    for (std::string line; std::getline(lines, line) && line != "$End" + name;) {
        result.push_back(line);
    }
    return result;
}

TEST(WriteMsh, OverlappingGroupsBecomePhysicalGroups)
{
    Mesh mesh = PlateMesh(9).mesh;
    mesh.groups[0].name = "with \"quotes\"\nand a break";
    const std::string text = formatMsh(mesh);
    const auto names = section(text, "PhysicalNames");
    ASSERT_EQ(names.size(), 8U);
    EXPECT_EQ(names[1], "2 1 \"with _quotes__and a break\"");
    EXPECT_EQ(names[3], "2 3 \"Plate\"");
    EXPECT_EQ(names[7], "0 7 \"Corner\"");
    const auto entities = section(text, "Entities");
    // One point, three curves, a surface for Left with Plate and one for Right with Plate.
    EXPECT_EQ(entities[0], "1 3 2 0");
    EXPECT_EQ(entities[1], "1 0 0 0 1 7");
    EXPECT_TRUE(entities[5].ends_with(" 2 1 3 0")) << entities[5];
    EXPECT_TRUE(entities[6].ends_with(" 2 2 3 0")) << entities[6];
}

TEST(WriteMsh, MeshWithoutAnything)
{
    EXPECT_TRUE(parseMsh(formatMsh(Mesh()), "a.msh").cells.empty());
}

TEST(WriteInp, RoundTrip)
{
    for (const bool second : {false, true}) {
        const Mesh mesh = second ? secondOrderPlate(9) : PlateMesh(9).mesh;
        const RawMesh raw = parseInp(formatInp(mesh), "a.inp");
        ASSERT_EQ(raw.nodes.size(), mesh.nodes.size());
        for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
            EXPECT_NEAR(raw.nodes[i][0], mesh.nodes[i].x, 1e-14 * std::fabs(mesh.nodes[i].x));
            EXPECT_NEAR(raw.nodes[i][1], mesh.nodes[i].y, 1e-14 * std::fabs(mesh.nodes[i].y));
        }
        ASSERT_EQ(raw.cells.size(), mesh.triangles.size());
        for (std::size_t t = 0; t < raw.cells.size(); ++t) {
            const auto nodes = raw.nodesOfCell(raw.cells[t]);
            EXPECT_TRUE(std::equal(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                                   nodes.begin()));
            if (second) {
                EXPECT_EQ(nodes[3], mesh.triangleMidNodes[t][2]);
                EXPECT_EQ(nodes[4], mesh.triangleMidNodes[t][0]);
                EXPECT_EQ(nodes[5], mesh.triangleMidNodes[t][1]);
            }
        }
    }
}

TEST(WriteInp, CoordinatesFitIntoTwentyCharacters)
{
    Mesh mesh;
    mesh.nodes = {{-1.2345678901234567e-5, 1.0 / 3.0},
                  {-0.00012345678901234567, -1.7976931348623157e308},
                  {1e22, -4.9406564584124654e-324}};
    mesh.nodeOrigin.resize(3);
    mesh.triangles = {{0, 1, 2}};
    mesh.triangleRegion = {0};
    mesh.regions.resize(1);
    std::istringstream lines(formatInp(mesh));
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    EXPECT_EQ(line, "*NODE, NSET=Nall");
    for (const Vec2 expected : mesh.nodes) {
        std::getline(lines, line);
        const std::size_t first = line.find(", ") + 2;
        const std::size_t second = line.find(", ", first) + 2;
        const std::string x = line.substr(first, second - 2 - first);
        const std::string y = line.substr(second, line.find(", ", second) - second);
        EXPECT_LE(x.size(), 20U) << x;
        EXPECT_LE(y.size(), 20U) << y;
        EXPECT_NEAR(std::stod(x), expected.x, 1e-12 * std::fabs(expected.x));
        EXPECT_NEAR(std::strtod(y.c_str(), nullptr) / expected.y, 1.0, 1e-12);
    }
}

TEST(WriteInp, SetsForEveryGroup)
{
    const std::string text = formatInp(PlateMesh(9).mesh);
    for (const char* set : {"*ELSET, ELSET=Left\n", "*ELSET, ELSET=Right\n",
                            "*ELSET, ELSET=Plate\n", "*NSET, NSET=Border\n", "*NSET, NSET=Hole\n",
                            "*NSET, NSET=Seam\n", "*NSET, NSET=Corner\n"}) {
        EXPECT_NE(text.find(set), std::string::npos) << set;
    }
    // The seam of a 9 x 9 plate runs from below to the hole and on above it.
    EXPECT_NE(text.find("*ELEMENT, TYPE=S3, ELSET=Eall\n"), std::string::npos);
    const std::string seam = text.substr(text.find("NSET=Seam\n") + 10);
    const std::string members = seam.substr(0, seam.find('*'));
    EXPECT_EQ(std::ranges::count(members, ',') + 1, 8);
}

TEST(DeckNames, ArePlainAndUnique)
{
    const std::string longName(200, 'x');
    const std::vector<std::string_view> names {
        "Edge 1", "edge_1", "Größe", "7up", "", "Nall", "a,b*c=d", longName, longName};
    const std::vector<std::string> plain = deckNames(names, {"Nall"});
    EXPECT_EQ(plain[0], "Edge_1");
    EXPECT_EQ(plain[1], "edge_1_2");
    EXPECT_EQ(plain[2], "Gr__e");
    EXPECT_EQ(plain[3], "G_7up");
    EXPECT_EQ(plain[4], "G_");
    EXPECT_EQ(plain[5], "Nall_2");
    EXPECT_EQ(plain[6], "a_b_c_d");
    EXPECT_EQ(plain[7].size(), 80U);
    EXPECT_EQ(plain[8].size(), 80U);
    EXPECT_NE(plain[7], plain[8]);
}

TEST(WritePoly, RoundTrip)
{
    const PlateMesh plate(9);
    const CurveNetwork network = parsePoly(formatPoly(plate.mesh, nullptr), "a.poly");
    EXPECT_EQ(network.points, plate.mesh.nodes);
    ASSERT_EQ(network.curves.size(), plate.mesh.edges.size());
    for (std::size_t e = 0; e < network.curves.size(); ++e) {
        EXPECT_EQ(network.curves[e].start.value, plate.mesh.edges[e][0]);
        EXPECT_EQ(network.curves[e].end.value, plate.mesh.edges[e][1]);
        EXPECT_EQ(network.curves[e].marker, plate.mesh.edgeIsOutline[e] != 0 ? 1 : 2);
    }
    ASSERT_EQ(network.holes.size(), 1U);
    EXPECT_GT(network.holes[0].position.x, 3.0);
    EXPECT_LT(network.holes[0].position.x, 6.0);
    EXPECT_TRUE(network.regions.empty());
}

TEST(WritePoly, MarkersOfTheInputAndAttributes)
{
    Mesh mesh = PlateMesh(6).mesh;
    mesh.regions[1].attribute = 2.5;
    CurveNetwork input;
    input.curves.resize(3);
    input.curves[2].marker = -7;
    const CurveNetwork network = parsePoly(formatPoly(mesh, &input), "a.poly");
    for (std::size_t e = 0; e < network.curves.size(); ++e) {
        EXPECT_EQ(network.curves[e].marker, mesh.edgeCurves[e] == CurveId(2U) ? -7 : 0);
    }
    ASSERT_EQ(network.regions.size(), 2U);
    EXPECT_LT(network.regions[0].position.x, 3.0);
    EXPECT_EQ(network.regions[0].attribute, 0.0);
    EXPECT_GT(network.regions[1].position.x, 3.0);
    EXPECT_EQ(network.regions[1].attribute, 2.5);
}

TEST(WritePoly, OrderTwoLeavesMidNodesOut)
{
    const CurveNetwork network = parsePoly(formatPoly(secondOrderPlate(6), nullptr), "a.poly");
    EXPECT_EQ(network.points.size(), PlateMesh(6).mesh.nodes.size());
}

/// A mesh of unit cells where the text has an x, two triangles each; outline edges only.
Mesh meshOfCells(const std::vector<std::string>& rows)
{
    Mesh mesh;
    std::map<std::pair<int, int>, std::uint32_t> nodeAt;
    const auto node = [&](int x, int y) {
        const auto [at, isNew] =
            nodeAt.try_emplace({x, y}, static_cast<std::uint32_t>(mesh.nodes.size()));
        if (isNew) {
            mesh.nodes.push_back({static_cast<double>(x), static_cast<double>(y)});
        }
        return at->second;
    };
    std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back({a, b, c});
        directed.insert({{a, b}, {b, c}, {c, a}});
    };
    for (int y = 0; y < static_cast<int>(rows.size()); ++y) {
        for (int x = 0; x < static_cast<int>(rows[static_cast<std::size_t>(y)].size()); ++x) {
            if (rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == 'x') {
                add(node(x, y), node(x + 1, y), node(x + 1, y + 1));
                add(node(x, y), node(x + 1, y + 1), node(x, y + 1));
            }
        }
    }
    for (const auto& [a, b] : directed) {
        if (!directed.contains({b, a})) {
            mesh.edges.push_back({a, b});
            mesh.edgeIsOutline.push_back(1);
        }
    }
    return mesh;
}

TEST(HolePoints, OneInEveryHole)
{
    struct Case
    {
        std::vector<std::string> rows;
        std::set<std::pair<int, int>> holes; ///< cells that points are expected in, any of them
        std::size_t count;
    };
    const std::vector<Case> cases {
        {{"xxx", "xxx"}, {}, 0},
        {{"xxx", "x x", "xxx"}, {{1, 1}}, 1},
        {{"xxxx", "x xx", "xx x", "xxxx"}, {{1, 1}, {2, 2}}, 2}, // touch at a corner
        {{"xxxxx", "x   x", "x x x", "x   x", "xxxxx"},
         {{1, 1}, {2, 1}, {3, 1}, {1, 2}, {3, 2}, {1, 3}, {2, 3}, {3, 3}},
         1},                                                     // an island in the hole
        {{"xx xx", "xx xx"}, {}, 0},                             // two parts
        {{"xxx", "x x", "x x"}, {}, 0},                          // a bay
        {{" xx", "x x", "xx "}, {{1, 1}}, 1},                    // parts that touch around a hole
    };
    for (const Case& test : cases) {
        const std::vector<Vec2> points = holePoints(meshOfCells(test.rows));
        EXPECT_EQ(points.size(), test.count) << test.rows[1];
        std::set<std::pair<int, int>> found;
        for (Vec2 p : points) {
            const std::pair<int, int> cell {static_cast<int>(std::floor(p.x)),
                                            static_cast<int>(std::floor(p.y))};
            EXPECT_TRUE(test.holes.contains(cell)) << p.x << ' ' << p.y;
            EXPECT_TRUE(found.insert(cell).second);
        }
    }
}

TEST(ReadMsh, VersionTwo)
{
    const RawMesh raw = parseMsh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                 "$PhysicalNames\n1\n2 1 \"a\"\n$EndPhysicalNames\n"
                                 "$Nodes\n5\n10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 0\n50 .5 .5 0\n"
                                 "$EndNodes\n$Elements\n4\n1 15 2 0 1 10\n2 1 2 0 1 10 20\n"
                                 "7 2 2 1 1 10 20 50\n9 3 3 1 1 0 10 20 30 40\n$EndElements\n",
                                 "a.msh");
    ASSERT_EQ(raw.cells.size(), 3U);
    EXPECT_EQ(raw.cells[1].kind, CellKind::Triangle3);
    EXPECT_EQ(raw.cells[1].number, 7);
    EXPECT_EQ(raw.nodesOfCell(raw.cells[1])[2], 4U);
    EXPECT_EQ(raw.nodesOfCell(raw.cells[2]).size(), 4U);
}

TEST(ReadMsh, SaysFileLineAndReason)
{
    const auto refuse = [](const std::string& text, const std::string& expected) {
        expectError(ErrorKind::Unreadable, expected, [&] { parseMsh(text, "bad.msh"); });
    };
    const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    const std::string nodes = head + "$Nodes\n1\n1 0 0 0\n$EndNodes\n";
    refuse("", "it does not start with $MeshFormat");
    refuse("hello\n", "it does not start with $MeshFormat");
    refuse("$MeshFormat\n3.0 0 8\n", "MSH version '3.0' is not supported");
    refuse("$MeshFormat\n4.1 1 8\n", "binary MSH files are not supported");
    refuse(head + "$Nodes\n2\n1 0 0 0\n$EndNodes\n",
           "bad.msh:7: '$EndNodes' is not a whole number");
    refuse(head + "$Nodes\n2\n1 0 0 0\n1 0 0 0\n$EndNodes\n", "there are two nodes 1");
    refuse(head + "$Elements\n0\n$EndElements\n", "$Elements is repeated or in the wrong place");
    refuse(nodes, "the file has no $Elements");
    refuse(nodes + "$Elements\n1\n1 1 0 1 2\n$EndElements\n", "bad.msh:10: there is no node 2");
    refuse(nodes + "$Elements\n1\n1 4 0 1 1 1 1\n$EndElements\n",
           "element type 4 is not supported");
    refuse(nodes + "$Elements\n1\n1 2 0 1\n$EndElements\n", "the node number is missing");
    refuse(nodes + "junk\n", "a section such as $Nodes was expected");
}

TEST(ReadInp, KeywordsElementsAndContinuations)
{
    const RawMesh raw = parseInp("*HEADING\n three, words\n** comment\n*Node, nset=All\n"
                                 "1, 0., 0.\n2, 2., 0., 0.\n3, 0, 2\n4, 1, 0\n5, 1, 1\n6, 0, 1\n"
                                 "*NODE PRINT, NSET=All\nU\n*Element, elset=E, type=CPS6\n"
                                 "1, 1, 2, 3,\n4, 5, 6\n*ELEMENT,TYPE=B32\n7, 1, 4, 2\n"
                                 "*ELSET, ELSET=X\n1, 7\n*STEP\n*STATIC\n1., 1.\n*END STEP\n",
                                 "a.inp");
    EXPECT_EQ(raw.nodes.size(), 6U);
    ASSERT_EQ(raw.cells.size(), 2U);
    EXPECT_EQ(raw.cells[0].kind, CellKind::Triangle6);
    EXPECT_EQ(raw.nodesOfCell(raw.cells[0])[5], 5U);
    EXPECT_EQ(raw.cells[1].kind, CellKind::Edge3);
    EXPECT_EQ(raw.nodesOfCell(raw.cells[1])[2], 3U); // the mid node last
}

TEST(ReadInp, ElementTypes)
{
    for (const auto& [type, count] : std::map<std::string, int> {
             {"S3", 3}, {"s3r", 3}, {"STRI3", 3}, {"STRI65", 6}, {"CPE4R", 4}, {"CAX8", 8},
             {"M3D6", 6}, {"S8R5", 8}, {"T3D2", 2}, {"B31", 2}, {"CPEG4", 4}, {"DS4", 4}}) {
        std::string text =
            "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,0,2\n6,0,3\n7,0,4\n8,0,5\n*ELEMENT,TYPE=" + type +
            "\n1";
        for (int i = 1; i <= count; ++i) {
            text += ", " + std::to_string(i);
        }
        const RawMesh raw = parseInp(text + "\n", "a.inp");
        EXPECT_EQ(raw.nodesOfCell(raw.cells.at(0)).size(), static_cast<std::size_t>(count)) << type;
    }
}

TEST(ReadInp, SaysFileLineAndReason)
{
    const auto refuse = [](const std::string& text, const std::string& expected) {
        expectError(ErrorKind::Unreadable, expected, [&] { parseInp(text, "bad.inp"); });
    };
    const std::string nodes = "*NODE\n1,0,0\n2,1,0\n3,0,1\n";
    refuse("", "the file has no *NODE");
    refuse("*NODE\n1, 0\n", "bad.inp:2: the y coordinate is missing");
    refuse("*INCLUDE, INPUT=x\n", "*INCLUDE is not supported");
    refuse(nodes + "*ELEMENT, ELSET=A\n", "bad.inp:5: *ELEMENT has no TYPE");
    refuse(nodes + "*ELEMENT, TYPE=C3D4\n", "element type 'C3D4' is not supported");
    refuse(nodes + "*ELEMENT, TYPE=S3\n1,1,2,4\n", "bad.inp:6: there is no node 4");
    refuse(nodes + "*ELEMENT, TYPE=S3\n1,1,2,3,3\n", "has 3 nodes; more are given");
    refuse(nodes + "*ELEMENT, TYPE=S3\n1,1,2\n", "the file ends before the rest of an element");
}

TEST(ReadInp, SetsNameWhatExists)
{
    const std::string mesh = "*NODE\n1,0,0\n2,1,0\n30,0,1\n*ELEMENT,TYPE=S3,ELSET=Eall\n7,1,2,30\n";
    for (const char* sets : {"*NSET,NSET=N,GENERATE\n1,30,1\n", "*NSET, NSET=A\n1, 2,\n30\n",
                             "*Elset, elset=B\neALL, 7\n", "*NSET,NSET=A\n1\n*NSET,NSET=B\nA\n"}) {
        EXPECT_EQ(parseInp(mesh + sets, "a.inp").cells.size(), 1U) << sets;
    }
    const auto refuse = [&](const std::string& sets, const std::string& expected) {
        expectError(ErrorKind::Unreadable, expected, [&] { parseInp(mesh + sets, "bad.inp"); });
    };
    refuse("*NSET,NSET=A\n1,2\n3\n", "bad.inp:9: the set names node 3, which does not exist");
    refuse("*NSET,NSET=A,GENERATE\n1,31,1\n", "bad.inp:8: the set names node 31");
    refuse("*ELSET,ELSET=A\n8\n", "bad.inp:8: the set names element 8");
    refuse("*ELSET,ELSET=A\nB\n", "bad.inp:8: there is no element set 'B'");
}

TEST(ReadTextMesh, TruncatedAnywhereIsRefusedOrRead)
{
    const std::string msh = formatMsh(secondOrderPlate(3));
    const std::string inp = formatInp(secondOrderPlate(3));
    for (std::size_t length = 0; length + 1 < msh.size(); ++length) {
        EXPECT_FALSE(testing::succeedsOrIsRefused(
            [&] { parseMsh(std::string_view(msh).substr(0, length), "cut.msh"); }));
    }
    for (std::size_t length = 0; length < inp.size(); ++length) {
        testing::succeedsOrIsRefused(
            [&] { parseInp(std::string_view(inp).substr(0, length), "cut.inp"); });
    }
}

} // namespace
} // namespace tessera
