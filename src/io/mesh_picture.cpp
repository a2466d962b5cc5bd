// SPDX-License-Identifier: MIT
#include "io/mesh_picture.h"

#include "io/drawing.h"

#include <algorithm>

namespace tessera
{

namespace
{

constexpr Color kWireColor {0.36, 0.44, 0.53};
constexpr Color kOutlineColor {0.08, 0.13, 0.24};
constexpr Color kConstraintColor {0.72, 0.16, 0.13};
constexpr Color kPointColor {0.55, 0.10, 0.45};

/// The constraint edges, outline and others apart.
struct ConstraintEdges
{
    std::vector<DrawnEdge> outline;
    std::vector<DrawnEdge> inside;
};

ConstraintEdges constraintEdges(const Mesh& mesh)
{
    ConstraintEdges result;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        DrawnEdge edge {mesh.edges[e][0], mesh.edges[e][1]};
        if (!mesh.edgeMidNodes.empty()) {
            edge.middle = mesh.edgeMidNodes[e];
        }
        (mesh.edgeIsOutline[e] != 0 ? result.outline : result.inside).push_back(edge);
    }
    return result;
}

} // namespace

Box2 boundsOf(const Mesh& mesh)
{
    Box2 box;
    for (Vec2 node : mesh.nodes) {
        box.add(node);
    }
    return box;
}

void drawMesh(Canvas& canvas, const Mesh& mesh, bool triangleSides)
{
    DrawnTriangles triangles;
    triangles.points = mesh.nodes;
    triangles.corners = mesh.triangles;
    triangles.classOf = mesh.triangleRegion;
    triangles.middles = mesh.triangleMidNodes;
    const std::vector<DrawnEdge> sides = sidesOf(triangles);
    fillClasses(canvas, mesh.nodes, sides, chooseColors(sides, mesh.regions.size()));
    if (triangleSides) {
        strokeEdges(canvas, mesh.nodes, sides, {kWireColor, 1.1, 14.0, 0.12});
    }

    const ConstraintEdges constraints = constraintEdges(mesh);
    strokeEdges(canvas, mesh.nodes, constraints.inside, {kConstraintColor, 2.8, 6.0, 1.8});
    strokeEdges(canvas, mesh.nodes, constraints.outline, {kOutlineColor, 3.2, 6.0, 2.0});
    for (const Group& group : mesh.groups) {
        if (group.kind == GroupKind::Nodes) {
            for (std::uint32_t node : group.members) {
                canvas.dot(mesh.nodes[node], 5.0, kPointColor);
            }
        }
    }
}

std::string drawMesh(const Mesh& mesh, const PictureOptions& options)
{
    Canvas canvas(options.view.value_or(boundsOf(mesh)), options.format, options.caption);
    drawMesh(canvas, mesh, options.triangleSides);
    return canvas.finish();
}

} // namespace tessera
