// SPDX-License-Identifier: MIT
#include "imprint/patches.h"

#include <algorithm>
#include <array>
#include <map>

namespace tessera
{

Patches::Patches(const OverlayResult& overlay)
    : mesh_(overlay.recovered.triangulation)
    , cellCount_(static_cast<std::uint32_t>(overlay.parts.parts.size()))
    , patchOf_(overlay.parts.partOfTriangle)
{
    static_assert(BooleanParts::kNoPart == kOutside);
    fillGaps();
    std::uint32_t count = cellCount_;
    for (const std::uint32_t patch : patchOf_) {
        count = patch == kOutside ? count : std::max(count, patch + 1);
    }
    start_.assign(count + 1, 0);
    for (const std::uint32_t patch : patchOf_) {
        if (patch != kOutside) {
            ++start_[patch + 1];
        }
    }
    for (std::uint32_t p = 0; p < count; ++p) {
        start_[p + 1] += start_[p];
    }
    triangles_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t t = 0; t < patchOf_.size(); ++t) {
        if (patchOf_[t] != kOutside) {
            triangles_[next[patchOf_[t]]++] = t;
        }
    }
}

/// Numbers the connected sets of uncovered triangles that do not reach infinity.
void Patches::fillGaps()
{
    std::uint32_t count = cellCount_;
    std::vector<std::uint8_t> reached(patchOf_.size(), 0);
    std::vector<std::uint32_t> found;
    for (std::uint32_t seed = 0; seed < patchOf_.size(); ++seed) {
        const auto isOpen = [&](std::uint32_t t) {
            return reached[t] == 0 && !mesh_.isDead(t) && patchOf_[t] == kOutside;
        };
        if (!isOpen(seed)) {
            continue;
        }
        bool bounded = true;
        reached[seed] = 1;
        found.assign(1, seed);
        for (std::size_t i = 0; i < found.size(); ++i) {
            bounded = bounded && !mesh_.isGhost(found[i]);
            for (std::uint32_t side = 0; side < 3; ++side) {
                const std::uint32_t next =
                    Topology::triangleOf(mesh_.twin(Topology::halfEdge(found[i], side)));
                if (isOpen(next)) {
                    reached[next] = 1;
                    found.push_back(next);
                }
            }
        }
        if (bounded) {
            for (const std::uint32_t t : found) {
                patchOf_[t] = count;
            }
            ++count;
        }
    }
}

namespace
{

/// Calls f(half-edge, length) for each edge on the border of a patch.
template<class F>
void forBorder(const Triangulation& mesh, const Patches& patches, std::uint32_t patch, F&& f)
{
    for (const std::uint32_t t : patches.trianglesOf(patch)) {
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge h = Topology::halfEdge(t, side);
            if (patches.of(Topology::triangleOf(mesh.twin(h))) != patch) {
                f(h);
            }
        }
    }
}

std::array<Vec2, 3> cornersOf(const Triangulation& mesh, std::uint32_t t)
{
    const auto& v = mesh.triangles[t].v;
    return {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]};
}

double lengthOf(const Triangulation& mesh, HalfEdge h)
{
    return distance(mesh.points[mesh.origin(h)], mesh.points[mesh.destination(h)]);
}

} // namespace

std::vector<Patches::Neighbor> Patches::neighborsOf(std::uint32_t patch) const
{
    std::map<std::uint32_t, double> shared;
    forBorder(mesh_, *this, patch, [&](HalfEdge h) {
        shared[patchOf_[Topology::triangleOf(mesh_.twin(h))]] += lengthOf(mesh_, h);
    });
    std::vector<Neighbor> neighbors;
    for (const auto& [other, border] : shared) {
        neighbors.push_back({other, border});
    }
    return neighbors;
}

double Patches::area(std::uint32_t patch) const
{
    double twice = 0.0;
    for (const std::uint32_t t : trianglesOf(patch)) {
        const auto [a, b, c] = cornersOf(mesh_, t);
        twice += cross(b - a, c - a);
    }
    return 0.5 * twice;
}

double Patches::perimeter(std::uint32_t patch) const
{
    double sum = 0.0;
    forBorder(mesh_, *this, patch, [&](HalfEdge h) { sum += lengthOf(mesh_, h); });
    return sum;
}

InscribedCircle Patches::circleIn(std::uint32_t patch, double limit) const
{
    std::vector<std::array<Vec2, 3>> corners;
    std::vector<std::array<Vec2, 2>> border;
    for (const std::uint32_t t : trianglesOf(patch)) {
        corners.push_back(cornersOf(mesh_, t));
    }
    forBorder(mesh_, *this, patch, [&](HalfEdge h) {
        border.push_back({mesh_.points[mesh_.origin(h)], mesh_.points[mesh_.destination(h)]});
    });
    return largestCircleIn(corners, border, limit);
}

bool Patches::contains(std::uint32_t patch, Vec2 p) const
{
    return std::ranges::any_of(trianglesOf(patch), [&](std::uint32_t t) {
        const auto [a, b, c] = cornersOf(mesh_, t);
        return cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0
            && cross(a - c, p - c) >= 0.0;
    });
}

} // namespace tessera
