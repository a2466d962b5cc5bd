// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_jet.h"
#include "sample/sample.h"
#include "sizing/size_field.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tessera
{

/// size.size(p); throws Error(InvalidOption) unless it is positive and finite.
double checkedSize(const SizeField& size, Vec2 p);

/// Throws Error(TooLarge) if pieces is more than most.
void requireFewPieces(double pieces, double most);

/// The running integral of ds/h along a stretch of a curve that has no corner, with ds/h raised to
/// what bending asks for. Symmetric: run through backwards it gives the same values.
class SizeIntegral
{
public:
    /// ends: the parameters of the stretch's ends and of the breaks between, ascending.
    SizeIntegral(const Curve& curve, std::span<const double> ends, const SizeField& size,
                 const SampleOptions& options, const Execution& execution);

    double total() const { return total_; }
    /// What total() would be for bending alone: at least so many pieces keep its bounds.
    double byBending() const { return byBending_; }
    /// The integral of the turning of the tangent is so small that the stretch is straight.
    bool straight() const { return straight_; }
    double length() const { return length_; }
    /// The parameter at which the running integral has the given share, 0 .. 1, of the total.
    double parameterAt(double share) const;

private:
    struct Chunk
    {
        double a;
        double b;
        double before; ///< running integral at a
        double within;
        double densityA; ///< d(integral)/dt at the ends
        double densityB;
    };
    struct Sums
    {
        double integral;
        double bending;
        double turning;
        double length;
    };

    double bendingDensity(double speed, double turning) const;
    double densityAt(double t) const;
    Sums integrate(double a, double b) const;
    void addChunks(double a, double b, const Sums& whole, int depth);

    JetEvaluator curve_;
    const SizeField& size_;
    const SampleOptions& options_;
    const Execution& execution_;
    double uniform_;
    double gradient_;
    std::vector<Chunk> chunks_;
    double total_ = 0.0;
    double byBending_ = 0.0;
    double turning_ = 0.0;
    double length_ = 0.0;
    bool straight_ = false;
};

} // namespace tessera
