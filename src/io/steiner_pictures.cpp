// SPDX-License-Identifier: MIT
#include "io/steiner_pictures.h"

#include <algorithm>
#include <set>

namespace tessera
{

namespace
{

constexpr std::size_t kMostSegments = 300;
constexpr std::size_t kMostPoints = 40; ///< on one segment; more make no clear picture

constexpr Color kCavity {1.0, 0.94, 0.78};
constexpr Color kEdge {0.45, 0.53, 0.62};
constexpr Color kBoundary {0.08, 0.13, 0.24};
constexpr Color kSteiner {0.80, 0.12, 0.10};

} // namespace

void SteinerPictures::steinerInserted(const Triangulation& triangulation, std::uint32_t vertex)
{
    if (removing_) {
        removing_ = false;
        inserted_.clear();
        snapshots_.clear();
        ++segments_;
    }
    if (segments_ >= kMostSegments) {
        return;
    }
    inserted_.push_back(vertex);
    // One of them is deleted when all have been inserted: what is around it then counts.
    snapshots_.clear();
    for (std::size_t i = 0; i < inserted_.size() && inserted_.size() <= kMostPoints; ++i) {
        snapshots_.push_back(around(triangulation, inserted_[i]));
    }
}

void SteinerPictures::steinerRemoved(const Triangulation& triangulation, std::uint32_t formerVertex)
{
    const bool isFirst = !removing_;
    removing_ = true;
    const auto at = static_cast<std::size_t>(
        std::find(inserted_.begin(), inserted_.end(), formerVertex) - inserted_.begin());
    if (!isFirst || at >= snapshots_.size() || !snapshots_[at]) {
        return;
    }
    const Snapshot& before = *snapshots_[at];
    const double clarity = clarityOf(before);
    if (best_ && clarity <= best_->clarity) {
        return;
    }
    Snapshot after = before;
    after.edges = edgesIn(triangulation, before.window, before.link.front());
    best_ = Pair {before, std::move(after), clarity};
}

/// None at the border of the triangulation.
std::optional<SteinerPictures::Snapshot>
SteinerPictures::around(const Triangulation& triangulation, std::uint32_t vertex)
{
    Snapshot snapshot;
    snapshot.center = triangulation.points[vertex];
    snapshot.window.add(snapshot.center);
    bool finite = true;
    triangulation.forEachAround(vertex, [&](HalfEdge h) {
        const std::uint32_t other = triangulation.destination(h);
        if (other == Topology::kInfinite) {
            finite = false;
            return;
        }
        snapshot.link.push_back(other);
        snapshot.cavity.push_back(triangulation.points[other]);
        snapshot.window.add(triangulation.points[other]);
    });
    if (!finite || snapshot.link.empty()) {
        return std::nullopt;
    }
    const Box2 box = snapshot.window;
    snapshot.window = box.grown(0.35 * std::max(box.max.x - box.min.x, box.max.y - box.min.y));
    snapshot.edges = edgesIn(triangulation, snapshot.window, vertex);
    return snapshot;
}

/// The edges of all finite triangles in the window that can be reached through such triangles.
std::vector<SteinerPictures::Edge> SteinerPictures::edgesIn(const Triangulation& triangulation,
                                                            const Box2& window,
                                                            std::uint32_t startVertex)
{
    constexpr std::size_t kMostTriangles = 2000;
    std::vector<std::uint32_t> open;
    std::set<std::uint32_t> seen;
    const auto visit = [&](std::uint32_t t) {
        if (!triangulation.isFinite(t) || seen.size() >= kMostTriangles) {
            return;
        }
        Box2 box;
        for (std::uint32_t v : triangulation.triangles[t].v) {
            box.add(triangulation.points[v]);
        }
        if (box.overlaps(window) && seen.insert(t).second) {
            open.push_back(t);
        }
    };
    triangulation.forEachAround(startVertex,
                                [&](HalfEdge h) { visit(Topology::triangleOf(h)); });
    std::vector<Edge> edges;
    while (!open.empty()) {
        const std::uint32_t t = open.back();
        open.pop_back();
        for (std::uint32_t i = 0; i < 3; ++i) {
            const HalfEdge h = Topology::halfEdge(t, i);
            edges.push_back({triangulation.points[triangulation.origin(h)],
                             triangulation.points[triangulation.destination(h)],
                             triangulation.isConstrained(h)});
            visit(Topology::triangleOf(triangulation.twin(h)));
        }
    }
    return edges;
}

/// From 0 to 1: a few neighbors, none much nearer than the others.
double SteinerPictures::clarityOf(const Snapshot& snapshot)
{
    double nearest = snapshot.window.diagonal();
    double farthest = 0.0;
    for (Vec2 p : snapshot.cavity) {
        const double d = distance(p, snapshot.center);
        nearest = std::min(nearest, d);
        farthest = std::max(farthest, d);
    }
    const double count = static_cast<double>(snapshot.cavity.size());
    const double crowd = count < 5.0 ? 0.5 : count > 9.0 ? 9.0 / count : 1.0;
    return farthest > 0.0 ? crowd * nearest / farthest : 0.0;
}

void SteinerPictures::draw(Canvas& canvas, const Snapshot& snapshot,
                           const std::vector<Vec2>& cavity)
{
    canvas.moveTo(cavity.front());
    for (std::size_t i = 1; i < cavity.size(); ++i) {
        canvas.lineTo(cavity[i]);
    }
    canvas.closePath();
    canvas.fill(kCavity);
    for (const bool constrained : {false, true}) {
        for (const Edge& edge : snapshot.edges) {
            if (edge.constrained == constrained) {
                canvas.line(edge.a, edge.b, constrained ? 6.0 : 2.0,
                            constrained ? kBoundary : kEdge);
            }
        }
    }
    for (const Edge& edge : snapshot.edges) {
        canvas.dot(edge.a, 6.0, kBoundary);
    }
}

void SteinerPictures::drawBefore(Canvas& canvas) const
{
    draw(canvas, best_->before, best_->before.cavity);
    canvas.dot(best_->before.center, 11.0, kSteiner);
    canvas.label(best_->before.center, "G", kSteiner);
}

void SteinerPictures::drawAfter(Canvas& canvas) const
{
    draw(canvas, best_->after, best_->before.cavity);
    canvas.ring(best_->before.center, 11.0, 3.0, kSteiner);
}

} // namespace tessera
