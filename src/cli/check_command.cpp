// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/number_text.h"
#include "cli/commands.h"
#include "cli/file_names.h"
#include "io/atomic_file.h"
#include "io/check_mesh.h"
#include "io/counted.h"
#include "io/quality_picture.h"
#include "io/read_network.h"
#include "io/report_json.h"
#include "vtk/mesh_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
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
    std::string picture;
    bool quiet = false;
};

void drawPicture(const CheckArguments& a, const MeshCheck& check)
{
    if (check.triangles == 0) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("{} has no triangles; --picture shows the angles of triangles.",
                                a.mesh));
    }
    const QualityReport& quality = check.quality;
    AtomicFile file(a.picture);
    file.write(drawQuality(
        check.corners, quality,
        extensionOf(a.picture) == ".svg" ? PictureFormat::Svg : PictureFormat::Png,
        fmt::format("{}: {}, smallest angle {:.1f}, 1 % below {:.1f} degrees, mean quality {:.4f}",
                    std::filesystem::path(a.mesh).filename().string(),
                    counted(check.triangles, "triangle"), quality.minAngle, quality.angleP01,
                    quality.meanQuality)));
    file.commit();
}

/// The worst triangle, for the summary.
std::string describeWorst(const QualityReport& quality)
{
    if (quality.worst.empty()) {
        return "";
    }
    const QualityReport::Worst& worst = quality.worst.front();
    return " at " + placeText(worst.place);
}

int runCheck(const CheckArguments& a)
{
    requireDistinct({a.mesh}, {{"--report", a.report}, {"--picture", a.picture}});
    std::optional<AtomicFile> reportFile;
    if (!a.report.empty()) {
        reportFile.emplace(a.report);
    }
    if (!a.picture.empty()) {
        requireWritable(a.picture);
    }
    const MeshCheck check = checkMesh(readMesh(a.mesh));
    if (reportFile) {
        reportFile->write(formatReport(check));
        reportFile->commit();
    }
    if (!a.picture.empty()) {
        drawPicture(a, check);
    }
    if (!a.quiet) {
        for (const std::string& problem : check.problems) {
            fmt::print("{}\n", problem);
        }
        for (const std::string& warning : check.warnings) {
            fmt::print("Warning: {}\n", warning);
        }
        fmt::print("{}: {}, {}, {}, {}, area {:.6g}, smallest angle {:.1f} degrees{}, mean "
                   "quality {:.3f}\n",
                   a.mesh, check.valid() ? "valid" : "not valid",
                   counted(check.triangles, "triangle"), counted(check.quads, "quadrangle"),
                   counted(check.nodes, "node"), check.area, check.quality.minAngle,
                   describeWorst(check.quality), check.quality.meanQuality);
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
    command->add_option("--picture", arguments->picture,
                        "Picture of the triangles by their smallest angles, the worst ones marked, "
                        "with histograms: .svg or .png");
    command->callback([arguments] {
        const std::string extension = extensionOf(arguments->picture);
        if (!arguments->picture.empty() && extension != ".svg" && extension != ".png") {
            throw CLI::ValidationError(
                "--picture", fmt::format("'{}' should end in .svg or .png", arguments->picture));
        }
    });
    command->add_flag("--quiet", arguments->quiet, "Print nothing but errors");
    return [arguments] { return runCheck(*arguments); };
}

} // namespace tessera::cli
