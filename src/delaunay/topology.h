// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tessera
{

/// Handle of an edge seen from one of its triangles: 4 × triangle + i, i = 0, 1, 2.
using HalfEdge = std::uint32_t;

/// Combinatorics of a triangulated sphere: the plane's triangles plus ghost triangles that
/// join every hull edge to the vertex at infinity (kInfinite). Knows no positions.
///
///              v[0]
///              /  \            vertices counter-clockwise;
///     edge 2  /    \  edge 1   edge i lies opposite v[i] and runs
///            /  t   \          from v[i+1] to v[i+2] (indices mod 3);
///         v[1] ---- v[2]       link[i] is the half-edge of the same edge
///              edge 0          in the neighbor, plus the constrained bit.
///
/// 24 bytes a triangle, up to 2^29 triangles. A freed slot has v[0] == kDead.
class Topology
{
public:
    static constexpr std::uint32_t kInfinite = 0; ///< the vertex at infinity
    static constexpr std::uint32_t kDead = 0xffffffffU;
    static constexpr std::uint32_t kConstrainedBit = 0x80000000U;

    struct Triangle
    {
        std::uint32_t v[3];
        std::uint32_t link[3];
    };

    std::vector<Triangle> triangles;

    static constexpr std::uint32_t triangleOf(HalfEdge h) { return h >> 2; }
    static constexpr std::uint32_t sideOf(HalfEdge h) { return h & 3U; }
    static constexpr HalfEdge halfEdge(std::uint32_t t, std::uint32_t i) { return 4U * t + i; }
    static constexpr std::uint32_t next3(std::uint32_t i) { return i == 2 ? 0 : i + 1; }
    static constexpr std::uint32_t prev3(std::uint32_t i) { return i == 0 ? 2 : i - 1; }

    /// The next and the previous edge counter-clockwise in the same triangle.
    static constexpr HalfEdge next(HalfEdge h) { return (h & ~3U) | next3(h & 3U); }
    static constexpr HalfEdge prev(HalfEdge h) { return (h & ~3U) | prev3(h & 3U); }

    HalfEdge twin(HalfEdge h) const { return link(h) & ~kConstrainedBit; }
    std::uint32_t origin(HalfEdge h) const { return triangles[h >> 2].v[next3(h & 3U)]; }
    std::uint32_t destination(HalfEdge h) const { return triangles[h >> 2].v[prev3(h & 3U)]; }
    std::uint32_t apex(HalfEdge h) const { return triangles[h >> 2].v[h & 3U]; }

    bool isConstrained(HalfEdge h) const { return (link(h) & kConstrainedBit) != 0; }
    void setConstrained(HalfEdge h, bool on)
    {
        setBit(h, on);
        setBit(twin(h), on);
    }

    bool isDead(std::uint32_t t) const { return triangles[t].v[0] == kDead; }
    bool isGhost(std::uint32_t t) const
    {
        const auto& v = triangles[t].v;
        return v[0] == kInfinite || v[1] == kInfinite || v[2] == kInfinite;
    }
    bool isFinite(std::uint32_t t) const { return !isDead(t) && !isGhost(t); }

    /// The half-edges out of a vertex, turning counter-clockwise: h, nextAround(h), ...
    HalfEdge nextAround(HalfEdge h) const { return twin(prev(h)); }
    HalfEdge prevAround(HalfEdge h) const { return next(twin(h)); }

    /// Joins two half-edges as twins; the constrained bit is set to the given value on both.
    void join(HalfEdge a, HalfEdge b, bool constrained = false)
    {
        const std::uint32_t bit = constrained ? kConstrainedBit : 0U;
        triangles[a >> 2].link[a & 3U] = b | bit;
        triangles[b >> 2].link[b & 3U] = a | bit;
    }

private:
    std::uint32_t link(HalfEdge h) const { return triangles[h >> 2].link[h & 3U]; }
    void setBit(HalfEdge h, bool on)
    {
        std::uint32_t& l = triangles[h >> 2].link[h & 3U];
        l = on ? (l | kConstrainedBit) : (l & ~kConstrainedBit);
    }
};

} // namespace tessera
