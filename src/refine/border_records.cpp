// SPDX-License-Identifier: MIT

#include "refine/border_records.h"

#include "base/parallel.h"

#include <algorithm>
#include <vector>

namespace tessera
{

namespace
{

/// The half-edges of outer triangles whose twins are the border without constraints.
std::vector<HalfEdge> findBorder(const WorkingMesh& mesh, const Execution& execution)
{
    constexpr std::size_t kPiece = 1 << 16;
    const Triangulation& t = mesh.triangulation;
    const auto isKept = [&](std::size_t i) {
        return mesh.regionOfTriangle[i] != WorkingMesh::kOutside;
    };
    const auto find = [&](std::size_t begin, std::size_t end, std::vector<HalfEdge>& border) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto triangle = static_cast<std::uint32_t>(i);
            if (isKept(i) || t.isDead(triangle)) {
                continue;
            }
            for (std::uint32_t side = 0; side < 3; ++side) {
                const HalfEdge h = Topology::halfEdge(triangle, side);
                if (!t.isConstrained(h) && isKept(Topology::triangleOf(t.twin(h)))) {
                    border.push_back(h);
                }
            }
        }
    };
    return collectPieces<HalfEdge>(execution, t.triangles.size(), kPiece, find);
}

} // namespace

BorderRecords::BorderRecords(WorkingMesh& mesh, const Execution& execution)
    : mesh_(mesh)
{
    Triangulation& t = mesh.triangulation;
    for (const ConstrainedEdge& edge : mesh.edges) {
        firstUseSet_ = std::max(firstUseSet_, edge.useSet + 1);
    }
    std::uint32_t next = firstUseSet_;
    for (const HalfEdge h : findBorder(mesh, execution)) {
        t.setConstrained(h, true);
        mesh.edges.push_back({t.origin(h), t.destination(h), next++, nullptr});
    }
}

BorderRecords::~BorderRecords()
{
    std::erase_if(mesh_.edges, [this](const ConstrainedEdge& edge) {
        const bool ours = edge.useSet >= firstUseSet_;
        if (ours) {
            Triangulation& t = mesh_.triangulation;
            t.setConstrained(t.findEdge(edge.a, edge.b), false);
        }
        return ours;
    });
}

} // namespace tessera
