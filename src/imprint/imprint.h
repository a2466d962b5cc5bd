// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "imprint/overlay.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tessera
{

/// Where a sweep starts, and where it ends.
enum class ImprintSide : std::uint8_t
{
    Source,
    Target,
};

struct ImprintOptions
{
    /// Overlaps and gaps of this width or less are closed, in the input's unit; >= 0. The width of a
    /// part of the plane is the diameter of the largest circle in it.
    double tolerance = 0.0;
    /// End points closer than this are one in any case (rounding of a CAD system); >= 0.
    double weld = 0.0;
    FillRule fill = FillRule::EvenOdd; ///< within each operand; not Hull
    RecoveryStrategy recovery = RecoveryStrategy::Cavity;
    double chordError = 0.0; ///< as OverlayOptions::chordError; 0: finer for a tolerance above weld
};

/// A piece of the common refinement. Sources are numbered from 0 among the sources, in the order of
/// the operands; targets likewise. Usually there is one of each.
struct ImprintCell
{
    double area = 0.0; ///< on the true curves
    std::vector<std::uint32_t> sources;
    std::vector<std::uint32_t> targets;
};

/// Why a place does not lie on exactly one source and one target.
enum class MismatchKind : std::uint8_t
{
    SourceOverlap, ///< on several sources
    TargetOverlap, ///< on one source at most, and on several targets
    SourceOnly,    ///< on a source, on no target
    TargetOnly,    ///< on a target, on no source
    Gap,           ///< on none, between several sources or several targets
    Sliver,        ///< on one of each, but within the tolerance
};

struct Mismatch
{
    MismatchKind kind = MismatchKind::Gap;
    double area = 0.0;
    double width = 0.0; ///< diameter of its largest circle
    Vec2 at;            ///< center of that circle
    /// Those that it lies on; of a gap those beside it. Ascending.
    std::vector<std::uint32_t> sources;
    std::vector<std::uint32_t> targets;
};

/// "source overlap", "target without source", ...
const char* nameOf(MismatchKind kind);

/// The common refinement of sources and targets.
struct ImprintResult
{
    /// Operation Cells; part and polygon i is cell i, areas are those on the true curves. Cells
    /// share every vertex and every edge.
    OverlayResult overlay;
    std::vector<ImprintCell> cells;
    /// The history: by source and by target, the cells it consists of, ascending.
    std::vector<std::vector<std::uint32_t>> cellsOfSource;
    std::vector<std::vector<std::uint32_t>> cellsOfTarget;
    std::vector<Mismatch> closed; ///< within the tolerance: belong to a cell beside them now
    std::vector<Mismatch> left;   ///< wider ones, and those with nothing beside them
    double tolerance = 0.0;
    std::vector<std::string> messages; ///< for the user, those of the overlay included
};

/// Projected sources and targets on one plane: each cell of their overlay lies on the same source
/// and the same target everywhere. side: by operand. What lies within the tolerance is closed: end
/// points and curves are welded, then narrow cells and gaps join the cell beside them with the
/// longest common border, one with a source and a target if there is one. Throws Error(InvalidInput)
/// without a source or without a target, Error(InvalidOption) for a tolerance below 0.
ImprintResult imprintNetwork(const CurveNetwork& network, const std::vector<ImprintSide>& side,
                             const ImprintOptions& options, Execution& execution);

} // namespace tessera
