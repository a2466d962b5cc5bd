// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/mesh.h"
#include "mesh/second_order.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tessera::samples
{

/// A square [0, n]² of unit cells, two triangles each, with a square hole of the middle third and
/// a second region right of the middle. Its curves: 0 the outer border, 1 the hole's, 2 the line
/// between the regions. Inner nodes are moved a little, so that coordinates are not whole numbers.
class PlateMesh
{
public:
    explicit PlateMesh(std::uint32_t cells)
        : n_(cells)
    {
        for (std::uint32_t j = 0; j < n_; ++j) {
            for (std::uint32_t i = 0; i < n_; ++i) {
                if (!isHole(i, j)) {
                    addCell(i, j);
                }
            }
        }
        addEdges();
        addGroups();
        moveInnerNodes();
    }

    Mesh mesh;
    double area() const { return static_cast<double>(n_) * n_ - hole() * hole(); }
    double outlineLength() const { return 4.0 * n_ + 4.0 * hole(); }

private:
    double hole() const { return n_ / 3; }
    bool isHole(std::uint32_t i, std::uint32_t j) const
    {
        const std::uint32_t third = n_ / 3;
        return i >= third && i < 2 * third && j >= third && j < 2 * third;
    }
    bool isRight(std::uint32_t i) const { return i >= n_ / 2; }

    std::uint32_t node(std::uint32_t i, std::uint32_t j)
    {
        const auto [at, isNew] =
            nodeAt_.try_emplace({i, j}, static_cast<std::uint32_t>(mesh.nodes.size()));
        if (isNew) {
            mesh.nodes.push_back({static_cast<double>(i), static_cast<double>(j)});
            mesh.nodeOrigin.push_back(VertexOrigin::Input);
        }
        return at->second;
    }

    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t region)
    {
        mesh.triangles.push_back({a, b, c});
        mesh.triangleRegion.push_back(region);
        const std::uint32_t corners[] = {a, b, c};
        for (int i = 0; i < 3; ++i) {
            regionLeftOf_[{corners[i], corners[(i + 1) % 3]}] = region;
        }
    }

    void addCell(std::uint32_t i, std::uint32_t j)
    {
        const std::uint32_t region = isRight(i) ? 1 : 0;
        const std::uint32_t a = node(i, j);
        const std::uint32_t b = node(i + 1, j);
        const std::uint32_t c = node(i + 1, j + 1);
        const std::uint32_t d = node(i, j + 1);
        mesh.regions.resize(2);
        mesh.regions[region].area += 1.0;
        mesh.regions[region].operands = {OperandId(region)};
        if ((i + j) % 2 == 0) {
            addTriangle(a, b, c, region);
            addTriangle(a, c, d, region);
        }
        else {
            addTriangle(a, b, d, region);
            addTriangle(b, c, d, region);
        }
    }

    void addEdges()
    {
        mesh.edgeCurveStart.push_back(0);
        for (const auto& [edge, region] : regionLeftOf_) {
            const auto twin = regionLeftOf_.find({edge.second, edge.first});
            const bool outline = twin == regionLeftOf_.end();
            if (!outline && (twin->second == region || region == 1)) {
                continue;
            }
            mesh.edges.push_back({edge.first, edge.second});
            mesh.edgeIsOutline.push_back(outline ? 1 : 0);
            const Vec2 a = mesh.nodes[edge.first];
            const double far = static_cast<double>(n_);
            const Vec2 b = mesh.nodes[edge.second];
            const bool border = (a.x == b.x && (a.x == 0.0 || a.x == far))
                || (a.y == b.y && (a.y == 0.0 || a.y == far));
            mesh.edgeCurves.push_back(CurveId(!outline ? 2U : border ? 0U : 1U));
            mesh.edgeCurveStart.push_back(static_cast<std::uint32_t>(mesh.edgeCurves.size()));
        }
    }

    void addGroups()
    {
        Group groups[] = {{"Left", GroupKind::Triangles, {}},  {"Right", GroupKind::Triangles, {}},
                          {"Plate", GroupKind::Triangles, {}}, {"Border", GroupKind::Edges, {}},
                          {"Hole", GroupKind::Edges, {}},      {"Seam", GroupKind::Edges, {}},
                          {"Corner", GroupKind::Nodes, {}}};
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            groups[mesh.triangleRegion[t]].members.push_back(t);
            groups[2].members.push_back(t);
        }
        for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
            groups[3 + mesh.edgeCurves[e].value].members.push_back(e);
        }
        groups[6].members.push_back(0);
        mesh.groups.assign(std::begin(groups), std::end(groups));
    }

    void moveInnerNodes()
    {
        std::vector<bool> onEdge(mesh.nodes.size(), false);
        for (const auto& edge : mesh.edges) {
            onEdge[edge[0]] = onEdge[edge[1]] = true;
        }
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            if (!onEdge[i]) {
                const double t = static_cast<double>(i);
                mesh.nodes[i] = mesh.nodes[i] + Vec2 {0.2 * std::sin(t), 0.2 * std::cos(3.0 * t)};
            }
        }
    }

    std::uint32_t n_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> nodeAt_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> regionLeftOf_;
};

/// The plate with mid nodes; those on the hole's border lie a tenth of an edge inside the hole.
inline Mesh secondOrderPlate(std::uint32_t cells)
{
    Mesh mesh = PlateMesh(cells).mesh;
    std::vector<Vec2> middles;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        const Vec2 a = mesh.nodes[mesh.edges[e][0]];
        const Vec2 b = mesh.nodes[mesh.edges[e][1]];
        const double bulge = mesh.edgeCurves[e] == CurveId(1U) ? 0.1 : 0.0;
        const Vec2 right {b.y - a.y, a.x - b.x};
        middles.push_back(midpoint(a, b) + bulge * right);
    }
    makeSecondOrder(mesh, middles);
    return mesh;
}

} // namespace tessera::samples
