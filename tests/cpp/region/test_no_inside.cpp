// SPDX-License-Identifier: MIT
#include "curve/arc.h"
#include "region/colored.h"
#include "region/no_inside.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace tessera
{
namespace
{

Error reasonFor(const CurveNetwork& network, FillRule fill)
{
    const Colored colored = color(network, fill);
    EXPECT_EQ(colored.map.keptRegions, 0U);
    return explainNoInside(colored.recovered, colored.network, colored.pslg, fill,
                           {colored.input, colored.parent});
}

/// Each curve of the network is named "A", "B", ... in order.
Error reasonForNamed(CurveNetwork network)
{
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        network.curveNames.emplace_back(1, static_cast<char>('A' + c));
    }
    return reasonFor(network, FillRule::EvenOdd);
}

void addLine(CurveNetwork& network, Vec2 a, Vec2 b, std::uint32_t operand = 0)
{
    addPolyline(network, Ring {a, b}, false, OperandId(operand), Role::Chain);
}

TEST(ExplainNoInside, OverlapsCrossingsAndTouchesInsteadOfEnds)
{
    CurveNetwork overlap = emptyNetwork(1);
    addLine(overlap, {0, 0}, {6, 0});
    addPolyline(overlap, Ring {{4, 0}, {10, 0}, {10, 8}, {0, 8}}, false, OperandId(0U),
                Role::Chain);
    overlap.curves.push_back({nullptr, PointId(5U), PointId(0U), OperandId(0U), Role::Chain});
    const Error shared = reasonForNamed(overlap);
    EXPECT_STREQ(shared.what(),
                 "The ends of the curves close no outline: B and A overlap between (4, 0) and "
                 "(6, 0); let one end where the other begins, or choose the fill rule 'all', which "
                 "meshes all that the curves enclose.");
    ASSERT_EQ(shared.places().size(), 2U);
    EXPECT_EQ(shared.places()[0].curve, 1U);
    EXPECT_EQ(shared.places()[1].curve, 0U);

    CurveNetwork overshoot = emptyNetwork(1);
    addLine(overshoot, {-1, 0}, {11, 0});
    addLine(overshoot, {10, -1}, {10, 9});
    addLine(overshoot, {11, 8}, {-1, 8});
    addLine(overshoot, {0.5, 9}, {0.5, -0.5});
    const Error crossed = reasonForNamed(overshoot);
    EXPECT_NE(std::string(crossed.what()).find("A and D cross at (0.5, 0)"), std::string::npos);
    ASSERT_EQ(crossed.places().size(), 2U);
    EXPECT_EQ(crossed.places()[0].curve, 0U);
    EXPECT_EQ(crossed.places()[1].curve, 3U);

    CurveNetwork touch = emptyNetwork(1);
    addPolyline(touch, Ring {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, -1}}, false, OperandId(0U),
                Role::Chain);
    EXPECT_NE(std::string(reasonForNamed(touch).what()).find("A ends on the inside of D at (0, 0)"),
              std::string::npos);

    // Lines that cross inside an outline with a gap are not what is wrong.
    CurveNetwork gap = emptyNetwork(1);
    addPolyline(gap, Ring {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0.25}}, false, OperandId(0U),
                Role::Chain);
    addLine(gap, {2, 2}, {6, 2});
    addLine(gap, {3, 1}, {3, 6});
    addLine(gap, {2, 5}, {5, 1});
    EXPECT_NE(std::string(reasonForNamed(gap).what()).find("and (0, 0.25) of D, 0.25 apart"),
              std::string::npos);
}

TEST(ExplainNoInside, CurvesThatAreThereTwiceDoNotCross)
{
    CurveNetwork network = emptyNetwork(1);
    for (const double seam : {0.0, 1.0}) {
        const auto circle = makeCircleArc({0, 0}, 2, seam, seam + 2 * std::numbers::pi);
        const PointId p = network.addPoint(circle->point(seam));
        network.curves.push_back({circle, p, p, OperandId(0U)});
    }
    EXPECT_NE(std::string(reasonForNamed(network).what()).find("drawn twice"), std::string::npos);
}

TEST(ExplainNoInside, CurvesOfSeveralOperands)
{
    CurveNetwork network = emptyNetwork(2);
    addPolyline(network, Ring {{0, 0}, {4, 0}, {4, 4}}, false, OperandId(0U), Role::Chain);
    addPolyline(network, Ring {{4, 4}, {0, 4}, {0, 0}}, false, OperandId(1U), Role::Chain);
    network.curves[2].start = network.curves[1].end;
    network.curves[3].end = network.curves[0].start;
    EXPECT_NE(std::string(reasonForNamed(network).what()).find("belong to different sources"),
              std::string::npos);
}

TEST(ExplainNoInside, RolesThatLeaveNoOutline)
{
    CurveNetwork side = emptyNetwork(1);
    addRing(side, rectangle(0, 0, 1, 1), 0, Role::Chain);
    side.curves[2].role = Role::Constraint;
    const Error constraint = reasonForNamed(side);
    EXPECT_STREQ(constraint.what(),
                 "No outline is left: C closes one but has the role constraint; give it the role "
                 "boundary (option 'boundary'), or choose the fill rule 'all', which meshes all "
                 "that the curves enclose.");
    ASSERT_EQ(constraint.places().size(), 1U);
    EXPECT_EQ(constraint.places()[0].curve, 2U);
    side.curves[2].role = Role::Ignored;
    EXPECT_NE(std::string(reasonForNamed(side).what()).find("C closes one but has the role ignored"),
              std::string::npos);

    CurveNetwork open = emptyNetwork(1);
    addPolyline(open, Ring {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0.25}}, false, OperandId(0U),
                Role::Constraint);
    EXPECT_NE(std::string(reasonForNamed(open).what()).find("and give the curves the role boundary"),
              std::string::npos);
}

TEST(ExplainNoInside, SaysWhatIsWrong)
{
    const auto says = [](const Error& error, const char* words) {
        EXPECT_EQ(error.kind(), ErrorKind::NoInside);
        return std::string(error.what()).find(words) != std::string::npos;
    };
    EXPECT_TRUE(says(reasonFor(emptyNetwork(1), FillRule::EvenOdd), "no curves"));

    CurveNetwork flat = emptyNetwork(1);
    addRing(flat, {{0, 0}, {1, 1}, {2, 2}});
    EXPECT_TRUE(says(reasonFor(flat, FillRule::EvenOdd), "one line"));

    CurveNetwork open = emptyNetwork(1);
    const Ring three {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0.25}};
    addPolyline(open, three, false, OperandId(0U), Role::Chain);
    const Error error = reasonFor(open, FillRule::EvenOdd);
    EXPECT_TRUE(says(error, "0.25 apart"));
    ASSERT_EQ(error.places().size(), 2U);
    EXPECT_EQ(error.places()[0].position, (Vec2 {0, 0}));
    EXPECT_EQ(error.places()[0].curve, 0U);
    EXPECT_EQ(error.places()[1].curve, 3U);

    CurveNetwork constraint = emptyNetwork(1);
    addRing(constraint, rectangle(0, 0, 1, 1), 0, Role::Constraint);
    EXPECT_TRUE(says(reasonFor(constraint, FillRule::EvenOdd), "4 curves close one"));

    CurveNetwork clockwise = emptyNetwork(1);
    addRing(clockwise, reversed(rectangle(0, 0, 1, 1)));
    EXPECT_TRUE(says(reasonFor(clockwise, FillRule::Positive), "clockwise"));

    CurveNetwork twice = emptyNetwork(1);
    addRing(twice, rectangle(0, 0, 1, 1));
    addRing(twice, rectangle(0, 0, 1, 1));
    EXPECT_TRUE(says(reasonFor(twice, FillRule::EvenOdd), "drawn twice"));

    CurveNetwork holes = emptyNetwork(1);
    addRing(holes, rectangle(0, 0, 1, 1));
    holes.holes.push_back({{0.5, 0.4}, OperandId(0U)});
    EXPECT_TRUE(says(reasonFor(holes, FillRule::EvenOdd), "hole points"));
}

} // namespace
} // namespace tessera
