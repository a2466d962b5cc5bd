// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "curve/curve.h"
#include "curve/curve_network.h"
#include "curve/line.h"

#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

namespace tessera
{

/// The meshed curves of a network behind one interface; straight ones get a LineCurve.
class CurveSet
{
public:
    explicit CurveSet(const CurveNetwork& network);

    std::size_t size() const { return curves_.size(); }
    /// Null for curves with Role::Ignored.
    const Curve* find(std::uint32_t curve) const { return curves_[curve]; }
    const Curve& operator[](std::uint32_t curve) const { return *curves_[curve]; }
    bool isStraight(std::uint32_t curve) const { return network_.curves[curve].geometry == nullptr; }
    const CurveNetwork& network() const { return network_; }

private:
    const CurveNetwork& network_;
    std::deque<LineCurve> lines_;
    std::vector<const Curve*> curves_;
};

/// A piece of a curve with bounds that hold for it: it lies within sagitta of its chord, and its
/// tangents within the angle asin(coneSine) of the one in its middle.
struct Arc
{
    std::uint32_t curve;
    double a;
    double b;
    Vec2 pa;
    Vec2 pb;
    Vec2 direction;      ///< derivative in the middle
    double secondBound;  ///< of |d²/dt²| over it
    double sagitta;
    double coneSine;     ///< 1 or more: nothing is known of the tangents

    Box2 box() const;
    double chord() const { return distance(pa, pb); }
};

/// An arc of a curve between two parameters without a break between them.
Arc makeArc(const CurveSet& curves, std::uint32_t curve, double a, double b);

std::pair<Arc, Arc> halve(const CurveSet& curves, const Arc& arc);

/// All curves cut at their breaks and further into arcs whose tangents turn by less than about a
/// right angle, straight curves as one arc each. Curves without length have none.
std::vector<Arc> cutIntoArcs(const CurveSet& curves);
/// Those of one curve that is meshed.
std::vector<Arc> cutIntoArcs(const CurveSet& curves, std::uint32_t curve);

/// The parameter in [a, b] of the arc's point nearest to p, for p near the arc.
double nearestParameter(const CurveSet& curves, const Arc& arc, Vec2 p);
/// The parameter in [low, high] of the curve's point nearest to p, which is near it; arcs: of all
/// curves, as cutIntoArcs() orders them.
double nearestParameter(const CurveSet& curves, std::span<const Arc> arcs, std::uint32_t curve,
                        double low, double high, Vec2 p);

} // namespace tessera
