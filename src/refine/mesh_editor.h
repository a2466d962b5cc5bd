// SPDX-License-Identifier: MIT
#pragma once

#include "delaunay/delaunay.h"
#include "refine/refine.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tessera
{

/// Where a walk that may not cross constrained edges ended.
struct VisibleWalk
{
    enum class Kind
    {
        Reached, ///< location says where the point is
        Blocked, ///< location.edge is the constrained edge in between
        Outside, ///< beyond the hull; location is the ghost triangle there
        Lost,    ///< too many steps; happens on badly shaped triangles only
    };
    Kind kind;
    Location location;
};

/// Inserts vertices into a WorkingMesh and keeps its other arrays right: vertex origins, regions by
/// triangle, records of the constrained edges. After every operation the triangulation is valid
/// and constrained Delaunay if it was before.
class MeshEditor
{
public:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    /// Constrained edges are grouped by their useSet: the pieces of one recovered subsegment have one
    /// root, whose ends are the vertices that are not SegmentSplit.
    explicit MeshEditor(WorkingMesh& mesh);

    WorkingMesh& mesh() { return mesh_; }
    const WorkingMesh& constMesh() const { return mesh_; }
    const Triangulation& triangulation() const { return mesh_.triangulation; }
    bool isKept(std::uint32_t triangle) const
    {
        return mesh_.regionOfTriangle[triangle] != WorkingMesh::kOutside;
    }
    bool isFree(std::uint32_t vertex) const
    {
        return mesh_.origin[vertex] == VertexOrigin::Interior;
    }

    /// A half-edge of some live triangle. Precondition: there is one.
    HalfEdge anyEdge() const;

    /// Walks from the triangle of start towards p through edges that are not constrained.
    VisibleWalk walk(HalfEdge start, Vec2 p) const;

    /// Inserts a free vertex. Precondition: where is a kept triangle or an edge that is not
    /// constrained inside one region.
    std::uint32_t insertInside(Vec2 p, const Location& where);

    /// As insertInside for a vertex that has its place in points but no triangle yet.
    void insertIsolated(std::uint32_t vertex, const Location& where);

    /// Index into mesh().edges; kNone if the two vertices are not joined by a constrained edge.
    std::uint32_t findRecord(std::uint32_t a, std::uint32_t b) const;

    /// Splits a constrained edge at the point of its curve whose distance from the edge's origin is
    /// fraction (0 .. 1) of the chord; a straight edge on the chord. Refuses, changing nothing, and
    /// returns kNone if something lies between chord and curve or the point coincides with an end.
    std::uint32_t splitEdge(HalfEdge edge, double fraction);

    /// The recovered subsegment that a split vertex belongs to, and its ends.
    std::uint32_t rootOfVertex(std::uint32_t v) const
    {
        return v < pieces_.size() ? pieces_[v].root : kNone;
    }
    std::uint32_t rootCount() const { return static_cast<std::uint32_t>(rootEnds_.size()); }
    std::uint32_t rootStart(std::uint32_t root) const { return rootEnds_[root].a; }
    std::uint32_t rootEnd(std::uint32_t root) const { return rootEnds_[root].b; }

    /// The distance from rootStart() of the nearest point of the chord between the ends of the root.
    double placeAlong(std::uint32_t root, Vec2 p) const;

    /// The length of the shortest recovered subsegment at an end of the root, growing with the
    /// distance from there, at a place beside it: what such short ones demand anyway.
    double spacingBeside(std::uint32_t root, Vec2 p) const;
    /// The same at a vertex; infinite if it is on no constrained edge.
    double spacingAt(std::uint32_t v) const;

    struct RootSide
    {
        std::uint32_t root;
        int side; ///< 0: the half-edge runs from rootStart to rootEnd, its triangle is on the left
    };
    /// What a constrained half-edge is part of; kNone if it is not recorded.
    RootSide rootSideOf(HalfEdge edge) const;

private:
    struct CurvePoint
    {
        Vec2 point;
        double parameter;
    };
    struct Ends
    {
        std::uint32_t a = kNone;
        std::uint32_t b = kNone;
    };

    /// The records on either side of a split vertex.
    struct Pieces
    {
        std::uint32_t root = kNone;
        std::uint32_t before = kNone; ///< ends at the vertex
        std::uint32_t after = kNone;  ///< begins there
    };

    bool isSplit(std::uint32_t vertex) const
    {
        return mesh_.origin[vertex] == VertexOrigin::SegmentSplit;
    }
    void enter(std::uint32_t record);
    static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b);
    CurvePoint pointOnEdge(const ConstrainedEdge& edge, bool fromA, double fraction) const;
    std::uint32_t insertOnEdge(HalfEdge edge, Vec2 p);
    std::uint32_t insertBeside(HalfEdge edge, Vec2 p);
    bool isInConflict(std::uint32_t triangle, Vec2 p) const;
    void addVertex(std::uint32_t v, VertexOrigin origin);
    void paintStar(std::uint32_t v, std::uint32_t region);
    void replaceRecord(std::uint32_t record, std::uint32_t v, double parameter);

    WorkingMesh& mesh_;
    std::unordered_map<std::uint64_t, std::uint32_t> wholeRoots_; ///< records between their ends
    std::vector<Ends> rootEnds_;
    std::vector<Pieces> pieces_; ///< by vertex
    std::vector<double> shortestAt_; ///< by vertex: the shortest recovered subsegment, or infinite
    std::vector<HalfEdge> suspects_;
};

} // namespace tessera
