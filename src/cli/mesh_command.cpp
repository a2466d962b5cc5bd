// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "cli/choices.h"
#include "cli/commands.h"
#include "cli/file_names.h"
#include "cli/inputs.h"
#include "cli/run_control.h"
#include "cli/run_options.h"
#include "cli/size_options.h"
#include "io/atomic_file.h"
#include "io/counted.h"
#include "io/read_network.h"
#include "io/report_json.h"
#include "io/stage_pictures.h"
#include "io/system_memory.h"
#include "pipeline.h"
#include "vtk/mesh_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tessera::cli
{

namespace
{

struct MeshArguments: RunOptions
{
    std::optional<double> size;
    std::optional<double> count;
    std::optional<double> minSize;
    std::optional<double> growth;
    std::optional<double> minAngle;
    std::optional<double> maxArea;
    std::optional<double> narrowGaps;
    std::optional<int> threads;
    int order = 1;
    RoleLists roles;
    SizeArguments sizes;
    bool noRefine = false;
    bool noOptimize = false;
    bool freezeBoundary = false;
};

void addOptions(CLI::App& command, MeshArguments& a)
{
    addFileOptions(command, a, "Mesh file: " + meshExtensions());
    command.add_option("--size", a.size, "Target edge length; default: a fortieth of the diagonal");
    command.add_option("--count", a.count,
                       "Number of triangles to aim for, instead of --size: finds the size");
    command.add_option("--min-size", a.minSize, "Smallest edge length to aim for");
    command.add_option("--growth", a.growth,
                       "How fast the size may grow, above 0 to 1; default 0.3");
    addSizeOptions(command, a.sizes);
    command.add_option("--max-area", a.maxArea, "Largest area of a triangle");
    command.add_option("--min-angle", a.minAngle,
                       "Smallest angle to reach, 0 to 33 degrees; default 30");
    command.add_option("--order", a.order, "1: corner nodes only; 2: also mid nodes on the curves")
        ->transform(namesOnly(kOrders))
        ->type_name("1|2");
    addFillOption(command, a,
                  "What is inside: even-odd (default), nonzero, positive, negative, all (every "
                  "bounded face) or hull (the convex hull)");
    addNumberList(command, "--boundary", a.roles.boundary,
                  "Markers (.poly), lines (.wkt) or edges (CAD) that separate");
    addNumberList(command, "--constraint", a.roles.constraint,
                  "Markers, lines or edges that are kept and do not separate");
    addNumberList(command, "--ignore", a.roles.ignored,
                  "Markers, lines or edges that are left out");
    command.add_flag("--no-refine", a.noRefine,
                     "No interior points; straight segments are not divided");
    command.add_flag("--no-optimize", a.noOptimize, "Leave the triangles as they were inserted");
    command.add_flag("--freeze-boundary", a.freezeBoundary,
                     "No new nodes on straight segments; on curves only what size and curvature "
                     "ask for");
    command
        .add_option("--narrow-gaps", a.narrowGaps,
                    fmt::format("Triangles that may be spent on gaps far narrower than the size, as "
                                "a multiple of the others; 0 leaves them coarse; default {}",
                                kNarrowShare))
        ->type_name("SHARE");
    command.add_option("--threads", a.threads,
                       "Threads to use, 1 to 1024; default: as many as there are cores. The result "
                       "is the same");
    addRunOptions(command, a);
}

std::size_t wholeCount(const std::optional<double>& count)
{
    constexpr double kMost = 1e9; // triangles are numbered with 32 bits, two to each node or so
    if (count && !(*count >= 1.0 && *count <= kMost && std::floor(*count) == *count)) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("--count is {}; it must be a whole number from 1 to {}.", *count,
                                kMost));
    }
    return static_cast<std::size_t>(count.value_or(0.0));
}

void setThreads(Execution& execution, const std::optional<int>& threads)
{
    if (threads && !(*threads >= 1 && *threads <= 1024)) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("--threads is {}; it must lie between 1 and 1024.", *threads));
    }
    execution.setThreads(threads.value_or(0));
}

MeshOptions meshOptions(const MeshArguments& a)
{
    MeshOptions options;
    options.size = positive(a.size, "--size");
    options.count = wholeCount(a.count);
    if (a.size && a.count) {
        throw Error(ErrorKind::InvalidOption, "--size and --count exclude each other; give one.");
    }
    options.minSize = positive(a.minSize, "--min-size");
    options.maxArea = positive(a.maxArea, "--max-area");
    options.growth = a.growth.value_or(options.growth);
    options.minAngle = a.minAngle.value_or(options.minAngle);
    requireValidWeld(a);
    options.weld = a.weld.value_or(-1.0);
    options.order = a.order;
    options.fill = a.fill;
    options.recovery = a.recovery;
    options.refine = !a.noRefine;
    options.optimize = !a.noOptimize;
    options.freezeBoundary = a.freezeBoundary;
    options.narrowShare = notNegative(a.narrowGaps, "--narrow-gaps", options.narrowShare);
    options.memoryLimit = static_cast<double>(availableMemoryBytes());
    return options;
}

void printSummary(const MeshArguments& a, const MeshResult& result)
{
    const MeshReport& report = result.report;
    for (const std::string& message : report.messages) {
        fmt::print("{}\n", message);
    }
    if (!report.unreached.empty()) {
        fmt::print("Not reached: {}; the report lists them.\n",
                   counted(report.unreached.size(), "target"));
    }
    fmt::print("{}: {}, {}, {}, area {:.6g}, smallest angle {:.1f} degrees, mean quality {:.3f}, "
               "{:.2f} s\n",
               a.output, counted(result.mesh.triangles.size(), "triangle"),
               counted(result.mesh.nodes.size(), "node"), counted(report.regions, "region"),
               report.area, report.quality.minAngle, report.quality.meanQuality,
               report.seconds.total);
}

void requireDistinctFiles(const MeshArguments& a)
{
    const std::vector<NamedFile> outputs {{"-o", a.output}, {"--report", a.report}};
    requireDistinct(a.inputs, outputs);
    requireOutsideOf(a.stages, outputs);
}

int runMesh(const MeshArguments& a)
{
    const CommandClock clock;
    MeshOptions options = meshOptions(a);
    Execution execution;
    setTimeLimit(execution, a);
    setThreads(execution, a.threads);
    const RunControl control(execution, a.quiet);

    requireDistinctFiles(a);
    // What cannot be written shows before the work, not after it.
    requireWritable(a.output);
    std::optional<AtomicFile> reportFile;
    if (!a.report.empty()) {
        reportFile.emplace(a.report);
    }
    std::unique_ptr<StagePictures> stages;
    if (!a.stages.empty()) {
        stages = std::make_unique<StagePictures>(a.stages);
    }

    const Inputs inputs = readInputs(a.inputs, a.roles);
    if (options.weld < 0.0) {
        options.weld = inputs.defaultWeld;
    }
    options.sizes = localSizes(a.sizes, inputs);
    execution.checkpoint();
    const double read = clock.seconds();
    MeshResult result = meshNetwork(inputs.network, options, execution, stages.get());
    const double meshed = clock.seconds();
    execution.checkpoint();
    writeMesh(result.mesh, a.output, &inputs.network);

    StageSeconds& seconds = result.report.seconds;
    seconds.read = read;
    seconds.write = clock.seconds() - meshed;
    seconds.total += seconds.read + seconds.write;
    if (reportFile) {
        reportFile->write(formatReport(result));
        reportFile->commit();
    }
    if (!a.quiet) {
        printSummary(a, result);
    }
    return kDone;
}

} // namespace

Command addMeshCommand(CLI::App& program)
{
    CLI::App* command = program.add_subcommand("mesh", "Meshes what the curves enclose.");
    const auto arguments = std::make_shared<MeshArguments>();
    addOptions(*command, *arguments);
    command->callback([arguments] {
        if (!isMeshExtension(extensionOf(arguments->output))) {
            throw CLI::ValidationError("-o", fmt::format("'{}' should end in {}",
                                                         arguments->output, meshExtensions()));
        }
    });
    return [arguments] { return runMesh(*arguments); };
}

} // namespace tessera::cli
