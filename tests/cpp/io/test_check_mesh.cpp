// SPDX-License-Identifier: MIT
#include "io/check_mesh.h"
#include "io/expect_error.h"
#include "io/outline_check.h"
#include "io/read_text_mesh.h"
#include "io/sample_meshes.h"
#include "io/write_text_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace tessera
{
namespace
{

using samples::PlateMesh;
using samples::secondOrderPlate;

/// A mesh written down: positions, then cells by node index (2, 3, 4 or 6 nodes).
RawMesh rawMesh(std::vector<Vec2> points, const std::vector<std::vector<std::uint32_t>>& cells)
{
    RawMesh mesh;
    for (std::size_t i = 0; i < points.size(); ++i) {
        mesh.nodes.push_back({points[i].x, points[i].y, 0.0});
        mesh.nodeNumber.push_back(static_cast<std::int64_t>(i));
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const std::size_t n = cells[c].size();
        const CellKind kind = n == 2 ? CellKind::Edge2
            : n == 3                 ? CellKind::Triangle3
            : n == 4                 ? CellKind::Quad4
                                     : CellKind::Triangle6;
        mesh.cells.push_back({kind, static_cast<std::uint32_t>(mesh.cellNodes.size()),
                              static_cast<std::int64_t>(c)});
        mesh.cellNodes.insert(mesh.cellNodes.end(), cells[c].begin(), cells[c].end());
    }
    return mesh;
}

/// The check finds a problem that contains text.
void expectProblem(const RawMesh& mesh, const std::string& text)
{
    const MeshCheck check = checkMesh(mesh);
    EXPECT_FALSE(check.valid()) << "expected: " << text;
    std::string all;
    for (const std::string& problem : check.problems) {
        all += problem + "\n";
    }
    EXPECT_NE(all.find(text), std::string::npos) << "problems:\n" << all << "expected: " << text;
}

void expectValid(const RawMesh& mesh)
{
    for (const std::string& problem : checkMesh(mesh).problems) {
        ADD_FAILURE() << problem;
    }
}

TEST(CheckMesh, ValidMeshAndItsFigures)
{
    const PlateMesh plate(12);
    const MeshCheck check = checkMesh(parseMsh(formatMsh(plate.mesh), "a.msh"));
    EXPECT_EQ(check.problems, std::vector<std::string> {});
    EXPECT_EQ(check.triangles, plate.mesh.triangles.size());
    EXPECT_EQ(check.edges, plate.mesh.edges.size());
    EXPECT_EQ(check.nodes, plate.mesh.nodes.size());
    EXPECT_EQ(check.unusedNodes, 0U);
    EXPECT_NEAR(check.area, plate.area(), 1e-12);
    EXPECT_NEAR(check.outlineLength, plate.outlineLength(), 1e-12);
    const QualityReport quality = measureQuality(plate.mesh, nullptr);
    EXPECT_EQ(check.quality.minAngle, quality.minAngle);
    EXPECT_NEAR(check.quality.meanQuality, quality.meanQuality, 1e-12);
}

TEST(CheckMesh, ValidMeshOfOrderTwoWithCurvedArea)
{
    const PlateMesh plate(12);
    const Mesh mesh = secondOrderPlate(12);
    const MeshCheck check = checkMesh(parseMsh(formatMsh(mesh), "a.msh"));
    EXPECT_EQ(check.problems, std::vector<std::string> {});
    EXPECT_EQ(check.order, 2);
    // 16 unit edges, each with a parabola of height 0.1 into the hole.
    EXPECT_NEAR(check.area, plate.area() + 16 * 2.0 / 3.0 * 0.1, 1e-12);
}

TEST(CheckMesh, Orientation)
{
    const std::vector<Vec2> square {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    expectValid(rawMesh(square, {{0, 1, 2}, {0, 2, 3}}));
    expectValid(rawMesh(square, {{0, 1, 2, 3}}));
    expectProblem(rawMesh(square, {{0, 1, 2}, {0, 3, 2}}),
                  "Element 1 (nodes 0, 3, 2) is clockwise");
    expectProblem(rawMesh(square, {{0, 3, 2, 1}}), "is clockwise");
    expectProblem(rawMesh(square, {{0, 1, 3, 2}}), "is not convex");
    expectProblem(rawMesh({{0, 0}, {2, 0}, {1, 0.1}, {1, 3}}, {{0, 1, 2, 3}}), "is not convex");
    expectProblem(rawMesh({{0, 0}, {1, 1}, {3, 3}}, {{0, 1, 2}}), "has no area");
    expectProblem(rawMesh({{0, 0}, {1, 0}, {2, 0}, {1, 1}}, {{0, 1, 2, 3}}), "is not convex");
    // Exactly: these three are not collinear, but rounded arithmetic says so.
    expectValid(rawMesh({{0, 0}, {0.1, 0.1}, {0.3, std::nextafter(0.3, 1)}}, {{0, 1, 2}}));
}

TEST(CheckMesh, NodesAndElementsTwice)
{
    const std::vector<Vec2> square {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 1}};
    expectProblem(rawMesh(square, {{0, 1, 1}}), "has node 1 twice");
    expectProblem(rawMesh(square, {{0, 1, 2}, {1, 2, 0}}), "has the same nodes as element 0");
    expectProblem(rawMesh(square, {{0, 1, 2}, {0, 4, 3}}), "Nodes 2 and 4 are at the same place");
    expectProblem(rawMesh(square, {{0, 1, 2}, {0, 1}, {1, 0}}), "has the same nodes as element 1");
}

TEST(CheckMesh, SidesOfTooManyElements)
{
    const std::vector<Vec2> points {{0, 0}, {1, 0}, {0.5, 1}, {0.5, 2}, {0.5, -1}};
    expectValid(rawMesh(points, {{0, 1, 2}, {1, 0, 4}}));
    expectProblem(rawMesh(points, {{0, 1, 2}, {1, 0, 4}, {0, 1, 3}}), "belongs to 3 elements");
    expectProblem(rawMesh(points, {{0, 1, 2}, {0, 1, 3}}), "they overlap");
}

TEST(CheckMesh, HangingNodes)
{
    // A triangle on one side of an edge, two on the other.
    const auto mesh = [](Vec2 a, Vec2 b, Vec2 on) {
        const Vec2 normal {a.y - b.y, b.x - a.x};
        return rawMesh({a, b, midpoint(a, b) + normal, on, midpoint(a, b) + (-1.0) * normal},
                       {{0, 1, 2}, {0, 4, 3}, {3, 4, 1}});
    };
    expectProblem(mesh({0, 0}, {2, 0}, {1, 0}),
                  "Node 3 at (1, 0) hangs on the side between nodes 0 and 1 (element 0)");
    // A rounded point of an oblique line is not exactly on it.
    const Vec2 a {0.1, 0.3};
    const Vec2 b {7.7, 3.1};
    for (double t : {0.1, 0.3, 0.5, 0.71}) {
        expectProblem(mesh(a, b, a + t * (b - a)), "hangs on the side between nodes 0 and 1");
    }
    // A gap is a gap, but a narrow one is told.
    expectValid(mesh({0, 0}, {2, 0}, {1, -1e-9}));
    const MeshCheck narrow = checkMesh(mesh({0, 0}, {2, 0}, {1, -1e-9}));
    ASSERT_EQ(narrow.warnings.size(), 1U);
    EXPECT_EQ(narrow.warnings[0],
              "Node 3 at (1, -1e-09) lies 1e-09 beside the side between nodes 0 and 1 (element 0): "
              "there is a slit, or the node should be on that side.");
    EXPECT_TRUE(checkMesh(mesh({0, 0}, {2, 0}, {1, -1e-3})).warnings.empty());
    EXPECT_TRUE(checkMesh(mesh({0, 0}, {2, 0}, {1, 0})).warnings.empty());
}

TEST(CheckMesh, SeveralNodesHangOnOneSide)
{
    const RawMesh mesh = rawMesh({{0, 0}, {3, 0}, {1, 2}, {1, 0}, {2, 0}, {1, -2}},
                                 {{0, 1, 2}, {0, 5, 3}, {3, 5, 4}, {4, 5, 1}});
    const MeshCheck check = checkMesh(mesh);
    ASSERT_EQ(check.problems.size(), 2U);
    EXPECT_NE(check.problems[0].find("Node 4"), std::string::npos);
    EXPECT_NE(check.problems[1].find("Node 3"), std::string::npos);
}

TEST(CheckMesh, Overlaps)
{
    const std::vector<Vec2> points {{0, 0}, {4, 0}, {0, 4}, {1, 1}, {5, 1}, {1, 5}};
    expectProblem(rawMesh(points, {{0, 1, 2}, {3, 4, 5}}), "overlap");
    // One inside the other: no sides cross.
    const std::vector<Vec2> nested {{0, 0}, {9, 0}, {0, 9}, {1, 1}, {2, 1}, {1, 2}};
    expectProblem(rawMesh(nested, {{0, 1, 2}, {3, 4, 5}}), "Elements overlap at");
    // Apart, or touching in a node: fine.
    expectValid(rawMesh({{0, 0}, {1, 0}, {0, 1}, {5, 0}, {6, 0}, {5, 1}}, {{0, 1, 2}, {3, 4, 5}}));
    expectValid(rawMesh({{0, 0}, {1, 0}, {0, 1}, {2, 0}, {2, 1}}, {{0, 1, 2}, {1, 3, 4}}));
    // A node of one touches a side of the other, apart otherwise.
    expectProblem(rawMesh({{0, 0}, {2, 0}, {0, 2}, {1, 1}, {3, 1}, {3, 3}}, {{0, 1, 2}, {3, 4, 5}}),
                  "meets the side");
}

TEST(CheckMesh, FanTwiceAroundANode)
{
    // Every side is used as it should be, every triangle is counter-clockwise: covered twice.
    std::vector<Vec2> points {{0, 0}};
    std::vector<std::vector<std::uint32_t>> cells;
    const std::uint32_t count = 14;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 4.0 * 3.14159265358979 * i / count;
        const double radius = 1.0 + 0.01 * i;
        points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        cells.push_back({0, i + 1, (i + 1) % count + 1});
    }
    expectProblem(rawMesh(points, cells), "overlap");
}

TEST(CheckMesh, LineElements)
{
    const std::vector<Vec2> square {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    expectValid(rawMesh(square, {{0, 1, 2}, {0, 2, 3}, {2, 0}, {0, 1}}));
    expectProblem(rawMesh(square, {{0, 1, 2}, {0, 2, 3}, {1, 3}}),
                  "Element 2 (nodes 1, 3) is not a side of any triangle");
    expectProblem(rawMesh(square, {{0, 1}}), "no triangles and no quadrangles");
    expectProblem(rawMesh({}, {}), "no triangles and no quadrangles");
}

TEST(CheckMesh, MidNodes)
{
    const std::vector<Vec2> points {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1},
                                    {1, 1}, {1, 2}, {0, 1}, {1.1, 1}};
    expectValid(rawMesh(points, {{0, 1, 2, 4, 5, 6}, {0, 2, 3, 6, 7, 8}}));
    expectProblem(rawMesh(points, {{0, 1, 2, 4, 5, 6}, {0, 2, 3, 9, 7, 8}}), "different mid nodes");
    expectProblem(rawMesh(points, {{0, 1, 2, 4, 5, 6}, {0, 2, 3}}), "different mid nodes");
    // A mid node near a corner folds the element there; a strong but harmless bend does not.
    std::vector<Vec2> moved = points;
    moved[4] = {0.45, 0};
    expectProblem(rawMesh(moved, {{0, 1, 2, 4, 5, 6}}), "folds over");
    moved[4] = {1, -3};
    expectValid(rawMesh(moved, {{0, 1, 2, 4, 5, 6}}));
}

TEST(CheckMesh, Plane)
{
    RawMesh mesh = rawMesh({{0, 0}, {1, 0}, {1, 1}}, {{0, 1, 2}});
    mesh.nodes = {{5, 0, 0}, {5, 1, 0}, {5, 1, 1}};
    expectValid(mesh);
    EXPECT_EQ(checkMesh(mesh).area, 0.5);
    mesh.nodes = {{0, 7, 0}, {1, 7, 0}, {1, 7, 1}}; // seen from +y: z to the right of x
    expectProblem(mesh, "is clockwise");
    mesh.nodes = {{0, 0, 0}, {1, 0, 0.5}, {1, 1, 1}};
    expectProblem(mesh, "The mesh is not plane");
    mesh.nodes = {{0, 0, 0}, {1, NAN, 0}, {1, 1, 0}};
    expectProblem(mesh, "Node 1 has a coordinate that is not finite");
}

TEST(CheckMesh, UnusedNodesAreCounted)
{
    const MeshCheck check =
        checkMesh(rawMesh({{0, 0}, {1, 0}, {1, 1}, {1, 1}, {9, NAN}}, {{0, 1, 2}}));
    EXPECT_TRUE(check.valid());
    EXPECT_EQ(check.unusedNodes, 2U);
}

TEST(CheckMesh, ListsProblemsUpToABound)
{
    Mesh mesh = PlateMesh(45).mesh;
    for (auto& triangle : mesh.triangles) {
        std::swap(triangle[0], triangle[1]);
    }
    const MeshCheck check = checkMesh(parseMsh(formatMsh(mesh), "a.msh"));
    EXPECT_EQ(check.problems.size(), MeshCheck::kMostListed + 1);
    EXPECT_NE(check.problems.back().find("more problems"), std::string::npos);
}

TEST(CheckMesh, EveryKindOfDamageIsFound)
{
    const RawMesh good = parseMsh(formatMsh(PlateMesh(9).mesh), "a.msh");
    expectValid(good);
    std::mt19937 random(7);
    for (int round = 0; round < 400; ++round) {
        RawMesh bad = good;
        std::size_t c = random() % bad.cells.size();
        while (isEdge(bad.cells[c].kind)) {
            c = random() % bad.cells.size();
        }
        std::uint32_t* nodes = bad.cellNodes.data() + bad.cells[c].firstNode;
        switch (round % 4) {
            case 0: // inverted
                std::swap(nodes[0], nodes[1]);
                break;
            case 1: { // doubled
                RawMesh::Cell copy = bad.cells[c];
                bad.cells.push_back(copy);
                break;
            }
            case 2: // a node of its own at the same place
                bad.nodes.push_back(bad.nodes[nodes[2]]);
                bad.nodeNumber.push_back(-1);
                nodes[2] = static_cast<std::uint32_t>(bad.nodes.size() - 1);
                break;
            case 3: // another node
                nodes[1] = (nodes[1] + 5) % static_cast<std::uint32_t>(bad.nodes.size());
                break;
        }
        EXPECT_FALSE(checkMesh(bad).valid()) << round;
    }
}

/// Against all pairs: a crossing is found exactly where there is one.
TEST(OutlineCheck, SweepAgreesWithAllPairs)
{
    std::mt19937 random(11);
    const auto sign = [](Vec2 a, Vec2 b, Vec2 c) {
        const double value = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        return value > 0 ? 1 : value < 0 ? -1 : 0; // exact for small whole numbers
    };
    const auto within = [](Vec2 a, Vec2 b, Vec2 p) {
        return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)
            && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y) && p != a && p != b;
    };
    int crossing = 0;
    for (int round = 0; round < 3000; ++round) {
        const int count = 2 + round % 5;
        const auto extent = static_cast<std::uint32_t>(3 + round % 12);
        std::vector<Vec2> points;
        std::vector<OutlineSide> sides;
        for (int s = 0; s < count; ++s) {
            sides.push_back(
                {static_cast<std::uint32_t>(2 * s), static_cast<std::uint32_t>(2 * s + 1)});
            do {
                points.resize(static_cast<std::size_t>(2 * s));
                for (int i = 0; i < 2; ++i) {
                    points.push_back({static_cast<double>(random() % extent),
                                      static_cast<double>(random() % extent)});
                }
            } while (points[points.size() - 1] == points[points.size() - 2]);
        }
        bool meet = false;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const Vec2 p = points[2 * i], q = points[2 * i + 1];
                const Vec2 r = points[2 * j], s = points[2 * j + 1];
                const int a = sign(r, s, p), b = sign(r, s, q), c = sign(p, q, r),
                          d = sign(p, q, s);
                meet = meet || (a * b < 0 && c * d < 0) || (a == 0 && within(r, s, p))
                    || (b == 0 && within(r, s, q)) || (c == 0 && within(p, q, r))
                    || (d == 0 && within(p, q, s)) || (p == r && q == s) || (p == s && q == r);
            }
        }
        bool found = false;
        for (const OutlineProblem& problem : sweepOutline(points, sides)) {
            found = found || problem.kind == OutlineProblem::Kind::Crossing;
        }
        EXPECT_EQ(found, meet) << round;
        crossing += meet ? 1 : 0;
    }
    EXPECT_GT(crossing, 500);
    EXPECT_LT(crossing, 2700);
}

} // namespace
} // namespace tessera
