// SPDX-License-Identifier: MIT
#include "recover/chains.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tessera
{
namespace
{

std::vector<std::uint32_t> verticesOf(const Chains& chains, std::uint32_t segment)
{
    std::vector<std::uint32_t> result;
    chains.forEachVertex(segment, [&](std::uint32_t v) { result.push_back(v); });
    return result;
}

std::vector<Chains::Use> usesOf(const Chains& chains, std::uint32_t u, std::uint32_t v)
{
    std::vector<Chains::Use> result;
    result.reserve(6);
    chains.forEachUse(u, v, [&](const Chains::Use& use) { result.push_back(use); });
    std::sort(result.begin(), result.end(),
              [](const auto& p, const auto& q) { return p.segment < q.segment; });
    return result;
}

/// Six segments through vertices 1, 5, 2; the odd ones the other way around.
Chains sixThroughOneVertex()
{
    Chains chains(6, 4);
    for (std::uint32_t s = 0; s < 6; ++s) {
        chains.append(s, s % 2 == 0 ? 1 : 2);
        chains.append(s, s % 2 == 0 ? 2 : 1);
    }
    for (const Chains::Use& use : usesOf(chains, 1, 2)) {
        EXPECT_EQ(use.forward, use.segment % 2 == 0);
        chains.insertAfter(use.before, 5);
    }
    return chains;
}

TEST(Chains, keepTheirOrder)
{
    const Chains chains = sixThroughOneVertex();
    for (std::uint32_t s = 0; s < 6; ++s) {
        const auto expected = s % 2 == 0 ? std::vector<std::uint32_t> {1, 5, 2}
                                         : std::vector<std::uint32_t> {2, 5, 1};
        EXPECT_EQ(verticesOf(chains, s), expected);
    }
    EXPECT_EQ(chains.nodeCount(), 18U);
    EXPECT_EQ(chains.lengths(), std::vector<std::uint32_t>(6, 3));
}

TEST(Chains, findUsesFromBothEnds)
{
    const Chains chains = sixThroughOneVertex();
    EXPECT_FALSE(chains.used(1, 2));
    EXPECT_TRUE(chains.used(1, 5));
    for (const auto& [u, v] : {std::pair(1U, 5U), std::pair(5U, 1U)}) {
        const auto uses = usesOf(chains, u, v);
        ASSERT_EQ(uses.size(), 6U);
        for (const Chains::Use& use : uses) {
            EXPECT_EQ(use.forward, (use.segment % 2 == 0) == (u == 1));
            EXPECT_EQ(chains.vertexOf(use.before), use.forward ? u : v);
        }
    }
}

TEST(Chains, renameVertices)
{
    Chains chains = sixThroughOneVertex();
    const std::vector<std::uint32_t> names {0, 9, 3, 0, 0, 1};
    chains.renameVertices(names, 10);
    EXPECT_EQ(verticesOf(chains, 0), (std::vector<std::uint32_t> {9, 1, 3}));
    EXPECT_EQ(verticesOf(chains, 5), (std::vector<std::uint32_t> {3, 1, 9}));
    EXPECT_EQ(usesOf(chains, 9, 1).size(), 6U);
    chains.append(0, 7);
    EXPECT_EQ(verticesOf(chains, 0).back(), 7U);
}

} // namespace
} // namespace tessera
