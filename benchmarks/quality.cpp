// SPDX-License-Identifier: MIT

// Quality meshing of one plate (unit square, five round holes, four inner lines) with uniform,
// graded and steep size fields, from curves to the finished mesh. One line a case: triangles,
// million triangles a second of process CPU time (stages triangulate to extract by their share of
// the wall time), mean quality, smallest angle, 1st percentile of the triangles' smallest angles,
// edge length / size (5 and 95 %), bytes a triangle at the heap's peak, seconds of the stages.
//
//     bench_quality [largest number of triangles, default 1100000] [repetitions, default 3]

#include "base/execution.h"
#include "curve/arc.h"
#include "pipeline.h"
#include "sizing/uniform_size.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <malloc.h>
#include <memory>
#include <new>
#include <vector>

namespace
{
std::size_t heapNow = 0;
std::size_t heapPeak = 0;
} // namespace

void* operator new(std::size_t size)
{
    void* p = std::malloc(size);
    if (p == nullptr) {
        throw std::bad_alloc();
    }
    heapNow += malloc_usable_size(p);
    heapPeak = std::max(heapPeak, heapNow);
    return p;
}

void operator delete(void* p) noexcept
{
    heapNow -= p != nullptr ? malloc_usable_size(p) : 0;
    std::free(p);
}

void operator delete(void* p, std::size_t) noexcept
{
    operator delete(p);
}

namespace
{

using namespace tessera;

/// smallest + growth × distance to the segment from a to b.
class GradedSize: public SizeField
{
public:
    GradedSize(Vec2 a, Vec2 b, double smallest, double growth)
        : a_(a)
        , b_(b)
        , smallest_(smallest)
        , growth_(growth)
    {}
    double size(Vec2 p) const override
    {
        const Vec2 along = b_ - a_;
        const double square = squaredLength(along);
        const double s = square > 0.0 ? std::clamp(dot(p - a_, along) / square, 0.0, 1.0) : 0.0;
        return smallest_ + growth_ * std::sqrt(squaredLength(p - a_ - s * along));
    }
    double gradientBound() const override { return growth_; }

private:
    Vec2 a_, b_;
    double smallest_, growth_;
};

CurveNetwork plate()
{
    CurveNetwork network;
    network.operands.push_back({"plate"});
    const OperandId operand(0U);
    const auto line = [&](PointId a, PointId b, Role role) {
        NetworkCurve curve;
        curve.start = a;
        curve.end = b;
        curve.operand = operand;
        curve.role = role;
        network.curves.push_back(curve);
    };
    const PointId corner[4] = {network.addPoint({0, 0}), network.addPoint({1, 0}),
                               network.addPoint({1, 1}), network.addPoint({0, 1})};
    for (int i = 0; i < 4; ++i) {
        line(corner[i], corner[(i + 1) % 4], Role::Boundary);
    }
    const struct
    {
        Vec2 center;
        double radius;
    } holes[5] = {{{0.22, 0.24}, 0.08}, {{0.78, 0.22}, 0.08}, {{0.24, 0.77}, 0.08},
                  {{0.76, 0.79}, 0.08}, {{0.52, 0.49}, 0.12}};
    for (const auto& hole : holes) {
        NetworkCurve circle;
        circle.geometry = makeCircleArc(hole.center, hole.radius, 0.0, 2.0 * M_PI);
        circle.start = network.addPoint(circle.geometry->point(circle.geometry->first()));
        circle.end = circle.start;
        circle.operand = operand;
        network.curves.push_back(circle);
    }
    const Vec2 lines[4][2] = {{{0.1, 0.45}, {0.3, 0.52}}, {{0.7, 0.55}, {0.92, 0.45}},
                              {{0.45, 0.08}, {0.55, 0.25}}, {{0.42, 0.72}, {0.58, 0.93}}};
    for (const auto& l : lines) {
        const PointId a = network.addPoint(l[0]);
        line(a, network.addPoint(l[1]), Role::Constraint);
    }
    return network;
}

double cpuSeconds()
{
    timespec t {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double meshingSeconds(const StageSeconds& s)
{
    return s.triangulate + s.recover + s.color + s.refine + s.optimize + s.extract;
}

void measureCase(const char* name, const CurveNetwork& network, const SizeField& size,
                 double largest, int repetitions)
{
    MeshOptions options;
    options.memoryLimit = largest * 250.0;
    double best = 1e300;
    std::size_t bytes = 0;
    MeshResult result;
    for (int i = 0; i < repetitions; ++i) {
        result = {};
        const std::size_t before = heapPeak = heapNow;
        Execution execution;
        const double begin = cpuSeconds();
        try {
            result = meshNetwork(network, size, options, execution);
        }
        catch (const Error& error) {
            std::printf("%-22s left out: %s\n", name, error.what());
            return;
        }
        const StageSeconds& s = result.report.seconds;
        const double share = meshingSeconds(s) / std::max(s.total, 1e-9);
        best = std::min(best, share * (cpuSeconds() - begin));
        bytes = heapPeak - before;
    }
    const auto n = static_cast<double>(result.mesh.triangles.size());
    const QualityReport& q = result.report.quality;
    const StageSeconds& s = result.report.seconds;
    std::printf("%-22s %9.0f %6.2f  %.4f %6.2f %6.2f  %.2f %.2f  %4.0f   %.3f %.3f %.3f %.3f  %zu\n",
                name, n, 1e-6 * n / best, q.meanQuality, q.minAngle, q.angleP01,
                q.sizeConformity.p05, q.sizeConformity.p95, static_cast<double>(bytes) / n,
                s.triangulate + s.recover + s.color, s.refine, s.optimize, s.extract,
                result.report.unreached.size());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    const double largest = argc > 1 ? std::atof(argv[1]) : 1.1e6;
    const int repetitions = argc > 2 ? std::atoi(argv[2]) : 3;
    const CurveNetwork network = plate();
    const auto run = [&](const char* name, const SizeField& size) {
        measureCase(name, network, size, largest, repetitions);
    };
    std::printf("%-22s %9s %6s  %6s %6s %6s  %4s %4s  %4s   %5s %5s %5s %5s  %s\n", "case",
                "triangles", "Mtri/s", "mean q", "min", "p01", "L/h", "95 %", "B/t", "cdt", "ref",
                "opt", "ext", "unreached");
    run("uniform 1e4", UniformSize(0.0142));
    run("uniform 1e5", UniformSize(0.00449));
    run("uniform 1e6", UniformSize(0.00142));
    run("uniform 4e6", UniformSize(0.00071));
    const Vec2 point {0.5, 0.3};
    const Vec2 from {0.1, 0.45};
    const Vec2 to {0.3, 0.52};
    run("point 0.0064, 1e6", GradedSize(point, point, 5.9e-5, 0.0064));
    run("segment 0.0153, 1e6", GradedSize(from, to, 1.3e-4, 0.0153));
    run("point 0.02, 1.2e5", GradedSize(point, point, 1e-4, 0.02));
    run("segment 0.05, 1e5", GradedSize(from, to, 4e-4, 0.05));
    run("segment 0.1, 1.7e5", GradedSize(from, to, 1e-4, 0.1));
    run("segment 0.3, 1.2e5", GradedSize(from, to, 5e-5, 0.3));
    run("segment 0.3, 1.2e6", GradedSize(from, to, 5e-6, 0.3));
    return 0;
}
