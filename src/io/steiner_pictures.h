// SPDX-License-Identifier: MIT
#pragma once

#include "base/box2.h"
#include "delaunay/triangulation.h"
#include "io/canvas.h"
#include "recover/recover.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tessera
{

/// Watches the deletion of Steiner points and keeps the surroundings of the one that makes the
/// clearest picture (the paper's Fig. 1b), just before and just after. Looks at the first few
/// hundred segments that need Steiner points only, so that it costs little.
class SteinerPictures: public RecoveryObserver
{
public:
    void steinerInserted(const Triangulation& triangulation, std::uint32_t vertex) override;
    void steinerRemoved(const Triangulation& triangulation, std::uint32_t formerVertex) override;

    /// A deletion was seen.
    bool available() const { return best_.has_value(); }
    /// What the pictures show. Precondition for the functions below: available().
    Box2 view() const { return best_->before.window; }
    void drawBefore(Canvas& canvas) const;
    void drawAfter(Canvas& canvas) const;

private:
    struct Edge
    {
        Vec2 a;
        Vec2 b;
        bool constrained;
    };
    /// The edges in a window around a Steiner point.
    struct Snapshot
    {
        Box2 window;
        std::vector<Edge> edges;
        Vec2 center;                    ///< the Steiner point
        std::vector<std::uint32_t> link; ///< the vertices around it, counter-clockwise
        std::vector<Vec2> cavity;        ///< their positions
    };
    struct Pair
    {
        Snapshot before;
        Snapshot after;
        double clarity;
    };

    static std::optional<Snapshot> around(const Triangulation& triangulation, std::uint32_t vertex);
    static std::vector<Edge> edgesIn(const Triangulation& triangulation, const Box2& window,
                                     std::uint32_t startVertex);
    static double clarityOf(const Snapshot& snapshot);
    static void draw(Canvas& canvas, const Snapshot& snapshot, const std::vector<Vec2>& cavity);

    std::vector<std::uint32_t> inserted_; ///< on the segment being recovered
    std::vector<std::optional<Snapshot>> snapshots_; ///< around each of inserted_, as it is now
    std::size_t segments_ = 0;
    bool removing_ = false;
    std::optional<Pair> best_;
};

} // namespace tessera
