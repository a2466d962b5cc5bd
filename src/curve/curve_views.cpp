// SPDX-License-Identifier: MIT
#include "curve/curve_views.h"

#include <algorithm>
#include <utility>

namespace tessera
{

TrimmedCurve::TrimmedCurve(std::shared_ptr<const Curve> base, double first, double last)
    : base_(std::move(base))
    , first_(first)
    , last_(last)
{
    if (const auto* trimmed = dynamic_cast<const TrimmedCurve*>(base_.get())) {
        base_ = std::shared_ptr<const Curve>(trimmed->base_);
    }
}

std::vector<double> TrimmedCurve::breaks() const
{
    std::vector<double> result = base_->breaks();
    std::erase_if(result, [this](double t) { return t <= first_ || t >= last_; });
    return result;
}

ReversedCurve::ReversedCurve(std::shared_ptr<const Curve> base)
    : base_(std::move(base))
{}

std::vector<double> ReversedCurve::breaks() const
{
    std::vector<double> result = base_->breaks();
    for (double& t : result) {
        t = onBase(t);
    }
    std::reverse(result.begin(), result.end());
    return result;
}

} // namespace tessera
