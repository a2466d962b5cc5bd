// SPDX-License-Identifier: MIT

// A thousand random domains (tests/cpp/pipeline/random_domains.h), about 5,000 triangles each. broken:
// meshes that are not valid; hidden: triangles below min(30 degrees, smallest input angle) that the
// report does not list; below: domains with such triangles; blunt: domains without an angle below 60
// degrees, and the share of those whose meshes have no angle below 32 degrees.

#include "section.h"

#include "pipeline/random_domains.h"

namespace
{

using namespace tessera;

void meshDomains(bench::Result& result)
{
    constexpr unsigned kDomains = 1000;
    testing::RandomDomainTally tally;
    for (unsigned seed = 1; seed <= kDomains; ++seed) {
        tally.add(seed, 0.03);
    }
    result.columns = {{"domains", static_cast<double>(tally.domains)},
                      {"triangles", static_cast<double>(tally.triangles)},
                      {"broken", static_cast<double>(tally.broken)},
                      {"hidden", static_cast<double>(tally.hidden)},
                      {"below", static_cast<double>(tally.below)},
                      {"blunt", static_cast<double>(tally.blunt)},
                      {"blunt ≥ 32°", static_cast<double>(tally.bluntGood)
                           / static_cast<double>(tally.blunt)},
                      {"worst", tally.worst}};
}

} // namespace

int main(int argc, char** argv)
{
    bench::Section section("A thousand random domains", "");
    section.add("stars with holes and lines", "Tessera", meshDomains, 1);
    section.expect("stars with holes and lines",
                   {.atLeast = {{"domains", 1000}, {"blunt ≥ 32°", 0.95}},
                    .atMost = {{"broken", 0}, {"hidden", 0}}});
    return section.run(argc, argv);
}
