// SPDX-License-Identifier: MIT
#include "cli/run_program.h"
#include "io/read_text_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace tessera
{
namespace
{

using testing::Outcome;
using testing::Program;

/// A plate with a hole, and a second one that overlaps its right half.
const std::string kPlates = "POLYGON((0 0,10 0,10 6,0 6,0 0),(3 2,4 2,4 4,3 4,3 2))\n"
                            "POLYGON((6 1,9 1,9 5,6 5,6 1))\n";
/// Two plates with a slot of 0.2 between them inside, and the same slot as a gap outside.
const std::string kSlots = "POLYGON((0 0,10 0,10 1,0 1,0 0))\nPOLYGON((0 1.2,10 1.2,10 1.4,0 1.4,"
                           "0 1.2))\n";

class SizeOptions: public ::testing::Test
{
protected:
    Program program;

    /// Mean length of the mesh edges whose middle is chosen.
    double meshed(std::vector<std::string> arguments, const std::function<bool(Vec2)>& chosen)
    {
        arguments.insert(arguments.begin(), {"mesh", "a.wkt", "-o", "out.msh", "--quiet"});
        const Outcome outcome = program.run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        const RawMesh mesh = parseMsh(program.text("out.msh"), "out.msh");
        double sum = 0.0;
        double count = 0.0;
        for (const RawMesh::Cell& cell : mesh.cells) {
            const auto nodes = mesh.nodesOfCell(cell);
            for (std::size_t i = 0; cell.kind == CellKind::Triangle3 && i < 3; ++i) {
                const auto& p = mesh.nodes[nodes[i]];
                const auto& q = mesh.nodes[nodes[(i + 1) % 3]];
                const Vec2 a {p[0], p[1]};
                const Vec2 b {q[0], q[1]};
                if (chosen(midpoint(a, b))) {
                    sum += distance(a, b);
                    ++count;
                }
            }
        }
        EXPECT_GT(count, 0.0);
        return sum / count;
    }
    static std::function<bool(Vec2)> near(Vec2 place, double radius)
    {
        return [=](Vec2 p) { return distance(p, place) < radius; };
    }
    void refuse(const std::vector<std::string>& options, const std::string& text)
    {
        std::vector<std::string> arguments {"mesh", "a.wkt", "-o", "out.msh"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        program.refuse(arguments, text);
    }
};

TEST_F(SizeOptions, AtPointsAndOnCurves)
{
    program.give("a.wkt", kPlates);
    const std::vector<std::string> coarse {"--size", "1"};
    EXPECT_NEAR(meshed({"--size", "1", "--size-at", "1,1,0.05,0.3", "--size-at", "1,5,0.1,0.3"},
                       near({1, 1}, 0.25)),
                0.05, 0.01);
    EXPECT_NEAR(meshed({"--size", "1", "--size-at", "1,1,0.05,0.3", "--size-at", "1,5,0.1,0.3"},
                       near({1, 5}, 0.25)),
                0.1, 0.02);
    // From 0.1 at 0.5 to 0.4 at 3.5: a tenth of the distance.
    EXPECT_NEAR(meshed({"--size", "1", "--size-at", "6,3,0.1,0.5,0.4,3.5"}, near({6, 5}, 0.5)),
                0.25, 0.06);
    EXPECT_NEAR(meshed({"--size", "1", "--size-on", "2:0.1,0.3"},
                       [](Vec2 p) { return std::abs(p.x - 6.0) < 0.25 && p.y > 1 && p.y < 5; }),
                0.1, 0.02);
    EXPECT_NEAR(meshed({"--size", "0.8", "--size-on", "1,2:0.2"}, near({10, 3}, 0.2)), 0.2, 0.05);
}

TEST_F(SizeOptions, InOperandsAndRegions)
{
    program.give("a.wkt", kPlates);
    const auto inSecond = [](Vec2 p) { return p.x > 6.3 && p.x < 8.7 && p.y > 1.3 && p.y < 4.7; };
    const auto farFromSecond = [](Vec2 p) { return p.x < 2.0; };
    const std::vector<std::string> options {"--size", "1", "--size-in", "2:0.15"};
    EXPECT_NEAR(meshed(options, inSecond), 0.15, 0.02);
    EXPECT_GT(meshed(options, farFromSecond), 0.6);
    const std::vector<std::string> around {"--size", "1", "--size-in", "1,1,0.15"};
    EXPECT_NEAR(meshed(around, farFromSecond), 0.15, 0.02);
    EXPECT_GT(meshed(around, inSecond), 0.3);
}

TEST_F(SizeOptions, AcrossGapsThatAreInside)
{
    program.give("a.wkt", kSlots);
    // The lower plate is 1 wide, the upper one 0.2, the slot between them is not meshed.
    const auto upper = [](Vec2 p) { return p.y > 1.25 && p.y < 1.35 && p.x > 1 && p.x < 9; };
    EXPECT_NEAR(meshed({"--size", "0.5", "--gap", "4"}, upper), 0.05, 0.01);
    EXPECT_GT(meshed({"--size", "0.5", "--gap", "1"}, upper), 0.12);
    const auto lower = [](Vec2 p) { return p.y > 0.3 && p.y < 0.7 && p.x > 1 && p.x < 9; };
    EXPECT_NEAR(meshed({"--size", "0.5", "--gap", "4"}, lower), 0.25, 0.05);
}

TEST_F(SizeOptions, ByExpressionAndFromAMesh)
{
    program.give("a.wkt", kPlates);
    const std::vector<std::string> byText {"--size", "1", "--size-expr", "0.1 + 0.05*x"};
    EXPECT_NEAR(meshed(byText, near({1, 3}, 0.4)), 0.15, 0.03);
    EXPECT_NEAR(meshed(byText, near({8, 3}, 0.6)), 0.5, 0.08);
    // Sizes that hardly grow beside each other are limited by the growth rate.
    EXPECT_LT(meshed({"--size", "1", "--growth", "0.1", "--size-expr", "x < 5 ? 0.1 : 1"},
                     near({7, 3}, 0.5)),
              0.4);
    program.give("b.vtu",
                 "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" "
                 "NumberOfCells=\"1\"><PointData><DataArray type=\"Float64\" Name=\"h\" "
                 "format=\"ascii\">0.1 1 1 0.1</DataArray></PointData><Points><DataArray "
                 "type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 10 0 0 10 6 0 0 6 "
                 "0</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" "
                 "format=\"ascii\">0 1 2 3</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
                 "format=\"ascii\">4</DataArray><DataArray type=\"UInt8\" Name=\"types\" "
                 "format=\"ascii\">9</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>");
    EXPECT_NEAR(meshed({"--size", "2", "--size-from", "b.vtu:h"}, near({1, 3}, 0.4)), 0.19, 0.04);
}

TEST_F(SizeOptions, ByCurvatureAndChordError)
{
    program.give("a.wkt", kPlates);
    // Straight curves: no difference.
    const auto all = [](Vec2) { return true; };
    EXPECT_EQ(meshed({"--size", "0.5", "--curvature", "60", "--chord-error", "0.001"}, all),
              meshed({"--size", "0.5"}, all));
    refuse({"--curvature", "2"}, "between 3 and 10000");
    refuse({"--chord-error", "-1"}, "--chord-error is -1");
    refuse({"--gap", "0"}, "--gap is 0");
}

TEST_F(SizeOptions, RefusedInOneLine)
{
    program.give("a.wkt", kPlates);
    refuse({"--size-at", "1,2"}, "--size-at is given as '1,2'; write X,Y,H");
    refuse({"--size-at", "1,2,x"}, "write X,Y,H");
    refuse({"--size-at", "1,2,nan"}, "write X,Y,H");
    refuse({"--size-at", "1,2,-3"}, "sizes must be above 0");
    refuse({"--size-at", "1,2,0.1,1,0.05,2"}, "not less than H and R");
    refuse({"--size-on", "1"}, "write LIST:H");
    refuse({"--size-on", "1,a:2"}, "write LIST:H");
    refuse({"--size-on", "7:1"}, "number 7 that --size-on lists");
    refuse({"--size-in", "1"}, "write LIST:H");
    refuse({"--size-in", "0:1"}, "write LIST:H");
    refuse({"--size-in", "3:1"}, "there are only 2");
    program.give("line.wkt", std::string(kPlates) + "LINESTRING(1 1,3 2)\n");
    program.refuse({"mesh", "line.wkt", "-o", "out.vtu", "--size-in", "3:0.1"},
                   "operand 3, which encloses nothing", 1);
    refuse({"--size-expr", "y=2"}, "did you mean ==?");
    refuse({"--size-in", "3.5,3,1"}, "is not inside");
    refuse({"--size-in", "1:0"}, "sizes must be above 0");
    refuse({"--size-expr", "1+"}, "cannot be read");
    refuse({"--size-expr", "x - 5"}, "is -5 at (0, 0); it must be a number above 0");
    refuse({"--size-expr", "1/(x-x)"}, "is inf at");
    refuse({"--size-from", "a.vtu"}, "not of that form");
    refuse({"--size-from", "none.vtu:h"}, "none.vtu");
    // As many triangles as no memory holds: refused before they are made.
    refuse({"--size-expr", "1e-7"}, "choose a larger size");
    refuse({"--size-at", "5,5,1e-7,0.5"}, "choose a larger size");
    refuse({"--size-in", "2:1e-6"}, "choose a larger size");
}

} // namespace
} // namespace tessera
