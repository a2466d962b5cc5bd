// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "cli/choices.h"
#include "cli/commands.h"
#include "cli/file_names.h"
#include "cli/inputs.h"
#include "cli/run_control.h"
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

/// The command line as it was read. An option that was not given is empty.
struct MeshArguments
{
    std::vector<std::string> inputs;
    std::string output;
    std::optional<double> size;
    std::optional<double> minSize;
    std::optional<double> growth;
    std::optional<double> minAngle;
    std::optional<double> maxArea;
    std::optional<double> weld;
    std::optional<double> timeLimit;
    int order = 1;
    FillRule fill = FillRule::EvenOdd;
    RecoveryStrategy recovery = RecoveryStrategy::Cavity;
    RoleLists roles;
    SizeArguments sizes;
    bool noRefine = false;
    bool noOptimize = false;
    std::string stages;
    std::string report;
    bool quiet = false;
};

void addOptions(CLI::App& command, MeshArguments& a)
{
    command.add_option("INPUT", a.inputs,
                       ".poly, .wkt, .brep or .step files; their operands in order")
        ->required();
    command.add_option("-o,--output", a.output, "Mesh file: " + meshExtensions())->required();
    command.add_option("--size", a.size, "Target edge length; default: a fortieth of the diagonal");
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
    command
        .add_option("--fill", a.fill,
                    "What is inside: even-odd (default), nonzero, positive, negative, all (every "
                    "bounded face) or hull (the convex hull)")
        ->transform(namesOnly(kFillRules))
        ->type_name("RULE");
    addNumberList(command, "--boundary", a.roles.boundary,
                  "Markers (.poly), lines (.wkt) or edges (CAD) that separate");
    addNumberList(command, "--constraint", a.roles.constraint,
                  "Markers, lines or edges that are kept and do not separate");
    addNumberList(command, "--ignore", a.roles.ignored,
                  "Markers, lines or edges that are left out");
    command.add_flag("--no-refine", a.noRefine,
                     "No interior points; straight segments are not divided");
    command.add_flag("--no-optimize", a.noOptimize, "Leave the triangles as they were inserted");
    command.add_option("--weld", a.weld,
                       "End points nearer than this are one; default: 0, for CAD its tolerance");
    command
        .add_option("--recovery", a.recovery,
                    "How boundaries are recovered: cavity (default) or steiner")
        ->transform(namesOnly(kStrategies))
        ->type_name("STRATEGY");
    command.add_option("--time-limit", a.timeLimit, "Seconds after which to give up");
    command.add_option("--stages", a.stages, "Folder for a picture of each stage")
        ->type_name("DIR");
    command.add_option("--report", a.report, "File for the report, JSON");
    command.add_flag("--quiet", a.quiet, "Print nothing but errors");
}

/// An option that was given must be positive; in MeshOptions 0 means that it was not.
double positive(const std::optional<double>& value, const char* option)
{
    if (value && !(*value > 0.0 && std::isfinite(*value))) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("{} is {}; it must be greater than 0.", option, *value));
    }
    return value.value_or(0.0);
}

MeshOptions meshOptions(const MeshArguments& a)
{
    MeshOptions options;
    options.size = positive(a.size, "--size");
    options.minSize = positive(a.minSize, "--min-size");
    options.maxArea = positive(a.maxArea, "--max-area");
    options.growth = a.growth.value_or(options.growth);
    options.minAngle = a.minAngle.value_or(options.minAngle);
    if (a.weld && !(*a.weld >= 0.0 && std::isfinite(*a.weld))) {
        throw Error(ErrorKind::InvalidOption,
                    fmt::format("--weld is {}; it must be a length of 0 or more.", *a.weld));
    }
    options.weld = a.weld.value_or(-1.0);
    options.order = a.order;
    options.fill = a.fill;
    options.recovery = a.recovery;
    options.refine = !a.noRefine;
    options.optimize = !a.noOptimize;
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
    if (a.timeLimit) {
        execution.setTimeLimit(positive(a.timeLimit, "--time-limit"));
    }
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
