// SPDX-License-Identifier: MIT
#include "curve/curve.h"

#include <algorithm>

namespace tessera
{

double Curve::secondDerivativeBound(double a, double b) const
{
    // The greatest of nine samples plus the greatest step between neighbors: between two samples
    // a smooth function exceeds them by less than it changes over a step, unless it oscillates
    // faster than the samples resolve.
    constexpr int kSteps = 8;
    double greatest = 0.0;
    double greatestStep = 0.0;
    Vec2 previous = secondDerivative(a);
    for (int i = 0; i <= kSteps; ++i) {
        const double s = static_cast<double>(i) / kSteps;
        const Vec2 here = secondDerivative((1.0 - s) * a + s * b);
        greatest = std::max(greatest, length(here));
        greatestStep = std::max(greatestStep, distance(previous, here));
        previous = here;
    }
    return greatest + greatestStep;
}

} // namespace tessera
