// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// Cells of plane meshes. Corners first, in order around; then the mid nodes of the sides from
/// corner 0 to 1, 1 to 2, ...
enum class CellKind : std::uint8_t
{
    Edge2,
    Edge3,
    Triangle3,
    Triangle6,
    Quad4,
    Quad8,
};

constexpr std::size_t nodesOf(CellKind kind)
{
    constexpr std::size_t kNodes[] = {2, 3, 3, 6, 4, 8};
    return kNodes[static_cast<std::size_t>(kind)];
}
constexpr std::size_t cornersOf(CellKind kind)
{
    constexpr std::size_t kCorners[] = {2, 2, 3, 3, 4, 4};
    return kCorners[static_cast<std::size_t>(kind)];
}
constexpr bool isEdge(CellKind kind)
{
    return kind == CellKind::Edge2 || kind == CellKind::Edge3;
}

/// A mesh as it stands in a file, nothing proved but that every node number exists. Other cells
/// (points) are left out; spatial cells are refused by the readers.
struct RawMesh
{
    struct Cell
    {
        CellKind kind;
        std::uint32_t firstNode; ///< in cellNodes
        std::int64_t number;     ///< in the file
    };

    std::vector<std::array<double, 3>> nodes;
    std::vector<std::int64_t> nodeNumber; ///< in the file
    std::vector<Cell> cells;
    std::vector<std::uint32_t> cellNodes; ///< indices into nodes

    std::span<const std::uint32_t> nodesOfCell(const Cell& cell) const
    {
        return {cellNodes.data() + cell.firstNode, nodesOf(cell.kind)};
    }
};

} // namespace tessera
