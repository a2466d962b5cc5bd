// SPDX-License-Identifier: MIT
#include "curve/arc.h"
#include "curve/default_roles.h"
#include "curve/network_check.h"
#include "curve/polyline.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

/// A network of one operand with straight curves between numbered points.
CurveNetwork straightNetwork(std::size_t points,
                             const std::vector<std::pair<std::uint32_t, std::uint32_t>>& segments,
                             Role role = Role::Chain)
{
    CurveNetwork network;
    network.operands.resize(1);
    for (std::size_t i = 0; i < points; ++i) {
        network.addPoint({static_cast<double>(i % 7), static_cast<double>(i / 7)});
    }
    for (const auto& [a, b] : segments) {
        network.curves.push_back({nullptr, PointId(a), PointId(b), OperandId(0U), role});
    }
    return network;
}

std::vector<Role> rolesOf(const CurveNetwork& network)
{
    std::vector<Role> roles;
    for (const NetworkCurve& curve : network.curves) {
        roles.push_back(curve.role);
    }
    return roles;
}

constexpr Role kB = Role::Boundary;
constexpr Role kC = Role::Constraint;
constexpr Role kO = Role::Outline;

TEST(NetworkCheck, AcceptsAValidNetwork)
{
    const CurveNetwork network = straightNetwork(3, {{0, 1}, {1, 2}, {2, 0}});
    EXPECT_TRUE(findProblems(network).empty());
    EXPECT_NO_THROW(requireValid(network));
    EXPECT_NO_THROW(requireValid(CurveNetwork {}));
}

TEST(NetworkCheck, ListsEveryProblemWithItsPlace)
{
    CurveNetwork network = straightNetwork(3, {{0, 1}, {1, 7}, {2, 0}});
    network.points[2].y = std::numeric_limits<double>::infinity();
    network.curves[2].operand = OperandId(3U);
    network.holes.push_back({{std::numeric_limits<double>::quiet_NaN(), 0}, OperandId(0U)});
    network.regions.push_back({{0, 0}, OperandId(9U), 1.0, 1.0});
    network.embedded.push_back({PointId(), OperandId(0U), ""});
    EXPECT_EQ(findProblems(network).size(), 6U);
    try {
        requireValid(network);
        FAIL() << "accepted";
    }
    catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::InvalidInput);
        ASSERT_EQ(error.places().size(), 6U);
        EXPECT_EQ(error.places()[1].curve, 1U);
        EXPECT_EQ(error.places()[2].curve, 2U);
        EXPECT_NE(std::string(error.what()).find("5 more"), std::string::npos);
    }
}

TEST(ClassifyEdges, AgreesWithRemovalOnRandomGraphs)
{
    // Oracle for bridges and trees: an edge is on a cycle exactly if its ends stay connected
    // without it.
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        const std::uint32_t n = 2 + random() % 9;
        std::vector<GraphEdge> edges(1 + random() % 14);
        for (GraphEdge& e : edges) {
            e.a = static_cast<std::uint32_t>(random() % n);
            e.b = static_cast<std::uint32_t>(random() % n);
        }
        const EdgeClasses classes = classifyEdges(edges, n, {.cutBridges = true});
        std::vector<int> degree(n);
        std::vector<bool> onCycle(edges.size());
        for (std::size_t e = 0; e < edges.size(); ++e) {
            std::vector<std::uint32_t> label(n);
            for (std::uint32_t v = 0; v < n; ++v) {
                label[v] = v;
            }
            for (std::uint32_t pass = 0; pass < n; ++pass) {
                for (std::size_t f = 0; f < edges.size(); ++f) {
                    if (f != e) {
                        const auto low = std::min(label[edges[f].a], label[edges[f].b]);
                        label[edges[f].a] = label[edges[f].b] = low;
                    }
                }
            }
            onCycle[e] = edges[e].a != edges[e].b && label[edges[e].a] == label[edges[e].b];
            if (onCycle[e]) {
                ++degree[edges[e].a];
                ++degree[edges[e].b];
            }
        }
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const EdgeClass c = classes.classOf[e];
            EXPECT_EQ(c == EdgeClass::Even || c == EdgeClass::Odd, onCycle[e]);
            EXPECT_EQ(c == EdgeClass::Loop, edges[e].a == edges[e].b);
            if (c == EdgeClass::Even) {
                EXPECT_EQ(degree[edges[e].a] % 2, 0);
                EXPECT_EQ(degree[edges[e].b] % 2, 0);
            }
            for (std::size_t f = 0; f < edges.size(); ++f) {
                const bool touching = edges[e].a == edges[f].a || edges[e].b == edges[f].b;
                if (onCycle[e] && onCycle[f] && touching) {
                    EXPECT_EQ(classes.component[e], classes.component[f]);
                    EXPECT_EQ(c, classes.classOf[f]);
                }
            }
        }
    }
}

TEST(PolyRoles, ClosedRingsAreBoundary)
{
    CurveNetwork network = straightNetwork(7, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}});
    assignPolyRoles(network, OperandId(0U));
    EXPECT_EQ(rolesOf(network), std::vector<Role>(6, kB));
}

TEST(PolyRoles, DanglingTreesAreConstraints)
{
    CurveNetwork network =
        straightNetwork(7, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {3, 5}, {6, 6}});
    assignPolyRoles(network, OperandId(0U));
    EXPECT_EQ(rolesOf(network), (std::vector<Role> {kB, kB, kB, kC, kC, kC, kC}));
}

TEST(PolyRoles, AComponentWithAnOddDegreeKeepsOnlyItsOutline)
{
    // A square with a diagonal, and beside it a triangle of its own.
    CurveNetwork network = straightNetwork(
        7, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {4, 5}, {5, 6}, {6, 4}});
    assignPolyRoles(network, OperandId(0U));
    EXPECT_EQ(rolesOf(network), (std::vector<Role> {kO, kO, kO, kO, kO, kB, kB, kB}));
}

TEST(PolyRoles, DuplicateSegmentsCountOnce)
{
    CurveNetwork network = straightNetwork(3, {{0, 1}, {1, 0}, {1, 2}, {2, 0}, {0, 1}});
    assignPolyRoles(network, OperandId(0U));
    EXPECT_EQ(rolesOf(network), (std::vector<Role> {kB, kC, kB, kB, kC}));
}

TEST(PolyRoles, LeavesOtherOperandsAlone)
{
    CurveNetwork network = straightNetwork(3, {{0, 1}, {1, 2}, {2, 0}}, Role::Constraint);
    network.operands.resize(2);
    network.curves[1].operand = OperandId(1U);
    assignPolyRoles(network, OperandId(1U));
    EXPECT_EQ(rolesOf(network), std::vector<Role>(3, kC));
}

TEST(ChainRoles, ClosedChainsAreBoundaryOpenOnesConstraints)
{
    // A ring, a tail on it, a bar from it to a second ring, an open chain.
    CurveNetwork network =
        straightNetwork(12, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {0, 4}, {4, 5}, {5, 6}, {6, 4},
                             {7, 8}, {8, 9}});
    settleChainRoles(network);
    EXPECT_EQ(rolesOf(network),
              (std::vector<Role> {kB, kB, kB, kC, kC, kB, kB, kB, kC, kC}));
}

TEST(ChainRoles, ACircleIsClosedAZeroLengthLineIsNot)
{
    CurveNetwork network = straightNetwork(2, {{0, 0}, {1, 1}});
    network.curves[0].geometry = makeCircleArc({-1, 0}, 1, 0, 2 * std::numbers::pi);
    settleChainRoles(network);
    EXPECT_EQ(rolesOf(network), (std::vector<Role> {kB, kC}));
}

TEST(ChainRoles, OperandsDoNotCloseEachOther)
{
    CurveNetwork network = straightNetwork(3, {{0, 1}, {1, 2}, {2, 0}});
    network.operands.resize(2);
    network.curves[2].operand = OperandId(1U);
    settleChainRoles(network);
    EXPECT_EQ(rolesOf(network), std::vector<Role>(3, kC));
}

TEST(ChainRoles, SetRolesStay)
{
    CurveNetwork network = straightNetwork(3, {{0, 1}, {1, 2}, {2, 0}}, Role::Constraint);
    settleChainRoles(network);
    EXPECT_EQ(rolesOf(network), std::vector<Role>(3, kC));
}

TEST(AddPolyline, OpenAndClosed)
{
    CurveNetwork network;
    network.operands.resize(1);
    const std::vector<Vec2> points {{0, 0}, {1, 0}, {1, 1}};
    addPolyline(network, points, false, OperandId(0U), Role::Constraint);
    const PointId first = addPolyline(network, points, true, OperandId(0U), Role::Boundary, 10);
    ASSERT_EQ(network.curves.size(), 5U);
    EXPECT_EQ(first, PointId(3U));
    EXPECT_EQ(network.curves[4].end, first);
    EXPECT_EQ(network.curves[4].source, 12U);
}

} // namespace
} // namespace tessera
