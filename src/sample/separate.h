// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "base/ids.h"
#include "base/vec2.h"
#include "curve/curve.h"

#include <vector>

namespace tessera
{

/// A chord of a curve. Null geometry: straight.
struct CurvePiece
{
    PointId a;
    PointId b;
    CurveId curve;
    const Curve* geometry;
    double ta; ///< parameters of a and b on the geometry; ta > tb if the curve runs backwards
    double tb;
};

struct Separation
{
    std::vector<CurvePiece> halves; ///< the pieces that were made
    bool done = true;               ///< false: some pieces are still in the way of others
};

/// Halves curved pieces until the pieces meet only where their curves do: no two of them cross, and
/// no point lies between a piece and its curve. Thin gaps between arcs and small loops beside an
/// arc need that. Equal pieces are halved alike.
///
/// Precondition: the curves themselves meet in common end points only, or coincide. Where that
/// fails (straight curves may cross straight ones) curved pieces are halved a bounded number of
/// times and then left.
Separation separatePieces(std::vector<Vec2>& points, std::vector<CurvePiece>& pieces,
                          Execution& execution);

} // namespace tessera
