// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "region/faces.h"
#include "sample/pslg.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tessera
{

/// What hole and region points do to faces. A point acts on all faces around it up to the curves of
/// its own operand, whatever their role.
struct MarkedFaces
{
    static constexpr std::uint32_t kNoPoint = 0xffffffffU;

    /// Faces that hole points remove from operands, as (face, operand), ascending.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> removed;
    /// By face: it occurs in removed. Empty if none does.
    std::vector<std::uint8_t> hasRemoval;
    /// By face: the region point around which it lies; empty if there is none.
    std::vector<std::uint32_t> regionPoint;
    /// The (face, operand) of each hole point that lies in a bounded face, ascending.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> holes;
    std::vector<std::string> messages; ///< points that do nothing, and why
};

/// Locates the points exactly. Points outside, and points on a curve, have no effect; the latter is
/// told. Each point costs a walk and its face.
MarkedFaces markFaces(const RecoveryResult& recovered, const CurveNetwork& network,
                      const Pslg& pslg, const FaceGraph& faces, bool withHoles,
                      Execution& execution);

} // namespace tessera
