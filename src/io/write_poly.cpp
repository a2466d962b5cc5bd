// SPDX-License-Identifier: MIT
#include "io/hole_points.h"
#include "io/text_builder.h"
#include "io/write_text_mesh.h"

#include <algorithm>
#include <optional>

namespace tessera
{

namespace
{

/// Mid nodes follow the corner nodes.
std::size_t cornerCount(const Mesh& mesh)
{
    std::size_t count = 0;
    for (const auto& triangle : mesh.triangles) {
        for (std::uint32_t node : triangle) {
            count = std::max<std::size_t>(count, node + 1);
        }
    }
    return mesh.order() == 2 ? count : mesh.nodes.size();
}

std::int32_t markerOf(const Mesh& mesh, std::size_t edge, const CurveNetwork* marked)
{
    if (marked != nullptr) {
        return marked->curves[mesh.edgeCurves[mesh.edgeCurveStart[edge]].index()].marker;
    }
    return mesh.edgeIsOutline[edge] != 0 ? 1 : 2;
}

void appendRegions(TextBuilder& out, const Mesh& mesh)
{
    const auto hasAttribute = [](const Mesh::MeshRegion& r) { return r.attribute != 0.0; };
    if (std::ranges::none_of(mesh.regions, hasAttribute)) {
        return;
    }
    std::vector<std::optional<std::size_t>> largest(mesh.regions.size());
    const auto twiceArea = [&mesh](std::size_t t) {
        const Vec2 a = mesh.nodes[mesh.triangles[t][0]];
        return cross(mesh.nodes[mesh.triangles[t][1]] - a, mesh.nodes[mesh.triangles[t][2]] - a);
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        auto& best = largest[mesh.triangleRegion[t]];
        if (!best || twiceArea(t) > twiceArea(*best)) {
            best = t;
        }
    }
    std::erase_if(largest, [](const auto& t) { return !t; });
    out << largest.size() << '\n';
    for (std::size_t r = 0; r < largest.size(); ++r) {
        const auto& t = mesh.triangles[*largest[r]];
        const Vec2 a = mesh.nodes[t[0]];
        const Vec2 inside =
            a + (1.0 / 3.0) * ((mesh.nodes[t[1]] - a) + (mesh.nodes[t[2]] - a));
        out << r + 1 << ' ' << inside.x << ' ' << inside.y << ' '
            << mesh.regions[mesh.triangleRegion[*largest[r]]].attribute << " -1\n";
    }
}

} // namespace

std::string formatPoly(const Mesh& mesh, const CurveNetwork* network)
{
    const bool marked = network != nullptr
        && std::ranges::any_of(network->curves, [](const auto& c) { return c.marker != 0; });
    TextBuilder out;
    const std::size_t corners = cornerCount(mesh);
    out.reserve(50 * corners + 4096);
    out << "# Mesh by Tessera " << TESSERA_VERSION << '\n' << corners << " 2 0 0\n";
    for (std::size_t i = 0; i < corners; ++i) {
        out << i + 1 << ' ' << mesh.nodes[i].x << ' ' << mesh.nodes[i].y << '\n';
    }
    out << mesh.edges.size() << " 1\n";
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        out << e + 1 << ' ' << mesh.edges[e][0] + 1 << ' ' << mesh.edges[e][1] + 1 << ' '
            << markerOf(mesh, e, marked ? network : nullptr) << '\n';
    }
    const std::vector<Vec2> holes = holePoints(mesh);
    out << holes.size() << '\n';
    for (std::size_t h = 0; h < holes.size(); ++h) {
        out << h + 1 << ' ' << holes[h].x << ' ' << holes[h].y << '\n';
    }
    appendRegions(out, mesh);
    return out.take();
}

} // namespace tessera
