// SPDX-License-Identifier: MIT
#include "cli/commands.h"
#include "cli/file_names.h"
#include "io/atomic_file.h"
#include "io/check_mesh.h"
#include "io/counted.h"
#include "io/report_json.h"
#include "vtk/mesh_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

namespace tessera::cli
{

namespace
{

struct CheckArguments
{
    std::string mesh;
    std::string report;
    bool quiet = false;
};

int runCheck(const CheckArguments& a)
{
    requireDistinct({a.mesh}, {{"--report", a.report}});
    std::optional<AtomicFile> reportFile;
    if (!a.report.empty()) {
        reportFile.emplace(a.report);
    }
    const MeshCheck check = checkMesh(readMesh(a.mesh));
    if (reportFile) {
        reportFile->write(formatReport(check));
        reportFile->commit();
    }
    if (!a.quiet) {
        for (const std::string& problem : check.problems) {
            fmt::print("{}\n", problem);
        }
        fmt::print("{}: {}, {}, {}, {}, area {:.6g}, smallest angle {:.1f} degrees, mean quality "
                   "{:.3f}\n",
                   a.mesh, check.valid() ? "valid" : "not valid",
                   counted(check.triangles, "triangle"), counted(check.quads, "quadrangle"),
                   counted(check.nodes, "node"), check.area, check.quality.minAngle, check.quality.meanQuality);
    }
    if (!check.valid()) {
        fmt::print(stderr, "tessera: {}: the mesh has {}; the first: {}\n", a.mesh,
                   counted(check.problems.size(), "problem"), check.problems.front());
        return kRefused;
    }
    return kDone;
}

} // namespace

Command addCheckCommand(CLI::App& program)
{
    CLI::App* command = program.add_subcommand(
        "check", "Proves that a mesh is valid: orientation, conformity, no overlaps.");
    const auto arguments = std::make_shared<CheckArguments>();
    command->add_option("MESH", arguments->mesh, ".vtu, .msh or .inp file")->required();
    command->add_option("--report", arguments->report, "File for the report, JSON");
    command->add_flag("--quiet", arguments->quiet, "Print nothing but errors");
    return [arguments] { return runCheck(*arguments); };
}

} // namespace tessera::cli
