// SPDX-License-Identifier: MIT
#include "sizing/curve_sources.h"

#include "curve/curve_tools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tessera
{

namespace
{

/// Below this part of the size, a piece is a reason to grade the field around it. Sampling makes
/// pieces of 0.7 of the size or more wherever it has the choice.
constexpr double kClearlyShorter = 0.7;
constexpr int kMaxDepth = 10;

class SourceCollector
{
public:
    SourceCollector(const CurveNetwork& network, const SizeField& base,
                    const CurveSourceOptions& options)
        : network_(network)
        , base_(base)
        , options_(options)
    {}

    std::vector<SizeSource> run()
    {
        for (const NetworkCurve& curve : network_.curves) {
            if (curve.role == Role::Ignored) {
                continue;
            }
            if (curve.geometry) {
                addCurved(*curve.geometry, curve.start == curve.end);
            }
            else {
                const Vec2 a = network_.points[curve.start.index()];
                const Vec2 b = network_.points[curve.end.index()];
                addIfShorter(a, b, distance(a, b));
            }
        }
        return std::move(sources_);
    }

private:
    void addIfShorter(Vec2 a, Vec2 b, double size)
    {
        const double wanted = base_.size(midpoint(a, b));
        const double least = options_.minSize > 0.0 ? options_.minSize : 1e-3 * wanted;
        if (size > 0.0 && size < kClearlyShorter * wanted) {
            sources_.push_back({a, b, std::max(size, std::min(least, wanted))});
        }
    }

    void addCurved(const Curve& curve, bool closed)
    {
        // A closed curve has three pieces or more, whatever the size.
        const double longest = arcLength(curve) / (closed ? 3.0 : 1.0);
        const std::vector<double> ends = smoothIntervals(curve);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            for (int k = 0; k < 4; ++k) {
                const double step = 0.25 * (ends[i + 1] - ends[i]);
                const double last = k == 3 ? ends[i + 1] : ends[i] + (k + 1) * step;
                addStretch(curve, ends[i] + k * step, last, longest, kMaxDepth);
            }
        }
    }

    /// The size that bending asks for at t; infinite on a straight stretch.
    double sizeByBending(const Curve& curve, double t) const
    {
        const double speed = length(curve.derivative(t));
        const double curvature = speed > 0.0 ? turningRate(curve, t) / speed : 0.0;
        if (!(curvature > 0.0)) {
            return std::numeric_limits<double>::infinity();
        }
        const double byTurn = 2.0 * std::numbers::pi / (options_.piecesPerTurn * curvature);
        const double byChord = options_.chordError > 0.0
            ? std::sqrt(8.0 * options_.chordError / curvature)
            : byTurn;
        return std::min(byTurn, byChord);
    }

    /// Halves the stretch until its chord stands for it and the size hardly changes along it.
    void addStretch(const Curve& curve, double a, double b, double longest, int depth)
    {
        const Vec2 p = curve.point(a);
        const Vec2 q = curve.point(b);
        const double t = 0.5 * (a + b);
        const double sizes[3] = {sizeByBending(curve, a), sizeByBending(curve, t),
                                 sizeByBending(curve, b)};
        const double least = std::min(longest, std::min({sizes[0], sizes[1], sizes[2]}));
        const double greatest = std::min(longest, std::max({sizes[0], sizes[1], sizes[2]}));
        if (least >= kClearlyShorter * base_.size(curve.point(t)) && depth < kMaxDepth - 2) {
            return;
        }
        const bool even = greatest <= 1.5 * least && sagittaBound(curve, a, b) <= 0.25 * least;
        if (even || depth == 0) {
            addIfShorter(p, q, least);
            return;
        }
        addStretch(curve, a, t, longest, depth - 1);
        addStretch(curve, t, b, longest, depth - 1);
    }

    const CurveNetwork& network_;
    const SizeField& base_;
    const CurveSourceOptions& options_;
    std::vector<SizeSource> sources_;
};

constexpr int kMostHalvings = 20;

void addChords(const Curve& curve, double a, double b, SizeSource law, int depth,
               std::vector<SizeSource>& sources)
{
    if (depth > 0 && sagittaBound(curve, a, b) > 0.1 * law.size) {
        const double t = 0.5 * (a + b);
        addChords(curve, a, t, law, depth - 1, sources);
        addChords(curve, t, b, law, depth - 1, sources);
        return;
    }
    law.a = curve.point(a);
    law.b = curve.point(b);
    sources.push_back(law);
}

} // namespace

void addSourcesAlong(const CurveNetwork& network, const NetworkCurve& curve, SizeSource law,
                     std::vector<SizeSource>& sources)
{
    if (!curve.geometry) {
        law.a = network.points[curve.start.index()];
        law.b = network.points[curve.end.index()];
        sources.push_back(law);
        return;
    }
    const std::vector<double> ends = smoothIntervals(*curve.geometry);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        addChords(*curve.geometry, ends[i], ends[i + 1], law, kMostHalvings, sources);
    }
}

std::vector<SizeSource> curveSources(const CurveNetwork& network, const SizeField& base,
                                     const CurveSourceOptions& options)
{
    return SourceCollector(network, base, options).run();
}

} // namespace tessera
