// SPDX-License-Identifier: MIT
#include "mesh/extract.h"

#include "base/huge_pages.h"
#include "base/parallel.h"
#include "mesh/node_order.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace tessera
{

namespace
{

constexpr std::size_t kPiece = 1 << 15;

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
               const RegionMap& regions, const Pslg& pslg, const Execution& execution)
        : working_(working)
        , constraints_(constraints)
        , regions_(regions)
        , pslg_(pslg)
        , execution_(execution)
    {}

    ExtractResult run()
    {
        numberRegions();
        MeshOrder order = orderMesh(working_, execution_);
        result_.nodeOfVertex = std::move(order.nodeOfVertex);
        makeRoom(order.nodes, order.triangles.size());
        takeNodes();
        takeTriangles(order.triangles);
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

    std::uint32_t nodeOf(std::uint32_t vertex) const { return result_.nodeOfVertex[vertex]; }

    /// The first writing to new memory costs more than the rest: threads share it array by array.
    void makeRoom(std::size_t nodes, std::size_t triangles)
    {
        const auto resize = [](auto& array, std::size_t size) {
            reserveOnHugePages(array, size);
            array.resize(size);
        };
        Mesh& mesh = result_.mesh;
        runTogether(
            execution_, [&] { resize(mesh.triangles, triangles); },
            [&] { resize(mesh.nodes, nodes); }, [&] { resize(mesh.triangleRegion, triangles); },
            [&] { resize(mesh.nodeOrigin, nodes); });
    }

    void takeNodes()
    {
        Mesh& mesh = result_.mesh;
        forEachPiece(execution_, result_.nodeOfVertex.size(), kPiece,
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                         for (std::size_t v = begin; v < end; ++v) {
                             const std::uint32_t node = result_.nodeOfVertex[v];
                             if (node != ExtractResult::kNoNode) {
                                 mesh.nodes[node] = working_.triangulation.points[v];
                                 mesh.nodeOrigin[node] = working_.origin[v];
                             }
                         }
                     });
    }

    void takeTriangles(const std::vector<std::uint32_t>& slots)
    {
        Mesh& mesh = result_.mesh;
        // Few pieces, because each sums the areas of all regions.
        const std::size_t piece = std::max(kPiece, slots.size() / 64 + 1);
        std::vector<std::vector<double>> areas((slots.size() + piece - 1) / piece);
        forEachPiece(execution_, slots.size(), piece,
                     [&](std::size_t index, std::size_t begin, std::size_t end) {
                         execution_.checkpoint();
                         areas[index].assign(mesh.regions.size(), 0.0);
                         for (std::size_t i = begin; i < end; ++i) {
                             takeTriangle(i, slots[i], areas[index]);
                         }
                     });
        for (const std::vector<double>& part : areas) {
            for (std::size_t r = 0; r < part.size(); ++r) {
                mesh.regions[r].area += part[r];
            }
        }
    }

    void takeTriangle(std::size_t index, std::uint32_t slot, std::vector<double>& areas)
    {
        Mesh& mesh = result_.mesh;
        const auto& v = working_.triangulation.triangles[slot].v;
        const std::uint32_t region = meshRegion_[working_.regionOfTriangle[slot]];
        mesh.triangles[index] = {nodeOf(v[0]), nodeOf(v[1]), nodeOf(v[2])};
        mesh.triangleRegion[index] = region;
        const auto& p = working_.triangulation.points;
        areas[region] += 0.5 * cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]);
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
    const Execution& execution_;
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
    if (members.size() == 1) {
        members[0].resize(mesh.triangles.size());
        std::iota(members[0].begin(), members[0].end(), 0U);
        addGroup(mesh, "Region1", GroupKind::Triangles, std::move(members[0]));
        return;
    }
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
                          const RegionMap& regions, const Pslg& pslg, const Execution& execution)
{
    return Extraction(working, constraints, regions, pslg, execution).run();
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
