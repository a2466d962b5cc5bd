// SPDX-License-Identifier: MIT
#pragma once

// Arranged networks of random curves, and fields that grow from random places in them.

#include "arrange/arrange.h"
#include "curve/arc.h"
#include "curve/curve_network.h"
#include "curve/curve_tools.h"
#include "curve/polyline.h"
#include "sizing/make_size_field.h"

#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace tessera::test
{

inline void addCurve(CurveNetwork& network, std::shared_ptr<const Curve> geometry, bool closed)
{
    network.operands.resize(1);
    const PointId start = network.addPoint(geometry->point(geometry->first()));
    const PointId end = closed ? start : network.addPoint(geometry->point(geometry->last()));
    network.curves.push_back({std::move(geometry), start, end, OperandId(0U)});
}

inline void addCircle(CurveNetwork& network, Vec2 center, double radius, double seam = 0.0)
{
    addCurve(network, makeCircleArc(center, radius, seam, seam + 2 * std::numbers::pi), true);
}

inline void addLine(CurveNetwork& network, Vec2 a, Vec2 b)
{
    network.operands.resize(1);
    const std::vector<Vec2> ends {a, b};
    addPolyline(network, ends, false, OperandId(0U), Role::Constraint);
}

/// Lines, circles, arcs and ellipses over a square of side 10, as they come.
inline CurveNetwork randomCurves(std::mt19937& random, int count)
{
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const auto place = [&] { return Vec2 {10 * uniform(random), 10 * uniform(random)}; };
    CurveNetwork network;
    for (int i = 0; i < count; ++i) {
        const Vec2 center = place();
        const double radius = 0.2 * std::pow(20.0, uniform(random));
        const double from = 6 * uniform(random);
        switch (random() % 4) {
            case 0:
                addLine(network, center, place());
                break;
            case 1:
                addCircle(network, center, radius, from);
                break;
            case 2:
                addCurve(network,
                         makeCircleArc(center, radius, from, from + 0.3 + 5 * uniform(random)),
                         false);
                break;
            default:
                addCurve(network,
                         makeEllipseArc(center, radius, radius * (0.1 + 0.9 * uniform(random)),
                                        6 * uniform(random), from, from + 2 * std::numbers::pi),
                         true);
                break;
        }
    }
    return network;
}

inline CurveNetwork arranged(const CurveNetwork& network)
{
    Execution execution;
    ArrangeReport report;
    return arrange(network, {.crossStraight = true}, report, execution);
}

/// What the pipeline makes for the network, with sizes at some random places.
inline std::unique_ptr<SizeField> randomField(std::mt19937& random, const CurveNetwork& network,
                                              double size, double growth)
{
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    SizeOptions options {.size = size, .growth = growth};
    const Box2 box = networkBounds(network);
    for (int i = 0; i < 5; ++i) {
        const Vec2 p {box.min.x + uniform(random) * (box.max.x - box.min.x),
                      box.min.y + uniform(random) * (box.max.y - box.min.y)};
        options.local.points.push_back({p, {size * (0.02 + 0.3 * uniform(random))}});
    }
    Execution execution;
    return makeSizeField(network, options, execution);
}

} // namespace tessera::test
