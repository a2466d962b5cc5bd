// SPDX-License-Identifier: MIT

// Constrained Delaunay triangulation of crossing segments, from points and segments to the finished
// mesh with its constraint map, against CGAL's Constrained_Delaunay_triangulation_2: with inexact
// crossings (EPICK, Exact_predicates_tag) and with exact ones (EPECK, Exact_intersections_tag).
// Same input, same process, process CPU time. `vertices` shows who invents or loses some;
// `bytes_per_vertex` is the greatest growth of the heap during one run over the number of vertices.

#include "../tests/cpp/recover/generators.h"
#include "heap_counter.h"

#include "base/execution.h"
#include "delaunay/delaunay.h"
#include "recover/recover.h"

#include <benchmark/benchmark.h>

#ifdef TESSERA_HAS_CGAL
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace tessera;
using test::RawPslg;

RawPslg uniformPoints(std::size_t n, std::size_t segments)
{
    test::Random random(5);
    RawPslg raw;
    for (std::size_t i = 0; i < n; ++i) {
        raw.addPoint(random.point());
    }
    // Short pieces of horizontal lines at different heights: none cross.
    for (std::size_t i = 0; i < segments; ++i) {
        const double y = (static_cast<double>(i) + 0.5) / static_cast<double>(segments);
        const double x = random.uniform(0.0, 0.99);
        raw.addSegment({x, y}, {x + 0.01, y});
    }
    return raw;
}

void countResult(benchmark::State& state, std::size_t vertices, std::size_t heapBefore)
{
    state.counters["vertices"] = static_cast<double>(vertices);
    state.counters["bytes_per_vertex"]
        = static_cast<double>(HeapCounter::peak() - heapBefore) / static_cast<double>(vertices);
}

void runTessera(benchmark::State& state, const RawPslg& raw, RecoveryStrategy strategy)
{
    std::vector<ConstraintEnds> ends(raw.segments.size());
    for (auto _ : state) {
        const std::size_t before = HeapCounter::restart();
        Execution execution;
        DelaunayResult delaunay = triangulate(raw.points, execution);
        for (std::size_t i = 0; i < ends.size(); ++i) {
            ends[i] = {delaunay.vertexOfPoint[raw.segments[i].first],
                       delaunay.vertexOfPoint[raw.segments[i].second]};
        }
        const RecoveryResult result = recoverBoundaries(std::move(delaunay.triangulation), ends,
                                                        strategy, execution);
        benchmark::DoNotOptimize(result.constraints.uses.data());
        countResult(state, result.triangulation.vertexCount(), before);
    }
}

#ifdef TESSERA_HAS_CGAL
template<class Kernel, class Tag>
void runCgal(benchmark::State& state, const RawPslg& raw)
{
    std::vector<typename Kernel::Point_2> points;
    for (const Vec2 p : raw.points) {
        points.emplace_back(p.x, p.y);
    }
    const std::vector<std::pair<std::size_t, std::size_t>> segments(raw.segments.begin(),
                                                                    raw.segments.end());
    for (auto _ : state) {
        const std::size_t before = HeapCounter::restart();
        CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, Tag> result;
        result.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
        benchmark::DoNotOptimize(result.number_of_faces());
        countResult(state, result.number_of_vertices(), before);
    }
}
#endif

void addBenchmark(const std::string& name, std::function<void(benchmark::State&)> run)
{
    benchmark::RegisterBenchmark(name.c_str(), std::move(run))
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
}

void addInput(const std::string& name, RawPslg raw)
{
    addBenchmark("cavity/" + name, [raw](benchmark::State& state) {
        runTessera(state, raw, RecoveryStrategy::Cavity);
    });
    addBenchmark("steiner/" + name, [raw](benchmark::State& state) {
        runTessera(state, raw, RecoveryStrategy::Steiner);
    });
#ifdef TESSERA_HAS_CGAL
    addBenchmark("cgal_inexact/" + name, [raw](benchmark::State& state) {
        runCgal<CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::Exact_predicates_tag>(
            state, raw);
    });
    addBenchmark("cgal_exact/" + name, [raw](benchmark::State& state) {
        runCgal<CGAL::Exact_predicates_exact_constructions_kernel, CGAL::Exact_intersections_tag>(
            state, raw);
    });
#endif
}

} // namespace

int main(int argc, char** argv)
{
    using namespace tessera::test;
    addInput("long_1000", longSegments(1000, 1));
    addInput("short_100000", shortSegments(100000, 1));
    addInput("lattice_1000", lattice(1000, 100, 1));
    addInput("points_1000000_segments_100000", uniformPoints(1000000, 100000));
    addInput("lattice_rotated", rotated(lattice(1000, 100, 1), 0.3));
    addInput("lattice_by_three", scaled(lattice(1000, 100, 1), 1.0 / 3.0));
    addInput("pencil_400", pencil(400, 1e-15, 1));
    addInput("long_shifted_2_30", shifted(longSegments(1000, 1), 0x1p30, 0x1p30));
    addInput("long_shifted_2_34", shifted(longSegments(1000, 1), 0x1p34, 0x1p34));
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
