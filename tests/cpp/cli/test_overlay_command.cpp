// SPDX-License-Identifier: MIT
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tessera
{
namespace
{

using nlohmann::json;
using testing::Outcome;
using testing::Program;

/// Two squares, 16 and 8, that share 4.
const std::string kTwo = "POLYGON((0 0,4 0,4 4,0 4,0 0))\nPOLYGON((2 1,6 1,6 3,2 3,2 1))\n";

class OverlayCommand: public ::testing::Test
{
protected:
    Program program;

    json overlay(std::vector<std::string> arguments, const std::string& output = "out.wkt")
    {
        arguments.insert(arguments.begin(), "overlay");
        arguments.insert(arguments.end(), {"-o", output, "--report", "out.json"});
        const Outcome outcome = program.run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return program.json("out.json");
    }
};

TEST_F(OverlayCommand, EveryOperation)
{
    program.give("two.wkt", kTwo);
    EXPECT_EQ(overlay({"two.wkt"}).at("area"), 20.0);
    EXPECT_EQ(overlay({"two.wkt", "--op", "union"}).at("area"), 20.0);
    EXPECT_EQ(overlay({"two.wkt", "--op", "intersection"}).at("area"), 4.0);
    EXPECT_EQ(overlay({"two.wkt", "--op", "difference"}).at("area"), 12.0);
    const json both = overlay({"two.wkt", "--op", "xor"});
    EXPECT_EQ(both.at("area"), 16.0);
    EXPECT_EQ(both.at("regions"), 2);
    EXPECT_EQ(both.at("theta").at("o"), 4.0);
    EXPECT_EQ(both.at("theta").at("t"), 12.0);
    EXPECT_EQ(both.at("theta").at("s"), 4.0);
    EXPECT_EQ(program.text("out.wkt").substr(0, 14), "MULTIPOLYGON (");
}

TEST_F(OverlayCommand, CellsAreLinesInTheOrderOfTheReport)
{
    program.give("two.wkt", kTwo + "LINESTRING(-1 2, 7 2)\n");
    const json report = overlay({"two.wkt", "--op", "cells"});
    ASSERT_EQ(report.at("cells").size(), 6U);
    double area = 0.0;
    double shared = 0.0;
    for (const json& cell : report.at("cells")) {
        area += cell.at("area").get<double>();
        shared += cell.at("operands") == json::array({1, 2}) ? cell.at("area").get<double>() : 0.0;
    }
    EXPECT_EQ(area, 20.0);
    EXPECT_EQ(shared, 4.0);
    const std::string text = program.text("out.wkt");
    EXPECT_EQ(std::ranges::count(text, '\n'), 6);
    // Each line by itself has its entry's area.
    std::size_t begin = 0;
    for (const json& cell : report.at("cells")) {
        const std::size_t end = text.find('\n', begin);
        program.give("cell.wkt", text.substr(begin, end - begin));
        const Outcome outcome =
            program.run({"overlay", "cell.wkt", "-o", "again.wkt", "--report", "cell.json"});
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(program.json("cell.json").at("area"), cell.at("area"));
        begin = end + 1;
    }
}

TEST_F(OverlayCommand, SeveralFilesTenThousandLinesAndPriorities)
{
    program.give("two.wkt", kTwo);
    program.give("one.wkt", "POLYGON((0 0,4 0,4 4,0 4,0 0))\n");
    program.give("other.wkt", "POLYGON((2 1,6 1,6 3,2 3,2 1))\n");
    EXPECT_EQ(overlay({"one.wkt", "other.wkt", "--op", "difference"}).at("area"), 12.0);
    const json first = overlay({"two.wkt", "--priority", "first"});
    EXPECT_EQ(first.at("cells").at(0).at("area"), 16.0);
    EXPECT_EQ(first.at("cells").at(1).at("area"), 4.0);

    std::string many;
    for (int i = 0; i < 10000; ++i) {
        const std::string x = std::to_string(i % 100);
        const std::string y = std::to_string(i / 100);
        const std::string x2 = std::to_string(i % 100 + 1) + ".5";
        const std::string y2 = std::to_string(i / 100 + 1) + ".5";
        many += "POLYGON((" + x + " " + y + "," + x2 + " " + y + "," + x2 + " " + y2 + "," + x
            + " " + y2 + "," + x + " " + y + "))\n";
    }
    program.give("many.wkt", many);
    const json cells = overlay({"many.wkt", "--op", "cells"});
    EXPECT_EQ(cells.at("input").at("operands"), 10000);
    EXPECT_EQ(cells.at("area"), 100.5 * 100.5);
    EXPECT_EQ(cells.at("cells").size(), 199U * 199U);
}

TEST_F(OverlayCommand, NothingLeftIsAnEmptyCollection)
{
    program.give("apart.wkt", "POLYGON((0 0,1 0,1 1,0 0))\nPOLYGON((5 0,6 0,6 1,5 0))\n");
    const json report = overlay({"apart.wkt", "--op", "intersection"});
    EXPECT_EQ(report.at("area"), 0.0);
    EXPECT_EQ(report.at("regions"), 0);
    EXPECT_EQ(program.text("out.wkt"), "GEOMETRYCOLLECTION EMPTY\n");
    program.give("line.wkt", "LINESTRING(0 0,1 0,1 1,0 0)\n");
    overlay({"line.wkt"});
    EXPECT_EQ(program.text("out.wkt"), "GEOMETRYCOLLECTION EMPTY\n");
}

TEST_F(OverlayCommand, OtherFormatsAndTheReportsKeys)
{
    program.give("two.wkt", kTwo);
    for (const std::string output : {"out.poly", "out.svg", "out.png", "out.vtu", "out.inp"}) {
        overlay({"two.wkt"}, output);
        EXPECT_TRUE(program.has(output));
    }
    const Outcome check = program.run({"check", "out.vtu"});
    EXPECT_EQ(check.status, 0) << check.err;
    const json report = overlay({"out.poly", "--recovery", "steiner"});
    EXPECT_EQ(report.at("area"), 20.0);
    for (const char* key :
         {"version", "input", "crossings", "touches", "overlaps", "steiner_inserted",
          "steiner_removed", "regions", "vertices", "triangles", "quads", "area", "region_areas",
          "cells", "max_displacement", "snap_pixel", "weld", "seconds", "peak_memory_bytes"}) {
        EXPECT_TRUE(report.contains(key)) << key;
    }
    double stages = 0.0;
    for (const auto& [stage, seconds] : report.at("seconds").items()) {
        stages += stage == "total" ? 0.0 : seconds.get<double>();
    }
    EXPECT_LE(stages, report.at("seconds").at("total").get<double>() * 1.0001);
}

TEST_F(OverlayCommand, PicturesOfThePapersFigures)
{
    const std::filesystem::path examples =
        std::filesystem::path(TESSERA_SOURCE_DIR) / "resources" / "examples";
    const json polygons = overlay(
        {(examples / "two_polygons.wkt").string(), "--op", "cells", "--stages", "two"});
    EXPECT_EQ(polygons.at("crossings"), 2);
    EXPECT_EQ(polygons.at("cells").size(), 3U);
    const json star = overlay(
        {(examples / "self_intersecting.wkt").string(), "--op", "cells", "--stages", "star"});
    EXPECT_EQ(star.at("crossings"), 15);
    // Five tips, five arms within the square, six parts of the square only.
    EXPECT_EQ(star.at("cells").size(), 16U);
    for (const std::string folder : {"two", "star"}) {
        for (const std::string name :
             {"0-loops", "1-rectangle", "2-points", "3-before-recovery", "4-recovered", "5-colors",
              "5-theta-o", "5-theta-t", "5-theta-s"}) {
            EXPECT_TRUE(program.has(folder + "/" + name + ".svg"));
            EXPECT_TRUE(program.has(folder + "/" + name + ".png"));
        }
    }
}

TEST_F(OverlayCommand, WhatIsWrongIsSaidInOneLine)
{
    program.give("two.wkt", kTwo);
    program.refuse({"overlay", "two.wkt", "-o", "out.wkt", "--op", "minus"}, "'minus' is not one of", 2);
    program.refuse({"overlay", "two.wkt", "-o", "out.abc"}, "should end in .wkt", 2);
    program.refuse({"overlay", "missing.wkt", "-o", "out.wkt"}, "missing.wkt", 1);
    program.refuse({"overlay", "two.wkt", "-o", "out.wkt", "--weld", "-1"}, "--weld", 1);
    program.refuse({"overlay", "two.wkt", "-o", "out.wkt", "--fill", "hull"}, "hull", 1);
    const std::string wrong =
        program.run({"overlay", "two.wkt", "-o", "out.wkt", "--fill", "some"}).err;
    EXPECT_NE(wrong.find("is not one of all, even-odd, negative, nonzero, positive"),
              std::string::npos)
        << wrong;
    const Outcome late =
        program.run({"overlay", "two.wkt", "-o", "out.wkt", "--time-limit", "1e-9"});
    EXPECT_EQ(late.status, 3);
    EXPECT_EQ(late.err.find("size"), std::string::npos) << late.err;
}

} // namespace
} // namespace tessera
