// SPDX-License-Identifier: MIT
#pragma once

// Sources and targets that the tests imprint on each other.

#include "curve/arc.h"
#include "imprint/imprint.h"
#include "region/colored.h"

#include <memory>
#include <numbers>
#include <vector>

namespace tessera
{

/// A network whose first operands are sources, the others targets.
struct ImprintCase
{
    CurveNetwork network;
    std::vector<ImprintSide> side;
};

inline std::uint32_t addSide(ImprintCase& c, ImprintSide side)
{
    c.network.operands.emplace_back();
    c.side.push_back(side);
    return static_cast<std::uint32_t>(c.side.size() - 1);
}

inline void addSource(ImprintCase& c, const Ring& ring)
{
    addRing(c.network, ring, addSide(c, ImprintSide::Source));
}

inline void addTarget(ImprintCase& c, const Ring& ring)
{
    addRing(c.network, ring, addSide(c, ImprintSide::Target));
}

/// Part of a circle between two angles, clockwise if the second is the smaller one.
struct ArcOf
{
    Vec2 center;
    double radius;
    double first;
    double last;
};

/// A closed outline of corners; arcs[i], where there is one, leads from corner i to the next.
inline void addOutline(ImprintCase& c, ImprintSide side, const Ring& corners,
                       const std::vector<std::pair<std::size_t, ArcOf>>& arcs)
{
    const std::uint32_t operand = addSide(c, side);
    const std::size_t first = c.network.points.size();
    c.network.points.insert(c.network.points.end(), corners.begin(), corners.end());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        NetworkCurve curve;
        curve.start = PointId(first + i);
        curve.end = PointId(first + (i + 1) % corners.size());
        curve.operand = OperandId(operand);
        for (const auto& [at, arc] : arcs) {
            if (at == i) {
                const double turn = arc.first < arc.last ? 1.0 : -1.0;
                curve.geometry = std::make_shared<EllipseArc>(
                    arc.center, Vec2 {arc.radius, 0.0}, Vec2 {0.0, turn * arc.radius},
                    turn * arc.first, turn * arc.last);
            }
        }
        c.network.curves.push_back(std::move(curve));
    }
}

/// Three slanted strips of a 12 x 8 plate as sources; as targets a disk in its middle and what is
/// left of the lower half, of the upper left and of the upper right quarter.
inline ImprintCase plateAndDisk()
{
    constexpr double kPi = std::numbers::pi;
    constexpr Vec2 kCenter {6.0, 4.0};
    constexpr double kRadius = 2.5;
    ImprintCase c;
    addSource(c, {{0, 0}, {3, 0}, {5, 8}, {0, 8}});
    addSource(c, {{3, 0}, {9, 0}, {7, 8}, {5, 8}});
    addSource(c, {{9, 0}, {12, 0}, {12, 8}, {7, 8}});
    addOutline(c, ImprintSide::Target, {{8.5, 4}}, {{0, {kCenter, kRadius, 0, 2 * kPi}}});
    addOutline(c, ImprintSide::Target, {{0, 0}, {12, 0}, {12, 4}, {8.5, 4}, {3.5, 4}, {0, 4}},
               {{3, {kCenter, kRadius, 0, -kPi}}});
    addOutline(c, ImprintSide::Target, {{0, 4}, {3.5, 4}, {6, 6.5}, {6, 8}, {0, 8}},
               {{1, {kCenter, kRadius, kPi, 0.5 * kPi}}});
    addOutline(c, ImprintSide::Target, {{8.5, 4}, {12, 4}, {12, 8}, {6, 8}, {6, 6.5}},
               {{4, {kCenter, kRadius, 0.5 * kPi, 0}}});
    return c;
}

inline ImprintResult imprint(const ImprintCase& c, const ImprintOptions& options = {})
{
    Execution execution;
    return imprintNetwork(c.network, c.side, options, execution);
}

} // namespace tessera
