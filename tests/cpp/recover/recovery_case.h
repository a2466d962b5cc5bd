// SPDX-License-Identifier: MIT
#pragma once

#include "raw_pslg.h"

#include "delaunay/delaunay.h"
#include "recover/recover.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tessera::test
{

struct Recovered
{
    DelaunayResult delaunay;
    std::vector<ConstraintEnds> ends; ///< by segment of the raw PSLG
    RecoveryResult result;
};

inline Recovered recoverRaw(const RawPslg& raw, RecoveryStrategy strategy,
                            RecoveryObserver* observer = nullptr)
{
    Execution execution;
    Recovered r {triangulate(raw.points, execution), {}, {}};
    for (const auto& [a, b] : raw.segments) {
        r.ends.push_back({r.delaunay.vertexOfPoint[a], r.delaunay.vertexOfPoint[b]});
    }
    r.result = recoverBoundaries(r.delaunay.triangulation, r.ends, strategy, execution, observer);
    return r;
}

inline std::string joined(const std::vector<std::string>& problems)
{
    std::string text;
    for (const std::string& problem : problems) {
        text += problem + "\n";
    }
    return text;
}

/// Everything that must hold after any recovery.
inline void expectValid(const Recovered& r)
{
    EXPECT_EQ(joined(verify(r.result.triangulation)), "");
    EXPECT_EQ(joined(verifyConstraints(r.result, r.ends, r.delaunay.triangulation.points)), "");
    EXPECT_EQ(r.result.report.crossings,
              r.result.triangulation.points.size() - r.result.firstCrossing);
    EXPECT_EQ(r.result.report.steinerInserted - r.result.report.steinerRemoved,
              r.result.report.steinerInserted == 0 ? 0 : r.result.report.crossings);
}

inline Recovered recoverAndVerify(const RawPslg& raw,
                                  RecoveryStrategy strategy = RecoveryStrategy::Cavity)
{
    Recovered r = recoverRaw(raw, strategy);
    expectValid(r);
    return r;
}

} // namespace tessera::test
