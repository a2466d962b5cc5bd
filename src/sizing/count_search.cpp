// SPDX-License-Identifier: MIT
#include "sizing/count_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tessera
{

namespace
{
constexpr double kGoodEnough = 0.02;
constexpr double kReached = 0.05;
constexpr double kFarthest = 2.0; ///< a step of the logarithm
constexpr double kNoStep = 1e-6;
} // namespace

CountSearch::CountSearch(double target, double width, double height, double leastSize)
    : target_(target)
    , smallest_(std::log(leastSize))
    , largest_(std::log(std::hypot(width, height)))
    , least_(std::numeric_limits<double>::infinity())
{
    const double equilateral = 4.0 / std::numbers::sqrt3 / target;
    next_ = bounded(0.5 * (std::log(width) + std::log(height) + std::log(equilateral)));
}

double CountSearch::next() const
{
    return std::exp(next_);
}

bool CountSearch::isReached(double triangles) const
{
    return std::fabs(triangles / target_ - 1.0) <= kReached;
}

bool CountSearch::take(double triangles)
{
    if (!(triangles > 0.0)) {
        lastIsBest_ = !tooMany_ && !tooFew_;
        return false;
    }
    const Outcome outcome {next_, std::log(triangles / target_)};
    lastIsBest_ = std::fabs(outcome.excess) < least_;
    least_ = std::min(least_, std::fabs(outcome.excess));
    if (least_ <= kGoodEnough) {
        return false;
    }
    (outcome.excess > 0.0 ? tooMany_ : tooFew_) = outcome;
    if (tooMany_ && tooFew_) {
        const double share = tooMany_->excess / (tooMany_->excess - tooFew_->excess);
        const double apart = tooFew_->size - tooMany_->size;
        next_ = tooMany_->size + std::clamp(share, 0.05, 0.95) * apart;
        return std::fabs(apart) > kNoStep;
    }
    // A little farther than the square law says, so that the next one lies on the other side.
    const double step = 0.5 * outcome.excess + std::copysign(0.5 * kGoodEnough, outcome.excess);
    next_ = bounded(outcome.size + std::clamp(step, -kFarthest, kFarthest));
    return next_ != outcome.size;
}

} // namespace tessera
