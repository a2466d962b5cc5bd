// SPDX-License-Identifier: MIT
// Sizes at points and curves with laws of their own, and across gaps, against their definitions.
#include "base/error.h"
#include "curve/arc.h"
#include "curve/polyline.h"
#include "sizing/gap_sources.h"
#include "sizing/make_size_field.h"
#include "sizing/uniform_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace tessera
{
namespace
{

constexpr double kTurn = 2 * std::numbers::pi;
const OperandId kOperand(0U);

CurveNetwork square(double side)
{
    CurveNetwork network;
    network.operands.resize(1);
    const std::vector<Vec2> corners {{0, 0}, {side, 0}, {side, side}, {0, side}};
    addPolyline(network, corners, true, kOperand, Role::Boundary);
    return network;
}

void addCircle(CurveNetwork& network, Vec2 center, double radius)
{
    const auto geometry = makeCircleArc(center, radius, 0.0, kTurn);
    const PointId p = network.addPoint(geometry->point(0.0));
    network.curves.push_back({geometry, p, p, kOperand});
}

double sizeByLaw(const SizeLaw& law, double distance, double growth)
{
    const double away = std::max(0.0, distance - law.radius);
    if (law.farRadius == 0.0) {
        return law.size + growth * away;
    }
    const double slope = (law.farSize - law.size) / (law.farRadius - law.radius);
    return std::min(law.farSize, law.size + std::min(slope, growth) * away);
}

TEST(LocalSizes, LawsAtPointsAgreeWithTheirDefinition)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const CurveNetwork network = square(10);
    Execution execution;
    for (int round = 0; round < 30; ++round) {
        const double growth = 0.1 + 0.5 * uniform(random);
        SizeOptions options {.size = 1.5, .growth = growth};
        for (int i = 0; i < 1 + round / 2; ++i) {
            SizeLaw law {0.05 + 0.2 * uniform(random), 2.0 * uniform(random) * (i % 2)};
            if (i % 3 == 2) {
                law.farSize = law.size + uniform(random);
                law.farRadius = law.radius + 0.5 + 5.0 * uniform(random);
            }
            options.local.points.push_back(
                {{10 * uniform(random), 10 * uniform(random)}, law});
        }
        const auto field = makeSizeField(network, options, execution);
        for (int i = 0; i < 200; ++i) {
            const Vec2 p {10 * uniform(random), 10 * uniform(random)};
            double expected = 1.5;
            for (const PointSize& point : options.local.points) {
                expected = std::min(expected,
                                    sizeByLaw(point.law, distance(p, point.position), growth));
            }
            EXPECT_LE(field->size(p), expected * 1.011);
            EXPECT_GE(field->size(p), expected * 0.96);
        }
    }
}

TEST(LocalSizes, LawsOnCurvesGoByTheDistance)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    CurveNetwork network = square(10);
    addCircle(network, {5, 5}, 2.0);
    const CurveId circle(4U);
    Execution execution;
    for (const SizeLaw law : {SizeLaw {0.1}, SizeLaw {0.1, 0.7}, SizeLaw {0.1, 0.5, 0.6, 3.0}}) {
        SizeOptions options {.size = 2.0};
        options.local.curves.push_back({{circle, CurveId(0U)}, law});
        const auto field = makeSizeField(network, options, execution);
        for (int i = 0; i < 500; ++i) {
            const Vec2 p {10 * uniform(random), 10 * uniform(random)};
            const double away = std::min(std::abs(distance(p, {5, 5}) - 2.0), p.y);
            const double expected = std::min(2.0, sizeByLaw(law, away, 0.3));
            // The circle's chords are within a tenth of the size.
            EXPECT_NEAR(field->size(p), expected, 0.04 * expected + 0.3 * 0.1 * law.size);
        }
    }
}

TEST(LocalSizes, TheMinimumOfSourcesOfAllKinds)
{
    const CurveNetwork network = square(10);
    Execution execution;
    SizeOptions options {.size = 1.0, .minSize = 0.05};
    options.local.points.push_back({{2, 2}, {0.01, 0.3}});
    options.local.curves.push_back({{CurveId(2U)}, {0.2, 0.5}});
    options.local.areas.push_back({"x", [](Vec2 p) { return 0.1 + 0.1 * p.x; }});
    const auto field = makeSizeField(network, options, execution);
    EXPECT_EQ(field->size({2, 2}), 0.05);
    EXPECT_NEAR(field->size({6, 9.8}), 0.2, 0.01);
    EXPECT_NEAR(field->size({0, 5}), 0.1, 0.003);
    EXPECT_NEAR(field->size({8, 4}), 0.9, 0.03);
    EXPECT_LE(field->gradientBound(), 0.3);
}

TEST(LocalSizes, AreasAloneAreLimitedByTheGeneralSize)
{
    Execution execution;
    SizeOptions options {.size = 0.5};
    options.local.areas.push_back({"x", [](Vec2 p) { return 0.1 + 0.1 * p.x; }});
    const auto field = makeSizeField(square(10), options, execution);
    EXPECT_NEAR(field->size({1, 5}), 0.2, 1e-3);
    EXPECT_NEAR(field->size({9, 5}), 0.5, 1e-9);
}

/// A strip of the given width between two lines, 10 long, open at its ends.
CurveNetwork strip(double width)
{
    CurveNetwork network;
    network.operands.resize(1);
    for (const double y : {0.0, width}) {
        const std::vector<Vec2> ends {{0, y}, {10, y}};
        addPolyline(network, ends, false, kOperand, Role::Boundary);
    }
    return network;
}

TEST(GapSizes, ParallelLines)
{
    Execution execution;
    for (const double width : {0.01, 0.1, 0.5}) {
        for (const double elements : {1.0, 3.0, 10.0}) {
            SizeOptions options {.size = 1.0};
            options.local.gap = elements;
            const auto field = makeSizeField(strip(width), options, execution);
            const double expected =
                width / elements < 0.7 ? std::max(1e-3, width / elements) : 1.0;
            for (double x = 0.0; x <= 10.0; x += 0.37) {
                EXPECT_NEAR(field->size({x, 0.0}), expected, 0.15 * expected) << width << elements;
                EXPECT_NEAR(field->size({x, 0.5 * width}), expected, 0.15 * expected);
            }
        }
    }
}

TEST(GapSizes, ConcentricAndEccentricCircles)
{
    Execution execution;
    for (const double shift : {0.0, 0.15, 0.19}) {
        CurveNetwork network;
        network.operands.resize(1);
        addCircle(network, {0, 0}, 2.0);
        addCircle(network, {shift, 0}, 1.8);
        SizeOptions options {.size = 1.0};
        options.local.gap = 4.0;
        const auto field = makeSizeField(network, options, execution);
        for (int i = 0; i < 40; ++i) {
            const Vec2 direction {std::cos(i * 0.157), std::sin(i * 0.157)};
            // Where the ray from the outer circle's point to its center meets the inner one.
            const Vec2 p = 2.0 * direction;
            const double b = direction.x * shift;
            const double width =
                2.0 - (b + std::sqrt(b * b - shift * shift + 1.8 * 1.8));
            EXPECT_NEAR(field->size(p), width / 4.0, 0.1 * width / 4.0 + 0.006) << shift << " " << i;
        }
    }
}

TEST(GapSizes, WhatIsOutsideDoesNotCount)
{
    const CurveNetwork network = strip(0.1);
    const UniformSize base(1.0);
    const Execution execution;
    const GapOptions everywhere {.elements = 3.0};
    EXPECT_FALSE(gapSources(network, base, everywhere, execution).empty());
    const GapOptions nowhere {.elements = 3.0, .inside = [](Vec2) { return false; }};
    EXPECT_TRUE(gapSources(network, base, nowhere, execution).empty());
}

TEST(GapSizes, NarrowerThanTheLeastSizeTakesNoMoreSources)
{
    const UniformSize base(1.0);
    const GapOptions options {.elements = 1.0, .minSize = 0.1};
    const auto count = [&](double width) {
        return gapSources(strip(width), base, options, Execution()).size();
    };
    const std::size_t wide = count(0.1);
    EXPECT_GT(wide, 100U);
    EXPECT_LE(count(0.01), wide);
    EXPECT_LE(count(0.001), wide);
}

TEST(GapSizes, CornersAndRoundCurvesAreNoGaps)
{
    Execution execution;
    CurveNetwork wedge;
    wedge.operands.resize(1);
    const std::vector<Vec2> corners {{0, 0}, {10, 0}, {10, 2}};
    addPolyline(wedge, corners, true, kOperand, Role::Boundary);
    SizeOptions options {.size = 0.5};
    options.local.gap = 2.0;
    const auto field = makeSizeField(wedge, options, execution);
    // 0.2 x wide at x: that counts from 0.5 from the tip on, so nothing is much below 0.05.
    EXPECT_GT(field->size({0, 0}), 0.04);
    EXPECT_NEAR(field->size({1.5, 0}), 0.15, 0.03);
    CurveNetwork circle;
    circle.operands.resize(1);
    addCircle(circle, {0, 0}, 3.0);
    EXPECT_EQ(makeSizeField(circle, options, execution)->uniformSize(), 0.5);
    // The same curve twice is no gap either.
    circle.curves.push_back(circle.curves[0]);
    EXPECT_EQ(makeSizeField(circle, options, execution)->uniformSize(), 0.5);
}

} // namespace
} // namespace tessera
