// SPDX-License-Identifier: MIT
#include "arrange/arrange.h"
#include "curve/arc.h"
#include "curve/curve_tools.h"
#include "curve/line.h"
#include "curve/polyline.h"
#include "sample/sample.h"
#include "sizing/uniform_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <optional>
#include <random>
#include <set>

namespace tessera
{
namespace
{

constexpr double kPi = std::numbers::pi;

/// Cubic with the given control points over [0, 1].
class Bezier final: public Curve
{
public:
    Bezier(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
        : p_ {a, b, c, d}
    {}
    double first() const override { return 0.0; }
    double last() const override { return 1.0; }
    Vec2 point(double t) const override
    {
        const double s = 1.0 - t;
        return s * s * s * p_[0] + 3.0 * s * s * t * p_[1] + 3.0 * s * t * t * p_[2]
            + t * t * t * p_[3];
    }
    Vec2 derivative(double t) const override
    {
        const double s = 1.0 - t;
        return 3.0 * s * s * (p_[1] - p_[0]) + 6.0 * s * t * (p_[2] - p_[1])
            + 3.0 * t * t * (p_[3] - p_[2]);
    }
    Vec2 secondDerivative(double t) const override
    {
        return 6.0 * (1.0 - t) * (p_[2] - 2.0 * p_[1] + p_[0])
            + 6.0 * t * (p_[3] - 2.0 * p_[2] + p_[1]);
    }

private:
    Vec2 p_[4];
};

struct Arranged
{
    CurveNetwork before;
    CurveNetwork network;
    ArrangeReport report;
};

void addCurve(CurveNetwork& network, std::shared_ptr<const Curve> geometry, bool closed = false)
{
    network.operands.resize(1);
    const PointId start = network.addPoint(geometry->point(geometry->first()));
    const PointId end = closed ? start : network.addPoint(geometry->point(geometry->last()));
    network.curves.push_back(
        {std::move(geometry), start, end, OperandId(0U), Role::Constraint});
}

void addLine(CurveNetwork& network, Vec2 a, Vec2 b)
{
    network.operands.resize(1);
    const PointId start = network.addPoint(a);
    const PointId end = network.addPoint(b);
    network.curves.push_back({nullptr, start, end, OperandId(0U), Role::Constraint});
}

std::shared_ptr<const Curve> circle(Vec2 center, double radius, double seam = 0.0)
{
    return makeCircleArc(center, radius, seam, seam + 2 * kPi);
}

/// Distance from p to a curve of the network, by brute force and refinement.
double distanceToCurve(const CurveNetwork& network, std::size_t index, Vec2 p)
{
    const NetworkCurve& curve = network.curves[index];
    if (!curve.geometry) {
        const Vec2 a = network.points[curve.start.index()];
        const Vec2 b = network.points[curve.end.index()];
        const double s = std::clamp(dot(p - a, b - a) / squaredLength(b - a), 0.0, 1.0);
        return distance(p, a + s * (b - a));
    }
    const Curve& g = *curve.geometry;
    double best = g.first();
    const double step = (g.last() - g.first()) / 2000;
    for (int i = 0; i <= 2000; ++i) {
        const double t = std::min(g.last(), g.first() + i * step);
        best = distance(g.point(t), p) < distance(g.point(best), p) ? t : best;
    }
    double width = step;
    for (int i = 0; i < 60; ++i, width *= 0.6) {
        for (const double t : {best - width, best + width}) {
            if (t >= g.first() && t <= g.last()
                && distance(g.point(t), p) < distance(g.point(best), p)) {
                best = t;
            }
        }
    }
    return distance(g.point(best), p);
}

Arranged arranged(CurveNetwork network, double weld = 0.0)
{
    Arranged result;
    result.before = std::move(network);
    Execution execution;
    result.network = arrange(result.before, {.weld = weld}, result.report, execution);
    return result;
}

/// Invariants of every arrangement: pieces follow their parents and end where they say; points that
/// were made lie on all parents that end there.
void expectConsistent(const Arranged& a, double tolerance)
{
    ASSERT_EQ(a.report.parent.size(), a.network.curves.size());
    std::vector<double> lengths(a.before.curves.size(), 0.0);
    for (std::size_t c = 0; c < a.network.curves.size(); ++c) {
        const NetworkCurve& piece = a.network.curves[c];
        const std::size_t parent = a.report.parent[c].index();
        lengths[parent] += curveLength(a.network, piece);
        for (const PointId end : {piece.start, piece.end}) {
            EXPECT_LE(distanceToCurve(a.before, parent, a.network.points[end.index()]), tolerance);
        }
        if (piece.geometry) {
            const Curve& g = *piece.geometry;
            EXPECT_LE(distance(g.point(g.first()), a.network.points[piece.start.index()]),
                      tolerance);
            EXPECT_LE(distance(g.point(g.last()), a.network.points[piece.end.index()]), tolerance);
        }
    }
    for (std::size_t c = 0; c < lengths.size(); ++c) {
        const double whole = curveLength(a.before, a.before.curves[c]);
        EXPECT_NEAR(lengths[c], whole, 1e-9 * whole + 4 * tolerance);
    }
}

std::vector<Vec2> made(const Arranged& a)
{
    return {a.network.points.begin() + static_cast<std::ptrdiff_t>(a.report.firstCrossing),
            a.network.points.end()};
}

TEST(CrossCurves, TwoCirclesInTwoPoints)
{
    CurveNetwork network;
    addCurve(network, circle({0, 0}, 2), true);
    addCurve(network, circle({2, 0}, 2, 1.0), true);
    const Arranged a = arranged(network);
    const std::vector<Vec2> points = made(a);
    ASSERT_EQ(points.size(), 2U);
    for (const Vec2 p : points) {
        EXPECT_NEAR(p.x, 1.0, 1e-14);
        EXPECT_NEAR(std::abs(p.y), std::sqrt(3.0), 1e-14);
    }
    EXPECT_EQ(a.report.crossed.crossings, 2U);
    EXPECT_EQ(a.network.curves.size(), 6U);
    expectConsistent(a, 1e-14);
}

TEST(CrossCurves, ALineThatEntersACircleByLessThanASagitta)
{
    CurveNetwork network;
    addCurve(network, circle({0, 0}, 1), true);
    addLine(network, {-2, 1 - 1e-6}, {2, 1 - 1e-6});
    const Arranged a = arranged(network);
    ASSERT_EQ(made(a).size(), 2U);
    for (const Vec2 p : made(a)) {
        EXPECT_NEAR(length(p), 1.0, 1e-15);
        EXPECT_NEAR(std::abs(p.x), std::sqrt(1 - (1 - 1e-6) * (1 - 1e-6)), 1e-12);
    }
    expectConsistent(a, 1e-12);
}

/// All kinds of curves that have a top at (0, 0) with a horizontal tangent, curving down by c / 2
/// x^2 (to second order), within |x| < 1.
std::vector<std::shared_ptr<const Curve>> curvesWithTop(double c, double turn)
{
    const double r = 1.0 / c;
    return {
        makeCircleArc({0, -r}, r, kPi / 2 + 0.8, kPi / 2 - 0.7 + turn),
        makeEllipseArc({0, -r / 4}, r / 2, r / 4, 0.0, kPi / 2 + 0.9, kPi / 2 - 0.8 + turn),
        std::make_shared<Bezier>(Vec2 {-0.9, -0.405 * c}, Vec2 {-0.3, 0.135 * c},
                                 Vec2 {0.3, 0.135 * c}, Vec2 {0.9, -0.405 * c}),
    };
}

/// A curve moved upwards.
class Raised final: public Curve
{
public:
    Raised(std::shared_ptr<const Curve> base, double height, bool mirrored)
        : base_(std::move(base))
        , height_(height)
        , sign_(mirrored ? -1.0 : 1.0)
    {}
    double first() const override { return base_->first(); }
    double last() const override { return base_->last(); }
    Vec2 point(double t) const override
    {
        const Vec2 p = base_->point(t);
        return {p.x, sign_ * p.y + height_};
    }
    Vec2 derivative(double t) const override
    {
        const Vec2 d = base_->derivative(t);
        return {d.x, sign_ * d.y};
    }
    Vec2 secondDerivative(double t) const override
    {
        const Vec2 d = base_->secondDerivative(t);
        return {d.x, sign_ * d.y};
    }
    double secondDerivativeBound(double a, double b) const override
    {
        return base_->secondDerivativeBound(a, b);
    }

private:
    std::shared_ptr<const Curve> base_;
    double height_;
    double sign_;
};

TEST(CrossCurves, LensesOfAllDepthsHaveTwoCrossingsForEveryPairOfKinds)
{
    const auto below = curvesWithTop(0.5, 0.0);
    const auto above = curvesWithTop(0.3, 0.05);
    for (const auto& lower : below) {
        for (std::size_t kind = 0; kind <= above.size(); ++kind) {
            for (int exponent = 2; exponent <= 9; ++exponent) {
                const double depth = std::pow(10.0, -exponent);
                CurveNetwork network;
                addCurve(network, std::make_shared<Raised>(lower, depth, false));
                if (kind == above.size()) {
                    addLine(network, {-3, 0}, {3, 0});
                }
                else {
                    addCurve(network, std::make_shared<Raised>(above[kind], 0.0, true));
                }
                const Arranged a = arranged(network, 1e-12);
                EXPECT_EQ(made(a).size(), 2U) << "depth 1e-" << exponent << " kind " << kind;
                expectConsistent(a, 3e-12);
            }
        }
    }
}

TEST(CrossCurves, TangenciesFromInsideAndOutsideAreOnePoint)
{
    const auto below = curvesWithTop(0.5, 0.0);
    const auto above = curvesWithTop(0.3, 0.05);
    for (const auto& lower : below) {
        for (std::size_t kind = 0; kind <= above.size(); ++kind) {
            for (const bool inside : {false, true}) {
                CurveNetwork network;
                addCurve(network, lower);
                if (kind == above.size()) {
                    addLine(network, {-3, 0}, {3, 0});
                }
                else {
                    addCurve(network, std::make_shared<Raised>(above[kind], 0.0, !inside));
                }
                const Arranged a = arranged(network);
                ASSERT_EQ(made(a).size(), 1U) << "kind " << kind << " inside " << inside;
                EXPECT_LE(length(made(a)[0]), 2e-6);
                expectConsistent(a, 1e-11);
            }
        }
    }
}

TEST(CrossCurves, GapsAreNoContacts)
{
    for (const auto& lower : curvesWithTop(0.5, 0.0)) {
        for (const double gap : {1e-2, 1e-5, 1e-8, 1e-10}) {
            CurveNetwork network;
            addCurve(network, std::make_shared<Raised>(lower, -gap, false));
            addLine(network, {-3, 0}, {3, 0});
            EXPECT_TRUE(made(arranged(network)).empty()) << gap;
        }
    }
}

TEST(CrossCurves, ConcentricCirclesInAThinGapDoNotMeet)
{
    CurveNetwork network;
    for (int i = 0; i < 5; ++i) {
        addCurve(network, circle({1, 2}, 1.0 + 1e-7 * i, 0.3 * i), true);
    }
    const Arranged a = arranged(network);
    EXPECT_TRUE(made(a).empty());
    EXPECT_EQ(a.network.curves.size(), 5U);
}

TEST(CrossCurves, RandomArcsAgreeWithTheFormulaForCircles)
{
    std::mt19937 random(31);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int round = 0; round < 300; ++round) {
        CurveNetwork network;
        Vec2 centers[2];
        double radii[2];
        for (int i = 0; i < 2; ++i) {
            centers[i] = {2 * uniform(random), 2 * uniform(random)};
            radii[i] = 0.3 + uniform(random);
            addCurve(network, makeCircleArc(centers[i], radii[i], 7 * uniform(random),
                                            7 * uniform(random)));
        }
        // Intersections of the circles that lie on both arcs.
        const Vec2 between = centers[1] - centers[0];
        const double d = length(between);
        const double along = (d * d + radii[0] * radii[0] - radii[1] * radii[1]) / (2 * d);
        const double square = radii[0] * radii[0] - along * along;
        std::vector<Vec2> expected;
        if (square > 1e-6) {
            const Vec2 unit = (1 / d) * between;
            for (const double side : {-1.0, 1.0}) {
                const Vec2 p = centers[0] + along * unit
                    + side * std::sqrt(square) * Vec2 {-unit.y, unit.x};
                if (distanceToCurve(network, 0, p) < 1e-9
                    && distanceToCurve(network, 1, p) < 1e-9) {
                    expected.push_back(p);
                }
            }
        }
        const Arranged a = arranged(network);
        const std::vector<Vec2> found = made(a);
        EXPECT_EQ(found.size(), expected.size());
        for (const Vec2 p : expected) {
            const bool there = std::any_of(found.begin(), found.end(), [p](Vec2 q) {
                return distance(p, q) < 1e-11;
            });
            EXPECT_TRUE(there);
        }
        expectConsistent(a, 1e-12);
    }
}

/// Crossings of two fine polylines; none of them close to another or to an end, else nothing.
std::optional<std::vector<Vec2>> fineCrossings(const Curve& a, const Curve& b, bool same)
{
    constexpr int kPieces = 600;
    const auto points = [](const Curve& c) {
        std::vector<Vec2> result;
        for (int i = 0; i <= kPieces; ++i) {
            result.push_back(c.point(c.first() + (c.last() - c.first()) * i / kPieces));
        }
        return result;
    };
    const std::vector<Vec2> p = points(a);
    const std::vector<Vec2> q = points(b);
    std::vector<Vec2> found;
    for (int i = 0; i < kPieces; ++i) {
        Box2 box;
        box.add(p[i]);
        box.add(p[i + 1]);
        for (int j = same ? i + 2 : 0; j < kPieces; ++j) {
            Box2 other;
            other.add(q[j]);
            other.add(q[j + 1]);
            if (!box.overlaps(other)) {
                continue;
            }
            const Vec2 u = p[i + 1] - p[i];
            const Vec2 v = q[j + 1] - q[j];
            const double determinant = cross(u, v);
            const double s = cross(q[j] - p[i], v) / determinant;
            const double t = cross(q[j] - p[i], u) / determinant;
            if (s >= 0 && s < 1 && t >= 0 && t < 1) {
                if (std::abs(determinant) < 0.02 * length(u) * length(v)) {
                    return std::nullopt;
                }
                found.push_back(p[i] + s * u);
            }
        }
    }
    return found;
}

TEST(CrossCurves, RandomPairsOfAllKindsAgreeWithFinePolylines)
{
    std::mt19937 random(32);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const auto somewhere = [&] { return Vec2 {3 * uniform(random), 3 * uniform(random)}; };
    const auto make = [&](int kind) -> std::shared_ptr<const Curve> {
        const Vec2 p = somewhere();
        const Vec2 q = somewhere();
        const double from = 7 * uniform(random);
        switch (kind) {
            case 0:
                return std::make_shared<LineCurve>(p, q);
            case 1:
                return makeCircleArc(p, 0.3 + uniform(random), from, from + 6 * uniform(random));
            case 2:
                return makeEllipseArc(p, 0.3 + uniform(random), 0.2 + uniform(random), from, from,
                                      from - 6 * uniform(random) - 0.1);
            default:
                return std::make_shared<Bezier>(p, q, somewhere(), somewhere());
        }
    };
    int compared = 0;
    for (int round = 0; round < 200; ++round) {
        const auto a = make(round % 4);
        const auto b = make(1 + round / 4 % 3);
        const auto between = fineCrossings(*a, *b, false);
        const auto selfA = fineCrossings(*a, *a, true);
        const auto selfB = fineCrossings(*b, *b, true);
        if (!between || !selfA || !selfB) {
            continue;
        }
        ++compared;
        CurveNetwork network;
        addCurve(network, a);
        addCurve(network, b);
        const Arranged result = arranged(network);
        const std::vector<Vec2> found = made(result);
        std::vector<Vec2> expected = *between;
        expected.insert(expected.end(), selfA->begin(), selfA->end());
        expected.insert(expected.end(), selfB->begin(), selfB->end());
        EXPECT_EQ(found.size(), expected.size()) << round;
        for (const Vec2 p : expected) {
            EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                                    [p](Vec2 q) { return distance(p, q) < 1e-4; }));
        }
        expectConsistent(result, 3e-12);
    }
    EXPECT_GT(compared, 100);
}

TEST(CrossCurves, ALoopCrossesItself)
{
    CurveNetwork network;
    addCurve(network,
             std::make_shared<Bezier>(Vec2 {0, 0}, Vec2 {4, 3}, Vec2 {-3, 3}, Vec2 {1, 0}));
    const Arranged a = arranged(network);
    ASSERT_EQ(made(a).size(), 1U);
    EXPECT_NEAR(made(a)[0].x, 0.5, 1e-12);
    EXPECT_EQ(a.network.curves.size(), 3U);
    EXPECT_EQ(a.network.curves[1].start, a.network.curves[1].end);
    expectConsistent(a, 1e-14);
}

TEST(CrossCurves, AHundredCurvesThroughOnePoint)
{
    CurveNetwork network;
    for (int i = 0; i < 100; ++i) {
        const double angle = 2 * kPi * i / 100 + 0.001;
        const double r = 1.0 + 0.001 * i;
        const Vec2 center = r * Vec2 {std::cos(angle), std::sin(angle)};
        addCurve(network, makeCircleArc(center, r, angle + kPi - 0.4, angle + kPi + 0.4));
    }
    const Arranged a = arranged(network);
    // Every arc is cut at the common point; it is one point.
    std::size_t common = 0;
    for (const Vec2 p : made(a)) {
        common += length(p) < 1e-6 ? 1 : 0;
    }
    EXPECT_EQ(common, 1U);
    expectConsistent(a, 1e-10);
}

TEST(CrossCurves, TangentArcsThatShareAnEndGetNoOtherPoint)
{
    // A slot: two sides and two half circles, as a sketcher draws it, ends slightly off.
    for (const double miss : {0.0, 1e-15, 1e-9, 1e-8}) {
        CurveNetwork network;
        addLine(network, {0, 1}, {4, 1 + miss});
        addCurve(network, makeCircleArc({4, 0}, 1, kPi / 2, -kPi / 2));
        addLine(network, {4, -1 - miss}, {0, -1});
        addCurve(network, makeCircleArc({0, 0}, 1, -kPi / 2, -3 * kPi / 2));
        const Arranged a = arranged(network, 1e-7);
        EXPECT_TRUE(made(a).empty()) << miss;
        EXPECT_EQ(a.network.curves.size(), 4U);
        EXPECT_EQ(a.network.points.size(), 4U);
    }
}

TEST(CrossCurves, EndsOnCurvesBecomePointsOfThem)
{
    for (const double miss : {0.0, 1e-9, -1e-9}) {
        CurveNetwork network;
        addCurve(network, circle({0, 0}, 1), true);
        addLine(network, {0, 1 - miss}, {0, 3});
        addLine(network, {-3, 0}, {-1 - miss, 0});
        addLine(network, {-2, miss}, {-2, -2});
        const Arranged a = arranged(network, 1e-7);
        EXPECT_TRUE(made(a).empty());
        EXPECT_EQ(a.network.curves.size(), 7U);
        EXPECT_EQ(a.report.crossed.touches, 3U);
        expectConsistent(a, 1.1e-9);
    }
    // Without a tolerance the last of them ends beside its line.
    CurveNetwork network;
    addLine(network, {-3, 0}, {3, 0});
    addLine(network, {-2, 1e-9}, {-2, 2});
    EXPECT_EQ(arranged(network).network.curves.size(), 2U);
    EXPECT_EQ(arranged(network, 1e-7).network.curves.size(), 3U);
}

/// Sampled pieces of both curves along their overlap are the same.
std::size_t sharedPieces(const CurveNetwork& network)
{
    Execution execution;
    const Pslg pslg = sample(network, UniformSize(0.05), {}, execution);
    std::multiset<std::pair<std::pair<double, double>, std::pair<double, double>>> pieces;
    std::size_t shared = 0;
    for (const PslgSegment& s : pslg.segments) {
        const Vec2 a = pslg.points[s.a.index()];
        const Vec2 b = pslg.points[s.b.index()];
        const std::pair p(a.x, a.y);
        const std::pair q(b.x, b.y);
        const auto key = std::pair(std::min(p, q), std::max(p, q));
        shared += pieces.count(key) > 0 ? 1 : 0;
        pieces.insert(key);
    }
    return shared;
}

TEST(CrossCurves, OverlappingArcsShareTheirPieces)
{
    for (const bool opposed : {false, true}) {
        CurveNetwork network;
        addCurve(network, makeCircleArc({1, 1}, 2, 0.0, 2.0));
        addCurve(network, opposed ? makeCircleArc({1, 1}, 2, 3.0, 1.0)
                                  : makeCircleArc({1, 1}, 2, 1.0, 3.0));
        const Arranged a = arranged(network);
        EXPECT_TRUE(made(a).empty());
        EXPECT_EQ(a.network.curves.size(), 4U);
        EXPECT_EQ(sharedPieces(a.network), 40U);
        expectConsistent(a, 1e-12);
    }
}

TEST(CrossCurves, TheSameCircleTwiceWithDifferentSeams)
{
    for (const bool opposed : {false, true}) {
        CurveNetwork network;
        addCurve(network, circle({0, 0}, 1, 0.2), true);
        addCurve(network, opposed ? makeCircleArc({0, 0}, 1, 1.4, 1.4 - 2 * kPi)
                                  : circle({0, 0}, 1, 1.4),
                 true);
        addLine(network, {-2, 0.1}, {2, 0.1});
        const Arranged a = arranged(network);
        EXPECT_EQ(made(a).size(), 2U);
        EXPECT_EQ(a.network.curves.size(), 4U + 4U + 3U);
        const std::size_t around = sharedPieces(a.network);
        EXPECT_GT(around, 120U);
        expectConsistent(a, 1e-12);
        // Directions are kept: the area under the pieces of each circle has its sign.
        double areas[2] = {0.0, 0.0};
        for (std::size_t c = 0; c < a.network.curves.size(); ++c) {
            const auto& g = a.network.curves[c].geometry;
            for (int i = 0; g && i < 100; ++i) {
                const double t0 = g->first() + (g->last() - g->first()) * i / 100;
                const double t1 = g->first() + (g->last() - g->first()) * (i + 1) / 100;
                areas[a.report.parent[c].index()] += 0.5 * cross(g->point(t0), g->point(t1));
            }
        }
        EXPECT_NEAR(areas[0], kPi, 1e-2);
        EXPECT_NEAR(areas[1], opposed ? -kPi : kPi, 1e-2);
    }
}

TEST(CrossCurves, ACurveOnItselfAndAStraightSplineOnALine)
{
    CurveNetwork network;
    const auto curve =
        std::make_shared<Bezier>(Vec2 {0, 0}, Vec2 {1, 2}, Vec2 {2, -1}, Vec2 {3, 1});
    addCurve(network, curve);
    addCurve(network, curve);
    addLine(network, {0, 5}, {3, 5});
    addCurve(network,
             std::make_shared<Bezier>(Vec2 {1, 5}, Vec2 {2, 5}, Vec2 {3, 5}, Vec2 {4, 5}));
    const Arranged a = arranged(network);
    EXPECT_EQ(a.network.curves.size(), 6U);
    EXPECT_EQ(a.network.curves[0].geometry, a.network.curves[1].geometry);
    EXPECT_EQ(a.network.curves[3].geometry, nullptr);
    EXPECT_EQ(a.network.curves[4].geometry, nullptr);
}

TEST(CrossCurves, APolylineThatRunsBackAndForthOnItself)
{
    CurveNetwork network;
    addCurve(network, std::make_shared<PolylineCurve>(
                          std::vector<Vec2> {{15, 15}, {11, 11}, {15, 15}, {10, 10}}));
    const Arranged a = arranged(network);
    ASSERT_EQ(a.network.curves.size(), 4U);
    for (const NetworkCurve& piece : a.network.curves) {
        ASSERT_NE(piece.geometry, nullptr);
        const Curve& geometry = *piece.geometry;
        EXPECT_LT(distance(geometry.point(geometry.first()), a.network.points[piece.start.index()]),
                  1e-9);
        EXPECT_LT(distance(geometry.point(geometry.last()), a.network.points[piece.end.index()]),
                  1e-9);
    }
}

TEST(CrossCurves, PointsOfTheInputStayWhereTheyAre)
{
    CurveNetwork network;
    addCurve(network, circle({0, 0}, 1), true);
    addCurve(network, circle({1, 0}, 1), true);
    network.embedded.push_back(
        {network.addPoint({0.5, std::sqrt(0.75)}), OperandId(0U), "pin"});
    const Arranged a = arranged(network, 1e-9);
    EXPECT_EQ(made(a).size(), 1U);
    EXPECT_EQ(a.network.points[a.network.embedded[0].point.index()],
              (Vec2 {0.5, std::sqrt(0.75)}));
    std::size_t ends = 0;
    for (const NetworkCurve& piece : a.network.curves) {
        ends += piece.start == a.network.embedded[0].point ? 1 : 0;
    }
    EXPECT_EQ(ends, 2U);
}

TEST(CrossCurves, TwoThousandCircles)
{
    std::mt19937 random(33);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    CurveNetwork network;
    std::vector<Vec2> centers;
    std::vector<double> radii;
    for (int i = 0; i < 2000; ++i) {
        centers.push_back({uniform(random), uniform(random)});
        radii.push_back(0.03 + 0.05 * uniform(random));
        addCurve(network, circle(centers.back(), radii.back()), true);
    }
    std::size_t expected = 0;
    for (std::size_t i = 0; i < centers.size(); ++i) {
        for (std::size_t j = i + 1; j < centers.size(); ++j) {
            const double d = distance(centers[i], centers[j]);
            expected += d < radii[i] + radii[j] && d > std::abs(radii[i] - radii[j]) ? 2 : 0;
        }
    }
    const auto begin = std::clock();
    const Arranged a = arranged(network);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    std::printf("2,000 circles, %zu crossings: %.3f s\n", made(a).size(), seconds);
    EXPECT_EQ(made(a).size(), expected);
    EXPECT_EQ(a.network.curves.size(), 2000 + 2 * expected);
    EXPECT_LT(seconds, 20.0);
}

} // namespace
} // namespace tessera
