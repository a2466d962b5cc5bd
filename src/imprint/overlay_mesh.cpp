// SPDX-License-Identifier: MIT
#include "imprint/overlay_mesh.h"

#include "mesh/extract.h"
#include "refine/working_mesh.h"

#include <algorithm>
#include <utility>

namespace tessera
{

namespace
{

/// The parts as regions; what is in none belongs to the outer one.
RegionMap regionsOf(const OverlayResult& result)
{
    const BooleanParts& parts = result.parts;
    RegionMap map;
    map.regions.resize(parts.parts.size() + 1);
    for (std::size_t p = 0; p < parts.parts.size(); ++p) {
        Region& region = map.regions[p + 1];
        region.inside = true;
        region.area = parts.parts[p].area;
        region.operands = parts.sets.members(parts.parts[p].operands);
    }
    const Triangulation& t = result.recovered.triangulation;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        const std::uint32_t part = parts.partOfTriangle[i];
        map.regionOfTriangle.push_back(!t.isFinite(i)                      ? RegionId()
                                           : part == BooleanParts::kNoPart ? RegionId(0U)
                                                                           : RegionId(part + 1));
    }
    for (const Subsegment& s : result.recovered.constraints.subsegments) {
        const HalfEdge h = t.findEdge(s.a, s.b);
        const auto partBeside = [&](HalfEdge side) {
            return parts.partOfTriangle[Topology::triangleOf(side)];
        };
        map.isBoundary.push_back(
            h != Topology::kDead && partBeside(h) != partBeside(t.twin(h)) ? 1 : 0);
    }
    map.keptRegions = parts.parts.size();
    return map;
}

/// Replaces arranged curves by those of the input that they are pieces of.
void nameInputCurves(Mesh& mesh, const std::vector<CurveId>& parent)
{
    for (CurveId& curve : mesh.edgeCurves) {
        curve = parent[curve.index()];
    }
}

} // namespace

Mesh meshOf(const OverlayResult& result)
{
    const RegionMap regions = regionsOf(result);
    RecoveryResult recovered = result.recovered;
    const WorkingMesh working = makeWorkingMesh(std::move(recovered), regions, result.network(),
                                                result.pslg, result.origin);
    Mesh mesh = extractMesh(working, result.recovered.constraints, regions, result.pslg).mesh;
    if (result.arranged) {
        nameInputCurves(mesh, result.parent);
    }
    const std::vector<std::uint32_t> noNodes(result.input.points.size(), ExtractResult::kNoNode);
    addGroups(mesh, result.input, noNodes);
    return mesh;
}

} // namespace tessera
