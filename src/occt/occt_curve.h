// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve.h"
#include "occt/edge_curve.h"
#include "occt/plane_frame.h"

#include <Geom_Curve.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <memory>
#include <vector>

namespace tessera
{

/// Maps space to the coordinates of a frame's plane, dropping the distance from it. Exact for the
/// global frame.
class PlaneProjection
{
public:
    explicit PlaneProjection(const PlaneFrame& frame)
        : frame_(frame)
    {}

    Vec2 point(const gp_Pnt& p) const
    {
        const gp_Vec d(p.X() - frame_.origin[0], p.Y() - frame_.origin[1],
                       p.Z() - frame_.origin[2]);
        return vector(d);
    }
    Vec2 vector(const gp_Vec& v) const { return {along(frame_.x, v), along(frame_.y, v)}; }
    /// Signed distance from the plane.
    double height(const gp_Pnt& p) const
    {
        return along(frame_.z, gp_Vec(p.X() - frame_.origin[0], p.Y() - frame_.origin[1],
                                      p.Z() - frame_.origin[2]));
    }

private:
    static double along(const std::array<double, 3>& axis, const gp_Vec& v)
    {
        return axis[0] * v.X() + axis[1] * v.Y() + axis[2] * v.Z();
    }

    PlaneFrame frame_;
};

/// A piece of an OpenCASCADE curve, seen in a plane; evaluated by OpenCASCADE itself, so points lie
/// on the CAD curve to rounding. Works on Geom_Curve rather than on an adaptor because adaptors
/// keep a cache that threads may not share.
class OcctCurve final: public Curve
{
public:
    /// reversed: run from the edge's last parameter to its first.
    OcctCurve(const EdgeCurve& edge, bool reversed, const PlaneProjection& projection);

    double first() const override { return edge_.first; }
    double last() const override { return edge_.last; }
    /// All three throw Error(InvalidInput) where OpenCASCADE cannot evaluate the curve.
    Vec2 point(double t) const override;
    Vec2 derivative(double t) const override;
    Vec2 secondDerivative(double t) const override;
    /// From the control points of the second derivative for B-splines.
    double secondDerivativeBound(double a, double b) const override;

    const EdgeCurve& edge() const { return edge_; }
    /// Its parameter t is the edge's first + last - t.
    bool reversed() const { return reversed_; }

private:
    /// Bound of |d²/dt²| over one knot span.
    struct SpanBound
    {
        double end;
        double bound;
    };

    static std::vector<SpanBound> spanBounds(const Handle(Geom_Curve)& curve);
    /// At the ends exactly the end's parameter.
    double parameter(double t) const;

    EdgeCurve edge_;
    bool reversed_;
    PlaneProjection projection_;
    std::vector<SpanBound> spans_; ///< of a B-spline that is not rational; ascending
};

/// The curve of a piece of an edge in a plane, from its last parameter to its first if reversed:
/// null for a straight one, an EllipseArc for circles and ellipses (so that equal supporting curves
/// can be recognized), else an OcctCurve.
std::shared_ptr<const Curve> makeCurve(const EdgeCurve& piece, bool reversed,
                                       const PlaneProjection& projection);

} // namespace tessera
