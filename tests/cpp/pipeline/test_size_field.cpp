// SPDX-License-Identifier: MIT
// The size field as finished meshes meet it.
#include "base/error.h"
#include "pipeline.h"
#include "sample/random_networks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tessera
{
namespace
{

using namespace test;

CurveNetwork framed(CurveNetwork network)
{
    network.operands.resize(1);
    const std::vector<Vec2> corners {{-1, -1}, {11, -1}, {11, 11}, {-1, 11}};
    addPolyline(network, corners, true, OperandId(0U), Role::Boundary);
    return network;
}

/// |h(p) - h(q)| / |p - q| over growth.
class Slopes
{
public:
    Slopes(const SizeField& size, double growth)
        : size_(size)
        , growth_(growth)
    {}
    void add(Vec2 p, Vec2 q)
    {
        if (p != q) {
            values_.push_back(std::abs(size_.size(p) - size_.size(q)) / distance(p, q) / growth_);
        }
    }
    void expectBelowOne(const char* name)
    {
        std::sort(values_.begin(), values_.end());
        std::printf("%-28s %8zu pairs, slope / growth:", name, values_.size());
        for (const double share : {0.0, 0.05, 0.5, 0.95, 0.99, 1.0}) {
            const auto last = static_cast<double>(values_.size() - 1);
            std::printf(" %.3f", values_[static_cast<std::size_t>(share * last)]);
        }
        std::printf("   (0, 5, 50, 95, 99, 100 %%)\n");
        EXPECT_LE(values_.back(), 1.0) << name;
    }

private:
    const SizeField& size_;
    double growth_;
    std::vector<double> values_;
};

TEST(SizeFieldOfMeshes, IsLipschitzOverPairsOfVertices)
{
    std::mt19937 random(31);
    for (const double growth : {0.1, 0.3, 0.5}) {
        const CurveNetwork network = framed(randomCurves(random, 6));
        MeshOptions options;
        options.size = 1.0;
        options.growth = growth;
        options.fill = FillRule::All;
        options.sizes.points = {{{2, 3}, {0.05}}, {{8, 8}, {0.1, 1.0}}};
        options.sizes.areas.push_back(
            {"step", [](Vec2 p) { return p.x + 0.4 * p.y > 9.0 ? 0.15 : 2.0; }});
        options.sizes.curves = {{{CurveId(0U)}, {0.2}}};
        Execution execution;
        const MeshResult result = meshNetwork(network, options, execution);
        // The same field once more.
        ArrangeReport report;
        const CurveNetwork pieces =
            arrange(network, {.crossStraight = true}, report, execution);
        SizeOptions sizeOptions {.size = options.size, .growth = growth, .local = options.sizes};
        sizeOptions.local.curves[0].curves.clear();
        for (std::size_t c = 0; c < report.parent.size(); ++c) {
            if (report.parent[c] == CurveId(0U)) {
                sizeOptions.local.curves[0].curves.emplace_back(c);
            }
        }
        const auto field = makeSizeField(pieces, sizeOptions, execution);
        const Mesh& mesh = result.mesh;
        Slopes edges(*field, growth);
        for (const auto& triangle : mesh.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec2 p = mesh.nodes[triangle[i]];
                const Vec2 q = mesh.nodes[triangle[(i + 1) % 3]];
                // Curves that cross make vertices nearer to each other than any size.
                if (distance(p, q) > 0.5 * field->size(p)) {
                    edges.add(p, q);
                }
            }
        }
        Slopes pairs(*field, growth);
        for (int i = 0; i < 200000; ++i) {
            const Vec2 p = mesh.nodes[random() % mesh.nodes.size()];
            const Vec2 q = mesh.nodes[random() % mesh.nodes.size()];
            if (distance(p, q) > 0.5 * field->size(p)) {
                pairs.add(p, q);
            }
        }
        std::printf("growth %.1f, %zu nodes\n", growth, mesh.nodes.size());
        edges.expectBelowOne("ends of mesh edges");
        pairs.expectBelowOne("any vertices");
        const auto& c = result.report.quality.sizeConformity;
        std::printf("edge / size: %.2f %.2f %.2f %.2f %.2f   (least, 5, 50, 95 %%, most)\n", c.min,
                    c.p05, c.median, c.p95, c.max);
        EXPECT_NEAR(c.median, 1.0, 0.1);
        EXPECT_LT(c.p95, 1.4);
    }
}

TEST(SizeFieldOfMeshes, WhatNoMemoryHoldsIsRefusedForEverySource)
{
    const CurveNetwork network = framed({});
    Execution execution;
    MeshOptions plain;
    plain.size = 1.0;
    plain.memoryLimit = 1e8; // 400,000 triangles
    std::vector<LocalSizes> sources(5);
    sources[0].points.push_back({{5, 5}, {1e-5, 2.0}});
    sources[1].curves.push_back({{CurveId(0U)}, {1e-6}});
    sources[2].areas.push_back({"tiny", [](Vec2) { return 1e-4; }});
    sources[3].regions.push_back({OperandId(0U), {}, 1e-4});
    sources[4].areas.push_back(
        {"corner", [](Vec2 p) { return p.x > 5 && p.y > 5 ? 1e-3 : 1.0; }});
    for (std::size_t i = 0; i < sources.size(); ++i) {
        MeshOptions options = plain;
        options.sizes = sources[i];
        try {
            meshNetwork(network, options, execution);
            ADD_FAILURE() << "source " << i << " was meshed";
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::TooLarge) << error.what();
        }
    }
}

TEST(SizeFieldOfMeshes, ErrorsNameThePlace)
{
    const CurveNetwork network = framed({});
    Execution execution;
    const auto refuse = [&](const LocalSizes& sizes, std::size_t places) {
        MeshOptions options;
        options.sizes = sizes;
        try {
            meshNetwork(network, options, execution);
            ADD_FAILURE() << "not refused";
        }
        catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::InvalidOption);
            EXPECT_EQ(error.places().size(), places) << error.what();
        }
    };
    LocalSizes sizes;
    sizes.curves = {{{CurveId(1U)}, {-1.0}}};
    refuse(sizes, 1);
    sizes.curves = {{{CurveId(99U)}, {1.0}}};
    refuse(sizes, 0);
    sizes = {};
    sizes.regions = {{OperandId(3U), {}, 1.0}};
    refuse(sizes, 0);
    sizes.regions = {{{}, {50, 50}, 1.0}};
    refuse(sizes, 1);
    sizes.regions = {{{}, {5, 5}, 0.0}};
    refuse(sizes, 0);
}

} // namespace
} // namespace tessera
