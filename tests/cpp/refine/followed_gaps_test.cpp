// SPDX-License-Identifier: MIT

#include "refine/followed_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace tessera
{
namespace
{

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(FollowedGaps, NoneHaveNoLength)
{
    FollowedGaps none;
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.at(0, 1.0), kInfinite);
    none.finish();
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.at(7, 1.0), kInfinite);
}

TEST(FollowedGaps, LengthsGrowAwayFromASpan)
{
    FollowedGaps gaps;
    gaps.add(3, 2.0, 4.0, 0.01);
    gaps.finish();
    EXPECT_FALSE(gaps.empty());
    EXPECT_EQ(gaps.at(3, 2.0), 0.01);
    EXPECT_EQ(gaps.at(3, 3.0), 0.01);
    EXPECT_EQ(gaps.at(3, 4.0), 0.01);
    EXPECT_DOUBLE_EQ(gaps.at(3, 1.0), 0.01 + FollowedGaps::kGrowth);
    EXPECT_DOUBLE_EQ(gaps.at(3, 6.0), 0.01 + 2.0 * FollowedGaps::kGrowth);
    EXPECT_EQ(gaps.at(2, 3.0), kInfinite);
    EXPECT_EQ(gaps.at(4, 3.0), kInfinite);
    gaps.clear();
    EXPECT_TRUE(gaps.empty());
    EXPECT_EQ(gaps.at(3, 3.0), kInfinite);
}

TEST(FollowedGaps, TheLeastOfManySpansCounts)
{
    std::mt19937_64 random(5);
    std::uniform_int_distribution<int> place(0, 40);
    std::uniform_int_distribution<int> size(1, 30);
    for (int round = 0; round < 200; ++round) {
        struct Span
        {
            std::uint32_t side;
            double from, to, piece;
        };
        std::vector<Span> spans;
        FollowedGaps gaps;
        for (int i = 0; i < 1 + round % 12; ++i) {
            const auto [from, to] = std::minmax({0.25 * place(random), 0.25 * place(random)});
            spans.push_back({static_cast<std::uint32_t>(size(random) % 3), from, to,
                             0.05 * size(random)});
            gaps.add(spans.back().side, from, to, spans.back().piece);
        }
        gaps.finish();
        for (std::uint32_t side = 0; side < 3; ++side) {
            for (double p = 0.0; p <= 10.0; p += 0.125) {
                double least = kInfinite;
                for (const Span& span : spans) {
                    const double away = std::max({0.0, span.from - p, p - span.to});
                    const double there = span.piece + FollowedGaps::kGrowth * away;
                    least = span.side == side ? std::min(least, there) : least;
                }
                if (least == kInfinite) {
                    EXPECT_EQ(gaps.at(side, p), kInfinite);
                }
                else {
                    EXPECT_NEAR(gaps.at(side, p), least, 1e-12) << "side " << side << " at " << p;
                }
            }
        }
    }
}

} // namespace
} // namespace tessera
