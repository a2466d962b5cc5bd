// SPDX-License-Identifier: MIT

// Random inputs of the kinds on which rounding crossings without a grid never ends, many of each,
// one after the other: see tests/cpp/recover/generators.h. TESSERA_KILLERS says how many of each
// kind, 100 by default.

#include "recover_engines.h"

#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace
{

using namespace tessera;
using bench::Result;
using bench::Section;
using test::RawPslg;

std::size_t killerCount()
{
    const char* given = std::getenv("TESSERA_KILLERS");
    return given != nullptr ? std::strtoul(given, nullptr, 10) : 100;
}

/// Of all inputs, of which only one is in memory at a time: no bytes per vertex.
void showVertices(Result& result)
{
    result.columns["vertices"] = static_cast<double>(result.vertices);
    result.vertices = 0;
}

void addKind(Section& section, const std::string& name,
             const std::function<RawPslg(std::uint64_t)>& make)
{
    const auto inputs = std::make_shared<std::vector<RawPslg>>();
    for (std::uint64_t seed = 0; seed < killerCount(); ++seed) {
        inputs->push_back(make(seed));
    }
    section.add(name, "Tessera", [inputs](Result& result) {
        for (const RawPslg& raw : *inputs) {
            bench::runTessera(result, raw, RecoveryStrategy::Cavity);
        }
        showVertices(result);
    });
#ifdef TESSERA_HAS_CGAL
    section.add(name, "CGAL exact", [inputs](Result& result) {
        for (const RawPslg& raw : *inputs) {
            bench::cgalExact(raw)(result);
        }
        showVertices(result);
    }, 1);
#endif
    section.expect(name, {"CGAL exact", 1.0, 0.0});
}

} // namespace

int main(int argc, char** argv)
{
    using namespace tessera::test;
    Section section("Ill-conditioned inputs, " + std::to_string(killerCount()) + " of each kind",
                    bench::peers({"CGAL"}));
    addKind(section, "lattices turned", [](std::uint64_t seed) {
        return rotated(lattice(150, 30, seed), 0.3 + 0.001 * static_cast<double>(seed));
    });
    addKind(section, "lattices by three",
            [](std::uint64_t seed) { return scaled(lattice(150, 30, seed), 1.0 / 3.0); });
    addKind(section, "pencils 1e-15 wide",
            [](std::uint64_t seed) { return pencil(60, 1e-15, seed); });
    addKind(section, "sheaves 1e-15 wide",
            [](std::uint64_t seed) { return sheaf(24, 1e-15, seed); });
    addKind(section, "bundles of four", [](std::uint64_t seed) { return bundles(14, seed); });
    addKind(section, "long segments + 2^30", [](std::uint64_t seed) {
        return shifted(longSegments(80, seed), 0x1p30, 0x1p30);
    });
    addKind(section, "long segments + 2^34", [](std::uint64_t seed) {
        return shifted(longSegments(80, seed), 0x1p34, 0x1p34);
    });
    return section.run(argc, argv);
}
