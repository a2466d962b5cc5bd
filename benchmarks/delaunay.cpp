// SPDX-License-Identifier: MIT

// Delaunay triangulation of a million points. CGAL: Delaunay_triangulation_2 with exact predicates
// (EPICK). GEOS: GEOSDelaunayTriangulation, which has a tolerance of 0 but no exact predicates and
// writes triangles as polygons. Boost: the Voronoi diagram of Boost.Polygon, which takes 32-bit
// integers only.

#include "section.h"

#include "base/execution.h"
#include "delaunay/delaunay.h"

#ifdef TESSERA_HAS_CGAL
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif
#ifdef TESSERA_HAS_GEOS
#include "geos_peer.h"
#endif
#ifdef TESSERA_HAS_BOOST
#include <boost/polygon/voronoi.hpp>
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
using bench::Result;
using bench::Section;
using Points = std::shared_ptr<const std::vector<Vec2>>;

constexpr std::size_t kCount = 1000000;

class Generator
{
public:
    double unit() { return unit_(random_); }
    double normal() { return normal_(random_); }
    std::size_t index(std::size_t n) { return random_() % n; }

    /// n points in random order.
    template<class F>
    Points make(F&& point)
    {
        std::vector<Vec2> points(kCount);
        for (std::size_t i = 0; i < kCount; ++i) {
            points[i] = point(i);
        }
        std::shuffle(points.begin(), points.end(), random_);
        return std::make_shared<const std::vector<Vec2>>(std::move(points));
    }

    Points uniform()
    {
        return make([this](std::size_t) {
            const double x = unit();
            return Vec2 {x, unit()};
        });
    }
    /// In 0 .. 2^30.
    Points integers()
    {
        return make([this](std::size_t) {
            const double x = std::floor(unit() * 0x1p30);
            return Vec2 {x, std::floor(unit() * 0x1p30)};
        });
    }
    Points grid(double step)
    {
        return make([step](std::size_t i) {
            return step * Vec2 {static_cast<double>(i % 1000), static_cast<double>(i / 1000)};
        });
    }
    /// 100 clusters whose normal deviations run from the first to the last.
    Points clusters(double first, double last)
    {
        constexpr std::size_t kClusters = 100;
        std::vector<Vec2> centers(kClusters);
        for (Vec2& c : centers) {
            c = {unit(), unit()};
        }
        return make([=, this](std::size_t) {
            const std::size_t k = index(kClusters);
            const double t = static_cast<double>(k) / (kClusters - 1);
            const double deviation = first * std::pow(last / first, t);
            const double x = normal();
            return centers[k] + deviation * Vec2 {x, normal()};
        });
    }
    Points circle()
    {
        return make([this](std::size_t) {
            const double angle = 2.0 * std::numbers::pi * unit();
            return Vec2 {std::cos(angle), std::sin(angle)};
        });
    }

private:
    std::mt19937_64 random_ {42};
    std::uniform_real_distribution<double> unit_ {0.0, 1.0};
    std::normal_distribution<double> normal_;
};

void runTessera(Result& result, const Points& points)
{
    Execution execution;
    const DelaunayResult delaunay = triangulate(*points, execution);
    result.vertices = delaunay.triangulation.vertexCount();
}

#ifdef TESSERA_HAS_CGAL
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

void addCgal(Section& section, const std::string& input, const Points& points)
{
    std::vector<Kernel::Point_2> converted;
    for (const Vec2 p : *points) {
        converted.emplace_back(p.x, p.y);
    }
    section.add(input, "CGAL", [converted = std::move(converted)](Result& result) {
        const CGAL::Delaunay_triangulation_2<Kernel> delaunay(converted.begin(), converted.end());
        result.vertices = delaunay.number_of_vertices();
    });
}
#endif

#ifdef TESSERA_HAS_GEOS
void addGeos(Section& section, const std::string& input, const Points& points)
{
    constexpr int kRepetitions = 1; // it takes seconds
    const bench::GeosGeometry converted = bench::geosPoints(*points);
    const auto run = [converted, count = points->size()](Result& result) {
        const bench::GeosGeometry triangles = bench::geosDelaunay(converted);
        result.vertices = triangles ? count : 0;
    };
    section.add(input, "GEOS", run, kRepetitions);
}
#endif

#ifdef TESSERA_HAS_BOOST
void addBoost(Section& section, const std::string& input, const Points& points)
{
    std::vector<boost::polygon::point_data<int>> converted;
    for (const Vec2 p : *points) {
        converted.emplace_back(static_cast<int>(p.x), static_cast<int>(p.y));
    }
    section.add(input, "Boost", [converted = std::move(converted)](Result& result) {
        boost::polygon::voronoi_diagram<double> diagram;
        boost::polygon::construct_voronoi(converted.begin(), converted.end(), &diagram);
        result.vertices = diagram.num_cells();
    });
}
#endif

/// Which peers besides CGAL run.
struct Others
{
    bool geos = false;
    bool boost = false;
};

void addInput(Section& section, const std::string& input, const Points& points, double ratio,
              [[maybe_unused]] Others others = {})
{
    section.add(input, "Tessera", [points](Result& result) { runTessera(result, points); });
#ifdef TESSERA_HAS_CGAL
    addCgal(section, input, points);
#endif
#ifdef TESSERA_HAS_GEOS
    if (others.geos) {
        addGeos(section, input, points);
    }
#endif
#ifdef TESSERA_HAS_BOOST
    if (others.boost) {
        addBoost(section, input, points);
    }
#endif
    section.expect(input, {"CGAL", ratio, 120.0});
}

} // namespace

int main(int argc, char** argv)
{
    Section section("Delaunay triangulation of a million points",
                    bench::peers({"CGAL", "GEOS", "Boost"}));
    Generator generator;
    addInput(section, "uniform", generator.uniform(), 0.4, {.geos = true});
    addInput(section, "grid", generator.grid(1.0), 0.4, {.boost = true});
    addInput(section, "grid of step 0.1", generator.grid(0.1), 0.0);
    addInput(section, "uniform integers", generator.integers(), 0.0, {.boost = true});
    addInput(section, "clusters", generator.clusters(1e-6, 1e-2), 0.5);
    addInput(section, "equal clusters", generator.clusters(1e-3, 1e-3), 0.5);
    addInput(section, "circle", generator.circle(), 0.65);
    return section.run(argc, argv);
}
