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

#include "section.h"

#include "imprint/overlay.h"

#ifdef TESSERA_HAS_CGAL
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#endif
#ifdef TESSERA_HAS_GEOS
#include "geos_peer.h"
#endif
#ifdef TESSERA_HAS_BOOST
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#endif
#ifdef TESSERA_HAS_CLIPPER
#include <polyclipping/clipper.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace tessera;
using bench::Expectation;
using bench::Result;
using bench::Section;
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

/// A circle with a random radius at each point.
Ring rough(std::size_t n, Vec2 center, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Ring ring;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double radius = 1.0 + 1e-4 * unit(random);
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

Section::Run tesseraRun(const Rings& rings, BooleanOperation operation)
{
    return [network = networkOf(rings), operation](Result& result) {
        OverlayOptions options;
        options.operation = operation;
        options.form = OverlayForm::Polygons;
        Execution execution;
        const OverlayResult overlay = overlayNetwork(network, options, execution);
        result.vertices = overlay.polygons.vertices.size();
        result.columns["area"] = overlay.report.area;
        result.columns["polygons"] = static_cast<double>(overlay.polygons.size());
    };
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

Section::Run cgalRun(const Rings& rings)
{
    return [a = cgalPolygon(rings[0]), b = cgalPolygon(rings[1])](Result& out) {
        CGAL::Polygon_set_2<Exact> set(a);
        set.intersection(b);
        std::vector<CGAL::Polygon_with_holes_2<Exact>> result;
        set.polygons_with_holes(std::back_inserter(result));
        double area = 0.0;
        for (const auto& polygon : result) {
            area += CGAL::to_double(polygon.outer_boundary().area());
        }
        out.columns["area"] = area;
    };
}

Section::Run cgalCellsRun(const Rings& rings)
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
    return [segments](Result& out) {
        Arrangement arrangement;
        const std::vector<Arrangement::X_monotone_curve_2> curves(segments.begin(),
                                                                  segments.end());
        CGAL::insert(arrangement, curves.begin(), curves.end());
        out.columns["polygons"] = static_cast<double>(arrangement.number_of_faces() - 1);
    };
}
#endif

#ifdef TESSERA_HAS_GEOS
bench::GeosGeometry geosPolygon(const Ring& ring)
{
    return bench::geosOwned(
        GEOSGeom_createPolygon_r(bench::geosContext(), bench::geosRing(ring), nullptr, 0));
}

Section::Run geosRun(const Rings& rings)
{
    return [a = geosPolygon(rings[0]), b = geosPolygon(rings[1])](Result& out) {
        const auto result =
            bench::geosOwned(GEOSIntersection_r(bench::geosContext(), a.get(), b.get()));
        double area = 0.0;
        GEOSArea_r(bench::geosContext(), result.get(), &area);
        out.columns["area"] = area;
    };
}

Section::Run geosCellsRun(const Rings& rings)
{
    std::vector<GEOSGeometry*> lines;
    for (const Ring& ring : rings) {
        lines.push_back(bench::geosRing(ring));
    }
    return [all = bench::geosCollection(GEOS_MULTILINESTRING, lines)](Result& out) {
        const auto noded = bench::geosNoding(all);
        const GEOSGeometry* list[] = {noded.get()};
        const auto cells = bench::geosOwned(GEOSPolygonize_r(bench::geosContext(), list, 1));
        out.columns["polygons"] = GEOSGetNumGeometries_r(bench::geosContext(), cells.get());
    };
}
#endif

#ifdef TESSERA_HAS_BOOST
Section::Run boostRun(const Rings& rings)
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
    return [a = polygonOf(rings[0]), b = polygonOf(rings[1])](Result& out) {
        bg::model::multi_polygon<Polygon> result;
        bg::intersection(a, b, result);
        out.columns["area"] = bg::area(result);
    };
}
#endif

#ifdef TESSERA_HAS_CLIPPER
Section::Run clipperRun(const Rings& rings)
{
    constexpr double kScale = 1e12; // integers of about 40 bits: doubles on the unit circle
    const auto pathOf = [](const Ring& ring) {
        ClipperLib::Path path;
        for (const Vec2 p : ring) {
            path.emplace_back(std::llround(p.x * kScale), std::llround(p.y * kScale));
        }
        return path;
    };
    return [a = pathOf(rings[0]), b = pathOf(rings[1])](Result& out) {
        ClipperLib::Clipper clipper;
        clipper.AddPath(a, ClipperLib::ptSubject, true);
        clipper.AddPath(b, ClipperLib::ptClip, true);
        ClipperLib::PolyTree result;
        clipper.Execute(ClipperLib::ctIntersection, result);
        double area = 0.0;
        for (const auto* node = result.GetFirst(); node != nullptr; node = node->GetNext()) {
            area += ClipperLib::Area(node->Contour);
        }
        out.columns["area"] = area / kScale / kScale;
    };
}
#endif

constexpr int kSlow = 1; ///< repetitions of what takes seconds

void addStars(Section& section, const std::string& name, const Rings& rings)
{
    section.add(name, "Tessera", tesseraRun(rings, BooleanOperation::Intersection));
#ifdef TESSERA_HAS_CGAL
    section.add(name, "CGAL", cgalRun(rings), kSlow);
#endif
    section.expect(name, {"CGAL", 0.2, 0.0});
}

void addWiggly(Section& section, const std::string& name, const Rings& rings)
{
    section.add(name, "Tessera", tesseraRun(rings, BooleanOperation::Intersection));
#ifdef TESSERA_HAS_GEOS
    section.add(name, "GEOS", geosRun(rings));
#endif
#ifdef TESSERA_HAS_BOOST
    section.add(name, "Boost", boostRun(rings));
#endif
    section.expect(name, {"GEOS", 0.5, 0.0});
}

void addFew(Section& section, const std::string& name, const Rings& rings)
{
    section.add(name, "Tessera", tesseraRun(rings, BooleanOperation::Intersection));
#ifdef TESSERA_HAS_GEOS
    section.add(name, "GEOS", geosRun(rings));
#endif
#ifdef TESSERA_HAS_CLIPPER
    section.add(name, "Clipper", clipperRun(rings));
#endif
    section.expect(name, {"Clipper", 1.0, 0.0});
}

void addCells(Section& section, const std::string& name, const Rings& rings)
{
    section.add(name, "Tessera", tesseraRun(rings, BooleanOperation::Cells));
#ifdef TESSERA_HAS_CGAL
    section.add(name, "CGAL", cgalCellsRun(rings), kSlow);
#endif
#ifdef TESSERA_HAS_GEOS
    section.add(name, "GEOS", geosCellsRun(rings), kSlow);
#endif
    section.expect(name, {"CGAL", 0.4, 0.0});
}

} // namespace

int main(int argc, char** argv)
{
    constexpr std::size_t kPoints = 100000;
    const auto n = static_cast<double>(kPoints);
    const Vec2 origin;
    Section section("Overlays of polygons with 10^5 points",
                    bench::peers({"CGAL", "GEOS", "Boost", "Clipper"}));
    section.note("Clipper's time on *few crossings* depends on what ran before it in the process; "
                 "alone with Tessera: `tools/bench overlay -- "
                 "--benchmark_filter='few crossings/(T|C)'`.");
    addStars(section, "stars", {star(kPoints, 0.0), star(kPoints, 2.0 * std::numbers::pi / n)});
    addWiggly(section, "wiggly",
              {waves(kPoints, origin, 1e-5, n / 2.0 + 0.3, 0.1),
               waves(kPoints, origin, 1e-5, n / 2.0 - 0.3, 1.7)});
    addFew(section, "few crossings",
           {waves(kPoints, origin, 0.1, 7.0, 0.1), waves(kPoints, {0.3, 0.2}, 0.1, 5.0, 0.5)});
    addFew(section, "few crossings, rough",
           {rough(kPoints, origin, 1), rough(kPoints, {0.3, 0.2}, 2)});
    addCells(section, "1,000 polygons to cells", overlappingPolygons(1000));
    return section.run(argc, argv);
}
