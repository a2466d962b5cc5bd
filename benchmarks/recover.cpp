// SPDX-License-Identifier: MIT

// Constrained Delaunay triangulation of crossing segments, from points and segments to the finished
// mesh with its constraint map. CGAL: Constrained_Delaunay_triangulation_2, with inexact crossings
// (EPICK, Exact_predicates_tag) and with exact ones (EPECK, Exact_intersections_tag). GEOS: noding
// by OverlayNG, which splits the segments and makes no triangles. `vertices` shows who invents or
// loses some.
//
// Both ways to recover are shown; the direct one is the default.

#include "recover_engines.h"

#ifdef TESSERA_HAS_GEOS
#include "geos_peer.h"
#endif

#include <cstddef>
#include <memory>
#include <string>

namespace
{

using namespace tessera;
using bench::Expectation;
using bench::Result;
using bench::Section;
using test::RawPslg;
using Input = std::shared_ptr<const RawPslg>;

constexpr int kSlow = 1; ///< repetitions of what takes seconds

/// Points, and short pieces of horizontal lines at different heights: none cross.
RawPslg uniformPoints(std::size_t n, std::size_t segments)
{
    test::Random random(5);
    RawPslg raw;
    for (std::size_t i = 0; i < n; ++i) {
        raw.addPoint(random.point());
    }
    for (std::size_t i = 0; i < segments; ++i) {
        const double y = (static_cast<double>(i) + 0.5) / static_cast<double>(segments);
        const double x = random.uniform(0.0, 0.99);
        raw.addSegment({x, y}, {x + 0.01, y});
    }
    return raw;
}

void addInput(Section& section, const std::string& name, const RawPslg& raw,
              const Expectation& expectation)
{
    const Input input = std::make_shared<const RawPslg>(raw);
    section.add(name, "Tessera", [input](Result& result) {
        bench::runTessera(result, *input, RecoveryStrategy::Cavity);
    });
    section.add(name, "Tessera, paper's way", [input](Result& result) {
        bench::runTessera(result, *input, RecoveryStrategy::Steiner);
    });
#ifdef TESSERA_HAS_CGAL
    section.add(name, "CGAL inexact", bench::cgalInexact(raw));
    section.add(name, "CGAL exact", bench::cgalExact(raw), kSlow);
#endif
#ifdef TESSERA_HAS_GEOS
    const bench::GeosGeometry lines = bench::geosLines(raw.points, raw.segments);
    section.add(name, "GEOS noding",
                [lines](Result&) { benchmark::DoNotOptimize(bench::geosNoding(lines)); }, kSlow);
#endif
    section.expect(name, expectation);
}

} // namespace

int main(int argc, char** argv)
{
    using namespace tessera::test;
    const RawPslg longOnes = longSegments(1000, 1);
    const RawPslg concurrent = lattice(1000, 100, 1);
    const Expectation fast {"CGAL inexact", 0.5, 200.0};
    const Expectation hard {"CGAL exact", 1.0, 0.0};
    Section section("Constraints, crossing or not", bench::peers({"CGAL", "GEOS"}));
    addInput(section, "1,000 long", longOnes, fast);
    addInput(section, "100,000 short", shortSegments(100000, 1), fast);
    addInput(section, "lattice", concurrent, fast);
    addInput(section, "10^6 points, 10^5 segments", uniformPoints(1000000, 100000),
             {"CGAL inexact", 0.0, 200.0});
    addInput(section, "lattice turned", rotated(concurrent, 0.3), hard);
    addInput(section, "lattice by three", scaled(concurrent, 1.0 / 3.0), hard);
    addInput(section, "pencil 1e-15 wide", pencil(400, 1e-15, 1), hard);
    addInput(section, "1,000 long + 2^30", shifted(longOnes, 0x1p30, 0x1p30), hard);
    addInput(section, "1,000 long + 2^34", shifted(longOnes, 0x1p34, 0x1p34), hard);
    return section.run(argc, argv);
}
