// SPDX-License-Identifier: MIT
//
// Hash consing: a node is looked up by its content before it is made. Element 0 of words and nodes
// is the empty set on every level.
#include "region/operand_sets.h"

namespace tessera
{

namespace
{

std::uint64_t mixed(std::uint64_t x)
{
    x ^= x >> 32;
    x *= 0x9e3779b97f4a7c15U;
    return x ^ (x >> 29);
}

std::uint64_t hashOf(std::uint64_t word)
{
    return mixed(word);
}

template<std::size_t N>
std::uint64_t hashOf(const std::array<std::uint32_t, N>& node)
{
    std::uint64_t hash = 0;
    for (const std::uint32_t child : node) {
        hash = (hash ^ child) * 0x9e3779b97f4a7c15U;
    }
    return mixed(hash);
}

} // namespace

OperandSets::OperandSets(std::size_t operandCount)
{
    for (std::size_t covered = 1U << kWordBits; covered < operandCount; covered <<= kChildBits) {
        ++levels_;
    }
    wordTable_.assign(64, 0);
    nodeTable_.assign(64, 0);
}

template<class Item>
std::uint32_t OperandSets::intern(std::vector<Item>& items, std::vector<std::uint32_t>& table,
                                  const Item& item)
{
    if (item == items[0]) {
        return 0;
    }
    const auto slotOf = [&](const Item& wanted) {
        std::size_t slot = hashOf(wanted) & (table.size() - 1);
        while (table[slot] != 0 && items[table[slot] - 1] != wanted) {
            slot = (slot + 1) & (table.size() - 1);
        }
        return slot;
    };
    const std::size_t slot = slotOf(item);
    if (table[slot] != 0) {
        return table[slot] - 1;
    }
    const auto id = static_cast<std::uint32_t>(items.size());
    items.push_back(item);
    table[slot] = id + 1;
    if (2 * items.size() > table.size()) {
        table.assign(2 * table.size(), 0);
        for (std::uint32_t i = 1; i < items.size(); ++i) {
            table[slotOf(items[i])] = i + 1;
        }
    }
    return id;
}

OperandSetId OperandSets::toggledAt(std::uint32_t level, std::uint32_t id, std::uint32_t operand)
{
    if (level == 0) {
        const std::uint32_t bit = operand & ((1U << kWordBits) - 1);
        return intern(words_, wordTable_, words_[id] ^ (std::uint64_t {1} << bit));
    }
    Node node = nodes_[id];
    std::uint32_t& child = node[(operand >> shiftAt(level)) & (kChildren - 1)];
    child = toggledAt(level - 1, child, operand);
    return intern(nodes_, nodeTable_, node);
}

bool OperandSets::contains(OperandSetId set, OperandId operand) const
{
    std::uint32_t id = set;
    for (std::uint32_t level = levels_; level > 0; --level) {
        id = nodes_[id][(operand.value >> shiftAt(level)) & (kChildren - 1)];
    }
    return ((words_[id] >> (operand.value & ((1U << kWordBits) - 1))) & 1U) != 0;
}

std::vector<OperandId> OperandSets::members(OperandSetId set) const
{
    std::vector<OperandId> result;
    forEach(set, [&result](OperandId operand) { result.push_back(operand); });
    return result;
}

std::size_t OperandSets::memoryBytes() const
{
    return words_.capacity() * sizeof(std::uint64_t) + nodes_.capacity() * sizeof(Node)
        + (wordTable_.capacity() + nodeTable_.capacity()) * sizeof(std::uint32_t);
}

} // namespace tessera
