// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"

namespace tessera
{

/// A smooth parametric curve of the plane over [first(), last()]. Lines, arcs and polylines are
/// in this folder; OpenCASCADE's curves implement it in occt/. Immutable and thread-safe.
class Curve
{
public:
    virtual ~Curve() = default;

    virtual double first() const = 0;
    virtual double last() const = 0;
    virtual Vec2 point(double t) const = 0;
    /// d/dt and d²/dt².
    virtual Vec2 derivative(double t) const = 0;
    virtual Vec2 secondDerivative(double t) const = 0;
};

} // namespace tessera
