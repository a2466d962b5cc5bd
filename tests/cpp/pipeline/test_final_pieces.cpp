// SPDX-License-Identifier: MIT
// The pieces of curves in finished meshes: refinement leaves those that sampling made, so that they
// fit the size field and each other.
#include "pipeline.h"
#include "sample/random_networks.h"
#include "sample/sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace tessera
{
namespace
{

using namespace test;

struct Named
{
    std::string name;
    CurveNetwork network;
};

struct Source
{
    std::string name;
    LocalSizes sizes;
};

CurveNetwork square()
{
    CurveNetwork network;
    network.operands.resize(1);
    const std::vector<Vec2> corners {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    addPolyline(network, corners, true, OperandId(0U), Role::Boundary);
    return network;
}

CurveNetwork circles(std::initializer_list<std::pair<Vec2, double>> of)
{
    CurveNetwork network;
    for (const auto& [center, radius] : of) {
        addCircle(network, center, radius);
    }
    return network;
}

std::vector<Named> openShapes()
{
    std::vector<Named> shapes {{"square", square()},
                               {"circle", circles({{{5, 5}, 5}})},
                               {"circles, crossing at 49 degrees",
                                circles({{{4, 5}, 4}, {{7, 5.5}, 3}})}};
    CurveNetwork ellipse;
    addCurve(ellipse, makeEllipseArc({5, 5}, 5, 2, 0.3, 0.0, 2 * std::numbers::pi), true);
    shapes.push_back({"ellipse", std::move(ellipse)});
    return shapes;
}

/// Lines that cross, with ends nearer to the outline than the size.
CurveNetwork narrow()
{
    CurveNetwork network = square();
    addLine(network, {1, 2}, {9, 7});
    addLine(network, {2, 8}, {8, 1});
    return network;
}

std::vector<Source> sources()
{
    std::vector<Source> all(6);
    all[0].name = "at a corner";
    all[0].sizes.points = {{{0, 0}, {0.05}}};
    all[1].name = "beside an edge";
    all[1].sizes.points = {{{5, 0.3}, {0.05}}};
    all[2].name = "at three points";
    all[2].sizes.points = {{{9, 5}, {0.1, 0.5}}, {{1, 6}, {0.05}}, {{5, 10}, {0.04}}};
    all[3].name = "at a segment";
    all[3].sizes.areas.push_back({"segment", [](Vec2 p) {
        const double s = std::clamp((p.x - 2.0) / 4.0, 0.0, 1.0);
        return 0.05 + 0.9 * std::hypot(p.x - 2.0 - 4.0 * s, p.y - 3.0 - s);
    }});
    all[4].name = "expression";
    all[4].sizes.areas.push_back(
        {"band", [](Vec2 p) { return 0.1 + 0.2 * std::abs(p.y - 5.0 - 2.0 * std::sin(p.x)); }});
    all[5].name = "none";
    return all;
}

/// Of the edges on curves that are not whole curves.
struct Fit
{
    std::size_t pieces = 0;
    std::size_t unfit = 0; ///< outside of 0.7 .. 1.4
    double least = 10.0; ///< integral of ds/h
    double most = 0.0;
    double shortest = 10.0; ///< length / the smaller size at its ends
    double ratio = 0.0;     ///< of neighbors

    void add(const Fit& other)
    {
        pieces += other.pieces;
        unfit += other.unfit;
        least = std::min(least, other.least);
        most = std::max(most, other.most);
        shortest = std::min(shortest, other.shortest);
        ratio = std::max(ratio, other.ratio);
    }
    void print(const char* name, double growth) const
    {
        std::printf("growth %.1f, %-28s %5zu pieces, ds/h %.2f .. %.2f, %4.1f %% not within 0.7 .. 1.4,"
                    " shortest %.2f h, ratio %.2f of %.2f\n",
                    growth, name, pieces, least, most,
                    100.0 * static_cast<double>(unfit) / static_cast<double>(pieces), shortest,
                    ratio, 1.0 + 2.0 * growth);
    }
};

double integralOfPieces(const SizeField& size, Vec2 a, Vec2 b)
{
    constexpr int kPlaces = 16;
    double sum = 0.0;
    for (int i = 0; i < kPlaces; ++i) {
        sum += distance(a, b) / kPlaces / size.size(a + ((i + 0.5) / kPlaces) * (b - a));
    }
    return sum;
}

Fit fitOf(const Mesh& mesh, const SizeField& size)
{
    const auto isEnd = [&](std::uint32_t node) {
        return mesh.nodeOrigin[node] == VertexOrigin::Input
            || mesh.nodeOrigin[node] == VertexOrigin::Crossing;
    };
    Fit fit;
    std::vector<std::vector<double>> lengthsAt(mesh.nodes.size());
    for (const auto& edge : mesh.edges) {
        const Vec2 a = mesh.nodes[edge[0]];
        const Vec2 b = mesh.nodes[edge[1]];
        const double length = distance(a, b);
        lengthsAt[edge[0]].push_back(length);
        lengthsAt[edge[1]].push_back(length);
        const double pieces = integralOfPieces(size, a, b);
        if (isEnd(edge[0]) && isEnd(edge[1]) && pieces < 1.4) {
            continue;
        }
        ++fit.pieces;
        fit.unfit += pieces < 0.699 || pieces > 1.401 ? 1 : 0;
        fit.least = std::min(fit.least, pieces);
        fit.most = std::max(fit.most, pieces);
        fit.shortest = std::min(fit.shortest, length / std::min(size.size(a), size.size(b)));
    }
    for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
        const std::vector<double>& lengths = lengthsAt[node];
        if (!isEnd(node) && lengths.size() == 2) {
            fit.ratio = std::max(fit.ratio, std::max(lengths[0] / lengths[1],
                                                     lengths[1] / lengths[0]));
        }
    }
    return fit;
}

Fit meshedFit(const CurveNetwork& network, const LocalSizes& sizes, double growth)
{
    MeshOptions options;
    options.size = 2.0;
    options.growth = growth;
    options.sizes = sizes;
    Execution execution;
    const MeshResult result = meshNetwork(network, options, execution);
    EXPECT_TRUE(result.report.unreached.empty());
    EXPECT_GE(result.report.quality.minAngle, 30.0);
    const SizeOptions sizeOptions {.size = options.size, .growth = growth, .local = sizes};
    const auto field = makeSizeField(arranged(network), sizeOptions, execution);
    return fitOf(result.mesh, *field);
}

TEST(FinalPieces, FitTheSizesAndEachOther)
{
    for (const double growth : {0.1, 0.2, 0.3, 0.4, 0.5}) {
        for (const Named& shape : openShapes()) {
            Fit all;
            for (const Source& source : sources()) {
                SCOPED_TRACE(shape.name + ", " + source.name);
                const Fit fit = meshedFit(shape.network, source.sizes, growth);
                // Neighbors of a piece that is cut for the arms at a corner below 60 degrees.
                const bool isAcute = shape.network.curves.size() == 2;
                EXPECT_LE(fit.unfit, isAcute ? 8U : 0U);
                EXPECT_LE(fit.most, 1.4);
                EXPECT_GE(fit.shortest, 0.3);
                EXPECT_LE(fit.ratio, isAcute ? 2.5 : 1.0 + 2.0 * growth);
                all.add(fit);
            }
            all.print(shape.name.c_str(), growth);
        }
    }
}

TEST(FinalPieces, AreHalvedInNarrowPlacesOnly)
{
    for (const double growth : {0.3, 0.4, 0.5}) {
        Fit all;
        for (const Source& source : sources()) {
            SCOPED_TRACE(source.name);
            all.add(meshedFit(narrow(), source.sizes, growth));
        }
        all.print("lines that end beside edges", growth);
        EXPECT_LE(static_cast<double>(all.unfit), 0.1 * static_cast<double>(all.pieces));
        EXPECT_LE(all.most, 1.4);
        EXPECT_GE(all.shortest, 0.3);
        EXPECT_LE(all.ratio, 2.5);
    }
}

} // namespace
} // namespace tessera
