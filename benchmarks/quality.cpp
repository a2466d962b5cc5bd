// SPDX-License-Identifier: MIT

// Quality meshing of one plate (unit square, five round holes, four inner lines) with uniform,
// graded and steep size fields, from curves to the finished mesh. The details show triangles,
// million triangles a second (stages triangulate to extract), mean quality, smallest angle, 1st
// percentile of the triangles' smallest angles, edge length / size (5 and 95 %), and targets that
// were not met.

#include "plate.h"
#include "section.h"

#include "base/execution.h"
#include "pipeline.h"
#include "sizing/uniform_size.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace
{

using namespace tessera;
using bench::GradedSize;

double meshingSeconds(const StageSeconds& s)
{
    return s.triangulate + s.recover + s.color + s.refine + s.optimize + s.extract;
}

void meshPlate(bench::Result& result, const CurveNetwork& network, const SizeField& size)
{
    Execution execution;
    const MeshResult mesh = meshNetwork(network, size, MeshOptions {}, execution);
    const auto triangles = static_cast<double>(mesh.mesh.triangles.size());
    const QualityReport& quality = mesh.report.quality;
    result.vertices = mesh.mesh.nodes.size();
    result.columns = {{"triangles", triangles},
                      {"Mtri/s", 1e-6 * triangles / meshingSeconds(mesh.report.seconds)},
                      {"mean q", quality.meanQuality},
                      {"min angle", quality.minAngle},
                      {"1 % angle", quality.angleP01},
                      {"L/h 5 %", quality.sizeConformity.p05},
                      {"L/h 95 %", quality.sizeConformity.p95},
                      {"unreached", static_cast<double>(mesh.report.unreached.size())}};
}

} // namespace

int main(int argc, char** argv)
{
    constexpr int kRepetitions = 3;
    bench::Section section("Quality meshing of a plate", "");
    const auto network = std::make_shared<const CurveNetwork>(bench::plate());
    const auto add = [&](const std::string& name, const std::shared_ptr<const SizeField>& size) {
        const auto run = [=](bench::Result& result) { meshPlate(result, *network, *size); };
        section.add(name, "Tessera", run, kRepetitions);
    };
    const auto uniform = [&](double h) { return std::make_shared<const UniformSize>(h); };
    add("uniform, 10^4", uniform(0.0142));
    add("uniform, 10^5", uniform(0.00449));
    add("uniform, 10^6", uniform(0.00142));
    const Vec2 point {0.5, 0.3};
    const Vec2 from {0.1, 0.45};
    const Vec2 to {0.3, 0.52};
    const auto graded = [](Vec2 a, Vec2 b, double smallest, double growth) {
        return std::make_shared<const GradedSize>(a, b, smallest, growth);
    };
    add("to a point, growth 0.0064", graded(point, point, 5.9e-5, 0.0064));
    add("to a segment, growth 0.0153", graded(from, to, 1.3e-4, 0.0153));
    add("to a segment, growth 0.05", graded(from, to, 4e-4, 0.05));
    add("to a segment, growth 0.1", graded(from, to, 1e-4, 0.1));
    add("to a segment, growth 0.3", graded(from, to, 5e-5, 0.3));
    return section.run(argc, argv);
}
