// SPDX-License-Identifier: MIT

// Boundary recovery on every planar straight-line graph of the corpora: as it is, in copies that
// must give the same, and in copies that must be valid.

#include "arrangement_counts.h"
#include "corpora.h"
#include "recover/generators.h"
#include "recover/recovery_case.h"
#include "same_mesh.h"

#include <cmath>

namespace tessera::test
{
namespace
{

class Corpora: public testing::Test
{
protected:
    void SetUp() override
    {
        TESSERA_NEEDS_CORPORA();
        cases_ = corpusPslgs();
    }
    std::vector<CorpusPslg> cases_;
};

/// The copies with exactly the same arrangement.
std::vector<RawPslg> exactCopies(const RawPslg& raw)
{
    std::vector<RawPslg> copies;
    copies.push_back(transformed(raw, [](Vec2 p) { return Vec2 {-p.x, p.y}; }));
    copies.push_back(transformed(raw, [](Vec2 p) { return Vec2 {-p.y, p.x}; }));
    copies.push_back(scaled(raw, 0x1p30));
    copies.push_back(scaled(raw, 0x1p-30));
    RawPslg reordered = raw;
    const auto last = static_cast<std::uint32_t>(raw.points.size() - 1);
    std::reverse(reordered.points.begin(), reordered.points.end());
    std::reverse(reordered.segments.begin(), reordered.segments.end());
    for (std::size_t i = 0; i < reordered.segments.size(); ++i) {
        auto& [a, b] = reordered.segments[i];
        a = last - a;
        b = last - b;
        if (i % 2 == 0) {
            std::swap(a, b);
        }
    }
    copies.push_back(std::move(reordered));
    return copies;
}

void expectCounts(const CorpusPslg& c, const RecoveryResult& result)
{
    const ArrangementCounts counts = countArrangement(result);
    EXPECT_EQ(counts.vertices, c.exact.vertices);
    EXPECT_EQ(counts.edges, c.exact.edges);
    EXPECT_EQ(counts.faces, c.exact.faces);
    EXPECT_EQ(result.report.crossings, c.exact.crossings);
    EXPECT_EQ(result.report.snapPixel, 0.0);
}

TEST_F(Corpora, bothStrategiesGiveTheExactArrangement)
{
    for (const CorpusPslg& c : cases_) {
        SCOPED_TRACE(c.name);
        const RawPslg raw = readCorpusPslg(c.name);
        ASSERT_EQ(raw.segments.size(), c.segments);
        const Recovered cavity = recoverAndVerify(raw, RecoveryStrategy::Cavity);
        const Recovered steiner = recoverAndVerify(raw, RecoveryStrategy::Steiner);
        if (c.wellConditioned) {
            expectCounts(c, cavity.result);
            expectCounts(c, steiner.result);
        }
        EXPECT_EQ(cavity.result.report.snapPixel, steiner.result.report.snapPixel);
        EXPECT_EQ(meshDifference(cavity.result.triangulation, steiner.result.triangulation), "");
    }
}

TEST_F(Corpora, exactCopiesGiveTheSame)
{
    for (const CorpusPslg& c : cases_) {
        if (c.segments > 20000) {
            continue; // the large maps: one copy below
        }
        SCOPED_TRACE(c.name);
        for (const RawPslg& copy : exactCopies(readCorpusPslg(c.name))) {
            const Recovered r = recoverAndVerify(copy);
            if (c.wellConditioned) {
                expectCounts(c, r.result);
            }
        }
    }
}

TEST_F(Corpora, turnedAndScaledCopiesAreValid)
{
    for (const CorpusPslg& c : cases_) {
        SCOPED_TRACE(c.name);
        const RawPslg raw = readCorpusPslg(c.name);
        recoverAndVerify(rotated(raw, 0.7));
        if (c.segments <= 20000) {
            recoverAndVerify(scaled(raw, 1e9));
            recoverAndVerify(rotated(scaled(raw, 1e-9), 2.1));
        }
    }
}

} // namespace
} // namespace tessera::test
