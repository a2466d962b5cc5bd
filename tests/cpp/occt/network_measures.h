// SPDX-License-Identifier: MIT
// Measures of a curve network by numerical integration, independent of the mesher.
#pragma once

#include "curve/curve_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

namespace tessera::test
{

/// The integral of (x dy - y dx) / 2 along a curve from its start to its end.
inline double sweptArea(const CurveNetwork& network, const NetworkCurve& curve)
{
    if (!curve.geometry) {
        return 0.5 * cross(network.points[curve.start.index()], network.points[curve.end.index()]);
    }
    constexpr int kSteps = 2000;
    const double first = curve.geometry->first();
    const double step = (curve.geometry->last() - first) / kSteps;
    const auto integrand = [&](double t) {
        return 0.5 * cross(curve.geometry->point(t), curve.geometry->derivative(t));
    };
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = first + i * step;
        sum += (integrand(t) + 4.0 * integrand(t + 0.5 * step) + integrand(t + step)) * step / 6.0;
    }
    return sum;
}

/// Area enclosed by the boundary curves, counter-clockwise loops positive.
inline double enclosedArea(const CurveNetwork& network)
{
    double sum = 0.0;
    for (const NetworkCurve& curve : network.curves) {
        if (curve.role == Role::Boundary) {
            sum += sweptArea(network, curve);
        }
    }
    return sum;
}

/// Every point has as many boundary curves arriving as leaving.
inline bool boundaryIsClosed(const CurveNetwork& network)
{
    std::map<std::uint32_t, int> balance;
    for (const NetworkCurve& curve : network.curves) {
        if (curve.role == Role::Boundary) {
            ++balance[curve.start.value];
            --balance[curve.end.value];
        }
    }
    return std::all_of(balance.begin(), balance.end(),
                       [](const auto& entry) { return entry.second == 0; });
}

/// The greatest distance between an end of a curve's geometry and its network point.
inline double greatestEndGap(const CurveNetwork& network)
{
    double greatest = 0.0;
    for (const NetworkCurve& curve : network.curves) {
        if (curve.geometry) {
            const Curve& c = *curve.geometry;
            greatest = std::max({greatest,
                                 distance(c.point(c.first()), network.points[curve.start.index()]),
                                 distance(c.point(c.last()), network.points[curve.end.index()])});
        }
    }
    return greatest;
}

} // namespace tessera::test
