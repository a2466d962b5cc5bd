// SPDX-License-Identifier: MIT

// Boundary recovery against brute force in exact rationals: the same vertices, chains and edges
// wherever the true distances allow that.

#include "exact_arrangement.h"
#include "recover/generators.h"
#include "recover/recovery_case.h"
#include "same_mesh.h"

#include <functional>

namespace tessera::test
{
namespace
{

constexpr double kWellConditioned = 1e-12;

/// Returns whether the input was well-conditioned, so that everything was compared.
bool compareWithOracle(const RawPslg& raw)
{
    const Recovered cavity = recoverAndVerify(raw, RecoveryStrategy::Cavity);
    const Recovered steiner = recoverAndVerify(raw, RecoveryStrategy::Steiner);
    const ExactArrangement exact = exactArrangement(raw);
    if (exact.separation < kWellConditioned) {
        return false;
    }
    for (const Recovered* r : {&cavity, &steiner}) {
        const RecoveryResult& result = r->result;
        EXPECT_EQ(result.report.snapPixel, 0.0);
        EXPECT_EQ(result.triangulation.vertexCount(), exact.vertices.size());
        EXPECT_EQ(result.report.crossings, exact.crossings);
        EXPECT_EQ(result.constraints.subsegments.size(), exact.edges);
        for (std::size_t i = 0; i < raw.segments.size(); ++i) {
            const auto chain = result.constraints.chainOf(ConstraintId(i));
            EXPECT_EQ(chain.size(), exact.chains[i].size());
            for (std::size_t k = 0; k < std::min(chain.size(), exact.chains[i].size()); ++k) {
                EXPECT_EQ(result.triangulation.points[chain[k]],
                          nearestPoint(exact.chains[i][k]));
            }
        }
    }
    EXPECT_EQ(meshDifference(cavity.result.triangulation, steiner.result.triangulation), "");
    return true;
}

struct Family
{
    const char* name;
    std::function<RawPslg(std::uint64_t)> make;
    std::size_t cases;
    double wellConditioned; ///< at least this share is
};

class Oracle: public testing::TestWithParam<Family>
{};

TEST_P(Oracle, agrees)
{
    std::size_t compared = 0;
    for (std::uint64_t seed = 0; seed < GetParam().cases && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        compared += compareWithOracle(GetParam().make(seed)) ? 1 : 0;
    }
    EXPECT_GE(static_cast<double>(compared),
              GetParam().wellConditioned * static_cast<double>(GetParam().cases));
}

RawPslg withPoints(RawPslg raw, std::size_t n, std::uint64_t seed)
{
    Random random(seed + 77);
    for (std::size_t i = 0; i < n; ++i) {
        raw.addPoint(random.point());
    }
    return raw;
}

INSTANTIATE_TEST_SUITE_P(
    Recover, Oracle,
    testing::Values(
        Family {"random", [](auto seed) { return longSegments(10, seed); }, 60, 0.9},
        Family {"withPoints", [](auto s) { return withPoints(longSegments(6, s), 40, s); }, 40,
                0.9},
        Family {"lattice", [](auto seed) { return lattice(14, 7, seed); }, 80, 1.0},
        Family {"smallLattice", [](auto seed) { return lattice(14, 4, seed); }, 80, 1.0},
        Family {"latticeOffGrid",
                [](auto s) { return shifted(scaled(lattice(10, 5, s), 0x1p-3), 0.5, 0x1p-7); }, 40,
                1.0},
        Family {"overlaps", [](auto seed) { return overlaps(16, seed); }, 60, 1.0},
        Family {"cocircular", [](auto seed) { return cocircular(7, seed); }, 30, 0.9},
        Family {"star", [](auto s) { return starPolygon(7 + s, 3); }, 8, 0.5},
        Family {"latticeTimes2To300",
                [](auto s) { return scaled(lattice(9, 5, s), 0x1p300); }, 20, 1.0},
        Family {"randomTimes2ToMinus300",
                [](auto s) { return scaled(longSegments(7, s), 0x1p-300); }, 20, 0.9},
        Family {"rotatedLattice", [](auto s) { return rotated(lattice(8, 4, s), 0.3); }, 40, 0.0},
        Family {"pencil", [](auto s) { return pencil(8, 1e-15, s); }, 20, 0.0},
        Family {"sheaf", [](auto s) { return sheaf(8, 1e-15, s); }, 20, 0.0},
        Family {"bundles", [](auto s) { return bundles(2, s); }, 40, 0.0}),
    [](const auto& info) { return info.param.name; });

} // namespace
} // namespace tessera::test
