// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/number_text.h"
#include "cli/choices.h"
#include "cli/commands.h"
#include "cli/file_names.h"
#include "cli/inputs.h"
#include "cli/overlay_output.h"
#include "cli/run_control.h"
#include "cli/run_options.h"
#include "imprint/imprint.h"
#include "io/atomic_file.h"
#include "io/counted.h"
#include "io/imprint_report.h"
#include "io/read_network.h"
#include "io/text_file.h"
#include "occt/imprint_faces.h"
#include "vtk/mesh_file.h"
#include "vtk/overlay_file.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tessera::cli
{

namespace
{

struct ImprintArguments: RunOptions
{
    std::vector<std::string> sources;
    std::vector<std::string> targets;
    std::optional<Vec3> direction;
    std::optional<double> tolerance;
};

void addDirection(CLI::App& command, std::optional<Vec3>& direction)
{
    command
        .add_option_function<std::string>(
            "--direction",
            [&direction](const std::string& text) {
                Vec3 given {};
                std::size_t begin = 0;
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::size_t end = std::min(text.find(',', begin), text.size());
                    const bool last = end == text.size();
                    if (!parseNumber(text.substr(begin, end - begin), given[i])
                        || !std::isfinite(given[i]) || last != (i == 2)) {
                        throw CLI::ValidationError(
                            "--direction", fmt::format("'{}' is not a direction; give three "
                                                       "numbers, for example 0,0,1",
                                                       text));
                    }
                    begin = end + 1;
                }
                direction = given;
            },
            "Along which targets are projected on sources; default: the normal of the faces")
        ->type_name("X,Y,Z");
}

void addOptions(CLI::App& command, ImprintArguments& a)
{
    command
        .add_option("--source", a.sources,
                    "Files with the faces where a sweep starts: all .brep and .step, or all .wkt "
                    "and .poly; each face or line is one source")
        ->required()
        ->type_name("FILE");
    command
        .add_option("--target", a.targets,
                    "Files with the faces where it ends, parallel to the sources")
        ->required()
        ->type_name("FILE");
    command
        .add_option("-o,--output", a.output,
                    "Imprinted faces on each plane (.brep, .step); cells as polygons in the plane of "
                    "the first source (.wkt, .poly) or triangles: "
                        + meshExtensions())
        ->required();
    addDirection(command, a.direction);
    command.add_option("--tolerance", a.tolerance,
                       "Overlaps and gaps up to this width are closed; default: 0, for CAD its "
                       "tolerance");
    addFillOption(command, a,
                  "What is inside a source or target: even-odd (default), nonzero, positive, "
                  "negative or all (every bounded face)",
                  true);
    addControlOptions(command, a);
}

void writeResult(const ImprintResult& result, const ImprintInput& input, const ImprintArguments& a)
{
    const std::string extension = extensionOf(a.output);
    if (isFaceExtension(extension)) {
        writeImprint(result, input, a.output);
        return;
    }
    writeOverlay(result.overlay, BooleanOperation::Cells, a.output);
}

void printSummary(const ImprintResult& result, const ImprintArguments& a, double seconds)
{
    for (const std::string& message : result.messages) {
        fmt::print("{}\n", message);
    }
    for (const Mismatch& mismatch : result.left) {
        fmt::print("Left: {} {:.4g} wide, area {:.4g}, at {}\n", nameOf(mismatch.kind),
                   mismatch.width, mismatch.area, placeText(mismatch.at));
    }
    fmt::print("{}: {}, area {:.6g}, {} closed, {} left, {:.2f} s\n", a.output,
               counted(result.cells.size(), "cell"), result.overlay.report.area,
               result.closed.size(), result.left.size(), seconds);
}

int runImprint(const ImprintArguments& a)
{
    const CommandClock clock;
    Execution execution;
    setTimeLimit(execution, a);
    const RunControl control(execution, a.quiet);
    std::vector<std::string> inputs = a.sources;
    inputs.insert(inputs.end(), a.targets.begin(), a.targets.end());
    requireDistinct(inputs, {{"-o", a.output}, {"--report", a.report}});
    requireWritable(a.output);
    std::optional<AtomicFile> reportFile;
    if (!a.report.empty()) {
        reportFile.emplace(a.report);
    }

    const ImprintInput input = readImprint(a.sources, a.targets, a.direction);
    execution.checkpoint();
    ImprintOptions options;
    options.fill = a.fill;
    options.recovery = a.recovery;
    options.weld = input.defaultWeld;
    options.tolerance = a.tolerance.value_or(input.defaultWeld);
    const double read = clock.seconds();
    ImprintResult result = imprintNetwork(input.network, input.side, options, execution);
    const double imprinted = clock.seconds();
    execution.checkpoint();
    writeResult(result, input, a);

    StageSeconds& seconds = result.overlay.report.seconds;
    seconds.read = read;
    seconds.write = clock.seconds() - imprinted;
    seconds.total += seconds.read + seconds.write;
    if (reportFile) {
        reportFile->write(formatReport(
            result, {input.side, [&](Vec2 p) { return input.frame.toSpace(p); }}));
        reportFile->commit();
    }
    if (!a.quiet) {
        printSummary(result, a, seconds.total);
    }
    return kDone;
}

} // namespace

Command addImprintCommand(CLI::App& program)
{
    CLI::App* command = program.add_subcommand(
        "imprint", "The common refinement of the source and target faces of a sweep.");
    const auto arguments = std::make_shared<ImprintArguments>();
    addOptions(*command, *arguments);
    requireOverlayOutput(*command, arguments);
    return [arguments] { return runImprint(*arguments); };
}

} // namespace tessera::cli
