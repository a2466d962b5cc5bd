// SPDX-License-Identifier: MIT
#include "mesh/second_order.h"

#include <algorithm>

namespace tessera
{

namespace
{

/// Finds an edge's number by its two nodes: edges sorted by their lower node.
class EdgeNumbers
{
public:
    explicit EdgeNumbers(const Mesh& mesh)
    {
        start_.assign(mesh.nodes.size() + 1, 0);
        for (const auto& t : mesh.triangles) {
            for (int i = 0; i < 3; ++i) {
                ++start_[std::min(t[i], t[(i + 1) % 3]) + 1];
            }
        }
        for (std::size_t i = 1; i < start_.size(); ++i) {
            start_[i] += start_[i - 1];
        }
        slots_.resize(start_.back());
        used_.assign(mesh.nodes.size(), 0);
    }

    /// The number stored for (a, b); a new one is taken from next.
    std::uint32_t& at(std::uint32_t a, std::uint32_t b, bool& isNew)
    {
        if (a > b) {
            std::swap(a, b);
        }
        for (std::uint32_t i = start_[a]; i < start_[a] + used_[a]; ++i) {
            if (slots_[i].other == b) {
                isNew = false;
                return slots_[i].number;
            }
        }
        isNew = true;
        Slot& slot = slots_[start_[a] + used_[a]++];
        slot.other = b;
        return slot.number;
    }

private:
    struct Slot
    {
        std::uint32_t other;
        std::uint32_t number;
    };
    std::vector<std::uint32_t> start_;
    std::vector<std::uint32_t> used_;
    std::vector<Slot> slots_;
};

bool isPositive(const Mesh& mesh, std::uint32_t t)
{
    Vec2 corner[3];
    Vec2 middle[3];
    for (int i = 0; i < 3; ++i) {
        corner[i] = mesh.nodes[mesh.triangles[t][i]];
        middle[i] = mesh.nodes[mesh.triangleMidNodes[t][i]];
    }
    return jacobianLowerBound(corner, middle) > 0.0;
}

/// Adds to the regions' areas what lies between the chords and the parabolas through the mid nodes:
/// 2/3 of the chord times the mid node's height above it.
void addCurvedAreas(Mesh& mesh)
{
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const Vec2 a = mesh.nodes[mesh.triangles[t][(i + 1) % 3]];
            const Vec2 b = mesh.nodes[mesh.triangles[t][(i + 2) % 3]];
            const Vec2 height = mesh.nodes[mesh.triangleMidNodes[t][i]] - midpoint(a, b);
            if (height != Vec2 {}) {
                mesh.regions[mesh.triangleRegion[t]].area -= 2.0 / 3.0 * cross(b - a, height);
            }
        }
    }
}

} // namespace

double jacobianLowerBound(const Vec2 corner[3], const Vec2 middle[3])
{
    // Bézier control points: the corners and c[i], the control point of the edge opposite corner i.
    Vec2 c[3];
    for (int i = 0; i < 3; ++i) {
        const Vec2 chord = midpoint(corner[(i + 1) % 3], corner[(i + 2) % 3]);
        c[i] = 2.0 * middle[i] - chord;
    }
    // The derivatives in the two directions are linear in the barycentric coordinates; u[k], v[k]
    // are their values at corner k (times one half).
    const Vec2 u[3] = {c[2] - corner[0], corner[1] - c[2], c[0] - c[1]};
    const Vec2 v[3] = {c[1] - corner[0], c[0] - c[2], corner[2] - c[1]};
    double lowest = 4.0 * cross(u[0], v[0]);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        lowest = std::min(lowest, 4.0 * cross(u[i], v[i]));
        lowest = std::min(lowest, 2.0 * (cross(u[i], v[j]) + cross(u[j], v[i])));
    }
    return lowest;
}

std::vector<std::uint32_t> makeSecondOrder(Mesh& mesh, const std::vector<Vec2>& edgeMiddle)
{
    EdgeNumbers numbers(mesh);
    bool isNew = false;
    mesh.edgeMidNodes.resize(mesh.edges.size());
    const auto addNode = [&](Vec2 p, VertexOrigin origin) {
        mesh.nodes.push_back(p);
        mesh.nodeOrigin.push_back(origin);
        return static_cast<std::uint32_t>(mesh.nodes.size() - 1);
    };
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        std::uint32_t& number = numbers.at(mesh.edges[e][0], mesh.edges[e][1], isNew);
        number = addNode(edgeMiddle[e], VertexOrigin::CurveSample);
        mesh.edgeMidNodes[e] = number;
    }
    mesh.triangleMidNodes.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = v[(i + 1) % 3];
            const std::uint32_t b = v[(i + 2) % 3];
            std::uint32_t& number = numbers.at(a, b, isNew);
            if (isNew) {
                number = addNode(midpoint(mesh.nodes[a], mesh.nodes[b]), VertexOrigin::Interior);
            }
            mesh.triangleMidNodes[t][i] = number;
        }
    }

    // Straighten the edges of triangles that are not provably valid, first by halves. After
    // kHalvings rounds each change makes one more edge straight for ever, so this ends.
    constexpr std::uint32_t kNoEdge = 0xffffffffU;
    std::vector<std::uint32_t> edgeOfMidNode(mesh.nodes.size(), kNoEdge);
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
        edgeOfMidNode[mesh.edgeMidNodes[e]] = e;
    }
    std::vector<std::uint32_t> moved;
    constexpr int kHalvings = 3;
    bool changed = true;
    for (int step = 0; changed; ++step) {
        changed = false;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            if (isPositive(mesh, t)) {
                continue;
            }
            for (const std::uint32_t node : mesh.triangleMidNodes[t]) {
                const std::uint32_t e = edgeOfMidNode[node];
                if (e == kNoEdge) {
                    continue;
                }
                const Vec2 chord =
                    midpoint(mesh.nodes[mesh.edges[e][0]], mesh.nodes[mesh.edges[e][1]]);
                if (mesh.nodes[node] != chord) {
                    mesh.nodes[node] =
                        step < kHalvings ? midpoint(mesh.nodes[node], chord) : chord;
                    moved.push_back(e);
                    changed = true;
                }
            }
        }
    }
    addCurvedAreas(mesh);
    std::sort(moved.begin(), moved.end());
    moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
    return moved;
}

} // namespace tessera
