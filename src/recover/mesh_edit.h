// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/cavity.h"
#include "delaunay/delaunay.h"
#include "delaunay/triangulation.h"

#include <cstdint>
#include <vector>

namespace tessera
{

/// Where the ray from a vertex toward another one leaves the triangles around the first.
struct Departure
{
    enum class Kind
    {
        Along,  ///< along `edge`, which starts at the vertex
        Across, ///< through the inside of a triangle and across its `edge`, seen from the vertex
        None,   ///< out of the convex hull: not for a target inside it
    };
    Kind kind;
    HalfEdge edge;
};

/// Exact. `from` and `to` are different vertices of triangles.
Departure depart(const Triangulation& mesh, std::uint32_t from, std::uint32_t to);

/// The half-edge from x to y; kDead if the two are not joined. Costs as much as going around the
/// one with fewer edges.
HalfEdge edgeBetween(const Triangulation& mesh, std::uint32_t x, std::uint32_t y);

/// The changes that boundary recovery makes to a triangulation.
///
/// Insertion of an edge (cavity): the triangles that the open segment x, y crosses are removed and
/// the polygons on both sides of it filled. Each of their vertices sees the segment, so that
/// Sklansky's scan triangulates them in linear time (Toussaint and Avis 1982, edge-visible
/// polygons); Lawson flips of the new edges then restore the constrained Delaunay property, which
/// holds outside the cavity all the time. A polygon may touch itself: edges that reach into the
/// cavity without being crossed stay.
///
/// All decisions are exact. Every operation leaves a valid triangulation, and a constrained
/// Delaunay one unless told to postpone that.
class MeshEdit
{
public:
    explicit MeshEdit(Triangulation& mesh)
        : mesh_(mesh)
        , cavity_(mesh)
    {}

    /// Makes the edge from x to y if it is missing, and constrains it. False if a constrained edge
    /// or a vertex is in the way; then nothing has changed.
    bool constrain(std::uint32_t x, std::uint32_t y);

    /// Whether p, put on the edge, makes four counter-clockwise triangles of its two finite ones.
    bool splitsEdge(HalfEdge edge, Vec2 p) const;
    /// Inserts a vertex at p, which splits the edge although it may lie beside it (splitsEdge()
    /// holds), and returns it; the halves are constrained as the edge was. The new vertex is joined
    /// to the edge's ends and both apexes.
    std::uint32_t splitEdge(HalfEdge edge, Vec2 p);

    /// Inserts a vertex at p, which is not at a vertex, and returns it.
    std::uint32_t insert(Vec2 p, const Location& where);

    /// Removes a vertex without constrained edges that is strictly inside the convex hull; the
    /// polygon around it is triangulated without it.
    void removeVertex(std::uint32_t vertex);

    /// Takes the constraint off an edge and restores the Delaunay property.
    void release(HalfEdge edge);

    /// While postponed, the operations do not restore the Delaunay property; ending that does.
    void postpone(bool on);

    /// Moves the last vertices into the places of those that were removed and have not been used
    /// again. Returns the new name of each vertex; nothing if there are no such places.
    std::vector<std::uint32_t> closeGaps();

private:
    struct Side
    {
        std::uint32_t vertex; ///< the further end of a side of a polygon
        HalfEdge inner;       ///< the side inside the cavity, from vertex to the one before
    };
    enum class SideKind : std::uint8_t
    {
        Border,   ///< the triangle beyond is outside the cavity
        Slit,     ///< both triangles are in the cavity, but the segment does not cross the edge
        Internal, ///< the triangle beyond is a new one
    };
    struct Open
    {
        std::uint32_t vertex;
        HalfEdge inner; ///< of a Slit
        HalfEdge outer;
        SideKind kind;
        bool constrained;
    };
    struct Slit
    {
        HalfEdge inner;
        HalfEdge placed;
    };

    bool walk(std::uint32_t x, std::uint32_t y, HalfEdge crossed);
    HalfEdge fill(std::uint32_t start, const std::vector<Open>& sides);
    std::uint32_t place(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void joinSide(HalfEdge h, const Open& side);
    bool inBothCircles(HalfEdge edge, Vec2 p) const;
    void splitOnly(HalfEdge edge, std::uint32_t p);
    void cutEar(std::vector<Open>& polygon);
    Open openSide(HalfEdge inner, std::uint32_t vertex) const;
    Open border(HalfEdge inner) const;
    std::uint32_t takeVertex(Vec2 p);

    void restore();

    Triangulation& mesh_;
    Cavity<CavityMode::General> cavity_;
    bool postponed_ = false;
    std::vector<HalfEdge> suspects_;
    std::vector<std::uint32_t> freeVertices_;

    // Of the cavity at work.
    std::vector<Side> left_, right_;
    std::vector<std::uint32_t> slots_; ///< its triangles, taken again by the new ones
    std::size_t nextSlot_ = 0;
    std::vector<Open> leftOpen_, rightOpen_, stack_;
    std::vector<Slit> slits_;
};

} // namespace tessera
