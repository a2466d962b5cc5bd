// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "recover/recover.h"
#include "region/operand_sets.h"
#include "sample/pslg.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// What a Boolean operation keeps of the plane; any number of operands.
enum class BooleanOperation : std::uint8_t
{
    Union,               ///< covered by an operand
    Intersection,        ///< covered by all operands
    Difference,          ///< covered by the first operand and by no other one
    SymmetricDifference, ///< covered by an odd number of operands
    Cells,               ///< each bounded face of the arrangement that an operand covers, by itself
};

/// To whom a place belongs that several operands cover.
enum class Priority : std::uint8_t
{
    None,  ///< to all of them
    First, ///< to the first of the input (multi-material parts: no place belongs to two)
    Last,  ///< to the last of the input
};

/// The paper's Algorithm 2: the sets that the triangles of two operands t and s fall into.
enum class Theta : std::uint8_t
{
    O, ///< in both
    T, ///< in t only
    S, ///< in s only
    E, ///< outside both
};

/// Algorithm 2, step 6, for one triangle.
constexpr Theta thetaOf(bool inT, bool inS)
{
    if (inT) {
        return inS ? Theta::O : Theta::T;
    }
    return inS ? Theta::S : Theta::E;
}

/// Whether a place is kept that the given operands (ascending) of operandCount cover.
constexpr bool isKept(BooleanOperation operation, std::span<const OperandId> covering,
                      std::size_t operandCount)
{
    switch (operation) {
        case BooleanOperation::Intersection:
            return !covering.empty() && covering.size() == operandCount;
        case BooleanOperation::Difference:
            return covering.size() == 1 && covering.front().value == 0;
        case BooleanOperation::SymmetricDifference:
            return covering.size() % 2 == 1;
        case BooleanOperation::Union:
        case BooleanOperation::Cells:
            break;
    }
    return !covering.empty();
}

/// A connected part of the result.
struct BooleanPart
{
    double area = 0.0;
    /// The operand that it belongs to, with a priority; otherwise none.
    OperandId owner;
    /// Cells: the operands that cover it, or its owner. Otherwise empty unless there is an owner.
    OperandSetId operands = OperandSets::kEmpty;
};

/// The colored triangulation of a Boolean operation.
struct BooleanParts
{
    static constexpr std::uint32_t kNoPart = 0xffffffffU;

    std::vector<std::uint32_t> partOfTriangle; ///< kNoPart: not in the result
    /// By owner, then by the lowest triangle.
    std::vector<BooleanPart> parts;
    OperandSets sets;
    std::vector<Theta> theta; ///< by triangle; two operands only, otherwise empty
    std::vector<std::string> messages;
};

struct BooleanOptions
{
    BooleanOperation operation = BooleanOperation::Union;
    Priority priority = Priority::None;
    FillRule fill = FillRule::EvenOdd; ///< within each operand; not Hull
};

/// Colors the triangles by the operands that cover them and joins what the operation keeps to parts:
/// maximal sets of triangles with the same owner that hang together by edges; for Cells by edges
/// that lie on no curve of any role. O(triangles + sum over subsegments of their operands), plus the
/// walk of cover.h. Memory: triangles + faces; with Cells also the different operand sets.
/// Throws Error(InvalidOption) for FillRule::Hull.
BooleanParts colorBoolean(const RecoveryResult& recovered, const CurveNetwork& network,
                          const Pslg& pslg, const BooleanOptions& options, Execution& execution);

} // namespace tessera
