// SPDX-License-Identifier: MIT
#include "mesh/node_order.h"

#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace tessera
{

namespace
{

constexpr std::size_t kPiece = 1 << 15;
constexpr std::size_t kSampleStride = 61;
constexpr double kOrdered = 0.9; ///< share of triangles whose vertices have near numbers

class Ordering
{
public:
    Ordering(const WorkingMesh& mesh, const Execution& execution)
        : mesh_(mesh)
        , t_(mesh.triangulation)
        , execution_(execution)
    {
        order_.nodeOfVertex.assign(t_.points.size(), MeshOrder::kNoNode);
    }

    MeshOrder run()
    {
        collectKept();
        if (isOrdered()) {
            numberByVertex();
        }
        else {
            walkBreadthFirst();
            numberByUse();
        }
        return std::move(order_);
    }

private:
    bool isKept(std::uint32_t triangle) const
    {
        return mesh_.regionOfTriangle[triangle] != WorkingMesh::kOutside;
    }

    void collectKept()
    {
        const std::size_t slots = t_.triangles.size();
        std::vector<std::size_t> start((slots + kPiece - 1) / kPiece + 1, 0);
        forEachPiece(execution_, slots, kPiece,
                     [&](std::size_t piece, std::size_t begin, std::size_t end) {
                         std::size_t count = 0;
                         for (std::size_t i = begin; i < end; ++i) {
                             count += isKept(static_cast<std::uint32_t>(i)) ? 1 : 0;
                         }
                         start[piece + 1] = count;
                     });
        for (std::size_t piece = 1; piece < start.size(); ++piece) {
            start[piece] += start[piece - 1];
        }
        reserveTouched(execution_, order_.triangles, start.back());
        order_.triangles.resize(start.back());
        forEachPiece(execution_, slots, kPiece,
                     [&](std::size_t piece, std::size_t begin, std::size_t end) {
                         std::size_t at = start[piece];
                         for (std::size_t i = begin; i < end; ++i) {
                             if (isKept(static_cast<std::uint32_t>(i))) {
                                 order_.triangles[at++] = static_cast<std::uint32_t>(i);
                             }
                         }
                     });
    }

    bool isOrdered() const
    {
        const double width = 1024.0 + 4.0 * std::sqrt(static_cast<double>(t_.points.size()));
        std::size_t near = 0;
        std::size_t samples = 0;
        for (std::size_t i = 0; i < order_.triangles.size(); i += kSampleStride) {
            const auto& v = t_.triangles[order_.triangles[i]].v;
            const auto [low, high] = std::minmax({v[0], v[1], v[2]});
            near += high - low < width ? 1 : 0;
            ++samples;
        }
        return static_cast<double>(near) >= kOrdered * static_cast<double>(samples);
    }

    void numberByVertex()
    {
        std::vector<std::uint32_t>& node = order_.nodeOfVertex;
        forEachPiece(execution_, order_.triangles.size(), kPiece,
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                         execution_.checkpoint();
                         for (std::size_t i = begin; i < end; ++i) {
                             for (const std::uint32_t v : t_.triangles[order_.triangles[i]].v) {
                                 // Several pieces may say so of one vertex; once is enough.
                                 const std::atomic_ref number(node[v]);
                                 if (number.load(std::memory_order_relaxed) != 0) {
                                     number.store(0, std::memory_order_relaxed);
                                 }
                             }
                         }
                     });
        std::vector<std::uint32_t> first((node.size() + kPiece - 1) / kPiece + 1, 0);
        forEachPiece(execution_, node.size(), kPiece,
                     [&](std::size_t piece, std::size_t begin, std::size_t end) {
                         std::uint32_t count = 0;
                         for (std::size_t v = begin; v < end; ++v) {
                             count += node[v] != MeshOrder::kNoNode ? 1 : 0;
                         }
                         first[piece + 1] = count;
                     });
        std::partial_sum(first.begin(), first.end(), first.begin());
        forEachPiece(execution_, node.size(), kPiece,
                     [&](std::size_t piece, std::size_t begin, std::size_t end) {
                         std::uint32_t number = first[piece];
                         for (std::size_t v = begin; v < end; ++v) {
                             if (node[v] != MeshOrder::kNoNode) {
                                 node[v] = number++;
                             }
                         }
                     });
        order_.nodes = first.back();
    }

    /// Replaces the order of the kept triangles; each connected part in turn.
    void walkBreadthFirst()
    {
        std::vector<std::uint8_t> seen(t_.triangles.size(), 0);
        std::vector<std::uint32_t> walked;
        walked.reserve(order_.triangles.size());
        for (const std::uint32_t first : order_.triangles) {
            if (seen[first] != 0) {
                continue;
            }
            seen[first] = 1;
            walked.push_back(first);
            for (std::size_t i = walked.size() - 1; i < walked.size(); ++i) {
                if (i % kPiece == 0) {
                    execution_.checkpoint();
                }
                for (std::uint32_t side = 0; side < 3; ++side) {
                    const std::uint32_t next =
                        Topology::triangleOf(t_.twin(Topology::halfEdge(walked[i], side)));
                    if (seen[next] == 0 && isKept(next)) {
                        seen[next] = 1;
                        walked.push_back(next);
                    }
                }
            }
        }
        order_.triangles = std::move(walked);
    }

    void numberByUse()
    {
        for (const std::uint32_t triangle : order_.triangles) {
            for (const std::uint32_t v : t_.triangles[triangle].v) {
                std::uint32_t& number = order_.nodeOfVertex[v];
                if (number == MeshOrder::kNoNode) {
                    number = order_.nodes++;
                }
            }
        }
    }

    const WorkingMesh& mesh_;
    const Triangulation& t_;
    const Execution& execution_;
    MeshOrder order_;
};

} // namespace

MeshOrder orderMesh(const WorkingMesh& mesh, const Execution& execution)
{
    return Ordering(mesh, execution).run();
}

} // namespace tessera
