// SPDX-License-Identifier: MIT
#pragma once

#include "io/canvas.h"
#include "io/steiner_pictures.h"
#include "pipeline.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tessera
{

/// Draws each stage of a run, like the paper's Fig. 2, as .svg and .png into a folder:
/// 1-rectangle, 2-points, 3-before-recovery, 4-recovered, 5-outside-removed, 6-optimized, and
/// 7-zoom, a part of the last enlarged as in Fig. 5. Pictures 3 and 4 show the recovery that had
/// more to do: of the straight curves before they are sampled, or of all sampled pieces. With the
/// strategy Steiner also steiner-before and steiner-after, a Steiner point on a boundary and a mesh
/// edge before and after it is deleted as in Fig. 1. Functions throw Error(Unwritable).
class StagePictures: public StageObserver
{
public:
    /// Makes the folder if it does not exist.
    explicit StagePictures(std::filesystem::path folder);

    void initialRectangle(const InitialRectangle& rectangle) override;
    void pointsInserted(const Triangulation& triangulation,
                        const InitialRectangle& rectangle) override;
    void beforeRecovery(const Triangulation& triangulation,
                        std::span<const ConstraintEnds> constraints) override;
    void steinerInserted(const Triangulation& triangulation, std::uint32_t vertex) override;
    void steinerRemoved(const Triangulation& triangulation, std::uint32_t formerVertex) override;
    void recovered(const RecoveryResult& result) override;
    void outsideRemoved(const RecoveryResult& result, const RegionMap& regions) override;
    void optimized(const Mesh& mesh) override;

    double seconds() const override { return seconds_; }

protected:
    const Box2& domain() const { return domain_; }
    /// Writes what draw() draws as .svg and .png.
    void save(const std::string& name, const Box2& view, const std::string& caption,
              const std::function<void(Canvas&)>& draw);

private:
    std::filesystem::path folder_;
    InitialRectangle rectangle_ {};
    Box2 domain_; ///< of all points
    std::size_t mostMissing_ = 0;
    bool drawsRecovery_ = false; ///< the one under way
    SteinerPictures steiner_;
    double seconds_ = 0.0;
};

} // namespace tessera
