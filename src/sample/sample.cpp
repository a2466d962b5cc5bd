// SPDX-License-Identifier: MIT
#include "sample/sample.h"

#include "base/error.h"
#include "base/number_text.h"
#include "curve/curve_tools.h"
#include "curve/curve_views.h"
#include "curve/line.h"
#include "sample/separate.h"
#include "sample/size_integral.h"
#include "sizing/graded_size.h"
#include "sizing/min_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace tessera
{

namespace
{

/// A tangent that turns by more than this (radians) at a break makes a corner.
constexpr double kCorner = 0.05;

bool isCorner(const Curve& curve, double t)
{
    const double step = 1e-7 * (curve.last() - curve.first());
    const Vec2 before = curve.derivative(t - step);
    const Vec2 after = curve.derivative(t + step);
    return std::abs(std::atan2(cross(before, after), dot(before, after))) > kCorner;
}

/// A piece of less than this share of the integral of ds/h is never cut in two: see pieceCount().
constexpr double kWhole = 1.3;

/// Samplings after the first one, with smaller sizes where curves are close to each other.
constexpr int kMostRounds = 4;

/// Halves that following gaps may take: so many, or so many for each piece; and no more than this
/// part of what the memory holds, as each brings triangles with it.
constexpr double kHalvesForGaps = 100000.0;
constexpr double kHalvesForGapsByPiece = 128.0;
constexpr double kHalvesForGapsOfMost = 0.05;

/// A curve and the direction in which it is sampled: views on a base curve are taken off, so that
/// all curves with the same geometry are cut at the same points.
struct Oriented
{
    const Curve* curve;
    bool reversed;
};

Oriented unwrap(const Curve* curve)
{
    bool reversed = false;
    while (const auto* view = dynamic_cast<const ReversedCurve*>(curve)) {
        curve = view->base().get();
        reversed = !reversed;
    }
    return {curve, reversed};
}

bool lexicographicallyLess(Vec2 a, Vec2 b)
{
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

class Sampler
{
public:
    Sampler(const CurveNetwork& network, const SizeField& size, const SampleOptions& options,
            Execution& execution)
        : network_(network)
        , given_(size)
        , options_(options)
        , execution_(execution)
        , sharesEnds_(findSharedEnds())
    {
        pslg_.points = network.points;
    }

    Pslg run()
    {
        sampleAll();
        for (int round = 0;; ++round) {
            if (!std::isinf(options_.growth)) {
                sampled_.points = pslg_.points;
                sampled_.pieces = pieces_;
            }
            // Pieces by size are up to 1.4 times as long as the halves that they replace.
            const SeparateOptions separateOptions {
                .gapShare = (round == 0 ? 1.0 : 2.0) * options_.gapShare,
                .mostHalvesForGaps = mostHalvesForGaps()};
            const Separation separation =
                separatePieces(pslg_.points, pieces_, separateOptions, execution_);
            // Curves that run on each other unshared come apart at no size.
            if (separation.halves.empty() || !separation.done || std::isinf(options_.growth)
                || round == kMostRounds) {
                tellTooClose(separation, separateOptions.mostHalvesForGaps);
                break;
            }
            sampleAgain(separation.halves);
        }
        exportSegments();
        tellDropped();
        return std::move(pslg_);
    }

private:
    /// The pieces of one round before they are separated.
    struct Sampling
    {
        std::vector<Vec2> points;
        std::vector<CurvePiece> pieces;
        std::vector<std::size_t> firstPiece; ///< by curve, and the end

        std::span<const CurvePiece> piecesOf(std::size_t curve) const
        {
            return std::span(pieces).subspan(firstPiece[curve],
                                             firstPiece[curve + 1] - firstPiece[curve]);
        }
    };

    std::size_t mostHalvesForGaps() const
    {
        const double wanted = std::max(
            kHalvesForGaps, kHalvesForGapsByPiece * static_cast<double>(pieces_.size()));
        return static_cast<std::size_t>(
            std::min(wanted, kHalvesForGapsOfMost * options_.mostPieces));
    }

    const SizeField& field() const { return finer_ ? *finer_ : given_; }

    void sampleAll()
    {
        for (std::size_t c = 0; c < network_.curves.size(); ++c) {
            reportCurve(c, 0.0);
            sampled_.firstPiece.push_back(pieces_.size());
            sampleCurve(CurveId(c));
        }
        sampled_.firstPiece.push_back(pieces_.size());
    }

    /// Samples with the lengths of the halves as sizes besides, growing from there. Curves on which
    /// the sizes stay as they were keep their pieces.
    void sampleAgain(const std::vector<CurvePiece>& halves)
    {
        std::vector<SizeSource> sources;
        sources.reserve(halves.size());
        for (const CurvePiece& half : halves) {
            const Vec2 a = pslg_.points[half.a.index()];
            const Vec2 b = pslg_.points[half.b.index()];
            sources.push_back({a, b, distance(a, b)});
        }
        const double uniform = given_.uniformSize();
        const GradedSize::Options options {
            .maxSize = uniform > 0.0 ? uniform : std::numeric_limits<double>::max(),
            .growth = std::max(options_.growth, given_.gradientBound())};
        const auto lower = std::make_shared<GradedSize>(networkBounds(network_), sources, options,
                                                        execution_);
        const std::shared_ptr<const SizeField> before =
            finer_ ? finer_ : std::shared_ptr<const SizeField>(&given_, [](const SizeField*) {});
        finer_ = std::make_shared<MinSize>(
            std::vector<std::shared_ptr<const SizeField>> {before, lower});
        const Sampling previous = std::move(sampled_);
        sampled_ = {};
        pslg_.points = network_.points;
        pieces_.clear();
        for (std::size_t c = 0; c < network_.curves.size(); ++c) {
            reportCurve(c, 0.5);
            sampled_.firstPiece.push_back(pieces_.size());
            const std::span<const CurvePiece> pieces = previous.piecesOf(c);
            if (isLowered(pieces, previous.points, *before, *lower)) {
                sampleCurve(CurveId(c));
            }
            else {
                keepPieces(pieces, previous.points);
            }
        }
        sampled_.firstPiece.push_back(pieces_.size());
    }

    /// Whether the new field can be below the one before on the curve of these pieces.
    static bool isLowered(std::span<const CurvePiece> pieces, const std::vector<Vec2>& points,
                          const SizeField& before, const SizeField& lower)
    {
        const double growth = before.gradientBound() + lower.gradientBound();
        return std::any_of(pieces.begin(), pieces.end(), [&](const CurvePiece& piece) {
            const Vec2 a = points[piece.a.index()];
            const Vec2 b = points[piece.b.index()];
            const Vec2 middle = midpoint(a, b);
            // All of the piece's curve is nearer to the middle than the chord is long.
            return lower.size(middle) < before.size(middle) + growth * distance(a, b);
        });
    }

    void keepPieces(std::span<const CurvePiece> pieces, const std::vector<Vec2>& points)
    {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            pieces_.push_back(pieces[i]);
            if (i > 0) {
                pieces_.back().a = PointId(pslg_.points.size() - 1);
            }
            if (i + 1 < pieces.size()) {
                pslg_.points.push_back(points[pieces[i].b.index()]);
                pieces_.back().b = PointId(pslg_.points.size() - 1);
            }
        }
    }

    void reportCurve(std::size_t c, double done)
    {
        if (c % 256 == 0) {
            execution_.report(std::max(done, static_cast<double>(c)
                                                 / static_cast<double>(network_.curves.size())));
        }
    }

    void sampleCurve(CurveId id)
    {
        const NetworkCurve& curve = network_.curves[id.index()];
        if (curve.role == Role::Ignored) {
            return;
        }
        if (curve.geometry) {
            sampleCurved(id, curve);
        }
        else {
            sampleStraight(id, curve);
        }
        requireFewPieces(static_cast<double>(pieces_.size()), options_.mostPieces);
    }

    using Ends = std::pair<std::uint32_t, std::uint32_t>;

    static Ends endsOf(const NetworkCurve& curve)
    {
        return std::minmax(curve.start.value, curve.end.value);
    }

    /// By curve: another one that is meshed has the same two ends.
    std::vector<std::uint8_t> findSharedEnds() const
    {
        std::vector<std::pair<Ends, std::size_t>> byEnds;
        for (std::size_t c = 0; c < network_.curves.size(); ++c) {
            if (network_.curves[c].role != Role::Ignored) {
                byEnds.emplace_back(endsOf(network_.curves[c]), c);
            }
        }
        std::sort(byEnds.begin(), byEnds.end());
        std::vector<std::uint8_t> shared(network_.curves.size(), 0);
        for (std::size_t i = 1; i < byEnds.size(); ++i) {
            if (byEnds[i].first == byEnds[i - 1].first) {
                shared[byEnds[i].second] = shared[byEnds[i - 1].second] = 1;
            }
        }
        return shared;
    }

    void sampleStraight(CurveId id, const NetworkCurve& curve)
    {
        const Vec2 a = network_.points[curve.start.index()];
        const Vec2 b = network_.points[curve.end.index()];
        if (a == b) {
            dropped_.push_back(id);
            return;
        }
        const bool reversed = lexicographicallyLess(b, a);
        const LineCurve line = reversed ? LineCurve(b, a) : LineCurve(a, b);
        std::vector<double> parameters;
        if (options_.straightSegments) {
            parameters = straightParameters(line, distance(a, b));
        }
        addPieces(id, nullptr, reversed, parameters, pointsAt(line, parameters));
    }

    static std::vector<Vec2> pointsAt(const Curve& curve, const std::vector<double>& parameters)
    {
        std::vector<Vec2> points;
        points.reserve(parameters.size());
        for (const double t : parameters) {
            points.push_back(curve.point(t));
        }
        return points;
    }

    /// Inner parameters of a line over [0, 1].
    std::vector<double> straightParameters(const LineCurve& line, double length)
    {
        std::vector<double> parameters;
        if (const double uniform = field().uniformSize(); uniform > 0.0) {
            requireFewPieces(length / checkedSize(field(), line.point(0.5)), options_.mostPieces);
            const std::size_t n = pieceCount(length / uniform);
            for (std::size_t k = 1; k < n; ++k) {
                parameters.push_back(static_cast<double>(k) / static_cast<double>(n));
            }
            return parameters;
        }
        // Most short pieces need no integral: nowhere on them the size is so small as to cut them.
        const double least =
            checkedSize(field(), line.point(0.5)) - 0.5 * length * field().gradientBound();
        if (length <= kWhole * least) {
            return parameters;
        }
        const double ends[2] = {0.0, 1.0};
        const SizeIntegral integral(line, ends, field(), options_, execution_);
        const std::size_t n = pieceCount(integral.total());
        for (std::size_t k = 1; k < n; ++k) {
            parameters.push_back(
                integral.parameterAt(static_cast<double>(k) / static_cast<double>(n)));
        }
        return parameters;
    }

    void sampleCurved(CurveId id, const NetworkCurve& curve)
    {
        const auto [geometry, reversed] = unwrap(curve.geometry.get());
        const std::vector<std::vector<double>> stretches = splitAtCorners(*geometry);
        std::vector<SizeIntegral> integrals;
        std::vector<std::size_t> counts;
        double length = 0.0;
        for (const std::vector<double>& ends : stretches) {
            integrals.emplace_back(*geometry, ends, field(), options_, execution_);
            counts.push_back(countFor(integrals.back()));
            length += integrals.back().length();
        }
        if (!(length > 0.0)) {
            dropped_.push_back(id);
            return;
        }
        raise(counts, integrals, id);
        std::vector<double> parameters;
        for (std::size_t i = 0; i < stretches.size(); ++i) {
            if (i > 0) {
                parameters.push_back(stretches[i].front());
            }
            for (std::size_t k = 1; k < counts[i]; ++k) {
                parameters.push_back(integrals[i].parameterAt(static_cast<double>(k)
                                                              / static_cast<double>(counts[i])));
            }
        }
        addPieces(id, geometry, reversed, parameters, pointsAt(*geometry, parameters));
    }

    /// Parameter lists from corner to corner, with the smooth breaks between.
    static std::vector<std::vector<double>> splitAtCorners(const Curve& curve)
    {
        std::vector<std::vector<double>> stretches {{curve.first()}};
        for (const double t : curve.breaks()) {
            stretches.back().push_back(t);
            if (isCorner(curve, t)) {
                stretches.push_back({t});
            }
        }
        stretches.back().push_back(curve.last());
        return stretches;
    }

    std::size_t countFor(const SizeIntegral& integral) const
    {
        if (integral.straight()) {
            return options_.straightSegments ? pieceCount(integral.total()) : 1;
        }
        const double byBending = std::ceil(integral.byBending() * (1.0 - 1e-6));
        return std::max(pieceCount(integral.total()), static_cast<std::size_t>(byBending));
    }

    /// A closed curve needs 3 pieces to enclose anything, one that shares both ends 2 to differ.
    void raise(std::vector<std::size_t>& counts, const std::vector<SizeIntegral>& integrals,
               CurveId id) const
    {
        const NetworkCurve& curve = network_.curves[id.index()];
        const bool bent = counts.size() > 1
            || std::any_of(integrals.begin(), integrals.end(),
                           [](const SizeIntegral& i) { return !i.straight(); });
        std::size_t least = 1;
        if (bent && curve.start == curve.end) {
            least = 3;
        }
        else if (bent && sharesEnds_[id.index()] != 0) {
            least = 2;
        }
        std::size_t sum = 0;
        for (const std::size_t count : counts) {
            sum += count;
        }
        for (; sum < least; ++sum) {
            std::size_t longest = 0;
            for (std::size_t i = 1; i < counts.size(); ++i) {
                const double share = integrals[i].length() / static_cast<double>(counts[i]);
                const double best =
                    integrals[longest].length() / static_cast<double>(counts[longest]);
                longest = share > best ? i : longest;
            }
            ++counts[longest];
        }
    }

    /// parameters: the inner ones, ascending on geometry. Null geometry: straight over [0, 1].
    void addPieces(CurveId id, const Curve* geometry, bool reversed,
                   const std::vector<double>& parameters, const std::vector<Vec2>& inner)
    {
        const NetworkCurve& curve = network_.curves[id.index()];
        const double first = geometry != nullptr ? geometry->first() : 0.0;
        const double last = geometry != nullptr ? geometry->last() : 1.0;
        const double begin = reversed ? last : first;
        CurvePiece piece {curve.start, curve.start, id, geometry, begin, begin};
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            const std::size_t i = reversed ? parameters.size() - 1 - k : k;
            pslg_.points.push_back(inner[i]);
            piece.b = PointId(pslg_.points.size() - 1);
            piece.tb = parameters[i];
            pieces_.push_back(piece);
            piece.a = piece.b;
            piece.ta = piece.tb;
        }
        piece.b = curve.end;
        piece.tb = reversed ? first : last;
        pieces_.push_back(piece);
    }

    /// Pieces run along their curve's base; segments along the curve itself.
    void exportSegments()
    {
        pslg_.segments.reserve(pieces_.size());
        for (const CurvePiece& piece : pieces_) {
            double ta = piece.ta;
            double tb = piece.tb;
            if (ta > tb) {
                const double first = piece.geometry != nullptr ? piece.geometry->first() : 0.0;
                const double last = piece.geometry != nullptr ? piece.geometry->last() : 1.0;
                ta = first + (last - ta);
                tb = first + (last - tb);
            }
            pslg_.segments.push_back({piece.a, piece.b, piece.curve, ta, tb});
        }
    }

    void tellTooClose(const Separation& separation, std::size_t mostHalvesForGaps)
    {
        pslg_.coarseGaps = separation.coarseGaps;
        if (!separation.done) {
            pslg_.messages.push_back(
                "Near " + placeText(separation.unseparated)
                + " curves run so close to each other that their pieces cross although the curves"
                  " do not; choose a smaller size there, or let the curves coincide.");
        }
        if (!pslg_.coarseGaps.empty()) {
            pslg_.messages.push_back(
                "The gap between curves near " + placeText(pslg_.coarseGaps.front().place)
                + " is too narrow for the pieces beside it, and following it would take more than "
                + std::to_string(mostHalvesForGaps)
                + " pieces, so areas and widths there are not the true ones; choose a smaller size"
                  " or chord error there.");
        }
    }

    void tellDropped()
    {
        if (dropped_.empty()) {
            return;
        }
        const NetworkCurve& curve = network_.curves[dropped_.front().index()];
        const std::string place = placeText(network_.points[curve.start.index()]);
        pslg_.messages.push_back(
            dropped_.size() == 1
                ? "A curve of zero length at " + place + " was left out."
                : std::to_string(dropped_.size()) + " curves of zero length were left out, the"
                    " first at " + place + ".");
    }

    const CurveNetwork& network_;
    const SizeField& given_;
    Sampling sampled_;
    std::shared_ptr<const SizeField> finer_; ///< after the first round
    const SampleOptions& options_;
    Execution& execution_;
    std::vector<std::uint8_t> sharesEnds_;
    std::vector<CurveId> dropped_;
    std::vector<CurvePiece> pieces_;
    Pslg pslg_;
};

} // namespace

std::size_t pieceCount(double x)
{
    const double below = std::max(1.0, std::floor(x));
    const double limit = std::min(1.4 * below, std::sqrt(below * (below + 1.0)));
    return static_cast<std::size_t>(x <= limit ? below : below + 1.0);
}

Pslg sample(const CurveNetwork& network, const SizeField& size, const SampleOptions& options,
            Execution& execution)
{
    if (!(options.piecesPerTurn >= 3.0 && options.piecesPerTurn <= 10000.0)) {
        throw Error(ErrorKind::InvalidOption,
                    "The pieces for a full turn must be between 3 and 10000.");
    }
    if (!(options.growth > 0.0)) {
        throw Error(ErrorKind::InvalidOption, "The growth rate must be above 0.");
    }
    if (!(options.mostPieces > 0.0)) {
        throw Error(ErrorKind::InvalidOption, "The greatest number of pieces must be above 0.");
    }
    if (!(options.chordError >= 0.0) || !std::isfinite(options.chordError)) {
        throw Error(ErrorKind::InvalidOption,
                    "The chord error must be a number above 0 (or 0 for none).");
    }
    return Sampler(network, size, options, execution).run();
}

} // namespace tessera
