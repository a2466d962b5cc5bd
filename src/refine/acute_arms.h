// SPDX-License-Identifier: MIT
#pragma once

#include "refine/mesh_editor.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace tessera
{

/// Which straight lines of constrained edges beside kept triangles meet at less than 60 degrees.
/// Between two of them small angles stay near the corner, however finely they are divided.
class AcuteArms
{
public:
    /// Complexity: O(n log n) for n constrained edges.
    explicit AcuteArms(const MeshEditor& editor);

    /// Whether a constrained edge and the apex of its triangle lie on the arms of one such corner,
    /// and the middle of the edge no farther from it than the apex if an arm ends there.
    bool areAround(HalfEdge base) const;

    /// Whether small angles stay in the triangle anyway: it lies within three of its longest edges of
    /// such a corner, as far as it sees it, or its own corners lie on two arms that meet acutely.
    bool concern(std::uint32_t triangle) const;

private:
    using Lines = std::pair<std::uint32_t, std::uint32_t>;
    struct Corner
    {
        Lines lines;
        std::uint32_t vertex;
    };
    struct Arm
    {
        Vec2 along;
        std::uint32_t root;
    };

    std::uint32_t lineOf(std::uint32_t root);
    std::uint32_t lineAt(HalfEdge h) const;
    std::vector<std::uint32_t> linesAt(std::uint32_t v) const;
    void measureArms(std::uint32_t v);
    void joinAt(std::uint32_t v);
    template<class F>
    bool anyCorner(const Lines& lines, F&& isAround) const;
    bool isNearCorner(std::uint32_t triangle) const;
    bool holdAll(std::uint32_t triangle) const;
    bool meetAcutely(Lines lines, HalfEdge base, bool endsAtApex) const;

    const MeshEditor& editor_;
    const Triangulation& t_;
    std::vector<std::uint32_t> line_; ///< by root: one that stands for its line
    std::vector<Corner> corners_;     ///< sorted by lines
    std::vector<std::uint8_t> isCorner_; ///< by vertex
    std::vector<Arm> arms_;
};

} // namespace tessera
