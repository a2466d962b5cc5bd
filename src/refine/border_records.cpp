// SPDX-License-Identifier: MIT

#include "refine/border_records.h"

#include <algorithm>

namespace tessera
{

BorderRecords::BorderRecords(WorkingMesh& mesh)
    : mesh_(mesh)
{
    Triangulation& t = mesh.triangulation;
    for (const ConstrainedEdge& edge : mesh.edges) {
        firstUseSet_ = std::max(firstUseSet_, edge.useSet + 1);
    }
    std::uint32_t next = firstUseSet_;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (t.isDead(i) || mesh.regionOfTriangle[i] != WorkingMesh::kOutside) {
            continue;
        }
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge h = Topology::halfEdge(i, side);
            const std::uint32_t other = Topology::triangleOf(t.twin(h));
            if (!t.isConstrained(h) && mesh.regionOfTriangle[other] != WorkingMesh::kOutside) {
                t.setConstrained(h, true);
                mesh.edges.push_back({t.origin(h), t.destination(h), next++, nullptr});
            }
        }
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
