// SPDX-License-Identifier: MIT
#include "curve/arc.h"
#include "imprint/overlay.h"
#include "imprint/overlay_mesh.h"
#include "io/overlay_files.h"
#include "io/overlay_report.h"
#include "io/read_poly.h"
#include "io/read_wkt.h"
#include "region/colored.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <set>

namespace tessera
{
namespace
{

OverlayResult overlay(const CurveNetwork& network, const OverlayOptions& options = {})
{
    Execution execution;
    return overlayNetwork(network, options, execution);
}

CurveNetwork crossedSquares()
{
    CurveNetwork network = emptyNetwork(2);
    addRing(network, rectangle(0, 0, 4, 4), 0);
    addRing(network, rectangle(2, 1, 6, 3), 1);
    return network;
}

CurveNetwork circles(std::size_t count, double distance, double radius)
{
    CurveNetwork network = emptyNetwork(count);
    for (std::uint32_t o = 0; o < count; ++o) {
        const Vec2 center {distance * static_cast<double>(o), 0.0};
        const auto arc = std::make_shared<EllipseArc>(
            center, Vec2 {radius, 0.0}, Vec2 {0.0, radius}, 0.0, 2.0 * std::numbers::pi);
        const PointId start = network.addPoint(arc->point(arc->first()));
        network.curves.push_back({arc, start, start, OperandId(o)});
    }
    return network;
}

TEST(Overlay, ThetaAreasAreThoseOfAlgorithm2)
{
    const OverlayResult result = overlay(crossedSquares());
    ASSERT_TRUE(result.report.theta.has_value());
    EXPECT_EQ(result.report.theta->o, 4.0);
    EXPECT_EQ(result.report.theta->t, 12.0);
    EXPECT_EQ(result.report.theta->s, 4.0);
    const Vec2 extent = result.rectangle.corner[2] - result.rectangle.corner[0];
    EXPECT_EQ(result.report.theta->e, extent.x * extent.y - 20.0);
    EXPECT_EQ(result.report.area, 20.0);
}

TEST(Overlay, EdgesAndCrossingsKnowTheCurvesTheyComeFrom)
{
    const CurveNetwork network = crossedSquares();
    OverlayOptions options;
    options.operation = BooleanOperation::Intersection;
    const OverlayResult result = overlay(network, options);
    const CurvesThroughVertices through(result);
    ASSERT_EQ(result.polygons.size(), 1U);
    const auto loop = result.polygons.loop(0, 0);
    ASSERT_EQ(loop.size(), 4U);
    std::set<CurveId> curves;
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto on = result.curvesOn(loop[i], loop[(i + 1) % loop.size()]);
        ASSERT_EQ(on.size(), 1U);
        curves.insert(on.front());
        const auto meeting = through.of(loop[i]);
        ASSERT_EQ(meeting.size(), 2U);
        if (result.origin[loop[i]] == VertexOrigin::Crossing) {
            ++crossings;
            EXPECT_NE(network.curves[meeting[0].index()].operand,
                      network.curves[meeting[1].index()].operand);
        }
    }
    EXPECT_EQ(crossings, 2U);
    // The right side of the first square, three sides of the second.
    EXPECT_EQ(curves, (std::set {CurveId(1U), CurveId(4U), CurveId(6U), CurveId(7U)}));
    EXPECT_TRUE(result.curvesOn(loop[0], loop[2]).empty());
}

TEST(Overlay, CurvedOperandsMeetOnTheirTrueCurves)
{
    OverlayOptions options;
    options.operation = BooleanOperation::Intersection;
    const OverlayResult result = overlay(circles(2, 1.0, 1.0), options);
    ASSERT_EQ(result.polygons.size(), 1U);
    const double lens = 2.0 * std::numbers::pi / 3.0 - std::sqrt(3.0) / 2.0;
    EXPECT_NEAR(result.report.area, lens, 3e-4);
    EXPECT_LT(result.report.area, lens);
    std::size_t crossings = 0;
    const CurvesThroughVertices through(result);
    for (const std::uint32_t v : result.polygons.vertices) {
        if (result.origin[v] == VertexOrigin::Crossing) {
            ++crossings;
            EXPECT_NEAR(result.point(v).x, 0.5, 1e-14);
            EXPECT_NEAR(std::abs(result.point(v).y), std::sqrt(0.75), 1e-14);
            EXPECT_EQ(through.of(v).size(), 2U);
        }
    }
    EXPECT_EQ(crossings, 2U);
}

TEST(Overlay, RingsAreMeasuredByTheirCurvesNotByTheirSeams)
{
    CurveNetwork network;
    constexpr double kGap = 1e-4;
    for (const double radius : {10.0, 10.0 + kGap}) {
        const auto circle = std::make_shared<EllipseArc>(
            Vec2 {0, 0}, Vec2 {radius, 0}, Vec2 {0, radius}, 0.0, 2.0 * std::numbers::pi);
        const PointId seam = network.addPoint({radius, 0.0});
        network.curves.push_back({circle, seam, seam, OperandId(network.operands.size())});
        network.operands.emplace_back();
    }
    OverlayOptions options;
    options.operation = BooleanOperation::Cells;
    const OverlayResult result = overlay(network, options);
    ASSERT_EQ(result.polygons.size(), 2U);
    EXPECT_LT(result.polygons.vertices.size(), 10000U);
}

TEST(Overlay, WktReadsBackAsTheSameResult)
{
    for (const BooleanOperation operation :
         {BooleanOperation::Union, BooleanOperation::SymmetricDifference}) {
        OverlayOptions options;
        options.operation = operation;
        const OverlayResult result = overlay(crossedSquares(), options);
        const std::string text = formatWkt(result, operation);
        const OverlayResult again = overlay(parseWkt(text, "result"));
        EXPECT_EQ(again.report.area, result.report.area);
        EXPECT_EQ(again.polygons.size(), result.polygons.size());
        EXPECT_EQ(again.report.recovery.crossings, 0U);
    }
    EXPECT_EQ(formatWkt(overlay(emptyNetwork(2)), BooleanOperation::Union),
              "GEOMETRYCOLLECTION EMPTY\n");
}

TEST(Overlay, PolyReadsBackWithItsHolesAndRegions)
{
    CurveNetwork network = crossedSquares();
    addRing(network, rectangle(0.5, 0.5, 1.5, 1.5), 0); // even-odd: a hole
    OverlayOptions options;
    options.operation = BooleanOperation::Cells;
    const OverlayResult cells = overlay(network, options);
    EXPECT_EQ(cells.report.area, 19.0);
    const CurveNetwork written = parsePoly(formatPoly(cells), "cells.poly");
    EXPECT_EQ(written.holes.size(), 1U);
    EXPECT_EQ(written.regions.size(), 3U);
    for (const auto& [operation, area] :
         {std::pair(BooleanOperation::Union, 19.0),
          std::pair(BooleanOperation::SymmetricDifference, 15.0)}) {
        options.operation = operation;
        const std::string text = formatPoly(overlay(network, options));
        EXPECT_EQ(overlay(parsePoly(text, "again.poly")).report.area, area);
    }
}

TEST(Overlay, PriorityGivesEachPlaceToOneOperand)
{
    OverlayOptions options;
    options.priority = Priority::Last;
    const OverlayResult result = overlay(crossedSquares(), options);
    ASSERT_EQ(result.parts.parts.size(), 2U);
    EXPECT_EQ(result.parts.parts[0].area, 12.0);
    EXPECT_EQ(result.parts.parts[0].owner, OperandId(0U));
    EXPECT_EQ(result.parts.parts[1].area, 8.0);
    const auto report = nlohmann::json::parse(formatReport(result, BooleanOperation::Union));
    EXPECT_EQ(report.at("cells").size(), 2U);
    EXPECT_EQ(report.at("cells").at(1).at("operands"), nlohmann::json::array({2}));
}

TEST(Overlay, TheMeshHasARegionForEachPartAndGroupsForTheOperands)
{
    OverlayOptions options;
    options.operation = BooleanOperation::Cells;
    CurveNetwork network = crossedSquares();
    network.operands[0].name = "Plate";
    network.operands[1].name = "Rib";
    const OverlayResult result = overlay(network, options);
    const Mesh mesh = meshOf(result);
    ASSERT_EQ(mesh.regions.size(), 3U);
    double area = 0.0;
    for (const auto& region : mesh.regions) {
        area += region.area;
    }
    EXPECT_EQ(area, 20.0);
    std::set<std::string> names;
    for (const Group& group : mesh.groups) {
        names.insert(group.name);
    }
    EXPECT_TRUE(names.contains("Plate") && names.contains("Rib") && names.contains("Region3"));
}

TEST(Overlay, BothRecoveriesGiveTheSameCells)
{
    CurveNetwork network = emptyNetwork(12);
    for (std::uint32_t o = 0; o < 12; ++o) {
        Ring star;
        for (int i = 0; i < 10; ++i) {
            const double angle = 0.4 * o + 2.0 * std::numbers::pi * 3.0 * i / 10.0;
            star.push_back({0.3 * o + std::cos(angle), 0.1 * o + std::sin(angle)});
        }
        addRing(network, star, o);
    }
    OverlayOptions options;
    options.operation = BooleanOperation::Cells;
    options.fill = FillRule::NonZero;
    const OverlayResult cavity = overlay(network, options);
    options.recovery = RecoveryStrategy::Steiner;
    const OverlayResult steiner = overlay(network, options);
    EXPECT_GT(steiner.report.recovery.steinerInserted, 0U);
    EXPECT_EQ(cavity.parts.parts.size(), steiner.parts.parts.size());
    EXPECT_NEAR(cavity.report.area, steiner.report.area, 1e-12);
}

TEST(Overlay, AnEmptyResultSaysWhy)
{
    CurveNetwork apart = emptyNetwork(3);
    addRing(apart, rectangle(0, 0, 1, 1), 0);
    addRing(apart, rectangle(5, 0, 6, 1), 1);
    addRing(apart, rectangle(0, 0, 1, 1), 2);
    CurveNetwork open = emptyNetwork(1);
    open.addPoint({0, 0});
    open.addPoint({1, 0});
    open.addPoint({1, 1});
    open.curves.push_back({nullptr, PointId(0U), PointId(1U), OperandId(0U)});
    open.curves.push_back({nullptr, PointId(1U), PointId(2U), OperandId(0U)});
    CurveNetwork constraint = open;
    for (NetworkCurve& curve : constraint.curves) {
        curve.role = Role::Constraint;
    }
    CurveNetwork twice = emptyNetwork(1);
    addRing(twice, rectangle(0, 0, 1, 1), 0);
    addRing(twice, rectangle(0, 0, 1, 1), 0);
    using enum BooleanOperation;
    const struct
    {
        CurveNetwork network;
        BooleanOperation operation;
        std::string part;
    } cases[] = {{apart, Intersection, "No place is covered by all 3 operands"},
                 {apart, Difference, "No place is covered by the first operand alone"},
                 {emptyNetwork(2), Union, "There are no curves"},
                 {open, Cells, "2 ends are free"},
                 {constraint, Union, "2 ends are free"},
                 {twice, SymmetricDifference, "drawn twice"}};
    for (const auto& c : cases) {
        for (const OverlayForm form : {OverlayForm::Triangles, OverlayForm::Polygons}) {
            OverlayOptions options;
            options.operation = c.operation;
            options.form = form;
            const OverlayResult result = overlay(c.network, options);
            EXPECT_TRUE(result.parts.parts.empty());
            ASSERT_FALSE(result.report.messages.empty()) << c.part;
            const std::string& last = result.report.messages.back();
            EXPECT_TRUE(last.starts_with("The result is empty. ")) << last;
            EXPECT_NE(last.find(c.part), std::string::npos) << last;
        }
    }
    OverlayOptions options;
    options.operation = SymmetricDifference;
    EXPECT_TRUE(overlay(crossedSquares(), options).report.messages.empty());
}

TEST(Overlay, CancelEndsIt)
{
    Execution execution;
    execution.cancel();
    EXPECT_THROW(overlayNetwork(crossedSquares(), {}, execution), Error);
}

} // namespace
} // namespace tessera
