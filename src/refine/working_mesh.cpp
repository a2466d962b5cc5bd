// SPDX-License-Identifier: MIT
#include "refine/working_mesh.h"

#include <algorithm>
#include <utility>

namespace tessera
{

namespace
{

/// Parameter of a chain vertex on the constraint's curve: exact at the ends, by the position along
/// the chord in between (where the vertex lies on the chord anyway).
double parameterAt(const Triangulation& triangulation, const PslgSegment& segment,
                   std::span<const std::uint32_t> chain, std::uint32_t vertex)
{
    if (vertex == chain.front()) {
        return segment.ta;
    }
    if (vertex == chain.back()) {
        return segment.tb;
    }
    const Vec2 a = triangulation.points[chain.front()];
    const Vec2 b = triangulation.points[chain.back()];
    const double whole = distance(a, b);
    const double part = whole > 0.0 ? distance(a, triangulation.points[vertex]) / whole : 0.0;
    return segment.ta + (segment.tb - segment.ta) * std::clamp(part, 0.0, 1.0);
}

ConstrainedEdge representedEdge(const RecoveryResult& recovered, std::size_t index,
                                const CurveNetwork& network, const Pslg& pslg)
{
    const Subsegment& subsegment = recovered.constraints.subsegments[index];
    ConstrainedEdge edge {subsegment.a, subsegment.b, static_cast<std::uint32_t>(index), nullptr};
    for (const ConstraintUse& use : recovered.constraints.usesOf(subsegment)) {
        const PslgSegment& segment = pslg.segments[use.constraint.index()];
        const Curve* geometry = network.curves[segment.curve.index()].geometry.get();
        if (geometry != nullptr) {
            const auto chain = recovered.constraints.chainOf(use.constraint);
            edge.geometry = geometry;
            edge.ta = parameterAt(recovered.triangulation, segment, chain, subsegment.a);
            edge.tb = parameterAt(recovered.triangulation, segment, chain, subsegment.b);
            break;
        }
    }
    return edge;
}

} // namespace

WorkingMesh makeWorkingMesh(RecoveryResult&& recovered, const RegionMap& regions,
                            const CurveNetwork& network, const Pslg& pslg,
                            std::vector<VertexOrigin> origin)
{
    WorkingMesh mesh;
    mesh.origin = std::move(origin);
    mesh.edges.reserve(recovered.constraints.subsegments.size());
    for (std::size_t i = 0; i < recovered.constraints.subsegments.size(); ++i) {
        mesh.edges.push_back(representedEdge(recovered, i, network, pslg));
    }
    mesh.triangulation = std::move(recovered.triangulation);
    mesh.regionOfTriangle.assign(mesh.triangulation.triangles.size(), WorkingMesh::kOutside);
    for (std::size_t t = 0; t < mesh.regionOfTriangle.size(); ++t) {
        const RegionId region = regions.regionOfTriangle[t];
        if (region.valid() && regions.regions[region.index()].inside) {
            mesh.regionOfTriangle[t] = region.value;
        }
    }
    return mesh;
}

} // namespace tessera
