// SPDX-License-Identifier: MIT

// Quality meshing of one plate (unit square, five round holes, four inner lines) with uniform,
// graded and steep size fields, from curves to the finished mesh, beside Gmsh's Frontal-Delaunay
// with the same sizes. The details show triangles, million triangles a second (CPU time of stages
// triangulate to extract), mean quality, smallest angle, 1st percentile of the triangles' smallest
// angles, edge length / size (5 and 95 %), and targets that were not met.

#include "gmsh_peer.h"
#include "plate.h"
#include "section.h"

#include "base/execution.h"
#include "pipeline.h"
#include "sizing/uniform_size.h"

#include <ctime>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace
{

using namespace tessera;
using bench::GradedSize;

/// The share of the run from triangulate to extract.
double meshingShare(const StageSeconds& s)
{
    return (s.triangulate + s.recover + s.color + s.refine + s.optimize + s.extract) / s.total;
}

double cpuSeconds()
{
    timespec t {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void tell(bench::Result& result, std::size_t triangles, double seconds, const QualityReport& quality)
{
    result.columns = {{"triangles", static_cast<double>(triangles)},
                      {"Mtri/s", 1e-6 * static_cast<double>(triangles) / seconds},
                      {"mean q", quality.meanQuality},
                      {"min angle", quality.minAngle},
                      {"1 % angle", quality.angleP01},
                      {"L/h 5 %", quality.sizeConformity.p05},
                      {"L/h 95 %", quality.sizeConformity.p95}};
}

void meshPlate(bench::Result& result, const CurveNetwork& network, const SizeField& size)
{
    Execution execution;
    const double begin = cpuSeconds();
    const MeshResult made = meshNetwork(network, size, MeshOptions {}, execution);
    const double seconds = (cpuSeconds() - begin) * meshingShare(made.report.seconds);
    result.vertices = made.mesh.nodes.size();
    tell(result, made.mesh.triangles.size(), seconds, made.report.quality);
    result.columns["unreached"] = static_cast<double>(made.report.unreached.size());
}

void meshPlateWithGmsh(bench::Result& result, const std::string& expression, const SizeField& size)
{
    const bench::GmshRun run = bench::meshWithGmsh(expression, size);
    result.seconds = run.seconds;
    tell(result, run.triangles, run.seconds, run.quality);
}

class Sections
{
public:
    explicit Sections(const std::string& gmsh)
        : section_("Quality meshing of a plate", gmsh)
        , hasGmsh_(!gmsh.empty())
    {}

    /// expression: the size for Gmsh; empty: without Gmsh.
    void add(const std::string& name, const std::shared_ptr<const SizeField>& size,
             const std::string& expression, bench::Expectation expectation)
    {
        section_.add(
            name, "Tessera",
            [=, this](bench::Result& result) { meshPlate(result, *network_, *size); }, 3);
        if (hasGmsh_ && !expression.empty()) {
            section_.add(
                name, "gmsh",
                [=](bench::Result& result) { meshPlateWithGmsh(result, expression, *size); }, 1);
        }
        expectation.reference = "gmsh";
        section_.expect(name, expectation);
    }
    void uniform(const std::string& name, double h, bench::Expectation expectation, bool peer = true)
    {
        std::ostringstream text;
        text << h;
        add(name, std::make_shared<const UniformSize>(h), peer ? text.str() : "",
            std::move(expectation));
    }
    void graded(const std::string& name, Vec2 a, Vec2 b, double smallest, double growth,
                bench::Expectation expectation, bool peer = true)
    {
        const auto size = std::make_shared<const GradedSize>(a, b, smallest, growth);
        add(name, size, peer ? size->expression() : "", std::move(expectation));
    }
    int run(int argc, char** argv) { return section_.run(argc, argv); }

private:
    bench::Section section_;
    bool hasGmsh_;
    std::shared_ptr<const CurveNetwork> network_
        = std::make_shared<const CurveNetwork>(bench::plate());
};

} // namespace

int main(int argc, char** argv)
{
    Sections sections(bench::gmshVersion());
    sections.uniform("uniform, 10^4", 0.0142, {.atLeast = {{"mean q", 0.985}, {"Mtri/s", 0.7}}});
    sections.uniform("uniform, 10^5", 0.00449,
                     {.atLeast = {{"mean q", 0.995}, {"1 % angle", 45}, {"Mtri/s", 2}}});
    sections.uniform("uniform, 10^6", 0.00142,
                     {.ratio = 0.01,
                      .bytesPerVertex = 500,
                      .atLeast = {{"mean q", 0.997},
                                  {"min angle", 32},
                                  {"1 % angle", 48},
                                  {"Mtri/s", 3}}});
    sections.uniform("uniform, 4 10^6", 0.00071, {.bytesPerVertex = 500}, false);
    const std::map<std::string, double> gentle
        = {{"mean q", 0.985}, {"min angle", 32}, {"Mtri/s", 1}, {"L/h 5 %", 0.7}};
    const std::map<std::string, double> steep
        = {{"mean q", 0.957}, {"min angle", 30}, {"Mtri/s", 0.5}, {"L/h 5 %", 0.7}};
    const std::map<std::string, double> lengths = {{"L/h 95 %", 1.4}};
    const Vec2 point {0.5, 0.3};
    const Vec2 from = bench::kLines[0][0];
    const Vec2 to = bench::kLines[0][1];
    sections.graded("to a point, growth 0.0064", point, point, 5.9e-5, 0.0064,
                    {.atLeast = gentle, .atMost = lengths});
    sections.graded("to a segment, growth 0.0122", from, to, 1.05e-4, 0.0122,
                    {.atLeast = gentle, .atMost = lengths});
    sections.graded("to a segment, growth 0.05", from, to, 4e-4, 0.05, {.atMost = lengths});
    sections.graded("to a segment, growth 0.1", from, to, 1e-4, 0.1, {.atMost = lengths});
    sections.graded("to a segment, growth 0.3", from, to, 5e-5, 0.3,
                    {.atLeast = steep, .atMost = lengths});
    sections.graded("to a segment, growth 0.3, finer", from, to, 5e-6, 0.3,
                    {.atLeast = steep, .atMost = lengths}, false);
    return sections.run(argc, argv);
}
