// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "mesh/mesh.h"
#include "refine/refine.h"
#include "region/region.h"
#include "sample/pslg.h"

namespace tessera
{

/// Compacts the kept triangles, the edges on constraints beside them and their nodes into a Mesh.
/// For their order see node_order.h. Kept regions are renumbered from 0.
struct ExtractResult
{
    Mesh mesh;
    /// By mesh edge: its middle on the true curve (the chord's middle for a straight one).
    std::vector<Vec2> edgeMiddle;
    /// By vertex of the triangulation: node, or kNoNode.
    std::vector<std::uint32_t> nodeOfVertex;

    static constexpr std::uint32_t kNoNode = 0xffffffffU;
};

ExtractResult extractMesh(const WorkingMesh& working, const ConstraintMap& constraints,
                          const RegionMap& regions, const Pslg& pslg,
                          const Execution& execution = Execution());

/// Names regions, curves and embedded points: one triangle group per kept region, further groups
/// for operands that cover several regions or share one, an edge group per curve name and per
/// marker, a node group per named point, and "Outline" for the edges used once.
void addGroups(Mesh& mesh, const CurveNetwork& network,
               const std::vector<std::uint32_t>& nodeOfPoint);

} // namespace tessera
