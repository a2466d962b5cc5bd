// SPDX-License-Identifier: MIT
#include "cli/run_program.h"
#include "io/sample_meshes.h"
#include "io/write_text_mesh.h"

#include <gtest/gtest.h>

#include <string>

namespace tessera
{
namespace
{

using nlohmann::json;
using testing::Outcome;
using testing::Program;

TEST(CheckCommand, ValidMesh)
{
    const Program program;
    const samples::PlateMesh plate(9);
    program.give("a.msh", formatMsh(plate.mesh));
    const Outcome outcome = program.run({"check", "a.msh", "--report", "a.json"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("a.msh: valid"), std::string::npos);
    const json report = program.json("a.json");
    EXPECT_EQ(report["valid"], true);
    EXPECT_EQ(report["problems"], json::array());
    EXPECT_EQ(report["triangles"], plate.mesh.triangles.size());
    EXPECT_EQ(report["vertices"], plate.mesh.nodes.size());
    EXPECT_NEAR(report["area"].get<double>(), plate.area(), 1e-9);
    EXPECT_TRUE(report.contains("min_angle_deg"));
    EXPECT_TRUE(report.contains("mean_quality"));
}

TEST(CheckCommand, PictureOfAnglesAndWorstTriangles)
{
    const Program program;
    const samples::PlateMesh plate(9);
    program.give("a.msh", formatMsh(plate.mesh));
    const Outcome outcome
        = program.run({"check", "a.msh", "--picture", "a.svg", "--report", "a.json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(program.text("a.svg").find("<svg"), std::string::npos);
    const json report = program.json("a.json");
    EXPECT_EQ(report["worst"].size(), 10U);
    EXPECT_EQ(report["worst"][0]["min_angle_deg"], report["min_angle_deg"]);
    std::size_t counted = 0;
    for (const json& count : report["angle_histogram"]) {
        counted += count.get<std::size_t>();
    }
    EXPECT_EQ(counted, plate.mesh.triangles.size());
    EXPECT_EQ(program.run({"check", "a.msh", "--picture", "a.txt"}).status, 2);
    EXPECT_EQ(program.run({"check", "a.msh", "--picture", "a.msh"}).status, 2);
}

TEST(CheckCommand, InvalidMeshListsEveryProblem)
{
    const Program program;
    Mesh mesh = samples::PlateMesh(9).mesh;
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    std::swap(mesh.triangles[40][0], mesh.triangles[40][1]);
    program.give("a.inp", formatInp(mesh));
    const Outcome outcome = program.run({"check", "a.inp", "--report", "a.json"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.errorLines(), 1U);
    EXPECT_NE(outcome.err.find("a.inp: the mesh has "), std::string::npos);
    EXPECT_NE(outcome.out.find("Element 4 "), std::string::npos);
    EXPECT_NE(outcome.out.find("Element 41 "), std::string::npos);
    const json report = program.json("a.json");
    EXPECT_EQ(report["valid"], false);
    EXPECT_GE(report["problems"].size(), 2U);
    EXPECT_EQ(program.run({"check", "a.inp", "--quiet"}).out, "");
}

TEST(CheckCommand, FilesThatAreNoMeshes)
{
    const Program program;
    program.give("a.vtu", "hello");
    program.give("a.msh", "$MeshFormat\n4.1 1 8\n");
    program.give("a.stl", "solid\n");
    for (const char* name : {"a.vtu", "a.msh", "a.stl", "none.vtu"}) {
        const Outcome outcome = program.run({"check", name, "--report", "r.json"});
        EXPECT_EQ(outcome.status, 1) << name;
        EXPECT_EQ(outcome.errorLines(), 1U) << outcome.err;
        EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
        EXPECT_FALSE(program.has("r.json"));
    }
    EXPECT_EQ(program.run({"check"}).status, 2);
    EXPECT_EQ(program.run({"check", "a.vtu", "b.vtu"}).status, 2);
}

} // namespace
} // namespace tessera
