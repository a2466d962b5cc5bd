// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve.h"

#include <memory>

namespace tessera
{

/// The part [first, last] of another curve, with the same parameters.
class TrimmedCurve final: public Curve
{
public:
    /// Precondition: base->first() <= first < last <= base->last().
    TrimmedCurve(std::shared_ptr<const Curve> base, double first, double last);

    double first() const override { return first_; }
    double last() const override { return last_; }
    Vec2 point(double t) const override { return base_->point(t); }
    Vec2 derivative(double t) const override { return base_->derivative(t); }
    Vec2 secondDerivative(double t) const override { return base_->secondDerivative(t); }
    std::vector<double> breaks() const override;
    double secondDerivativeBound(double a, double b) const override
    {
        return base_->secondDerivativeBound(a, b);
    }
    const std::shared_ptr<const Curve>& base() const { return base_; }

private:
    std::shared_ptr<const Curve> base_;
    double first_;
    double last_;
};

/// Another curve run through backwards over the same interval.
class ReversedCurve final: public Curve
{
public:
    explicit ReversedCurve(std::shared_ptr<const Curve> base);

    double first() const override { return base_->first(); }
    double last() const override { return base_->last(); }
    Vec2 point(double t) const override { return base_->point(onBase(t)); }
    Vec2 derivative(double t) const override { return -1.0 * base_->derivative(onBase(t)); }
    Vec2 secondDerivative(double t) const override { return base_->secondDerivative(onBase(t)); }
    std::vector<double> breaks() const override;
    double secondDerivativeBound(double a, double b) const override
    {
        return base_->secondDerivativeBound(onBase(b), onBase(a));
    }
    const std::shared_ptr<const Curve>& base() const { return base_; }
    /// The base's parameter of the same point, and the other way round.
    double onBase(double t) const { return base_->first() + (base_->last() - t); }

private:
    std::shared_ptr<const Curve> base_;
};

} // namespace tessera
