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

/// Three slanted strips of a plate with a gap of 0.01 between the last two, and its four quarters.
const std::string kStrips = "POLYGON((0 0,3 0,5 8,0 8,0 0))\n"
                            "POLYGON((3 0,9 0,7 8,5 8,3 0))\n"
                            "POLYGON((9.01 0,12 0,12 8,7.01 8,9.01 0))\n";
const std::string kQuarters = "POLYGON((0 0,6 0,6 4,0 4,0 0))\nPOLYGON((6 0,12 0,12 4,6 4,6 0))\n"
                              "POLYGON((0 4,7 4,7 8,0 8,0 4))\nPOLYGON((7 4,12 4,12 8,7 8,7 4))\n";

class ImprintCommand: public ::testing::Test
{
protected:
    ImprintCommand()
    {
        program.give("s.wkt", kStrips);
        program.give("t.wkt", kQuarters);
    }

    json imprint(std::vector<std::string> more, const std::string& output = "out.wkt")
    {
        std::vector<std::string> arguments {"imprint", "--source", "s.wkt", "--target", "t.wkt",
                                            "-o", output, "--report", "out.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = program.run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return program.json("out.json");
    }

    Program program;
};

TEST_F(ImprintCommand, TheReportHasTheHistoryFromOne)
{
    const json report = imprint({});
    EXPECT_EQ(report.at("cells").size(), 10U);
    EXPECT_EQ(report.at("tolerance"), 0.0);
    EXPECT_EQ(report.at("sources").size(), 3U);
    EXPECT_EQ(report.at("targets").size(), 4U);
    EXPECT_EQ(report.at("sources")[0].at("name"), "s_Line1");
    EXPECT_EQ(report.at("sources")[0].at("cells"), json({1, 2}));
    EXPECT_NEAR(report.at("targets")[0].at("area"), 24.0, 1e-12);
    const json& first = report.at("cells")[0];
    EXPECT_EQ(first.at("operands"), json({1, 4}));
    EXPECT_EQ(first.at("sources"), json({1}));
    EXPECT_EQ(first.at("targets"), json({1}));
    EXPECT_NEAR(first.at("area"), 14.0, 1e-12);
    EXPECT_TRUE(report.at("closed").empty());
    ASSERT_EQ(report.at("left").size(), 2U);
    for (const json& left : report.at("left")) {
        EXPECT_EQ(left.at("kind"), "target without source");
        EXPECT_NEAR(left.at("width"), 0.0097, 1e-4);
        EXPECT_EQ(left.at("at").size(), 3U);
    }
    // Every line of the output is a cell, in the report's order.
    const std::string text = program.text("out.wkt");
    EXPECT_EQ(std::ranges::count(text, '\n'), 10);
}

TEST_F(ImprintCommand, TheToleranceClosesTheGap)
{
    const json report = imprint({"--tolerance", "0.02"}, "out.brep");
    EXPECT_EQ(report.at("cells").size(), 8U);
    EXPECT_EQ(report.at("closed").size(), 2U);
    EXPECT_TRUE(report.at("left").empty());
    EXPECT_NEAR(report.at("area"), 96.0, 1e-9);
    // The faces can be imprinted again: nothing is left to do.
    const Outcome again = program.run({"imprint", "--source", "out.brep", "--target", "out.brep",
                                       "-o", "again.step", "--report", "again.json"});
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(program.json("again.json").at("cells").size(), 8U);
    EXPECT_NEAR(program.json("again.json").at("area"), 96.0, 1e-9);
}

TEST_F(ImprintCommand, EveryOutput)
{
    for (const std::string output :
         {"a.step", "a.poly", "a.vtu", "a.msh", "a.inp", "a.svg", "a.png"}) {
        imprint({"--quiet"}, output);
        EXPECT_TRUE(program.has(output)) << output;
    }
}

TEST_F(ImprintCommand, RefusesInOneLine)
{
    const std::vector<std::string> start {"imprint", "--source", "s.wkt", "--target", "t.wkt"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), start.begin(), start.end());
        return more;
    };
    program.refuse({"imprint", "--source", "s.wkt", "-o", "a.wkt"}, "--target is required", 2);
    program.refuse(with({"-o", "a.txt"}), ".brep", 2);
    program.refuse(with({"-o", "a.wkt", "--direction", "1,0"}), "three numbers", 2);
    program.refuse(with({"-o", "a.wkt", "--direction", "1,0,0"}), "along the faces", 1);
    program.refuse(with({"-o", "a.wkt", "--tolerance=-1"}), "tolerance", 1);
    program.refuse(with({"-o", "a.wkt", "--tolerance", "nan"}), "tolerance", 1);
    program.refuse(with({"-o", "s.wkt"}), "replace the input", 1);
    program.refuse({"imprint", "--source", "s.wkt", "--target", "no.brep", "-o", "a.wkt"},
           "cannot be imprinted together", 1);
    program.refuse({"imprint", "--source", "no.wkt", "--target", "t.wkt", "-o", "a.wkt"}, "no.wkt", 1);
}

} // namespace
} // namespace tessera
