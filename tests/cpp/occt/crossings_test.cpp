// SPDX-License-Identifier: MIT
// Where curves cross, against OpenCASCADE's own intersections of plane curves; where the two
// disagree, a subdivision that knows of neither decides.
#include "arranged_edges.h"
#include "fine_subdivision.h"

#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI.hxx>
#include <gp_Pln.hxx>
#include <gp_Pnt2d.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

using namespace tessera;
using namespace tessera::test;

namespace
{

constexpr double kSize = 10.0;

std::vector<Vec2> crossingsByOcct(const Handle(Geom_Curve)& a, const Handle(Geom_Curve)& b)
{
    const gp_Pln plane;
    const Geom2dAPI_InterCurveCurve found(GeomAPI::To2d(a, plane), GeomAPI::To2d(b, plane), 1e-10);
    std::vector<Vec2> result;
    for (int i = 1; i <= found.NbPoints(); ++i) {
        result.push_back({found.Point(i).X(), found.Point(i).Y()});
    }
    return result;
}

/// Each point of one list has one of the other within the tolerance, and the other way round.
bool agree(const std::vector<Vec2>& p, const std::vector<Vec2>& q, double tolerance)
{
    const auto covered = [tolerance](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
        return std::all_of(a.begin(), a.end(), [&](Vec2 x) {
            return std::any_of(b.begin(), b.end(),
                               [&](Vec2 y) { return distance(x, y) <= tolerance; });
        });
    };
    return covered(p, q) && covered(q, p);
}

std::string text(const std::vector<Vec2>& points)
{
    std::string result;
    char buffer[80];
    for (const Vec2 p : points) {
        std::snprintf(buffer, sizeof buffer, " (%.15g, %.15g)", p.x, p.y);
        result += buffer;
    }
    return result;
}

} // namespace

TEST(Crossings, SixtyRandomPairsOfEveryTwoKindsAgreeWithOpenCascade)
{
    constexpr int kRounds = 60;
    std::size_t points = 0;
    int pairs = 0;
    int settled = 0;
    double residual = 0.0;
    unsigned seed = 1;
    for (const EdgeKind kindA : kEdgeKinds) {
        for (const EdgeKind kindB : kEdgeKinds) {
            if (kindB < kindA) {
                continue;
            }
            int disagreed = 0;
            for (int round = 0; round < kRounds; ++round, ++seed) {
                RandomEdges random(seed, kSize);
                const Handle(Geom_Curve) a = random.make(kindA);
                const Handle(Geom_Curve) b = random.make(kindB);
                const Crossed crossed = arranged({a, b}, 0.0);
                const std::vector<Vec2> ours = meetings(crossed);
                const std::vector<Vec2> theirs = crossingsByOcct(a, b);
                points += ours.size();
                ++pairs;
                residual = std::max(residual, greatestResidual(crossed));
                if (!agree(ours, theirs, 1e-9 * kSize)) {
                    ++disagreed;
                    const std::vector<Vec2> fine = crossingsByFineSubdivision(a, b, kSize);
                    EXPECT_TRUE(agree(ours, fine, 1e-9 * kSize))
                        << nameOf(kindA) << " and " << nameOf(kindB) << ", seed " << seed
                        << "\nours" << text(ours) << "\nOpenCASCADE" << text(theirs)
                        << "\nsubdivision" << text(fine);
                }
            }
            settled += disagreed;
            if (disagreed > 0) {
                std::printf("%s and %s: %d of %d pairs settled by subdivision\n", nameOf(kindA),
                            nameOf(kindB), disagreed, kRounds);
            }
        }
    }
    std::printf("%d pairs, %zu crossings, %d pairs settled against OpenCASCADE, greatest residual"
                " %.3g\n", pairs, points, settled, residual);
    EXPECT_LE(residual, 1e-12 * 2 * kSize);
    EXPECT_GT(points, 2000U);
}

TEST(Crossings, TwoHundredCurvesOfAllKindsThroughOnePoint)
{
    RandomEdges random(77, kSize, gp_Pnt(-5, -5, 0));
    std::vector<Handle(Geom_Curve)> curves;
    for (int i = 0; i < 200; ++i) {
        const Handle(Geom_Curve) curve = random.make(kEdgeKinds[i % 8]);
        const double share = random.between(0.1, 0.9);
        const gp_Pnt p = curve->Value((1.0 - share) * curve->FirstParameter()
                                      + share * curve->LastParameter());
        curve->Translate(gp_Vec(p, gp_Pnt(1, 2, 0)));
        curves.push_back(curve);
    }
    for (const double weld : {0.0, 2e-6}) {
        const Crossed crossed = arranged(curves, weld);
        std::set<std::uint32_t> common;
        std::set<std::uint32_t> edges;
        for (std::size_t c = 0; c < crossed.network.curves.size(); ++c) {
            const NetworkCurve& piece = crossed.network.curves[c];
            for (const PointId p : {piece.start, piece.end}) {
                if (distance(crossed.network.points[p.index()], {1, 2}) < 1e-8) {
                    common.insert(p.value);
                    edges.insert(crossed.edgeOf[c]);
                }
            }
        }
        EXPECT_EQ(common.size(), 1U) << weld;
        EXPECT_EQ(edges.size(), curves.size());
        if (weld == 0.0) {
            EXPECT_LE(greatestResidual(crossed), 1e-12 * 3 * kSize);
        }
    }
}

TEST(Crossings, NetworksMovedFarAwayOrTurnedCrossAlike)
{
    for (unsigned seed = 0; seed < 4; ++seed) {
        RandomEdges random(500 + seed, kSize);
        std::vector<Handle(Geom_Curve)> curves;
        for (int i = 0; i < 40; ++i) {
            curves.push_back(random.make(kEdgeKinds[i % 8]));
        }
        const Crossed here = arranged(curves, 0.0);
        for (const double shift : {0.0, 1e3, 1e5}) {
            gp_Trsf turn;
            turn.SetRotation(gp::OZ(), 0.3 + seed);
            gp_Trsf move;
            move.SetTranslation(gp_Vec(shift, -0.7 * shift, 0));
            std::vector<Handle(Geom_Curve)> moved;
            for (const Handle(Geom_Curve)& curve : curves) {
                moved.push_back(Handle(Geom_Curve)::DownCast(curve->Transformed(move * turn)));
            }
            const Crossed there = arranged(moved, 0.0);
            EXPECT_EQ(there.network.points.size(), here.network.points.size()) << shift;
            EXPECT_EQ(there.network.curves.size(), here.network.curves.size()) << shift;
            EXPECT_LE(greatestResidual(there), 1e-12 * (2 * kSize + shift));
        }
    }
}

TEST(Crossings, SplinesThatCrossThemselves)
{
    std::size_t crossings = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        RandomEdges random(900 + seed, kSize);
        const EdgeKind kind = kEdgeKinds[5 + seed % 3];
        const Handle(Geom_Curve) curve = random.make(kind);
        const Crossed crossed = arranged({curve}, 0.0);
        const std::vector<Vec2> fine = selfCrossingsByFineSubdivision(curve, kSize);
        const std::vector<Vec2> ours(crossed.network.points.begin()
                                         + static_cast<std::ptrdiff_t>(crossed.report.firstCrossing),
                                     crossed.network.points.end());
        EXPECT_TRUE(agree(ours, fine, 1e-9 * kSize))
            << nameOf(kind) << " seed " << seed << "\nours" << text(ours) << "\nsubdivision"
            << text(fine);
        EXPECT_LE(greatestResidual(crossed), 1e-12 * kSize);
        crossings += ours.size();
    }
    std::printf("60 splines cross themselves %zu times\n", crossings);
    EXPECT_GT(crossings, 30U);
}
