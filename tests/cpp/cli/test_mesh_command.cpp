// SPDX-License-Identifier: MIT
#include "cli/run_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace tessera
{
namespace
{

using nlohmann::json;
using testing::Outcome;
using testing::Program;

const std::string kSquare = "4 2 0 0\n1 0 0\n2 10 0\n3 10 10\n4 0 10\n"
                            "4 1\n1 1 2 11\n2 2 3 12\n3 3 4 13\n4 4 1 14\n0\n";
/// A square and in it, not joined to it, a smaller one.
const std::string kNested = "8 2 0 0\n1 0 0\n2 10 0\n3 10 10\n4 0 10\n5 3 3\n6 6 3\n7 6 6\n8 3 6\n"
                            "8 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n"
                            "5 5 6 2\n6 6 7 2\n7 7 8 2\n8 8 5 2\n0\n";
/// A square and in it two lines 0.002 apart.
const std::string kSlit = "8 2 0 0\n1 0 0\n2 10 0\n3 10 10\n4 0 10\n5 3 5\n6 7 5\n7 3 5.002\n"
                          "8 7 5.002\n6 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n"
                          "5 5 6 2\n6 7 8 2\n0\n";
/// Two squares that overlap in a third of each.
const std::string kTwo = "POLYGON((0 0,6 0,6 6,0 6,0 0))\nPOLYGON((4 0,10 0,10 6,4 6,4 0))\n";

class MeshCommand: public ::testing::Test
{
protected:
    Program program;

    /// Meshes and returns the report.
    json mesh(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.begin(), "mesh");
        arguments.insert(arguments.end(), {"-o", "out.vtu", "--report", "out.json"});
        const Outcome outcome = program.run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        const Outcome check = program.run({"check", "out.vtu"});
        EXPECT_EQ(check.status, 0) << check.err;
        return program.json("out.json");
    }
    /// One line on stderr with text in it, the status, and nothing written.
};

TEST_F(MeshCommand, CountFindsTheSizeAndThreadsChangeNothing)
{
    program.give("a.poly", kSquare);
    const json report = mesh({"a.poly", "--count", "3000", "--threads", "2"});
    EXPECT_NEAR(report["triangles"].get<double>(), 3000.0, 150.0);
    EXPECT_EQ(report["count"]["reached"], report["triangles"]);
    const json one = mesh({"a.poly", "--count", "3000", "--threads", "1"});
    EXPECT_EQ(one["mean_quality"], report["mean_quality"]);
    EXPECT_EQ(one["worst"], report["worst"]);
    program.refuse({"mesh", "a.poly", "-o", "b.vtu", "--count", "3000", "--size", "1"}, "exclude each other");
    program.refuse({"mesh", "a.poly", "-o", "b.vtu", "--count", "2.5"}, "--count is 2.5");
    program.refuse({"mesh", "a.poly", "-o", "b.vtu", "--threads", "0"}, "--threads is 0");
}

TEST_F(MeshCommand, FrozenBoundariesKeepTheirSegments)
{
    program.give("a.poly", kSquare);
    const json report = mesh({"a.poly", "--size", "1", "--freeze-boundary"});
    EXPECT_GT(report["triangles"], 50);
    const Outcome outcome = program.run({"mesh", "a.poly", "-o", "b.poly", "--size", "1",
                                         "--freeze-boundary", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
}

TEST_F(MeshCommand, NarrowGapsTakeTheShareThatTheyMay)
{
    program.give("a.poly", kSlit);
    const json coarse = mesh({"a.poly", "--size", "0.5", "--narrow-gaps", "0"});
    EXPECT_TRUE(coarse["messages"].empty());
    const json fine = mesh({"a.poly", "--size", "0.5", "--narrow-gaps", "40"});
    EXPECT_GT(fine["triangles"], 2 * coarse["triangles"].get<int>());
    ASSERT_EQ(fine["messages"].size(), 1U);
    const Outcome outcome = program.run(
        {"mesh", "a.poly", "-o", "b.vtu", "--size", "0.5", "--narrow-gaps", "40"});
    const std::string message = fine["messages"][0];
    EXPECT_EQ(outcome.out.substr(0, message.size() + 1), message + "\n");
    const json welded
        = mesh({"a.poly", "--size", "0.5", "--narrow-gaps", "40", "--weld", "0.01"});
    EXPECT_LT(welded["triangles"], 2 * coarse["triangles"].get<int>());
    for (const json& text : welded["messages"]) {
        EXPECT_EQ(text.get<std::string>().find("narrow"), std::string::npos) << text;
    }
}

TEST_F(MeshCommand, ReportHasAllKeys)
{
    program.give("a.poly", kSquare);
    const json report = mesh({"a.poly", "--size", "1"});
    for (const char* key :
         {"version", "input", "crossings", "touches", "overlaps", "steiner_inserted",
          "steiner_removed", "regions", "vertices", "triangles", "quads", "area", "region_areas",
          "min_angle_deg", "max_angle_deg", "angle_p01_deg", "min_quality", "mean_quality",
          "size_conformity", "max_displacement", "snap_pixel", "unreached", "default_size", "weld",
          "seconds", "peak_memory_bytes"}) {
        EXPECT_TRUE(report.contains(key)) << key;
    }
    std::set<std::string> stages;
    double sum = 0.0;
    for (const auto& [stage, seconds] : report["seconds"].items()) {
        stages.insert(stage);
        sum += stage == "total" ? 0.0 : seconds.get<double>();
    }
    EXPECT_EQ(stages, (std::set<std::string> {"read", "arrange", "sample", "triangulate", "recover",
                                              "color", "refine", "optimize", "extract", "write",
                                              "total"}));
    EXPECT_NEAR(sum, report["seconds"]["total"].get<double>(),
                0.05 * report["seconds"]["total"].get<double>());
    EXPECT_EQ(report["input"],
              (json{{"points", 4}, {"segments", 4}, {"curves", 4}, {"operands", 1}}));
    for (const char* key : {"min", "p05", "median", "p95", "max"}) {
        EXPECT_TRUE(report["size_conformity"].contains(key)) << key;
    }
    EXPECT_GT(report["peak_memory_bytes"].get<double>(), 1e6);
    EXPECT_NEAR(report["area"].get<double>(), 100.0, 1e-9);
    EXPECT_EQ(report["regions"], 1);
    EXPECT_NEAR(report["default_size"].get<double>(), std::sqrt(200.0) / 40.0, 1e-12);
    EXPECT_GT(report["triangles"].get<int>(), 150);
    EXPECT_GE(report["min_angle_deg"].get<double>(), 25.0);
}

TEST_F(MeshCommand, SizesAndBounds)
{
    program.give("a.poly", kSquare);
    const int coarse = mesh({"a.poly", "--size", "2"})["triangles"];
    const int fine = mesh({"a.poly", "--size", "0.5"})["triangles"];
    const int bounded = mesh({"a.poly", "--size", "2", "--max-area", "0.2"})["triangles"];
    EXPECT_GT(fine, 8 * coarse);
    EXPECT_GE(bounded, 500);
    const json plain = mesh({"a.poly", "--no-refine"});
    EXPECT_EQ(plain["triangles"], 2);
    EXPECT_EQ(plain["vertices"], 4);
}

TEST_F(MeshCommand, OrderTwo)
{
    program.give("a.poly", kSquare);
    const json one = mesh({"a.poly", "--size", "2"});
    const json two = mesh({"a.poly", "--size", "2", "--order", "2"});
    EXPECT_EQ(one["triangles"], two["triangles"]);
    EXPECT_GT(two["vertices"].get<int>(), 3 * one["vertices"].get<int>());
}

TEST_F(MeshCommand, FillRules)
{
    program.give("a.poly", kNested);
    const auto area = [&](const std::string& fill) {
        return mesh({"a.poly", "--no-refine", "--fill", fill})["area"].get<double>();
    };
    EXPECT_NEAR(area("even-odd"), 91.0, 1e-9);
    EXPECT_NEAR(area("nonzero"), 100.0, 1e-9);
    EXPECT_NEAR(area("positive"), 100.0, 1e-9);
    EXPECT_NEAR(area("all"), 100.0, 1e-9);
    EXPECT_NEAR(area("hull"), 100.0, 1e-9);
    program.refuse({"mesh", "a.poly", "-o", "x.vtu", "--fill", "negative"}, "");
}

TEST_F(MeshCommand, RolesByMarkerAndLine)
{
    program.give("a.poly", kNested);
    EXPECT_NEAR(mesh({"a.poly", "--no-refine", "--constraint", "2"})["area"].get<double>(), 100.0,
                1e-9);
    EXPECT_NEAR(mesh({"a.poly", "--no-refine", "--constraint", "1"})["area"].get<double>(), 9.0,
                1e-9);
    program.give("a.wkt", "POLYGON((0 0,10 0,10 10,0 10,0 0))\nLINESTRING(2 2,4 2,4 4,2 2)\n");
    EXPECT_EQ(mesh({"a.wkt", "--no-refine"})["regions"], 1);
    EXPECT_EQ(mesh({"a.wkt", "--no-refine", "--boundary", "2"})["regions"], 2);
    EXPECT_NEAR(mesh({"a.poly", "--no-refine", "--ignore", "2"})["area"].get<double>(), 100.0, 1e-9);
    EXPECT_NEAR(mesh({"a.poly", "--no-refine", "--ignore", "1"})["area"].get<double>(), 9.0, 1e-9);
    EXPECT_EQ(mesh({"a.wkt", "--no-refine", "--boundary", "2", "--ignore", "1"})["area"], 2.0);
    program.refuse({"mesh", "a.poly", "-o", "x.vtu", "--constraint", "2,7"}, "number 7");
}

TEST_F(MeshCommand, EdgeNumbersOfSeveralShapes)
{
    program.give("a.wkt", "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (4 4, 6 4, 6 6, 4 6, 4 4))\n");
    program.give("b.wkt", "POLYGON ((20 0, 25 0, 25 5, 20 5, 20 0))\n");
    for (const char* name : {"a", "b"}) {
        const std::string stem = name;
        ASSERT_EQ(program.run({"overlay", stem + ".wkt", "-o", stem + ".brep"}).status, 0);
    }
    EXPECT_NEAR(mesh({"a.brep", "b.brep"})["area"].get<double>(), 121.0, 1e-9);
    // Only the first shape has that many edges: its hole.
    EXPECT_NEAR(mesh({"a.brep", "b.brep", "--constraint", "5,6,7,8"})["area"].get<double>(), 125.0,
                1e-9);
    program.refuse({"mesh", "a.brep", "b.brep", "-o", "x.vtu", "--constraint", "9"}, "number 9");
    program.refuse({"mesh", "b.brep", "-o", "x.vtu", "--constraint", "5"}, "has 4 edges");
}

TEST_F(MeshCommand, AGapIsNamedAndClosedByTheWeldTolerance)
{
    program.give("gap.poly", "5 2 0 0\n1 0 0\n2 10 0\n3 10 10\n4 0 10\n5 0 0.1\n"
                             "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n0\n");
    program.refuse({"mesh", "gap.poly", "-o", "x.vtu"}, "(0, 0) and (0, 0.1), 0.1 apart");
    const auto report = mesh({"gap.poly", "--weld", "0.2"});
    EXPECT_NEAR(report["area"].get<double>(), 100.0, 1e-9);
    EXPECT_EQ(report["welded"], 1);
    EXPECT_EQ(report["weld"], 0.2);
    EXPECT_NE(report["messages"][0].get<std::string>().find("joined"), std::string::npos);
}

TEST_F(MeshCommand, OperandsOfSeveralInputs)
{
    program.give("a.wkt", kTwo);
    program.give("b.poly", kSquare);
    const json report = mesh({"a.wkt", "b.poly", "--no-refine"});
    EXPECT_EQ(report["input"]["operands"], 3);
    EXPECT_NEAR(report["area"].get<double>(), 100.0, 1e-9);
    const json two = mesh({"a.wkt", "--no-refine"});
    EXPECT_EQ(two["regions"], 3);
    EXPECT_NEAR(two["area"].get<double>(), 60.0, 1e-9);
    std::vector<double> areas = two["region_areas"];
    std::ranges::sort(areas);
    EXPECT_NEAR(areas[0], 12.0, 1e-9);
    EXPECT_NEAR(areas[2], 24.0, 1e-9);
    EXPECT_EQ(two["overlaps"], 2); // above and below the part in common
}

TEST_F(MeshCommand, BothRecoveries)
{
    program.give("a.wkt",
                 "POLYGON((0 0,8 0,8 8,0 8,0 0))\nLINESTRING(-1 1,9 7)\nLINESTRING(2 9,6 -1)\n");
    const json cavity = mesh({"a.wkt", "--no-refine"});
    const json steiner = mesh({"a.wkt", "--no-refine", "--recovery", "steiner"});
    EXPECT_EQ(cavity["crossings"], 5);
    EXPECT_EQ(steiner["crossings"], 5);
    EXPECT_EQ(cavity["steiner_inserted"], 0);
    EXPECT_EQ(steiner["steiner_inserted"].get<int>() - steiner["steiner_removed"].get<int>(), 5);
    EXPECT_NEAR(steiner["area"].get<double>(), 64.0, 1e-9);
}

TEST_F(MeshCommand, NoInsideIsRefusedUnlessAllOrHull)
{
    program.give("line.wkt", "LINESTRING(0 0,1 1,2 0)\n");
    program.give("points.wkt", "MULTIPOINT(0 0,1 0,0 1,2 2)\n");
    program.give("flat.wkt", "POLYGON((0 0,1 1,2 2,0 0))\n");
    program.give("empty.wkt", "POLYGON EMPTY\n");
    program.give("nothing.wkt", "");
    for (const char* file : {"line.wkt", "points.wkt", "flat.wkt", "empty.wkt", "nothing.wkt"}) {
        program.refuse({"mesh", file, "-o", "x.vtu"}, "tessera: ");
    }
    for (const char* fill : {"all", "hull"}) {
        const Outcome outcome = program.run(
            {"mesh", "flat.wkt", "-o", "out.vtu", "--fill", fill, "--report", "out.json"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(program.json("out.json")["regions"], 0);
    }
    EXPECT_NEAR(mesh({"points.wkt", "--fill", "hull"})["area"].get<double>(), 2.0, 1e-12);
}

TEST_F(MeshCommand, BadOptions)
{
    program.give("a.poly", kSquare);
    const auto with = [](const std::vector<std::string>& more) {
        std::vector<std::string> arguments {"mesh", "a.poly", "-o", "x.vtu"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    };
    for (const char* bad : {"0", "-1", "nan", "inf"}) {
        program.refuse(with({"--size", bad}), "--size");
        program.refuse(with({"--min-size", bad}), "--min-size");
        program.refuse(with({"--max-area", bad}), "--max-area");
        program.refuse(with({"--time-limit", bad}), "--time-limit");
    }
    program.refuse(with({"--weld", "-1"}), "--weld");
    for (const char* bad : {"-1", "nan", "inf"}) {
        program.refuse(with({"--narrow-gaps", bad}), "--narrow-gaps");
    }
    program.refuse(with({"--growth", "0"}), "growth");
    program.refuse(with({"--growth", "nan"}), "growth");
    program.refuse(with({"--min-angle", "40"}), "angle");
    program.refuse(with({"--size", "1e-9"}), "memory");
    program.refuse(with({"--max-area", "1e-30"}), "1e+12 triangles or more");
    for (const auto& wrong : std::vector<std::vector<std::string>> {
             {"--size", "small"}, {"--size"}, {"--order", "3"}, {"--fill", "some"}, {"--fill", "3"},
             {"--recovery", "none"}, {"--constraint", "1,x"}, {"--no-such-option"},
             {"--elements", "quad"}}) {
        program.refuse(with(wrong), "--help", 2);
    }
    program.refuse({"mesh", "a.poly"}, "--output is required", 2);
    program.refuse({"mesh", "-o", "x.vtu"}, "INPUT is required", 2);
    program.refuse({"mesh", "a.poly", "-o", "x.obj"}, "should end in .vtu", 2);
    program.refuse({"mesh", "a.poly", "-o", "x"}, "should end in .vtu", 2);
    program.refuse({}, "--help", 2);
    program.refuse({"meshes"}, "There is no command meshes; the commands are mesh, ", 2);
    program.refuse({"--size", "1"}, "There is no option --size; the commands are", 2);
    program.refuse(with({"--order", "1.5"}), "--order: '1.5' is not one of 1, 2", 2);
    program.refuse(with({"--size", "abc"}), "--size: 'abc' is not a number", 2);
    program.refuse(with({"--size"}), "--size needs a value", 2);
    program.refuse(with({"--size", "1", "--size", "2"}), "--size is given more than once", 2);
    for (const char* option : {"--size", "--weld", "--report", "--stages", "--time-limit",
                               "--boundary", "--size-at", "--size-expr"}) {
        program.refuse(with({option, ""}), std::string(option) + ": the value is empty", 2);
    }
    for (const char* list : {",", "1,", "1,,2", "a", "1.5", "99999999999"}) {
        program.refuse(with({"--boundary", list}), "is not a whole number", 2);
    }
    program.refuse(with({"--boundary", "11,99"}), "number 99");
}

TEST_F(MeshCommand, BadInputs)
{
    program.refuse({"mesh", "none.poly", "-o", "x.vtu"}, "none.poly: cannot be read: No such file");
    program.give("a.dxf", "0");
    program.refuse({"mesh", "a.dxf", "-o", "x.vtu"}, "a.dxf: files of this kind cannot be read");
    program.give("bad.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 1 nan\n");
    program.refuse({"mesh", "bad.poly", "-o", "x.vtu"}, "bad.poly:4: 'nan' is not a finite number");
    program.give("bad.wkt", "POLYGON((0 0,1 0,1 1,0 0))\nPOLYGON((0 0,1 0\n");
    program.refuse({"mesh", "bad.wkt", "-o", "x.vtu"}, "bad.wkt:");
    program.give("bad.brep", "CASCADE Topology V1, (c) Matra-Datavision\nLocations 1\n");
    program.refuse({"mesh", "bad.brep", "-o", "x.vtu"}, "bad.brep");
    program.give("bad.step", "ISO-10303-21;\nHEADER;\n");
    program.refuse({"mesh", "bad.step", "-o", "x.vtu"}, "bad.step");
    program.give("far.poly", "3 2 0 0\n1 0 0\n2 1e200 0\n3 1 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    program.refuse({"mesh", "far.poly", "-o", "x.vtu"}, "tessera: ");
}

TEST_F(MeshCommand, RegressionsAreMeshed)
{
    std::size_t files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(TESSERA_SOURCE_DIR "/tests/data/regressions")) {
        SCOPED_TRACE(entry.path());
        ++files;
        for (const char* option : {"--quiet", "--no-optimize"}) {
            // The limit ends what would never end; each takes a tenth of a second.
            const json report = mesh({entry.path().string(), option, "--time-limit", "60"});
            EXPECT_EQ(report["regions"], 1);
            EXPECT_LE(report["triangles"].get<int>(), 10000);
        }
    }
    EXPECT_GE(files, 4U);
}

TEST_F(MeshCommand, TruncatedInputIsRefusedOrMeshed)
{
    for (std::size_t length = 0; length < kSquare.size(); length += 3) {
        program.give("cut.poly", kSquare.substr(0, length));
        const Outcome outcome = program.run({"mesh", "cut.poly", "-o", "x.vtu", "--no-refine"});
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 1) << length << ' ' << outcome.status;
        EXPECT_EQ(outcome.errorLines(), outcome.status == 0 ? 0U : 1U) << outcome.err;
    }
}

TEST_F(MeshCommand, OutputsThatCannotBeWritten)
{
    program.give("a.poly", kSquare);
    program.refuse({"mesh", "a.poly", "-o", "none/x.vtu"}, "none/x.vtu: cannot be written: there is no folder none");
    program.refuse({"mesh", "a.poly", "-o", "x.vtu", "--report", "none/x.json"},
           "none/x.json: cannot be written");
    program.refuse({"mesh", "a.poly", "-o", "x.vtu", "--stages", "a.poly"}, "cannot be made");
    std::filesystem::create_directory(program.folder() / "x.vtu");
    program.refuse({"mesh", "a.poly", "-o", "x.vtu"}, "Is a directory");
}

TEST_F(MeshCommand, OutputsThatWouldReplaceAFileAreRefused)
{
    program.give("a.poly", kSquare);
    std::filesystem::create_symlink("a.poly", program.folder() / "link.poly");
    std::filesystem::create_directory(program.folder() / "sub");
    for (const char* name : {"a.poly", "./a.poly", "sub/../a.poly", "link.poly"}) {
        program.refuse({"mesh", "a.poly", "-o", name}, "would replace the input a.poly");
        program.refuse({"mesh", "a.poly", "-o", "x.vtu", "--report", name}, "would replace the input");
    }
    program.refuse({"mesh", "a.poly", "-o", "x.vtu", "--report", "./x.vtu"}, "are one file");
    program.refuse({"mesh", "a.poly", "-o", "sub/1-rectangle.svg", "--stages", "sub"},
           "in the folder of --stages");
    EXPECT_EQ(program.text("a.poly"), kSquare);
    EXPECT_EQ(program.run({"mesh", "a.poly", "-o", "x.vtu"}).status, 0);
    const std::string mesh = program.text("x.vtu");
    program.refuse({"check", "x.vtu", "--report", "x.vtu"}, "would replace the input");
    EXPECT_EQ(program.text("x.vtu"), mesh);
    // A device is nothing that could be replaced.
    EXPECT_EQ(program.run({"check", "x.vtu", "--report", "/dev/null"}).status, 0);
}

TEST_F(MeshCommand, LongNames)
{
    program.give("a.poly", kSquare);
    const std::string longest = std::string(251, 'x') + ".vtu";
    EXPECT_EQ(program.run({"mesh", "a.poly", "-o", longest}).status, 0);
    EXPECT_TRUE(program.has(longest));
    program.refuse({"mesh", "a.poly", "-o", "x" + longest}, "File name too long");
}

TEST_F(MeshCommand, WeldThatSwallowsTheDrawing)
{
    program.give("a.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))");
    for (const char* weld : {"10", "1"}) {
        program.refuse({"mesh", "a.wkt", "-o", "x.vtu", "--weld", weld},
               "The weld tolerance of " + std::string(weld)
                   + " leaves nothing of the drawing, which measures 1.41421");
    }
}

TEST_F(MeshCommand, HullOfOpenCurves)
{
    program.give("a.wkt", "LINESTRING(0 0,1 0,1 1,0.2 0.9)");
    const json open = mesh({"a.wkt", "--fill", "hull"});
    EXPECT_EQ(open["regions"], 1);
    EXPECT_NEAR(open["area"].get<double>(), 0.85, 1e-9);
    // Samples on slanted sides are off them by rounding; the slivers outside are no part of it.
    EXPECT_GE(open["min_angle_deg"].get<double>(), 25.0);
    program.give("b.wkt", "POLYGON((0 0,1 0.1,1.3 1,0.2 0.9,0 0))");
    const json closed = mesh({"b.wkt", "--fill", "hull"});
    EXPECT_EQ(closed["regions"], 1);
    EXPECT_GE(closed["min_angle_deg"].get<double>(), 25.0);
}

TEST_F(MeshCommand, PicturesCountForNoStage)
{
    program.give("a.poly", kSquare);
    const auto total = [this](const std::vector<std::string>& more) {
        std::vector<std::string> arguments {"a.poly", "--size", "0.1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const json seconds = mesh(arguments)["seconds"];
        double sum = 0.0;
        for (const auto& [stage, value] : seconds.items()) {
            sum += stage == "total" ? 0.0 : value.get<double>();
        }
        EXPECT_NEAR(sum, seconds["total"].get<double>(), 0.05 * seconds["total"].get<double>());
        return seconds["color"].get<double>();
    };
    // Coloring takes about a thousandth of the time that the pictures before and after it take.
    EXPECT_LT(total({"--stages", "pictures"}), total({}) + 0.05);
}

TEST_F(MeshCommand, FailureKeepsTheFileThatWasThere)
{
    program.give("out.vtu", "precious");
    program.give("line.wkt", "LINESTRING(0 0,1 1)");
    EXPECT_EQ(program.run({"mesh", "line.wkt", "-o", "out.vtu"}).status, 1);
    EXPECT_EQ(program.text("out.vtu"), "precious");
    EXPECT_EQ(program.folder().fileCount(), 2U);
}

TEST_F(MeshCommand, AllOutputFormats)
{
    program.give("a.wkt", kTwo + "LINESTRING(1 1,9 5)\nPOINT(2 4)\n");
    for (const char* extension : {"vtu", "vtk", "msh", "inp", "poly", "svg", "png", "VTU"}) {
        const std::string name = std::string("out.") + extension;
        const Outcome outcome = program.run({"mesh", "a.wkt", "-o", name, "--size", "1"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_GT(program.text(name).size(), 1000U) << name;
    }
    for (const char* name : {"out.vtu", "out.msh", "out.inp", "out.VTU"}) {
        const Outcome outcome = program.run({"check", name, "--report", "check.json"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NEAR(program.json("check.json")["area"].get<double>(), 60.0, 1e-9) << name;
    }
    EXPECT_NE(program.text("out.msh").find("\"Line1\""), std::string::npos);
    EXPECT_NE(program.text("out.msh").find("\"Line3_Edges\""), std::string::npos);
    EXPECT_NE(program.text("out.inp").find("NSET=Line4_Points\n"), std::string::npos);
    EXPECT_TRUE(program.text("out.svg").starts_with("<?xml"));
    EXPECT_TRUE(program.text("out.png").starts_with("\x89PNG"));
    // The mesh as drawing is a drawing of the same domain.
    EXPECT_NEAR(mesh({"out.poly", "--no-refine", "--fill", "all"})["area"].get<double>(), 60.0,
                1e-9);
}

TEST_F(MeshCommand, SameInputSameBytes)
{
    program.give("a.wkt", kTwo + "LINESTRING(-1 1,9 5)\n");
    for (const char* name : {"out.vtu", "out.msh", "out.inp", "out.poly", "out.svg", "out.png"}) {
        EXPECT_EQ(program.run({"mesh", "a.wkt", "-o", name}).status, 0);
        const std::string first = program.text(name);
        EXPECT_EQ(program.run({"mesh", "a.wkt", "-o", name}).status, 0);
        EXPECT_EQ(program.text(name), first) << name;
    }
    // Every process has its memory at other addresses.
    const std::string first = program.text("out.vtu");
    for (int run = 2; run < 20; ++run) {
        EXPECT_EQ(program.run({"mesh", "a.wkt", "-o", "out.vtu"}).status, 0);
        ASSERT_EQ(program.text("out.vtu"), first) << run;
    }
}

TEST_F(MeshCommand, StagePictures)
{
    program.give("a.wkt", "POLYGON((0 0,80 0,80 80,0 80,0 0),(20 20,20 40,40 40,40 20,20 20))\n"
                          "LINESTRING(-10 10,90 70)\nLINESTRING(20 90,60 -10)\n");
    const json report = mesh({"a.wkt", "--recovery", "steiner", "--stages", "folder/stages"});
    EXPECT_GT(report["steiner_removed"].get<int>(), 0);
    for (const char* name :
         {"1-rectangle", "2-points", "3-before-recovery", "4-recovered", "5-outside-removed",
          "6-optimized", "7-zoom", "steiner-before", "steiner-after"}) {
        const std::string svg = program.text(std::string("folder/stages/") + name + ".svg");
        const std::string png = program.text(std::string("folder/stages/") + name + ".png");
        EXPECT_TRUE(svg.ends_with("</svg>\n")) << name;
        EXPECT_TRUE(png.starts_with("\x89PNG")) << name;
        EXPECT_GT(png.size(), 5000U) << name;
    }
}

TEST_F(MeshCommand, TimeLimitAndInterruptLeaveNothing)
{
    program.give("a.poly", kSquare);
    const std::vector<std::string> big {"mesh", "a.poly", "-o", "x.vtu", "--size", "0.004"};
    std::vector<std::string> limited = big;
    limited.insert(limited.end(), {"--time-limit", "0.05"});
    program.refuse(limited, "time limit", 3);
    for (const int signal : {SIGINT, SIGTERM}) {
        const Outcome outcome =
            program.interrupt(big, signal, std::chrono::milliseconds(100));
        EXPECT_EQ(outcome.status, 3) << outcome.err;
        EXPECT_EQ(outcome.err, "tessera: Cancelled.\n");
        EXPECT_EQ(program.folder().fileCount(), 1U);
    }
}

TEST_F(MeshCommand, QuietAndNot)
{
    program.give("a.poly", kSquare);
    const Outcome loud = program.run({"mesh", "a.poly", "-o", "x.vtu"});
    EXPECT_NE(loud.out.find("x.vtu: "), std::string::npos);
    EXPECT_NE(loud.out.find("triangles"), std::string::npos);
    EXPECT_EQ(program.run({"mesh", "a.poly", "-o", "x.vtu", "--quiet"}).out, "");
    // Loops that even-odd turned into holes without being told are mentioned.
    program.give("b.poly", kNested);
    EXPECT_NE(program.run({"mesh", "b.poly", "-o", "x.vtu"}).out.find("became a hole"),
              std::string::npos);
}

TEST_F(MeshCommand, VersionAndHelp)
{
    const Outcome version = program.run({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.out, "tessera " TESSERA_VERSION "\n");
    for (const auto& arguments : std::vector<std::vector<std::string>> {
             {"--help"}, {"mesh", "--help"}, {"check", "--help"}, {"mesh", "-h"}}) {
        const Outcome help = program.run(arguments);
        EXPECT_EQ(help.status, 0);
        EXPECT_EQ(help.err, "");
        EXPECT_NE(help.out.find("Usage: tessera"), std::string::npos) << help.out;
    }
    const std::string help = program.run({"mesh", "--help"}).out;
    for (const char* option :
         {"--size", "--min-size", "--growth", "--order", "--fill", "--boundary", "--constraint",
          "--ignore", "--min-angle", "--max-area", "--no-refine", "--no-optimize", "--weld", "--recovery",
          "--narrow-gaps", "--time-limit", "--stages", "--report", "--quiet"}) {
        EXPECT_NE(help.find(option), std::string::npos) << option;
    }
}

} // namespace
} // namespace tessera
