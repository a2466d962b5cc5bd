// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"
#include "recover/recover.h"
#include "sample/pslg.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// The first reason why the ends of curves close no outline.
struct OutlineFlaw
{
    enum class Kind
    {
        Gap,      ///< the two free ends closest to each other
        Overlap,  ///< curves share a length instead of an end
        Crossing, ///< curves run past their crossing
        Touch,    ///< a curve ends on the inside of another one
        Operands, ///< curves of different operands meet in their ends
    };
    Kind kind;
    std::string what;   ///< "(0, 0) of Geometry0 and (0, 0.1) of Geometry3, 0.1 apart"
    std::string remedy; ///< "close the gap, or raise the weld tolerance to that"
    std::vector<ErrorPlace> places;
    std::size_t freeEnds; ///< points at which an odd number of an operand's curves end

    /// The fill rule 'all' meshes what the curves enclose.
    bool meshedByAll() const { return kind != Kind::Gap && kind != Kind::Operands; }
};

/// Why the wanted curves of an arranged network (all that are meshed, if wanted is empty) form no
/// closed outline by their ends. Where they enclose nothing, that is a gap between free ends;
/// otherwise they may also overlap, cross, or end inside each other, and of a gap and of such a
/// place the one with the smaller length to mend is named. None where no end is free.
/// parent: by curve of the network, the curve of the input that it is a piece of; empty: itself.
/// Works on the recovered subsegments, so what meets counts however it was found. O(n log n).
std::optional<OutlineFlaw> findOutlineFlaw(const RecoveryResult& recovered,
                                           const CurveNetwork& network, const Pslg& pslg,
                                           std::span<const CurveId> parent,
                                           std::span<const std::uint8_t> wanted);

} // namespace tessera
