// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"
#include "base/vec2.h"
#include "recover/recover.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tessera
{

/// What a group holds: indices of triangles, edges or nodes.
enum class GroupKind : std::uint8_t
{
    Triangles,
    Edges,
    Nodes,
};

struct Group
{
    std::string name;
    GroupKind kind;
    std::vector<std::uint32_t> members; ///< ascending
};

/// The finished mesh: passive arrays. Node, triangle and edge numbers are indices from 0.
struct Mesh
{
    std::vector<Vec2> nodes;
    std::vector<VertexOrigin> nodeOrigin;

    /// Corners counter-clockwise.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Index into regions.
    std::vector<std::uint32_t> triangleRegion;

    /// Edges on constraints; those on the outline have the kept side to their left, the others run
    /// as their first curve does.
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<std::uint8_t> edgeIsOutline; ///< 1: only one triangle has this edge
    /// The curves each edge lies on: edgeCurves[edgeCurveStart[e] .. edgeCurveStart[e + 1]).
    std::vector<std::uint32_t> edgeCurveStart;
    std::vector<CurveId> edgeCurves;

    /// Order 2 only: entry i is the node in the middle of the edge opposite corner i. Mid nodes
    /// follow the corner nodes in nodes.
    std::vector<std::array<std::uint32_t, 3>> triangleMidNodes;
    std::vector<std::uint32_t> edgeMidNodes;

    struct MeshRegion
    {
        double area = 0.0;
        double attribute = 0.0;
        std::vector<OperandId> operands;
    };
    std::vector<MeshRegion> regions;
    std::vector<Group> groups;

    int order() const { return triangleMidNodes.empty() && edgeMidNodes.empty() ? 1 : 2; }
};

} // namespace tessera
