// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"
#include "imprint/inscribed_circle.h"
#include "imprint/overlay.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// The bounded faces of an overlay with operation Cells: its cells, then the gaps that they enclose.
/// Gaps run through lines that separate nothing.
class Patches
{
public:
    static constexpr std::uint32_t kOutside = 0xffffffffU;

    explicit Patches(const OverlayResult& overlay);

    std::uint32_t size() const { return static_cast<std::uint32_t>(start_.size() - 1); }
    std::uint32_t cellCount() const { return cellCount_; }
    bool isGap(std::uint32_t patch) const { return patch >= cellCount_; }
    std::uint32_t of(std::uint32_t triangle) const { return patchOf_[triangle]; }
    /// Its triangles, ascending.
    std::span<const std::uint32_t> trianglesOf(std::uint32_t patch) const
    {
        return {triangles_.data() + start_[patch], start_[patch + 1] - start_[patch]};
    }

    /// A patch beside another one and how much border they share.
    struct Neighbor
    {
        std::uint32_t patch; ///< or kOutside
        double border;
    };
    /// Ascending by patch.
    std::vector<Neighbor> neighborsOf(std::uint32_t patch) const;

    double area(std::uint32_t patch) const;
    double perimeter(std::uint32_t patch) const;
    /// limit: as for largestCircleIn().
    InscribedCircle circleIn(std::uint32_t patch, double limit = 0.0) const;
    bool contains(std::uint32_t patch, Vec2 p) const;

private:
    void fillGaps();

    const Triangulation& mesh_;
    std::uint32_t cellCount_;
    std::vector<std::uint32_t> patchOf_; ///< by triangle
    std::vector<std::uint32_t> triangles_;
    std::vector<std::uint32_t> start_;
};

} // namespace tessera
