// SPDX-License-Identifier: MIT
#pragma once

#include "recover/mesh_edit.h"
#include "recover/recover.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tessera
{

/// The paper's own way to put a missing piece of boundary into the mesh. See the head of
/// steiner_points.cpp.
class SteinerPoints
{
public:
    /// edit: of mesh. Counts in report.
    SteinerPoints(Triangulation& mesh, MeshEdit& edit, RecoveryReport& report,
                  RecoveryObserver* observer)
        : mesh_(mesh)
        , edit_(edit)
        , report_(report)
        , observer_(observer)
    {}

    /// What MeshEdit::constrain() does, with the same result up to cocircular ties: true or false
    /// for the same piece in the same mesh.
    bool constrain(std::uint32_t x, std::uint32_t y);

    /// Counts a Steiner point that stays: one where boundaries cross.
    void countInserted(std::uint32_t vertex);

private:
    void insertBetween(std::uint32_t x, std::uint32_t y);
    bool insertNext(std::uint32_t x, std::uint32_t y);
    void removeBetween(std::size_t first, std::size_t last);
    void constrainIfThere(std::uint32_t x, std::uint32_t y);

    Triangulation& mesh_;
    MeshEdit& edit_;
    RecoveryReport& report_;
    RecoveryObserver* observer_;
    std::vector<std::uint32_t> way_; ///< the piece's start, its Steiner points, its end
};

} // namespace tessera
