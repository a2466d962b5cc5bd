// SPDX-License-Identifier: MIT

// Boolean operations on polygons in memory to polygons in memory, against CGAL's Polygon_set_2 and
// Arrangement_2, GEOS (OverlayNG; node and polygonize), Boost.Geometry and Clipper 6. Same input,
// same process, process CPU time. `area` shows that all mean the same.
//
//   stars    two stars with n points, O(n) crossings, long thin triangles
//   wiggly   two wiggly outlines, n local crossings
//   few      two smooth outlines with n points and four crossings
//   cells    a thousand overlapping polygons to all cells of their arrangement
//
// A peer that needs more than half a minute for an input is left out there.

#include "imprint/overlay.h"

#include <benchmark/benchmark.h>

#ifdef TESSERA_HAS_CGAL
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#endif
#ifdef TESSERA_HAS_GEOS
#include <geos_c.h>
#endif
#ifdef TESSERA_HAS_BOOST
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#endif
#ifdef TESSERA_HAS_CLIPPER
#include <polyclipping/clipper.hpp>
#endif

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace tessera;
using Ring = std::vector<Vec2>;
using Rings = std::vector<Ring>;

Ring star(std::size_t n, double phase)
{
    Ring ring;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle =
            phase + 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double radius = i % 2 == 0 ? 1.0 : 0.5;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

/// A circle around a center whose radius waves.
Ring waves(std::size_t n, Vec2 center, double amplitude, double count, double phase)
{
    Ring ring;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double radius = 1.0 + amplitude * std::sin(count * angle + phase);
        ring.push_back(center + radius * Vec2 {std::cos(angle), std::sin(angle)});
    }
    return ring;
}

Rings overlappingPolygons(std::size_t count)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Rings rings(count);
    for (Ring& ring : rings) {
        const Vec2 center {unit(random), unit(random)};
        for (int i = 0; i < 20; ++i) {
            const double radius = 0.115 * (1.0 + 0.2 * unit(random));
            const double angle = 2.0 * std::numbers::pi * i / 20.0;
            ring.push_back(center + radius * Vec2 {std::cos(angle), std::sin(angle)});
        }
    }
    return rings;
}

CurveNetwork networkOf(const Rings& rings)
{
    CurveNetwork network;
    network.operands.resize(rings.size());
    for (std::size_t o = 0; o < rings.size(); ++o) {
        const std::size_t first = network.points.size();
        network.points.insert(network.points.end(), rings[o].begin(), rings[o].end());
        for (std::size_t i = 0; i < rings[o].size(); ++i) {
            network.curves.push_back({nullptr, PointId(first + i),
                                      PointId(first + (i + 1) % rings[o].size()), OperandId(o)});
        }
    }
    return network;
}

void runTessera(benchmark::State& state, const Rings& rings, BooleanOperation operation)
{
    const CurveNetwork network = networkOf(rings);
    OverlayOptions options;
    options.operation = operation;
    for (auto _ : state) {
        state.PauseTiming();
        CurveNetwork input = network;
        state.ResumeTiming();
        Execution execution;
        const OverlayResult result = overlayNetwork(std::move(input), options, execution);
        state.counters["area"] = result.report.area;
        state.counters["polygons"] = static_cast<double>(result.polygons.size());
        state.counters["crossings"] = static_cast<double>(result.report.recovery.crossings);
        const StageSeconds& s = result.report.seconds;
        state.counters["arrange"] = s.arrange;
        state.counters["triangulate"] = s.triangulate;
        state.counters["recover"] = s.recover;
        state.counters["color"] = s.color;
        state.counters["outline"] = s.extract;
    }
}

#ifdef TESSERA_HAS_CGAL
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

CGAL::Polygon_2<Exact> cgalPolygon(const Ring& ring)
{
    CGAL::Polygon_2<Exact> polygon;
    for (const Vec2 p : ring) {
        polygon.push_back({p.x, p.y});
    }
    return polygon;
}

void runCgal(benchmark::State& state, const Rings& rings)
{
    const auto a = cgalPolygon(rings[0]);
    const auto b = cgalPolygon(rings[1]);
    for (auto _ : state) {
        CGAL::Polygon_set_2<Exact> set(a);
        set.intersection(b);
        std::vector<CGAL::Polygon_with_holes_2<Exact>> result;
        set.polygons_with_holes(std::back_inserter(result));
        double area = 0.0;
        for (const auto& polygon : result) {
            area += CGAL::to_double(polygon.outer_boundary().area());
        }
        state.counters["area"] = area;
    }
}

void runCgalCells(benchmark::State& state, const Rings& rings)
{
    using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Exact>>;
    std::vector<Exact::Segment_2> segments;
    for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 p = ring[i];
            const Vec2 q = ring[(i + 1) % ring.size()];
            segments.emplace_back(Exact::Point_2(p.x, p.y), Exact::Point_2(q.x, q.y));
        }
    }
    for (auto _ : state) {
        Arrangement arrangement;
        const std::vector<Arrangement::X_monotone_curve_2> curves(segments.begin(),
                                                                  segments.end());
        CGAL::insert(arrangement, curves.begin(), curves.end());
        state.counters["polygons"] = static_cast<double>(arrangement.number_of_faces() - 1);
    }
}
#endif

#ifdef TESSERA_HAS_GEOS
class Geos
{
public:
    Geos()
        : context_(GEOS_init_r())
    {}
    ~Geos() { GEOS_finish_r(context_); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;
    GEOSContextHandle_t context() const { return context_; }

    GEOSGeometry* ring(const Ring& points) const
    {
        const auto count = static_cast<unsigned>(points.size() + 1);
        GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, count, 2);
        for (unsigned i = 0; i < count; ++i) {
            const Vec2 p = points[i % points.size()];
            GEOSCoordSeq_setXY_r(context_, sequence, i, p.x, p.y);
        }
        return GEOSGeom_createLinearRing_r(context_, sequence);
    }
    GEOSGeometry* polygon(const Ring& points) const
    {
        return GEOSGeom_createPolygon_r(context_, ring(points), nullptr, 0);
    }

private:
    GEOSContextHandle_t context_;
};

void runGeos(benchmark::State& state, const Rings& rings)
{
    const Geos geos;
    GEOSGeometry* a = geos.polygon(rings[0]);
    GEOSGeometry* b = geos.polygon(rings[1]);
    for (auto _ : state) {
        GEOSGeometry* result = GEOSIntersection_r(geos.context(), a, b);
        double area = 0.0;
        GEOSArea_r(geos.context(), result, &area);
        state.counters["area"] = area;
        GEOSGeom_destroy_r(geos.context(), result);
    }
    GEOSGeom_destroy_r(geos.context(), a);
    GEOSGeom_destroy_r(geos.context(), b);
}

void runGeosCells(benchmark::State& state, const Rings& rings)
{
    const Geos geos;
    std::vector<GEOSGeometry*> lines;
    for (const Ring& ring : rings) {
        lines.push_back(geos.ring(ring));
    }
    GEOSGeometry* all =
        GEOSGeom_createCollection_r(geos.context(), GEOS_MULTILINESTRING, lines.data(),
                                    static_cast<unsigned>(lines.size()));
    for (auto _ : state) {
        GEOSGeometry* noded = GEOSUnaryUnion_r(geos.context(), all);
        const GEOSGeometry* list[] = {noded};
        GEOSGeometry* cells = GEOSPolygonize_r(geos.context(), list, 1);
        state.counters["polygons"] = GEOSGetNumGeometries_r(geos.context(), cells);
        GEOSGeom_destroy_r(geos.context(), cells);
        GEOSGeom_destroy_r(geos.context(), noded);
    }
    GEOSGeom_destroy_r(geos.context(), all);
}
#endif

#ifdef TESSERA_HAS_BOOST
void runBoost(benchmark::State& state, const Rings& rings)
{
    namespace bg = boost::geometry;
    using Point = bg::model::d2::point_xy<double>;
    using Polygon = bg::model::polygon<Point, false>;
    const auto polygonOf = [](const Ring& ring) {
        Polygon polygon;
        for (const Vec2 p : ring) {
            polygon.outer().emplace_back(p.x, p.y);
        }
        polygon.outer().push_back(polygon.outer().front());
        return polygon;
    };
    const Polygon a = polygonOf(rings[0]);
    const Polygon b = polygonOf(rings[1]);
    for (auto _ : state) {
        bg::model::multi_polygon<Polygon> result;
        bg::intersection(a, b, result);
        state.counters["area"] = bg::area(result);
    }
}
#endif

#ifdef TESSERA_HAS_CLIPPER
void runClipper(benchmark::State& state, const Rings& rings)
{
    constexpr double kScale = 1e12; // integers of about 40 bits: doubles on the unit circle
    const auto pathOf = [](const Ring& ring) {
        ClipperLib::Path path;
        for (const Vec2 p : ring) {
            path.emplace_back(std::llround(p.x * kScale), std::llround(p.y * kScale));
        }
        return path;
    };
    const auto a = pathOf(rings[0]);
    const auto b = pathOf(rings[1]);
    for (auto _ : state) {
        ClipperLib::Clipper clipper;
        clipper.AddPath(a, ClipperLib::ptSubject, true);
        clipper.AddPath(b, ClipperLib::ptClip, true);
        ClipperLib::PolyTree result;
        clipper.Execute(ClipperLib::ctIntersection, result);
        double area = 0.0;
        for (const auto* node = result.GetFirst(); node != nullptr; node = node->GetNext()) {
            area += ClipperLib::Area(node->Contour);
        }
        state.counters["area"] = area / kScale / kScale;
    }
}
#endif

void add(const std::string& name, std::function<void(benchmark::State&)> run)
{
    benchmark::RegisterBenchmark(name.c_str(), std::move(run))
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
}

struct Peers
{
    bool cgal = false;
    bool geos = false;
    bool boost = false;
    bool clipper = false;
};

void addIntersection(const std::string& name, const Rings& rings, [[maybe_unused]] Peers peers)
{
    add("tessera/" + name, [rings](benchmark::State& state) {
        runTessera(state, rings, BooleanOperation::Intersection);
    });
#ifdef TESSERA_HAS_CGAL
    if (peers.cgal) {
        add("cgal/" + name, [rings](benchmark::State& state) { runCgal(state, rings); });
    }
#endif
#ifdef TESSERA_HAS_GEOS
    if (peers.geos) {
        add("geos/" + name, [rings](benchmark::State& state) { runGeos(state, rings); });
    }
#endif
#ifdef TESSERA_HAS_BOOST
    if (peers.boost) {
        add("boost/" + name, [rings](benchmark::State& state) { runBoost(state, rings); });
    }
#endif
#ifdef TESSERA_HAS_CLIPPER
    if (peers.clipper) {
        add("clipper/" + name, [rings](benchmark::State& state) { runClipper(state, rings); });
    }
#endif
}

} // namespace

int main(int argc, char** argv)
{
    constexpr std::size_t kPoints = 100000;
    const double n = static_cast<double>(kPoints);
    const Vec2 origin;
    addIntersection("stars", {star(kPoints, 0.0), star(kPoints, 2.0 * std::numbers::pi / n)},
                    {.cgal = true});
    addIntersection("wiggly",
                    {waves(kPoints, origin, 1e-5, n / 2.0 + 0.3, 0.1),
                     waves(kPoints, origin, 1e-5, n / 2.0 - 0.3, 1.7)},
                    {.geos = true, .boost = true});
    addIntersection("few",
                    {waves(kPoints, origin, 0.1, 7.0, 0.1),
                     waves(kPoints, {0.3, 0.2}, 0.1, 5.0, 0.5)},
                    {.geos = true, .clipper = true});
    const Rings polygons = overlappingPolygons(1000);
    add("tessera/cells", [&polygons](benchmark::State& state) {
        runTessera(state, polygons, BooleanOperation::Cells);
    });
#ifdef TESSERA_HAS_CGAL
    add("cgal/cells", [&polygons](benchmark::State& state) { runCgalCells(state, polygons); });
#endif
#ifdef TESSERA_HAS_GEOS
    add("geos/cells", [&polygons](benchmark::State& state) { runGeosCells(state, polygons); });
#endif
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
