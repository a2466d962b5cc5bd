// SPDX-License-Identifier: MIT

// A missing piece of boundary in the paper's two steps (section 2).
//
//   Step 1  a Steiner point at every intersection of the piece with a mesh edge. The edge is split,
//           and the point joined to both vertices opposite to it.
//   Step 2  each point is deleted again: the cavity that it leaves is re-meshed and split along the
//           boundary. As a rounded point lies beside the line, the boundary may cross further
//           triangles; they belong to the cavity.
//
// The piece runs between two vertices that stay: boundary_recovery.cpp cuts a boundary where it
// meets others. So none of the edges here is on a boundary, and none of the points stays.
//
// Guarantees: Step 1 ends early where rounding leaves no room for a point on its edge (four
// counter-clockwise triangles), or where the next one would not be farther along the piece; so
// every point makes progress. Step 2 leaves the vertices and the constrained edges that were there
// before. Whether the piece can be put in then depends on them alone, and is decided, and done if
// need be, by MeshEdit::constrain(): that is why both strategies always agree.
// Cost: that of the cavities. The points are deleted in the order of halving, each when those
// beside it are its neighbors in turn: one after the other would make ever longer pieces.

#include "recover/steiner_points.h"

#include "predicates/crossing.h"
#include "predicates/predicates.h"

namespace tessera
{

bool SteinerPoints::constrain(std::uint32_t x, std::uint32_t y)
{
    if (edgeBetween(mesh_, x, y) == Topology::kDead) {
        edit_.postpone(true);
        insertBetween(x, y);
        removeBetween(0, way_.size() - 1);
        edit_.postpone(false);
    }
    return edit_.constrain(x, y);
}

/// Step 1. Fills way_.
void SteinerPoints::insertBetween(std::uint32_t x, std::uint32_t y)
{
    way_.assign(1, x);
    while (insertNext(x, y)) {
        constrainIfThere(way_[way_.size() - 2], way_.back());
    }
    way_.push_back(y);
}

/// Where the way from the last point to the end crosses an edge. False: there is none to be made.
bool SteinerPoints::insertNext(std::uint32_t x, std::uint32_t y)
{
    const Departure departure = depart(mesh_, way_.back(), y);
    if (departure.kind != Departure::Kind::Across || mesh_.isConstrained(departure.edge)) {
        return false;
    }
    const Vec2 from = mesh_.points[x];
    const Vec2 to = mesh_.points[y];
    const Vec2 u = mesh_.points[mesh_.origin(departure.edge)];
    const Vec2 v = mesh_.points[mesh_.destination(departure.edge)];
    if (orient2d(from, to, u) * orient2d(from, to, v) >= 0) {
        return false;
    }
    const Vec2 p = crossLines(from, to, u, v).point;
    if (!(compareAlong(from, to, p, mesh_.points[way_.back()]) > 0)
        || !(compareAlong(from, to, p, to) < 0) || !edit_.splitsEdge(departure.edge, p)) {
        return false;
    }
    way_.push_back(edit_.splitEdge(departure.edge, p));
    countInserted(way_.back());
    return true;
}

/// Step 2, for all points between two of the way.
void SteinerPoints::removeBetween(std::size_t first, std::size_t last)
{
    if (last - first < 2) {
        return;
    }
    const std::size_t middle = first + (last - first) / 2;
    removeBetween(first, middle);
    removeBetween(middle, last);
    const std::uint32_t vertex = way_[middle];
    mesh_.forEachAround(vertex, [this](HalfEdge h) { mesh_.setConstrained(h, false); });
    edit_.removeVertex(vertex);
    // Where rounding puts something in the way of this piece, a longer one does without it.
    edit_.constrain(way_[first], way_[last]);
    ++report_.steinerRemoved;
    if (observer_ != nullptr) {
        observer_->steinerRemoved(mesh_, vertex);
    }
}

void SteinerPoints::constrainIfThere(std::uint32_t x, std::uint32_t y)
{
    const HalfEdge edge = edgeBetween(mesh_, x, y);
    if (edge != Topology::kDead) {
        mesh_.setConstrained(edge, true);
    }
}

void SteinerPoints::countInserted(std::uint32_t vertex)
{
    ++report_.steinerInserted;
    if (observer_ != nullptr) {
        observer_->steinerInserted(mesh_, vertex);
    }
}

} // namespace tessera
