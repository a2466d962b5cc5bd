// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve.h"

namespace tessera
{

/// The signed area between a curve's piece from parameter a to b (b < a: run backwards) and its
/// chord: positive where the piece bulges to the right of the chord. Exact to rounding for lines and
/// arcs of ellipses, otherwise to about 1e-12 of the squared length.
double chordArea(const Curve& curve, double a, double b);

} // namespace tessera
