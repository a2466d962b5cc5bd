// SPDX-License-Identifier: MIT
#pragma once

#include "io/raw_mesh.h"
#include "io/text_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

namespace tessera
{

/// Adds nodes and cells of a file to a RawMesh and turns the file's node numbers into indices.
class RawMeshBuilder
{
public:
    explicit RawMeshBuilder(LineReader& lines)
        : lines_(lines)
    {}

    void addNode(std::int64_t number, std::array<double, 3> position)
    {
        // Nearly all files number from 1 without gaps; others pay for a map.
        const std::size_t index = mesh_.nodes.size();
        if (number != static_cast<std::int64_t>(index) + 1 || !indexOf_.empty()) {
            useMap();
            if (!indexOf_.try_emplace(number, static_cast<std::uint32_t>(index)).second) {
                lines_.fail(fmt::format("there are two nodes {}; give each its own number.",
                                        number));
            }
        }
        mesh_.nodes.push_back(position);
        mesh_.nodeNumber.push_back(number);
    }

    /// Starts a cell; its nodes follow.
    void beginCell(CellKind kind, std::int64_t number)
    {
        mesh_.cells.push_back(
            {kind, static_cast<std::uint32_t>(mesh_.cellNodes.size()), number});
    }
    /// A node of the last cell, by its number in the file.
    void addCellNode(std::int64_t number)
    {
        mesh_.cellNodes.push_back(indexOf(number));
    }
    bool hasNode(std::int64_t number) const { return find(number).has_value(); }
    RawMesh take() { return std::move(mesh_); }
    RawMesh& mesh() { return mesh_; }
    const RawMesh& mesh() const { return mesh_; }

private:
    void useMap()
    {
        for (std::size_t i = indexOf_.size(); i < mesh_.nodes.size(); ++i) {
            indexOf_.emplace(mesh_.nodeNumber[i], static_cast<std::uint32_t>(i));
        }
    }
    std::optional<std::uint32_t> find(std::int64_t number) const
    {
        if (indexOf_.empty()) {
            if (number >= 1 && number <= static_cast<std::int64_t>(mesh_.nodes.size())) {
                return static_cast<std::uint32_t>(number - 1);
            }
        }
        else if (const auto found = indexOf_.find(number); found != indexOf_.end()) {
            return found->second;
        }
        return std::nullopt;
    }
    std::uint32_t indexOf(std::int64_t number) const
    {
        if (const std::optional<std::uint32_t> index = find(number)) {
            return *index;
        }
        lines_.fail(fmt::format("there is no node {}.", number));
    }

    LineReader& lines_;
    RawMesh mesh_;
    std::unordered_map<std::int64_t, std::uint32_t> indexOf_; ///< empty: number - 1
};

} // namespace tessera
