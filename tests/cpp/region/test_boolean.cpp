// SPDX-License-Identifier: MIT
#include "region/boolean.h"
#include "region/colored.h"
#include "region/region_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace tessera
{
namespace
{

constexpr FillRule kRules[] = {FillRule::EvenOdd, FillRule::NonZero, FillRule::Positive,
                               FillRule::Negative};
constexpr BooleanOperation kOperations[] = {
    BooleanOperation::Union, BooleanOperation::Intersection, BooleanOperation::Difference,
    BooleanOperation::SymmetricDifference, BooleanOperation::Cells};
constexpr Priority kPriorities[] = {Priority::None, Priority::First, Priority::Last};

BooleanParts boolean(const Colored& colored, const BooleanOptions& options)
{
    Execution execution;
    return colorBoolean(colored.recovered, colored.network, colored.pslg, options, execution);
}

/// The rings of each operand.
using Operands = std::vector<std::vector<Ring>>;

CurveNetwork networkOf(const Operands& operands)
{
    CurveNetwork network = emptyNetwork(operands.size());
    for (std::uint32_t o = 0; o < operands.size(); ++o) {
        for (const Ring& ring : operands[o]) {
            addRing(network, ring, o);
        }
    }
    return network;
}

bool coversByRule(FillRule rule, int winding)
{
    switch (rule) {
        case FillRule::EvenOdd:
            return winding % 2 != 0;
        case FillRule::Positive:
            return winding > 0;
        case FillRule::Negative:
            return winding < 0;
        default:
            return winding != 0;
    }
}

/// The operands around a point, by counting crossings of a ray with every ring.
std::vector<OperandId> coveringAt(const Operands& operands, FillRule rule, Vec2 p)
{
    std::vector<OperandId> covering;
    for (std::size_t o = 0; o < operands.size(); ++o) {
        int winding = 0;
        for (const Ring& ring : operands[o]) {
            winding += windingAround(ring, p);
        }
        if (coversByRule(rule, winding)) {
            covering.emplace_back(o);
        }
    }
    return covering;
}

bool keptByDefinition(BooleanOperation operation, const std::vector<OperandId>& covering,
                      std::size_t operands)
{
    const std::set<OperandId> in(covering.begin(), covering.end());
    switch (operation) {
        case BooleanOperation::Intersection:
            return in.size() == operands;
        case BooleanOperation::Difference:
            return in == std::set {OperandId(0U)};
        case BooleanOperation::SymmetricDifference:
            return in.size() % 2 == 1;
        default:
            return !in.empty();
    }
}

Operands randomOperands(std::mt19937& random, std::size_t count, unsigned grid)
{
    Operands operands(count);
    for (auto& rings : operands) {
        rings.resize(1 + random() % 3);
        for (Ring& ring : rings) {
            ring.resize(3 + random() % 8);
            for (Vec2& p : ring) {
                p = {static_cast<double>(random() % grid), static_cast<double>(random() % grid)};
            }
        }
    }
    return operands;
}

/// Compares every triangle that is not too thin for rounded arithmetic.
std::size_t compareWithOracle(const Operands& operands, const Colored& colored,
                              const BooleanOptions& options)
{
    const BooleanParts result = boolean(colored, options);
    const Triangulation& t = colored.recovered.triangulation;
    std::size_t compared = 0;
    double sum = 0.0;
    for (const BooleanPart& part : result.parts) {
        EXPECT_GT(part.area, 0.0);
        sum += part.area;
    }
    double expected = 0.0;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (!t.isFinite(i)) {
            EXPECT_EQ(result.partOfTriangle[i], BooleanParts::kNoPart);
            continue;
        }
        const auto& v = t.triangles[i].v;
        const double area =
            0.5 * cross(t.points[v[1]] - t.points[v[0]], t.points[v[2]] - t.points[v[0]]);
        const std::uint32_t part = result.partOfTriangle[i];
        if (area < 1e-9) {
            expected += part != BooleanParts::kNoPart ? area : 0.0;
            continue;
        }
        const Vec2 center = (1.0 / 3.0) * (t.points[v[0]] + t.points[v[1]] + t.points[v[2]]);
        const auto covering = coveringAt(operands, options.fill, center);
        const bool kept = keptByDefinition(options.operation, covering, operands.size());
        EXPECT_EQ(part != BooleanParts::kNoPart, kept);
        expected += kept ? area : 0.0;
        if (kept && part != BooleanParts::kNoPart) {
            const BooleanPart& found = result.parts[part];
            if (options.priority == Priority::None) {
                EXPECT_FALSE(found.owner.valid());
            }
            else {
                EXPECT_EQ(found.owner, options.priority == Priority::First ? covering.front()
                                                                           : covering.back());
            }
            if (options.operation == BooleanOperation::Cells
                && options.priority == Priority::None) {
                EXPECT_EQ(result.sets.members(found.operands), covering);
            }
        }
        if (operands.size() == 2) {
            const bool inT = !covering.empty() && covering.front().value == 0;
            const bool inS = !covering.empty() && covering.back().value == 1;
            EXPECT_EQ(result.theta[i], inT && inS ? Theta::O
                                           : inT  ? Theta::T
                                           : inS  ? Theta::S
                                                  : Theta::E);
        }
        ++compared;
    }
    EXPECT_NEAR(sum, expected, 1e-9);
    return compared;
}

TEST(Boolean, AgreesWithWindingNumbersOfRaysForEveryOperationRuleAndPriority)
{
    std::mt19937 random(6);
    std::size_t compared = 0;
    for (int round = 0; round < 120; ++round) {
        const Operands operands = randomOperands(random, 1 + random() % 5, 4 + random() % 12);
        const Colored colored = color(networkOf(operands), FillRule::EvenOdd);
        for (const FillRule fill : kRules) {
            for (const BooleanOperation operation : kOperations) {
                for (const Priority priority : kPriorities) {
                    SCOPED_TRACE(::testing::Message()
                                 << "round " << round << ", rule " << static_cast<int>(fill)
                                 << ", operation " << static_cast<int>(operation));
                    compared += compareWithOracle(operands, colored, {operation, priority, fill});
                }
            }
        }
        ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(compared, 100000U);
}

TEST(Boolean, PartsHangTogetherAndCellsAreTheFacesOfTheArrangement)
{
    std::mt19937 random(7);
    for (int round = 0; round < 100; ++round) {
        const Operands operands = randomOperands(random, 1 + random() % 4, 10);
        const Colored colored = color(networkOf(operands), FillRule::EvenOdd);
        const Triangulation& t = colored.recovered.triangulation;
        for (const BooleanOperation operation : kOperations) {
            const BooleanParts result =
                boolean(colored, {operation, Priority::None, FillRule::NonZero});
            for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
                for (std::uint32_t side = 0; side < 3; ++side) {
                    const HalfEdge h = Topology::halfEdge(i, side);
                    const std::uint32_t here = result.partOfTriangle[i];
                    const std::uint32_t there =
                        result.partOfTriangle[Topology::triangleOf(t.twin(h))];
                    const bool bothKept =
                        here != BooleanParts::kNoPart && there != BooleanParts::kNoPart;
                    if (operation != BooleanOperation::Cells && bothKept) {
                        EXPECT_EQ(here, there);
                    }
                    else if (!t.isConstrained(h)) {
                        EXPECT_EQ(here, there);
                    }
                }
            }
            const Polygons polygons =
                partOutlines(t, result.partOfTriangle, result.parts.size());
            ASSERT_EQ(polygons.size(), result.parts.size());
            for (std::size_t p = 0; p < polygons.size(); ++p) {
                double area = 0.0;
                for (std::size_t i = 0; i < polygons.loopCount(p); ++i) {
                    Ring ring;
                    for (const std::uint32_t v : polygons.loop(p, i)) {
                        ring.push_back(t.points[v]);
                    }
                    EXPECT_EQ(shoelace(ring) > 0.0, i == 0);
                    area += shoelace(ring);
                }
                EXPECT_NEAR(area, result.parts[p].area, 1e-9);
            }
        }
    }
}

TEST(Boolean, CoincidentBordersOfTwoOperandsDoNotCancelButThoseOfOneDo)
{
    const Ring square = rectangle(0, 0, 2, 2);
    const Ring beside = rectangle(2, 0, 4, 2);
    const auto areaOf = [](const Operands& operands, BooleanOperation operation) {
        const Colored colored = color(networkOf(operands), FillRule::EvenOdd);
        double sum = 0.0;
        for (const BooleanPart& part : boolean(colored, {operation}).parts) {
            sum += part.area;
        }
        return sum;
    };
    EXPECT_EQ(areaOf({{square}, {square}}, BooleanOperation::Intersection), 4.0);
    EXPECT_EQ(areaOf({{square}, {square}}, BooleanOperation::SymmetricDifference), 0.0);
    EXPECT_EQ(areaOf({{square, square}}, BooleanOperation::Union), 0.0);
    EXPECT_EQ(areaOf({{square, square, square}}, BooleanOperation::Union), 4.0);
    EXPECT_EQ(areaOf({{square}, {beside}}, BooleanOperation::Intersection), 0.0);
    EXPECT_EQ(areaOf({{square}, {beside}}, BooleanOperation::Union), 8.0);
    EXPECT_EQ(areaOf({{square, beside}}, BooleanOperation::Union), 8.0);
}

TEST(Boolean, LinesAmongTheOperandsSplitCellsAndBoundNone)
{
    CurveNetwork network = networkOf({{rectangle(0, 0, 4, 4)}, {}});
    addRing(network, rectangle(1, 1, 2, 2), 1, Role::Constraint); // inside: a cell of its own
    addRing(network, rectangle(6, 6, 7, 7), 1, Role::Constraint); // outside: none
    const Colored colored = color(network, FillRule::EvenOdd);
    const BooleanParts cells = boolean(colored, {BooleanOperation::Cells});
    ASSERT_EQ(cells.parts.size(), 2U);
    EXPECT_EQ(cells.parts[0].area + cells.parts[1].area, 16.0);
    EXPECT_EQ(std::min(cells.parts[0].area, cells.parts[1].area), 1.0);
    EXPECT_EQ(boolean(colored, {BooleanOperation::Union}).parts.size(), 1U);
}

TEST(Boolean, HolePointsTakeTheirFaceFromTheirOperandOnly)
{
    CurveNetwork network = networkOf({{rectangle(0, 0, 4, 4)}, {rectangle(2, 0, 6, 4)}});
    network.holes.push_back({{1, 1}, OperandId(0U)});
    const Colored colored = color(network, FillRule::EvenOdd);
    // The hole is the face around its point up to the curves of its operand: all of operand 0.
    const BooleanParts cells = boolean(colored, {BooleanOperation::Cells});
    ASSERT_EQ(cells.parts.size(), 2U);
    for (const BooleanPart& cell : cells.parts) {
        EXPECT_EQ(cells.sets.members(cell.operands), std::vector {OperandId(1U)});
    }
}

TEST(Boolean, RefusesTheHullAndTakesNothing)
{
    const Colored nothing = color(emptyNetwork(3), FillRule::EvenOdd);
    for (const BooleanOperation operation : kOperations) {
        EXPECT_TRUE(boolean(nothing, {operation}).parts.empty());
    }
    BooleanOptions hull;
    hull.fill = FillRule::Hull;
    EXPECT_THROW(boolean(nothing, hull), Error);
}

TEST(Boolean, TenThousandNestedOperandsNeedMemoryForTheirRegionsOnly)
{
    constexpr std::size_t kCount = 10000;
    Operands operands(kCount);
    for (std::size_t o = 0; o < kCount; ++o) {
        const double r = static_cast<double>(o + 1);
        operands[o] = {rectangle(-r, -r, r, r)};
    }
    const Colored colored = color(networkOf(operands), FillRule::EvenOdd);
    const BooleanParts cells = boolean(colored, {BooleanOperation::Cells});
    ASSERT_EQ(cells.parts.size(), kCount);
    std::size_t members = 0;
    for (const BooleanPart& cell : cells.parts) {
        const auto covering = cells.sets.members(cell.operands);
        members += covering.size();
        // The ring between squares k and k - 1 has the area (2k)^2 - (2k - 2)^2.
        const double k = static_cast<double>(covering.front().value) + 1;
        EXPECT_EQ(cell.area, 4.0 * (2.0 * k - 1.0));
    }
    EXPECT_EQ(members, kCount * (kCount + 1) / 2);
    EXPECT_LT(cells.sets.memoryBytes(), members * sizeof(OperandId) / 20);
}

TEST(OperandSets, AgreeWithSetsAndAreInterned)
{
    for (const std::size_t operands : {1U, 64U, 65U, 1024U, 1025U, 100000U}) {
        OperandSets sets(operands);
        std::mt19937 random(8);
        std::set<OperandId> expected;
        OperandSetId set = OperandSets::kEmpty;
        for (int step = 0; step < 2000; ++step) {
            const OperandId operand(static_cast<std::uint32_t>(random() % operands));
            const OperandSetId before = set;
            set = sets.toggled(set, operand);
            if (!expected.insert(operand).second) {
                expected.erase(operand);
            }
            EXPECT_EQ(sets.contains(set, operand), expected.contains(operand));
            EXPECT_EQ(sets.toggled(set, operand), before);
            if (step % 100 == 0) {
                EXPECT_EQ(sets.members(set),
                          std::vector(expected.begin(), expected.end()));
            }
        }
        while (!expected.empty()) {
            set = sets.toggled(set, *expected.begin());
            expected.erase(expected.begin());
        }
        EXPECT_EQ(set, OperandSets::kEmpty);
    }
}

} // namespace
} // namespace tessera
