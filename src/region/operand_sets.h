// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tessera
{

/// A set of operands in an OperandSets; equal sets have equal ids.
using OperandSetId = std::uint32_t;

/// Sets of operands, each kept once. A set is a tree of 64-operand words with 16 children a node;
/// equal subtrees are shared, so that a set that differs from another one by one operand costs a few
/// nodes, however many operands both hold. Memory grows with the number of different sets times
/// log(operands).
class OperandSets
{
public:
    static constexpr OperandSetId kEmpty = 0;

    explicit OperandSets(std::size_t operandCount = 0);

    /// The set with the operand taken in if it is not there, and taken out if it is.
    OperandSetId toggled(OperandSetId set, OperandId operand)
    {
        return toggledAt(levels_, set, operand.value);
    }
    bool contains(OperandSetId set, OperandId operand) const;

    /// Calls f(OperandId) in ascending order.
    template<class F>
    void forEach(OperandSetId set, F&& f) const
    {
        forEachAt(levels_, set, 0, f);
    }
    std::vector<OperandId> members(OperandSetId set) const;

    std::size_t memoryBytes() const;

private:
    static constexpr std::uint32_t kWordBits = 6;
    static constexpr std::uint32_t kChildBits = 4;
    static constexpr std::uint32_t kChildren = 1U << kChildBits;
    using Node = std::array<std::uint32_t, kChildren>;

    /// Finds the index of an equal element of `items`, or appends it. table holds index + 1.
    template<class Item>
    static std::uint32_t intern(std::vector<Item>& items, std::vector<std::uint32_t>& table,
                                const Item& item);
    static std::uint32_t shiftAt(std::uint32_t level)
    {
        return kWordBits + kChildBits * (level - 1);
    }

    OperandSetId toggledAt(std::uint32_t level, std::uint32_t id, std::uint32_t operand);

    template<class F>
    void forEachAt(std::uint32_t level, std::uint32_t id, std::uint32_t first, F& f) const
    {
        if (id == kEmpty) {
            return;
        }
        if (level == 0) {
            for (std::uint64_t word = words_[id]; word != 0; word &= word - 1) {
                f(OperandId(first + static_cast<std::uint32_t>(std::countr_zero(word))));
            }
            return;
        }
        for (std::uint32_t i = 0; i < kChildren; ++i) {
            forEachAt(level - 1, nodes_[id][i], first + (i << shiftAt(level)), f);
        }
    }

    std::uint32_t levels_ = 0; ///< of nodes above the words
    std::vector<std::uint64_t> words_ {0};
    std::vector<Node> nodes_ {Node {}};
    std::vector<std::uint32_t> wordTable_;
    std::vector<std::uint32_t> nodeTable_;
};

} // namespace tessera
