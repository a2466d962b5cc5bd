// SPDX-License-Identifier: MIT
//
// The borders of a connected set of triangles, with the set on the left, turn at each vertex
// through the outside. Where a set passes a vertex twice, the wedges of outside between its own
// wedges are parts of different holes (or a hole and the outer space): a path through the set from
// one wedge to the other closes around one of them. So no loop passes a vertex twice, exactly one
// is outer, and the inside stays in one piece.
#include "region/region_outlines.h"

#include "predicates/predicates.h"

#include <algorithm>
#include <utility>

namespace tessera
{

namespace
{

constexpr std::uint32_t kNone = 0xffffffffU;

class OutlineTracer
{
public:
    OutlineTracer(const Triangulation& t, const RegionMap& map,
                  std::span<const std::uint32_t> labelOfRegion)
        : t_(t)
        , map_(map)
        , labelOfRegion_(labelOfRegion)
        , partOf_(t.triangles.size(), kNone)
    {}

    std::vector<RegionOutline> run()
    {
        findParts();
        collectBorders();
        std::vector<RegionOutline> outlines(labels_.size());
        std::size_t begin = 0;
        for (std::uint32_t part = 0; part < labels_.size(); ++part) {
            outlines[part].label = labels_[part];
            std::size_t end = begin;
            while (end < borders_.size() && borders_[end].part == part) {
                ++end;
            }
            outlines[part].loops = trace(part, {borders_.data() + begin, end - begin});
            begin = end;
        }
        std::stable_sort(
            outlines.begin(), outlines.end(),
            [](const RegionOutline& a, const RegionOutline& b) { return a.label < b.label; });
        return outlines;
    }

private:
    /// A half-edge of a part's triangle to a triangle outside the part.
    struct Border
    {
        std::uint32_t part;
        std::uint32_t origin;
        HalfEdge edge;
    };

    std::uint32_t labelAt(std::uint32_t triangle) const
    {
        const RegionId region = map_.regionOfTriangle[triangle];
        return region.valid() ? labelOfRegion_[region.index()] : kNoLabel;
    }

    void findParts()
    {
        std::vector<std::uint32_t> stack;
        for (std::uint32_t seed = 0; seed < t_.triangles.size(); ++seed) {
            const std::uint32_t label = labelAt(seed);
            if (label == kNoLabel || partOf_[seed] != kNone) {
                continue;
            }
            const auto part = static_cast<std::uint32_t>(labels_.size());
            labels_.push_back(label);
            partOf_[seed] = part;
            stack.push_back(seed);
            while (!stack.empty()) {
                const std::uint32_t triangle = stack.back();
                stack.pop_back();
                for (std::uint32_t i = 0; i < 3; ++i) {
                    const std::uint32_t next =
                        Topology::triangleOf(t_.twin(Topology::halfEdge(triangle, i)));
                    if (partOf_[next] == kNone && labelAt(next) == label) {
                        partOf_[next] = part;
                        stack.push_back(next);
                    }
                }
            }
        }
    }

    bool isBorder(HalfEdge h) const
    {
        return partOf_[Topology::triangleOf(h)] != partOf_[Topology::triangleOf(t_.twin(h))];
    }

    void collectBorders()
    {
        for (std::uint32_t triangle = 0; triangle < t_.triangles.size(); ++triangle) {
            if (partOf_[triangle] == kNone) {
                continue;
            }
            for (std::uint32_t i = 0; i < 3; ++i) {
                const HalfEdge h = Topology::halfEdge(triangle, i);
                if (isBorder(h)) {
                    borders_.push_back({partOf_[triangle], t_.origin(h), h});
                }
            }
        }
        std::sort(borders_.begin(), borders_.end(), [](const Border& a, const Border& b) {
            return a.part != b.part ? a.part < b.part
                                    : std::pair(a.origin, a.edge) < std::pair(b.origin, b.edge);
        });
    }

    std::vector<std::vector<std::uint32_t>> trace(std::uint32_t part,
                                                  std::span<const Border> borders) const
    {
        std::vector<std::vector<std::uint32_t>> loops;
        std::vector<std::uint8_t> traced(borders.size(), 0);
        for (std::size_t first = 0; first < borders.size(); ++first) {
            if (traced[first] != 0) {
                continue;
            }
            std::vector<std::uint32_t> loop;
            for (std::size_t i = first; traced[i] == 0; i = next(part, borders, borders[i].edge)) {
                traced[i] = 1;
                loop.push_back(borders[i].origin);
            }
            if (!loops.empty() && isCounterClockwise(loop)) {
                loops.insert(loops.begin(), std::move(loop));
            }
            else {
                loops.push_back(std::move(loop));
            }
        }
        return loops;
    }

    /// The border that follows h: the only one out of its end, or the first one after turning
    /// counter-clockwise from h through the outside.
    std::size_t next(std::uint32_t part, std::span<const Border> borders, HalfEdge h) const
    {
        const std::uint32_t vertex = t_.destination(h);
        const auto first = std::lower_bound(
            borders.begin(), borders.end(), vertex,
            [](const Border& border, std::uint32_t v) { return border.origin < v; });
        const auto index = static_cast<std::size_t>(first - borders.begin());
        if (index + 1 == borders.size() || borders[index + 1].origin != vertex) {
            return index;
        }
        HalfEdge out = t_.nextAround(t_.twin(h));
        while (partOf_[Topology::triangleOf(out)] != part) {
            out = t_.nextAround(out);
        }
        std::size_t i = index;
        while (borders[i].edge != out) {
            ++i;
        }
        return i;
    }

    bool isCounterClockwise(const std::vector<std::uint32_t>& loop) const
    {
        std::size_t smallest = 0;
        for (std::size_t i = 1; i < loop.size(); ++i) {
            const Vec2 a = t_.points[loop[i]];
            const Vec2 b = t_.points[loop[smallest]];
            if (a.x != b.x ? a.x < b.x : a.y < b.y) {
                smallest = i;
            }
        }
        const Vec2 before = t_.points[loop[(smallest + loop.size() - 1) % loop.size()]];
        const Vec2 after = t_.points[loop[(smallest + 1) % loop.size()]];
        return orient2d(before, t_.points[loop[smallest]], after) > 0;
    }

    const Triangulation& t_;
    const RegionMap& map_;
    std::span<const std::uint32_t> labelOfRegion_;
    std::vector<std::uint32_t> partOf_; ///< by triangle
    std::vector<std::uint32_t> labels_; ///< by part
    std::vector<Border> borders_;
};

} // namespace

std::vector<RegionOutline> regionOutlines(const RecoveryResult& recovered, const RegionMap& map,
                                          std::span<const std::uint32_t> labelOfRegion)
{
    return OutlineTracer(recovered.triangulation, map, labelOfRegion).run();
}

} // namespace tessera
