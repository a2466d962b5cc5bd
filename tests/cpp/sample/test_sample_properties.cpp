// SPDX-License-Identifier: MIT
// What every sampled network keeps, over random networks and those of other projects.
#include "curve/curve_tools.h"
#include "curve/curve_views.h"
#include "curve/line.h"
#include "property/corpora.h"
#include "sample/random_networks.h"
#include "sample/sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

namespace tessera
{
namespace
{

using namespace test;

/// A sample of numbers, printed as its percentiles.
class Distribution
{
public:
    explicit Distribution(const char* name)
        : name_(name)
    {}
    ~Distribution() { print(); }
    Distribution(const Distribution&) = delete;
    Distribution& operator=(const Distribution&) = delete;
    void add(double value) { values_.push_back(value); }

private:
    void print()
    {
        if (values_.empty()) {
            return;
        }
        std::sort(values_.begin(), values_.end());
        std::printf("%-34s %8zu:", name_, values_.size());
        for (const double share : {0.0, 0.01, 0.05, 0.5, 0.95, 0.99, 1.0}) {
            const auto last = static_cast<double>(values_.size() - 1);
            std::printf(" %7.4f", values_[static_cast<std::size_t>(share * last)]);
        }
        std::printf("   (0, 1, 5, 50, 95, 99, 100 %%)\n");
    }

    const char* name_;
    std::vector<double> values_;
};

std::unique_ptr<const Curve> geometryOf(const CurveNetwork& network, const NetworkCurve& curve)
{
    const Vec2 a = network.points[curve.start.index()];
    const Vec2 b = network.points[curve.end.index()];
    if (curve.geometry) {
        return std::make_unique<TrimmedCurve>(curve.geometry, curve.geometry->first(),
                                              curve.geometry->last());
    }
    return std::make_unique<LineCurve>(a, b);
}

/// Sums over small steps: the length, and ds/h.
struct Integrals
{
    double length = 0.0;
    double pieces = 0.0;
};
Integrals integrate(const Curve& curve, const SizeField& size, double a, double b)
{
    constexpr int kSteps = 64;
    Integrals sums;
    for (int i = 0; i < kSteps; ++i) {
        const double t = a + (b - a) * (i + 0.5) / kSteps;
        const double ds = length(curve.derivative(t)) * (b - a) / kSteps;
        sums.length += ds;
        sums.pieces += ds / size.size(curve.point(t));
    }
    return sums;
}

double sagittaOf(const Curve& curve, double a, double b)
{
    const Vec2 p = curve.point(a);
    const Vec2 chord = curve.point(b) - p;
    double greatest = 0.0;
    for (int i = 1; i < 32; ++i) {
        const Vec2 offset = curve.point(a + (b - a) * i / 32) - p;
        greatest = std::max(greatest, std::abs(cross(chord, offset)) / length(chord));
    }
    return greatest;
}

/// Segments of each curve, in order along it.
std::map<std::uint32_t, std::vector<PslgSegment>> byCurve(const Pslg& pslg)
{
    std::map<std::uint32_t, std::vector<PslgSegment>> result;
    for (const PslgSegment& segment : pslg.segments) {
        result[segment.curve.value].push_back(segment);
    }
    return result;
}

struct Distributions
{
    Distribution shares {"integral of ds/h per piece"};
    Distribution lengths {"piece / size at its middle"};
    Distribution neighbors {"ratio of neighbors - 1, over growth"};
};

/// Checks all pieces of one network.
class PieceCheck
{
public:
    PieceCheck(const CurveNetwork& network, const SizeField& size, double growth,
               const SampleOptions& options, Distributions& found)
        : network_(network)
        , size_(size)
        , growth_(growth)
        , options_(options)
        , found_(found)
    {}

    void run()
    {
        Execution execution;
        SampleOptions options = options_;
        options.growth = growth_;
        const Pslg pslg = sample(network_, size_, options, execution);
        collectMiddles(pslg);
        for (const auto& [c, pieces] : byCurve(pslg)) {
            checkCurve(pslg, network_.curves[c], pieces);
        }
        EXPECT_LT(byTopology_, 5U + all_ / 25U);
    }

private:
    void checkCurve(const Pslg& pslg, const NetworkCurve& curve,
                    const std::vector<PslgSegment>& pieces)
    {
        const auto geometry = geometryOf(network_, curve);
        const bool straight = curve.geometry == nullptr;
        double before = 0.0;
        double usualStep = 0.0;
        for (const PslgSegment& s : pieces) {
            const double a = straight ? at(pslg, s.a, curve) : s.ta;
            const double b = straight ? at(pslg, s.b, curve) : s.tb;
            const Integrals sums = integrate(*geometry, size_, a, b);
            const double h = size_.size(geometry->point(0.5 * (a + b)));
            found_.shares.add(sums.pieces);
            found_.lengths.add(sums.length / h);
            EXPECT_LE(sums.pieces, 1.41);
            // Less than 0.7 in whole curves, where there are least numbers, where a curve bends, and
            // around the few places where pieces would be in the way of others.
            const double ofTurn =
                turn(*geometry, a, b) / (2 * std::numbers::pi) * options_.piecesPerTurn;
            const bool byChord = options_.chordError > 0.0
                && sagittaOf(*geometry, a, b) > 0.3 * options_.chordError;
            const Vec2 middle = geometry->point(0.5 * (a + b));
            const bool byTopology = isBesideAnother(curve, middle, 2.0 * h);
            if (pieces.size() > 3 && !byChord && !byTopology) {
                EXPECT_GE(sums.pieces + ofTurn, 0.69) << pieces.size();
            }
            if (pieces.size() > 3 && !byChord && !byTopology) {
                EXPECT_GE(sums.length, 0.3 * h);
            }
            byTopology_ += byTopology && sums.pieces < 0.69 ? 1U : 0U;
            ++all_;
            if (options_.chordError > 0.0) {
                EXPECT_LE(sagittaOf(*geometry, a, b), 1.1 * options_.chordError);
            }
            if (before > 0.0) {
                const double ratio = std::max(before / sums.length, sums.length / before);
                found_.neighbors.add((ratio - 1.0) / growth_);
                EXPECT_LE(ratio, 1.0 + 2.0 * growth_) << pieces.size() << " pieces";
            }
            before = sums.length;
            usualStep = b - a;
        }
        EXPECT_GT(usualStep, 0.0);
    }

    void collectMiddles(const Pslg& pslg)
    {
        for (const PslgSegment& s : pslg.segments) {
            middles_.push_back({midpoint(pslg.points[s.a.index()], pslg.points[s.b.index()]),
                                s.curve.value});
        }
    }

    /// Whether a piece of another curve is near: there topology may have asked for finer pieces.
    bool isBesideAnother(const NetworkCurve& curve, Vec2 p, double reach) const
    {
        const auto c = static_cast<std::uint32_t>(&curve - network_.curves.data());
        return std::any_of(middles_.begin(), middles_.end(), [&](const auto& middle) {
            return middle.second != c && squaredLength(middle.first - p) < reach * reach;
        });
    }

    double at(const Pslg& pslg, PointId p, const NetworkCurve& curve) const
    {
        const Vec2 a = network_.points[curve.start.index()];
        const Vec2 along = network_.points[curve.end.index()] - a;
        return dot(pslg.points[p.index()] - a, along) / squaredLength(along);
    }

    static double turn(const Curve& curve, double a, double b)
    {
        double sum = 0.0;
        for (int i = 0; i < 32; ++i) {
            sum += turningRate(curve, a + (b - a) * (i + 0.5) / 32) * (b - a) / 32;
        }
        return sum;
    }

    const CurveNetwork& network_;
    const SizeField& size_;
    double growth_;
    const SampleOptions& options_;
    Distributions& found_;
    std::vector<std::pair<Vec2, std::uint32_t>> middles_;
    std::size_t byTopology_ = 0;
    std::size_t all_ = 0;
};

TEST(SampleProperties, PiecesOfRandomNetworks)
{
    std::mt19937 random(11);
    for (const double growth : {0.1, 0.3, 0.5}) {
        std::printf("growth %.1f\n", growth);
        Distributions found;
        for (int round = 0; round < 12; ++round) {
            const CurveNetwork network = arranged(randomCurves(random, 12));
            const auto field = randomField(random, network, 0.8, growth);
            PieceCheck(network, *field, growth, {}, found).run();
        }
    }
}

TEST(SampleProperties, ChordErrorOverRandomNetworks)
{
    std::mt19937 random(12);
    Distributions found;
    for (int round = 0; round < 10; ++round) {
        const CurveNetwork network = arranged(randomCurves(random, 10));
        Execution execution;
        const double error = 1e-3 * std::pow(10.0, round % 3);
        const auto field = makeSizeField(
            network, {.size = 0.8, .growth = 0.5, .local = {.chordError = error}}, execution);
        PieceCheck(network, *field, 0.5, {.chordError = error}, found).run();
    }
}

TEST(SampleProperties, ReversedNetworksGetTheSamePoints)
{
    std::mt19937 random(13);
    for (int round = 0; round < 15; ++round) {
        const CurveNetwork network = arranged(randomCurves(random, 10));
        const auto field = randomField(random, network, 0.8, 0.3);
        CurveNetwork reversed = network;
        for (NetworkCurve& curve : reversed.curves) {
            std::swap(curve.start, curve.end);
            if (curve.geometry) {
                curve.geometry = std::make_shared<ReversedCurve>(curve.geometry);
            }
        }
        Execution execution;
        std::vector<Vec2> there = sample(network, *field, {}, execution).points;
        std::vector<Vec2> back = sample(reversed, *field, {}, execution).points;
        const auto less = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
        std::sort(there.begin(), there.end(), less);
        std::sort(back.begin(), back.end(), less);
        EXPECT_EQ(there, back);
    }
}

TEST(SampleProperties, EqualCurvesAreEquallySampled)
{
    std::mt19937 random(14);
    const CurveNetwork network = arranged(randomCurves(random, 10));
    const auto field = randomField(random, network, 0.5, 0.3);
    CurveNetwork twice = network;
    for (const NetworkCurve& curve : network.curves) {
        twice.curves.push_back(curve); // the same geometry, as where operands overlap
    }
    Execution execution;
    const Pslg pslg = sample(twice, *field, {}, execution);
    const auto pieces = byCurve(pslg);
    for (std::uint32_t c = 0; c < network.curves.size(); ++c) {
        const auto& one = pieces.at(c);
        const auto& other = pieces.at(c + static_cast<std::uint32_t>(network.curves.size()));
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            EXPECT_EQ(pslg.points[one[i].a.index()], pslg.points[other[i].a.index()]);
            EXPECT_EQ(pslg.points[one[i].b.index()], pslg.points[other[i].b.index()]);
        }
    }
}

TEST(SampleProperties, PiecesOfOtherProjectsNetworks)
{
    TESSERA_NEEDS_CORPORA();
    const auto files = corpusPslgs();
    Distributions found;
    std::size_t used = 0;
    for (const CorpusPslg& file : files) {
        if (!file.wellConditioned || file.segments > 3000) {
            continue;
        }
        const RawPslg raw = readCorpusPslg(file.name);
        CurveNetwork network;
        network.operands.resize(1);
        network.points = raw.points;
        for (const auto& [a, b] : raw.segments) {
            network.curves.push_back({nullptr, PointId(a), PointId(b), OperandId(0U)});
        }
        const CurveNetwork pieces = arranged(network);
        const double size = defaultSize(pieces);
        if (!(size > 0.0)) {
            continue; // points only
        }
        std::mt19937 random(15);
        const auto field = randomField(random, pieces, size, 0.3);
        PieceCheck(pieces, *field, 0.3, {}, found).run();
        ++used;
    }
    std::printf("%zu networks\n", used);
    EXPECT_GT(used, 3U);
}

} // namespace
} // namespace tessera
