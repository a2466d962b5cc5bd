// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "region/borders.h"
#include "region/faces.h"
#include "region/fill_rules.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// The winding numbers of all operands at one place, and which operands cover it. Moves from face
/// to face by crossing borders, so that nothing is stored per face.
class Cover
{
public:
    Cover(FillRule rule, std::size_t operandCount)
        : rule_(rule)
        , winding_(operandCount, 0)
    {}

    /// Whether the operand of a crossing covers the place on this side and on the far side.
    bool coversHere(const BorderCrossing& c) const { return covers(winding_[c.operand]); }
    bool coversBeyond(const BorderCrossing& c, bool leftToRight) const
    {
        return covers(windingBeyond(c, leftToRight));
    }
    bool covers(OperandId operand) const { return covers(winding_[operand.index()]); }

    void cross(std::span<const BorderCrossing> border, bool leftToRight)
    {
        for (const BorderCrossing& c : border) {
            const bool before = coversHere(c);
            winding_[c.operand] = windingBeyond(c, leftToRight);
            const bool after = coversHere(c);
            if (before != after) {
                const auto place = std::lower_bound(covering_.begin(), covering_.end(),
                                                    OperandId(c.operand));
                if (after) {
                    covering_.insert(place, OperandId(c.operand));
                }
                else {
                    covering_.erase(place);
                }
            }
        }
    }

    /// The operands that cover the place, ascending.
    std::span<const OperandId> covering() const { return covering_; }

private:
    bool byParity() const { return rule_ == FillRule::EvenOdd || rule_ == FillRule::Hull; }
    bool covers(std::int32_t winding) const { return isInside(rule_, winding); }
    std::int32_t windingBeyond(const BorderCrossing& c, bool leftToRight) const
    {
        const std::int32_t here = winding_[c.operand];
        if (byParity()) {
            return rule1Outer(here == 0) ? 0 : 1; // even crossings are not kept
        }
        return leftToRight ? here - c.leftMinusRight : here + c.leftMinusRight;
    }

    FillRule rule_;
    std::vector<std::int32_t> winding_;
    std::vector<OperandId> covering_;
};

/// Instead of a link, for face 0.
inline constexpr std::uint32_t kNoLink = 0xffffffffU;

/// Depth-first walk over all faces from face 0, where nothing covers. Calls visit(face, cover,
/// entry) once for each, entry being the link by which it was reached. Borders are crossed twice for
/// each face. Faces that no link reaches are left out.
template<class Visit>
void walkFaces(const FaceGraph& faces, const Borders& borders, Cover& cover, Execution& execution,
               Visit visit)
{
    struct Step
    {
        std::uint32_t face;
        std::uint32_t entry; ///< link by which it was entered
        std::uint32_t next;  ///< position in its links
    };
    const auto cross = [&](std::uint32_t link, std::uint32_t from) {
        if (faces.links[link].subsegment != FaceLink::kNoSubsegment) {
            cover.cross(borders.of(faces.links[link].subsegment), faces.links[link].left == from);
        }
    };
    std::vector<std::uint8_t> reached(faces.faceCount, 0);
    std::vector<Step> stack {{0, kNoLink, 0}};
    reached[0] = 1;
    visit(0U, cover, kNoLink);
    std::uint64_t count = 0;
    while (!stack.empty()) {
        Step& step = stack.back();
        const auto links = faces.linksOf(step.face);
        if (step.next == links.size()) {
            const Step done = step;
            stack.pop_back();
            if (!stack.empty()) {
                cross(done.entry, done.face);
            }
            continue;
        }
        const std::uint32_t link = links[step.next++];
        const std::uint32_t beyond = faces.across(link, step.face);
        if (reached[beyond] != 0) {
            continue;
        }
        if ((++count & 0xfffU) == 0) {
            execution.checkpoint();
        }
        reached[beyond] = 1;
        cross(link, step.face);
        visit(beyond, cover, link);
        stack.push_back({beyond, link, 0});
    }
}

} // namespace tessera
