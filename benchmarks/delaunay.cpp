// SPDX-License-Identifier: MIT

// Delaunay triangulation of 10^6 points against CGAL's Delaunay_triangulation_2 with exact
// predicates (EPICK): same points, same process, process CPU time. `bytes_per_vertex` is the
// greatest growth of the heap during one run over the number of points.

#include "base/execution.h"
#include "delaunay/delaunay.h"

#include <benchmark/benchmark.h>

#ifdef TESSERA_HAS_CGAL
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <malloc.h>
#include <new>
#include <random>
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

using tessera::Vec2;

enum class Kind
{
    Uniform,
    Grid,
    DecimalGrid,
    Clusters,
    MultiScale,
    Circle,
};

std::vector<Vec2> makePoints(Kind kind, std::size_t n)
{
    std::mt19937_64 random(42);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
    std::vector<Vec2> centers(100);
    for (Vec2& c : centers) {
        c = {unit(random), unit(random)};
    }
    std::vector<Vec2> points(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double column = static_cast<double>(i % side);
        const double row = static_cast<double>(i / side);
        const double angle = 2.0 * M_PI * unit(random);
        const std::size_t cluster = random() % centers.size();
        switch (kind) {
            case Kind::Uniform:
                points[i] = {unit(random), unit(random)};
                break;
            case Kind::Grid:
                points[i] = {column, row};
                break;
            case Kind::DecimalGrid:
                points[i] = {0.1 * column, 0.1 * row};
                break;
            case Kind::Clusters:
                points[i] = centers[cluster] + 1e-3 * Vec2 {normal(random), normal(random)};
                break;
            case Kind::MultiScale:
                points[i] = centers[cluster]
                    + std::pow(10.0, -2.0 - 0.06 * static_cast<double>(cluster))
                        * Vec2 {normal(random), normal(random)};
                break;
            case Kind::Circle:
                points[i] = {std::cos(angle), std::sin(angle)};
                break;
        }
    }
    std::shuffle(points.begin(), points.end(), random);
    return points;
}

void countMemory(benchmark::State& state, std::size_t before, std::size_t points)
{
    state.counters["bytes_per_vertex"]
        = static_cast<double>(heapPeak - before) / static_cast<double>(points);
}

void tesseraDelaunay(benchmark::State& state, Kind kind)
{
    const std::vector<Vec2> points = makePoints(kind, static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        const std::size_t before = heapPeak = heapNow;
        tessera::Execution execution;
        const tessera::DelaunayResult result = tessera::triangulate(points, execution);
        benchmark::DoNotOptimize(result.triangulation.triangles.data());
        countMemory(state, before, points.size());
    }
}

#ifdef TESSERA_HAS_CGAL
void cgalDelaunay(benchmark::State& state, Kind kind)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_2> points;
    for (const Vec2 p : makePoints(kind, static_cast<std::size_t>(state.range(0)))) {
        points.emplace_back(p.x, p.y);
    }
    for (auto _ : state) {
        const std::size_t before = heapPeak = heapNow;
        const CGAL::Delaunay_triangulation_2<Kernel> result(points.begin(), points.end());
        benchmark::DoNotOptimize(result.number_of_faces());
        countMemory(state, before, points.size());
    }
}
#define PEER(name, kind)                                                                           \
    BENCHMARK_CAPTURE(cgalDelaunay, name, kind)                                                    \
        ->Arg(1000000)                                                                             \
        ->Unit(benchmark::kMillisecond)                                                            \
        ->MeasureProcessCPUTime()
#else
#define PEER(name, kind) static_assert(true)
#endif

#define OURS_AND_PEER(name, kind)                                                                  \
    BENCHMARK_CAPTURE(tesseraDelaunay, name, kind)                                                 \
        ->Arg(1000000)                                                                             \
        ->Unit(benchmark::kMillisecond)                                                            \
        ->MeasureProcessCPUTime();                                                                 \
    PEER(name, kind)

OURS_AND_PEER(uniform, Kind::Uniform);
OURS_AND_PEER(grid, Kind::Grid);
OURS_AND_PEER(decimal_grid, Kind::DecimalGrid);
OURS_AND_PEER(clusters, Kind::Clusters);
OURS_AND_PEER(multi_scale, Kind::MultiScale);
OURS_AND_PEER(circle, Kind::Circle);

} // namespace

BENCHMARK_MAIN();
