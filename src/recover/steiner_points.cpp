// SPDX-License-Identifier: MIT

// The paper's own way to recover a boundary, in its two steps (see boundary_recovery.cpp).

#include "predicates/crossing.h"
#include "predicates/predicates.h"
#include "recover/boundary_recovery.h"

#include <vector>

namespace tessera
{

bool BoundaryRecovery::recoverWithSteinerPoints(std::uint32_t s)
{
    chains_.append(s, segments_[s].a);
    way_.assign(1, {segments_[s].a, true});
    edit_.postpone(true);
    const bool done = insertSteinerPoints(s) && removeSteinerPoints(s);
    edit_.postpone(false);
    if (!done) {
        return false;
    }
    for (std::size_t i = 1; i < way_.size(); ++i) {
        if (!pickUpTouches(way_[i - 1].vertex, way_[i].vertex)) {
            return false;
        }
    }
    return true;
}

/// Step 1. Fills way_ from the segment's start to its end.
bool BoundaryRecovery::insertSteinerPoints(std::uint32_t s)
{
    while (way_.back().vertex != segments_[s].b) {
        const std::uint32_t from = way_.back().vertex;
        Step step = next(s, from, Stop::AtAnyEdge);
        if (step.kind == Step::Kind::Edge && !mesh_.isConstrained(step.edge)) {
            if (insertSteinerPoint(s, from, step.edge)) {
                continue;
            }
            step = next(s, from, Stop::AtConstraint);
        }
        const std::uint32_t to
            = step.kind == Step::Kind::Edge ? cross(s, from, step.edge) : step.vertex;
        if (to == kNone) {
            return false;
        }
        if (to != from) {
            constrainIfThere(from, to);
            way_.push_back({to, true});
        }
        else if (!way_.back().kept) {
            way_.back().kept = true;
            ++report_.crossings;
        }
    }
    return true;
}

/// A Steiner point on an edge that is not constrained. False if its rounding does not fit there.
bool BoundaryRecovery::insertSteinerPoint(std::uint32_t s, std::uint32_t from, HalfEdge edge)
{
    const Vec2 u = mesh_.points[mesh_.origin(edge)];
    const Vec2 v = mesh_.points[mesh_.destination(edge)];
    if (orient2d(start(s), end(s), u) * orient2d(start(s), end(s), v) >= 0) {
        return false;
    }
    const Vec2 p = crossLines(start(s), end(s), u, v).point;
    if (p == end(s) || !edit_.splitsEdge(edge, p)) {
        return false;
    }
    const std::uint32_t vertex = edit_.splitEdge(edge, p);
    constrainIfThere(from, vertex);
    way_.push_back({vertex, false});
    countSteinerPoint(vertex);
    return true;
}

/// Step 2. Leaves only the kept vertices in way_, joined by constrained edges, and appends them to
/// the segment's chain.
bool BoundaryRecovery::removeSteinerPoints(std::uint32_t s)
{
    std::size_t first = 0;
    for (std::size_t i = 1; i < way_.size(); ++i) {
        if (way_[i].kept) {
            removeSteinerPointsBetween(first, i);
            if (!edit_.constrain(way_[first].vertex, way_[i].vertex)) {
                return false;
            }
            chains_.append(s, way_[i].vertex);
            first = i;
        }
    }
    std::erase_if(way_, [](const WayPoint& point) { return !point.kept; });
    return true;
}

/// Removes all points between two of the way, each when those beside it are its neighbors in turn:
/// halving keeps the cavities small, where one after the other would make ever longer pieces.
void BoundaryRecovery::removeSteinerPointsBetween(std::size_t first, std::size_t last)
{
    if (last - first < 2) {
        return;
    }
    const std::size_t middle = first + (last - first) / 2;
    removeSteinerPointsBetween(first, middle);
    removeSteinerPointsBetween(middle, last);
    const std::uint32_t vertex = way_[middle].vertex;
    mesh_.forEachAround(vertex, [this](HalfEdge h) { mesh_.setConstrained(h, false); });
    edit_.removeVertex(vertex);
    // Where rounding puts something in the way of this piece, a longer one does without it.
    edit_.constrain(way_[first].vertex, way_[last].vertex);
    ++report_.steinerRemoved;
    if (observer_ != nullptr) {
        observer_->steinerRemoved(mesh_, vertex);
    }
}

void BoundaryRecovery::constrainIfThere(std::uint32_t x, std::uint32_t y)
{
    const HalfEdge edge = edgeBetween(mesh_, x, y);
    if (edge != Topology::kDead) {
        mesh_.setConstrained(edge, true);
    }
}

void BoundaryRecovery::countSteinerPoint(std::uint32_t vertex)
{
    ++report_.steinerInserted;
    if (observer_ != nullptr) {
        observer_->steinerInserted(mesh_, vertex);
    }
}

} // namespace tessera
