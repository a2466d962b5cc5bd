// SPDX-License-Identifier: MIT
//
// The interval is halved until Gauss–Legendre sums of the whole and of the halves agree, and until
// the size field, which is no steeper than its gradient bound, cannot hide a fine spot between two
// sums. Within a chunk the running integral is the monotone cubic through its ends' values and
// slopes, so that inverting it evaluates nothing.
#include "sample/size_integral.h"

#include "base/error.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace tessera
{

namespace
{

constexpr int kMaxDepth = 48;
/// Disagreement of the sums at which halving stops, in pieces.
constexpr double kTolerance = 1e-6;
/// Turning of the tangent, in radians, below which a stretch is straight.
constexpr double kStraight = 1e-9;

/// |d(angle)/dt| of the tangent.
double turningRate(const CurveJet& jet, double speed)
{
    return speed > 0.0
        ? std::abs(cross((1.0 / speed) * jet.derivative, jet.secondDerivative)) / speed
        : 0.0;
}

} // namespace

double checkedSize(const SizeField& size, Vec2 p)
{
    const double h = size.size(p);
    if (!(h > 0.0) || !std::isfinite(h)) {
        throw Error(ErrorKind::InvalidOption,
                    "The size at " + placeText(p) + " is " + numberText(h)
                        + "; it must be a number above 0.",
                    {{p}});
    }
    return h;
}

void requireFewPieces(double pieces, double most)
{
    if (!(pieces <= most)) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "The curves would be cut into more than %.2g pieces, too many for the memory; "
                      "choose a larger size.",
                      std::min(pieces, 1e300));
        throw Error(ErrorKind::TooLarge, text);
    }
}

SizeIntegral::SizeIntegral(const Curve& curve, std::span<const double> ends,
                           const SizeField& size, const SampleOptions& options,
                           const Execution& execution)
    : curve_(curve)
    , size_(size)
    , options_(options)
    , execution_(execution)
    , uniform_(size.uniformSize())
    , gradient_(size.gradientBound())
{
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        addChunks(ends[i], ends[i + 1], integrate(ends[i], ends[i + 1]), 0);
    }
    straight_ = turning_ <= kStraight;
}

double SizeIntegral::bendingDensity(double speed, double turning) const
{
    const double byTurn = turning * options_.piecesPerTurn / (2.0 * std::numbers::pi);
    return options_.chordError > 0.0
        ? std::max(byTurn, std::sqrt(speed * turning / (8.0 * options_.chordError)))
        : byTurn;
}

double SizeIntegral::densityAt(double t) const
{
    const CurveJet jet = curve_(t);
    const double h = uniform_ > 0.0 ? uniform_ : checkedSize(size_, jet.point);
    const double speed = tessera::length(jet.derivative);
    return std::max(speed / h, bendingDensity(speed, turningRate(jet, speed)));
}

SizeIntegral::Sums SizeIntegral::integrate(double a, double b) const
{
    Sums sums {};
    // One pass gives all four sums: the integrand of the quadrature collects the others.
    constexpr double kNode[3] = {0.0, 0.53846931010568309, 0.90617984593866399};
    constexpr double kWeight[3] = {0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
    const double middle = 0.5 * (a + b);
    const double half = 0.5 * (b - a);
    for (int i = -2; i <= 2; ++i) {
        const int k = std::abs(i);
        const double t = middle + (i < 0 ? -half : half) * kNode[k];
        const double weight = half * kWeight[k];
        const CurveJet jet = curve_(t);
        const double h = uniform_ > 0.0 ? uniform_ : checkedSize(size_, jet.point);
        const double speed = tessera::length(jet.derivative);
        const double turning = turningRate(jet, speed);
        const double bending = bendingDensity(speed, turning);
        sums.integral += weight * std::max(speed / h, bending);
        sums.bending += weight * bending;
        sums.turning += weight * turning;
        sums.length += weight * speed;
    }
    return sums;
}

void SizeIntegral::addChunks(double a, double b, const Sums& whole, int depth)
{
    const double middle = 0.5 * (a + b);
    const Sums left = integrate(a, middle);
    const Sums right = integrate(middle, b);
    const double sum = left.integral + right.integral;
    const bool agree = std::abs(sum - whole.integral) <= kTolerance * (1.0 + sum)
        && std::abs(left.turning + right.turning - whole.turning)
            <= kTolerance * (1.0 + whole.turning);
    bool resolved = uniform_ > 0.0;
    if (!resolved && agree) {
        const double h = std::min({checkedSize(size_, curve_(a).point),
                                   checkedSize(size_, curve_(middle).point),
                                   checkedSize(size_, curve_(b).point)});
        resolved = gradient_ * (left.length + right.length) <= h;
    }
    if ((agree && resolved) || depth == kMaxDepth) {
        const double atMiddle = densityAt(middle);
        chunks_.push_back({a, middle, total_, left.integral, densityAt(a), atMiddle});
        chunks_.push_back(
            {middle, b, total_ + left.integral, right.integral, atMiddle, densityAt(b)});
        total_ += sum;
        byBending_ += left.bending + right.bending;
        turning_ += left.turning + right.turning;
        length_ += left.length + right.length;
        requireFewPieces(total_, options_.mostPieces);
        if (chunks_.size() % 256 == 0) {
            execution_.checkpoint();
        }
        return;
    }
    addChunks(a, middle, left, depth + 1);
    addChunks(middle, b, right, depth + 1);
}

double SizeIntegral::parameterAt(double share) const
{
    const double target = share * total_;
    auto chunk = std::upper_bound(chunks_.begin(), chunks_.end(), target,
                                  [](double value, const Chunk& c) { return value < c.before; });
    if (chunk != chunks_.begin()) {
        --chunk;
    }
    const double width = chunk->b - chunk->a;
    if (!(chunk->within > 0.0)) {
        return chunk->a;
    }
    // Cubic from 0 to 1 with end slopes of at most 3, which makes it monotone (Fritsch, Carlson).
    const double slopeA = std::min(3.0, chunk->densityA * width / chunk->within);
    const double slopeB = std::min(3.0, chunk->densityB * width / chunk->within);
    const double wanted = std::clamp((target - chunk->before) / chunk->within, 0.0, 1.0);
    double low = 0.0;
    double high = 1.0;
    double s = wanted;
    for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
        const double r = 1.0 - s;
        const double value = s * s * (3.0 - 2.0 * s) + slopeA * s * r * r - slopeB * s * s * r;
        const double slope =
            6.0 * s * r + slopeA * r * (r - 2.0 * s) + slopeB * s * (s - 2.0 * r);
        (value < wanted ? low : high) = s;
        const double next = slope > 0.0 ? s - (value - wanted) / slope : -1.0;
        const double previous = s;
        s = next > low && next < high ? next : 0.5 * (low + high);
        if (std::abs(s - previous) <= 1e-15) {
            break;
        }
    }
    return chunk->a + s * width;
}

} // namespace tessera
