// SPDX-License-Identifier: MIT

// Boundary recovery on families of inputs that break kernels: valid, verified, the same by both
// strategies, and the same for exact copies.

#include "integer_arrangement.h"
#include "recover/generators.h"
#include "recover/recovery_case.h"
#include "rounded_arrangement.h"
#include "same_mesh.h"

#include <cstdlib>
#include <functional>

namespace tessera::test
{
namespace
{

/// How many seeds of each family: one unless TESSERA_FAMILY_CASES says otherwise.
std::size_t caseCount()
{
    const char* given = std::getenv("TESSERA_FAMILY_CASES");
    return given != nullptr ? std::strtoul(given, nullptr, 10) : 1;
}

struct Family
{
    const char* name;
    std::function<RawPslg(std::uint64_t)> make;
    bool fastPath; ///< well-conditioned: no snap rounding
};

class Families: public testing::TestWithParam<Family>
{};

/// The same straight pieces: counts that do not depend on where the copy lies.
void expectSameCounts(const Recovered& r, const Recovered& copy)
{
    EXPECT_EQ(copy.result.report.crossings, r.result.report.crossings);
    EXPECT_EQ(copy.result.report.touches, r.result.report.touches);
    EXPECT_EQ(copy.result.report.overlaps, r.result.report.overlaps);
    EXPECT_EQ(copy.result.constraints.subsegments.size(), r.result.constraints.subsegments.size());
}

TEST_P(Families, areValidByBothStrategies)
{
    for (std::uint64_t seed = 0; seed < caseCount(); ++seed) {
        SCOPED_TRACE(seed);
        const RawPslg raw = GetParam().make(seed);
        const Recovered cavity = recoverAndVerify(raw, RecoveryStrategy::Cavity);
        const Recovered steiner = recoverAndVerify(raw, RecoveryStrategy::Steiner);
        const RecoveryReport& report = cavity.result.report;
        EXPECT_TRUE(report.snapPixel == 0.0 || !GetParam().fastPath);
        EXPECT_EQ(steiner.result.report.snapPixel, report.snapPixel);
        EXPECT_EQ(meshDifference(cavity.result.triangulation, steiner.result.triangulation), "");
        if (report.snapPixel > 0.0) {
            EXPECT_LE(report.maxDisplacement, 0.75 * report.snapPixel);
        }
        else {
            const std::vector<Vec2>& points = cavity.result.triangulation.points;
            std::vector<Vec2> vertices(points.begin() + 1, points.end());
            sortUnique(vertices);
            EXPECT_EQ(vertices, roundedArrangement(raw));
        }
    }
}

/// Only these: how often chains merge on a grid may differ with the position on it.
class WellConditioned: public testing::TestWithParam<Family>
{};

TEST_P(WellConditioned, exactCopiesGiveTheSame)
{
    const RawPslg raw = GetParam().make(3);
    const Recovered r = recoverAndVerify(raw);
    const auto check = [&](const RawPslg& copy) { expectSameCounts(r, recoverAndVerify(copy)); };
    check(transformed(raw, [](Vec2 p) { return Vec2 {p.x, -p.y}; }));
    check(transformed(raw, [](Vec2 p) { return Vec2 {-p.y, p.x}; }));
    check(scaled(raw, 0x1p300));
    check(scaled(raw, 0x1p-300));
    RawPslg reversed = raw;
    std::reverse(reversed.segments.begin(), reversed.segments.end());
    for (auto& [a, b] : reversed.segments) {
        std::swap(a, b);
    }
    check(reversed);
}

TEST_P(Families, movedCopiesAreValid)
{
    const RawPslg raw = GetParam().make(5);
    recoverAndVerify(rotated(raw, 0.3));
    recoverAndVerify(shifted(raw, 1e15, -1e15));
    recoverAndVerify(shifted(scaled(raw, 1e-9), 0.125, 1e3));
}

TEST_P(Families, resultsAreTheSameEveryTime)
{
    const RawPslg raw = GetParam().make(7);
    const Recovered first = recoverRaw(raw, RecoveryStrategy::Cavity);
    const Recovered second = recoverRaw(raw, RecoveryStrategy::Cavity);
    EXPECT_EQ(first.result.triangulation.points, second.result.triangulation.points);
    EXPECT_EQ(first.result.constraints.chainVertices, second.result.constraints.chainVertices);
    const auto& a = first.result.triangulation.triangles;
    const auto& b = second.result.triangulation.triangles;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t t = 0; t < a.size(); ++t) {
        EXPECT_TRUE(std::equal(a[t].v, a[t].v + 3, b[t].v)
                    && std::equal(a[t].link, a[t].link + 3, b[t].link));
    }
}

const Family kWellConditioned[] = {
    {"longSegments", [](auto s) { return longSegments(150, s); }, true},
    {"shortSegments", [](auto s) { return shortSegments(3000, s); }, true},
    {"lattice", [](auto s) { return lattice(300, 40, s); }, true},
    {"denseLattice", [](auto s) { return lattice(300, 9, s); }, true},
    {"overlaps", [](auto s) { return overlaps(300, s); }, true},
    {"cocircular", [](auto s) { return cocircular(60, s); }, true},
    {"spirals", [](auto s) { return spirals(1500 + s); }, true},
    {"star", [](auto s) { return starPolygon(61 + s, 23); }, true},
};

const Family kIllConditioned[] = {
    {"spiderWeb", [](auto s) { return spiderWeb(60, 20, s); }, false},
    {"rotatedLattice", [](auto s) { return rotated(lattice(300, 40, s), 0.3); }, false},
    {"latticeByThree", [](auto s) { return scaled(lattice(300, 40, s), 1.0 / 3.0); }, false},
    {"pencil", [](auto s) { return pencil(120, 1e-15, s); }, false},
    {"sheaf", [](auto s) { return sheaf(40, 1e-15, s); }, false},
    {"bundles", [](auto s) { return bundles(30, s); }, false},
    {"shifted2To30", [](auto s) { return shifted(longSegments(150, s), 0x1p30, 0x1p30); }, false},
    {"shifted2To34", [](auto s) { return shifted(longSegments(150, s), 0x1p34, 0x1p34); }, false},
    {"shifted1e15", [](auto s) { return shifted(lattice(100, 20, s), 1e15, 1e15); }, false},
};

std::string nameOf(const testing::TestParamInfo<Family>& info)
{
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(WellConditioned, Families, testing::ValuesIn(kWellConditioned), nameOf);
INSTANTIATE_TEST_SUITE_P(IllConditioned, Families, testing::ValuesIn(kIllConditioned), nameOf);
INSTANTIATE_TEST_SUITE_P(Families, WellConditioned, testing::ValuesIn(kWellConditioned), nameOf);

/// 1,000 segments between points of a 100 x 100 grid: as many vertices as the exact arrangement.
TEST(Lattice, hasExactlyTheTrueVertices)
{
    const RawPslg raw = lattice(1000, 100, 1);
    const std::size_t vertices = integerArrangement(raw).size();
    for (const auto strategy : {RecoveryStrategy::Cavity, RecoveryStrategy::Steiner}) {
        const Recovered r = recoverAndVerify(raw, strategy);
        EXPECT_EQ(r.result.triangulation.vertexCount(), vertices);
        EXPECT_EQ(r.result.report.snapPixel, 0.0);
    }
}

} // namespace
} // namespace tessera::test
