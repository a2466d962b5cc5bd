// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "cli/choices.h"
#include "cli/commands.h"
#include "cli/file_names.h"
#include "cli/inputs.h"
#include "cli/overlay_output.h"
#include "cli/run_control.h"
#include "cli/run_options.h"
#include "imprint/overlay.h"
#include "io/atomic_file.h"
#include "io/counted.h"
#include "io/overlay_pictures.h"
#include "io/overlay_report.h"
#include "io/read_network.h"
#include "occt/overlay_faces.h"
#include "vtk/mesh_file.h"
#include "vtk/overlay_file.h"

#include <memory>
#include <optional>
#include <vector>

namespace tessera::cli
{

namespace
{

struct OverlayArguments: RunOptions
{
    BooleanOperation operation = BooleanOperation::Union;
    Priority priority = Priority::None;
};

const std::map<std::string, BooleanOperation> kOperations {
    {"union", BooleanOperation::Union},
    {"intersection", BooleanOperation::Intersection},
    {"difference", BooleanOperation::Difference},
    {"xor", BooleanOperation::SymmetricDifference},
    {"cells", BooleanOperation::Cells},
};
const std::map<std::string, Priority> kPriorities {
    {"first", Priority::First},
    {"last", Priority::Last},
};

void addOptions(CLI::App& command, OverlayArguments& a)
{
    addFileOptions(command, a,
                   "Result as polygons (.wkt, .poly), faces on the original curves (.brep, .step) "
                   "or triangles: "
                       + meshExtensions());
    command
        .add_option("--op", a.operation,
                    "union (default), intersection, difference (the first operand minus the "
                    "others), xor, or cells: every cell of the arrangement on a line of its own; "
                    "the report lists the operands that cover it, numbered from 1")
        ->transform(namesOnly(kOperations))
        ->type_name("OPERATION");
    command
        .add_option("--priority", a.priority,
                    "first or last: what several operands cover belongs to the first or last of "
                    "them alone; the result is divided by owner (a line of .wkt for each)")
        ->transform(namesOnly(kPriorities))
        ->type_name("WHICH");
    addFillOption(command, a,
                  "What is inside an operand: even-odd (default), nonzero, positive, negative or "
                  "all (every bounded face)",
                  true);
    addRunOptions(command, a);
}

void writeResult(const OverlayResult& result, const PlaneFrame& frame, const OverlayArguments& a)
{
    const std::string extension = extensionOf(a.output);
    if (isFaceExtension(extension)) {
        writeFaces(result, frame, a.output);
        return;
    }
    writeOverlay(result, a.operation, a.output);
}

int runOverlay(const OverlayArguments& a)
{
    const CommandClock clock;
    requireValidWeld(a);
    Execution execution;
    setTimeLimit(execution, a);
    const RunControl control(execution, a.quiet);
    requireDistinct(a.inputs, {{"-o", a.output}, {"--report", a.report}});
    requireWritable(a.output);
    std::optional<AtomicFile> reportFile;
    if (!a.report.empty()) {
        reportFile.emplace(a.report);
    }

    std::unique_ptr<OverlayPictures> stages;
    if (!a.stages.empty()) {
        stages = std::make_unique<OverlayPictures>(a.stages);
    }

    Inputs inputs = readInputs(a.inputs, {});
    execution.checkpoint();
    OverlayOptions options;
    options.operation = a.operation;
    options.priority = a.priority;
    options.fill = a.fill;
    options.recovery = a.recovery;
    options.weld = a.weld.value_or(inputs.defaultWeld);
    const std::string extension = extensionOf(a.output);
    options.form = isFaceExtension(extension) ? OverlayForm::Faces
        : extension == ".wkt"                 ? OverlayForm::Polygons
                                              : OverlayForm::Triangles;
    const double read = clock.seconds();
    OverlayResult result = overlayNetwork(std::move(inputs.network), options, execution,
                                          stages.get());
    if (stages) {
        stages->colored(result);
    }
    const double overlaid = clock.seconds();
    execution.checkpoint();
    writeResult(result, inputs.frame, a);

    StageSeconds& seconds = result.report.seconds;
    seconds.read = read;
    seconds.write = clock.seconds() - overlaid;
    seconds.total += seconds.read + seconds.write;
    if (reportFile) {
        reportFile->write(formatReport(result, a.operation));
        reportFile->commit();
    }
    if (!a.quiet) {
        for (const std::string& message : result.report.messages) {
            fmt::print("{}\n", message);
        }
        fmt::print("{}: {}, area {:.6g}, {}, {:.2f} s\n", a.output,
                   counted(result.polygons.size(), "polygon"), result.report.area,
                   counted(result.report.recovery.crossings, "crossing"), seconds.total);
    }
    return kDone;
}

} // namespace

Command addOverlayCommand(CLI::App& program)
{
    CLI::App* command = program.add_subcommand(
        "overlay", "Boolean operations on any number of shapes, however they cross and overlap.");
    const auto arguments = std::make_shared<OverlayArguments>();
    addOptions(*command, *arguments);
    requireOverlayOutput(*command, arguments);
    return [arguments] { return runOverlay(*arguments); };
}

} // namespace tessera::cli
