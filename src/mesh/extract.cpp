// SPDX-License-Identifier: MIT
#include "mesh/extract.h"

#include <algorithm>
#include <map>
#include <set>

namespace tessera
{

namespace
{

/// The point of the curve between ta and tb that lies above the chord's middle.
Vec2 middleOnCurve(const ConstrainedEdge& edge, Vec2 a, Vec2 b)
{
    const Vec2 middle = midpoint(a, b);
    if (edge.geometry == nullptr) {
        return middle;
    }
    const Vec2 along = b - a;
    double low = edge.ta;
    double high = edge.tb;
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (low + high);
        const double side = dot(edge.geometry->point(t) - middle, along);
        (side < 0.0 ? low : high) = t;
    }
    return edge.geometry->point(0.5 * (low + high));
}

class Extraction
{
public:
    Extraction(const WorkingMesh& working, const ConstraintMap& constraints,
               const RegionMap& regions, const Pslg& pslg)
        : working_(working)
        , constraints_(constraints)
        , regions_(regions)
        , pslg_(pslg)
    {
        result_.nodeOfVertex.assign(working.triangulation.points.size(), ExtractResult::kNoNode);
    }

    ExtractResult run()
    {
        numberRegions();
        takeTriangles();
        takeEdges();
        return std::move(result_);
    }

private:
    bool isKept(std::uint32_t t) const
    {
        return working_.regionOfTriangle[t] != WorkingMesh::kOutside;
    }

    void numberRegions()
    {
        meshRegion_.assign(regions_.regions.size(), 0);
        for (std::size_t r = 0; r < regions_.regions.size(); ++r) {
            const Region& region = regions_.regions[r];
            if (region.inside) {
                meshRegion_[r] = static_cast<std::uint32_t>(result_.mesh.regions.size());
                result_.mesh.regions.push_back({0.0, region.attribute, region.operands});
            }
        }
    }

    std::uint32_t nodeOf(std::uint32_t vertex)
    {
        std::uint32_t& node = result_.nodeOfVertex[vertex];
        if (node == ExtractResult::kNoNode) {
            node = static_cast<std::uint32_t>(result_.mesh.nodes.size());
            result_.mesh.nodes.push_back(working_.triangulation.points[vertex]);
            result_.mesh.nodeOrigin.push_back(working_.origin[vertex]);
        }
        return node;
    }

    void takeTriangles()
    {
        const auto& triangles = working_.triangulation.triangles;
        std::size_t kept = 0;
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            kept += isKept(t) ? 1 : 0;
        }
        Mesh& mesh = result_.mesh;
        mesh.triangles.reserve(kept);
        mesh.triangleRegion.reserve(kept);
        mesh.nodes.reserve(kept / 2 + 16);
        mesh.nodeOrigin.reserve(kept / 2 + 16);
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            if (isKept(t)) {
                const auto& v = triangles[t].v;
                mesh.triangles.push_back({nodeOf(v[0]), nodeOf(v[1]), nodeOf(v[2])});
                mesh.triangleRegion.push_back(meshRegion_[working_.regionOfTriangle[t]]);
                addArea(mesh);
            }
        }
    }

    static void addArea(Mesh& mesh)
    {
        const auto& t = mesh.triangles.back();
        const Vec2 a = mesh.nodes[t[0]];
        mesh.regions[mesh.triangleRegion.back()].area +=
            0.5 * cross(mesh.nodes[t[1]] - a, mesh.nodes[t[2]] - a);
    }

    void takeEdges()
    {
        Mesh& mesh = result_.mesh;
        mesh.edgeCurveStart.push_back(0);
        for (const ConstrainedEdge& edge : working_.edges) {
            const HalfEdge h = working_.triangulation.findEdge(edge.a, edge.b);
            if (h == Topology::kDead) {
                continue;
            }
            const bool left = isKept(Topology::triangleOf(h));
            const bool right = isKept(Topology::triangleOf(working_.triangulation.twin(h)));
            if (left || right) {
                takeEdge(edge, left, right);
            }
        }
    }

    void takeEdge(const ConstrainedEdge& edge, bool left, bool right)
    {
        Mesh& mesh = result_.mesh;
        const auto& points = working_.triangulation.points;
        const auto uses = constraints_.usesOf(constraints_.subsegments[edge.useSet]);
        const bool outline = left != right;
        const bool forward = outline ? left : (runsForward(edge) == uses.front().forward);
        std::uint32_t a = nodeOf(edge.a);
        std::uint32_t b = nodeOf(edge.b);
        mesh.edges.push_back(forward ? std::array {a, b} : std::array {b, a});
        mesh.edgeIsOutline.push_back(outline ? 1 : 0);
        result_.edgeMiddle.push_back(middleOnCurve(edge, points[edge.a], points[edge.b]));

        std::set<CurveId> curves;
        for (const ConstraintUse& use : uses) {
            curves.insert(pslg_.segments[use.constraint.index()].curve);
        }
        mesh.edgeCurves.insert(mesh.edgeCurves.end(), curves.begin(), curves.end());
        mesh.edgeCurveStart.push_back(static_cast<std::uint32_t>(mesh.edgeCurves.size()));
    }

    /// Whether a split edge runs the same way as the subsegment that it came from.
    bool runsForward(const ConstrainedEdge& edge) const
    {
        const Subsegment& s = constraints_.subsegments[edge.useSet];
        const auto& p = working_.triangulation.points;
        return dot(p[s.b] - p[s.a], p[edge.b] - p[edge.a]) >= 0.0;
    }

    const WorkingMesh& working_;
    const ConstraintMap& constraints_;
    const RegionMap& regions_;
    const Pslg& pslg_;
    std::vector<std::uint32_t> meshRegion_;
    ExtractResult result_;
};

void addGroup(Mesh& mesh, const std::string& name, GroupKind kind,
              std::vector<std::uint32_t> members)
{
    if (!members.empty() && !name.empty()) {
        mesh.groups.push_back({name, kind, std::move(members)});
    }
}

void addRegionGroups(Mesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> members(mesh.regions.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        members[mesh.triangleRegion[t]].push_back(t);
    }
    for (std::size_t r = 0; r < members.size(); ++r) {
        addGroup(mesh, "Region" + std::to_string(r + 1), GroupKind::Triangles,
                 std::move(members[r]));
    }
}

void addOperandGroups(Mesh& mesh, const CurveNetwork& network)
{
    if (network.operands.size() < 2) {
        return;
    }
    std::vector<std::vector<std::uint32_t>> members(network.operands.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (OperandId operand : mesh.regions[mesh.triangleRegion[t]].operands) {
            members[operand.index()].push_back(t);
        }
    }
    for (std::size_t o = 0; o < members.size(); ++o) {
        addGroup(mesh, network.operands[o].name, GroupKind::Triangles, std::move(members[o]));
    }
}

void addEdgeGroups(Mesh& mesh, const CurveNetwork& network)
{
    std::map<std::string, std::set<std::uint32_t>> byName;
    std::map<std::int32_t, std::set<std::uint32_t>> byMarker;
    std::vector<std::uint32_t> outline;
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
        for (std::uint32_t i = mesh.edgeCurveStart[e]; i < mesh.edgeCurveStart[e + 1]; ++i) {
            const CurveId curve = mesh.edgeCurves[i];
            if (curve.index() < network.curveNames.size()) {
                byName[network.curveNames[curve.index()]].insert(e);
            }
            const std::int32_t marker = network.curves[curve.index()].marker;
            if (marker != 0) {
                byMarker[marker].insert(e);
            }
        }
        if (mesh.edgeIsOutline[e] != 0) {
            outline.push_back(e);
        }
    }
    addGroup(mesh, "Outline", GroupKind::Edges, std::move(outline));
    for (const auto& [name, members] : byName) {
        addGroup(mesh, name, GroupKind::Edges, {members.begin(), members.end()});
    }
    for (const auto& [marker, members] : byMarker) {
        addGroup(mesh, "Marker" + std::to_string(marker), GroupKind::Edges,
                 {members.begin(), members.end()});
    }
}

} // namespace

ExtractResult extractMesh(const WorkingMesh& working, const ConstraintMap& constraints,
                          const RegionMap& regions, const Pslg& pslg)
{
    return Extraction(working, constraints, regions, pslg).run();
}

void addGroups(Mesh& mesh, const CurveNetwork& network,
               const std::vector<std::uint32_t>& nodeOfPoint)
{
    addRegionGroups(mesh);
    addOperandGroups(mesh, network);
    addEdgeGroups(mesh, network);
    std::map<std::string, std::set<std::uint32_t>> named;
    for (const EmbeddedPoint& embedded : network.embedded) {
        const std::uint32_t node = nodeOfPoint[embedded.point.index()];
        if (node != ExtractResult::kNoNode) {
            named[embedded.name].insert(node);
        }
    }
    for (const auto& [name, members] : named) {
        addGroup(mesh, name, GroupKind::Nodes, {members.begin(), members.end()});
    }
}

} // namespace tessera
