// SPDX-License-Identifier: MIT
//
// The paper's flood fill (section 3, step 2, and section 4), in two levels. Triangles that no
// subsegment separates are one face (rule 2 needs no more); the walk from face to face crosses one
// border at a time and carries the winding numbers along (rule 1 and its generalization), so that a
// place's operands are known without storing them for each triangle or face. Faces between which
// nothing changes are joined to regions.
//
// Cost: O(triangles) for the faces; each face is entered and left once, at the cost of the operands
// that change there; regions list their operands. Nothing grows with triangles x operands.
#include "region/region.h"

#include "region/borders.h"
#include "region/cover.h"
#include "region/faces.h"
#include "region/hull_slivers.h"
#include "region/marked_points.h"
#include "region/region_order.h"
#include "region/subsegment_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tessera
{

namespace
{

class Coloring
{
public:
    Coloring(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
             FillRule fill, Execution& execution)
        : recovered_(recovered)
        , network_(network)
        , fill_(fill)
        , execution_(execution)
        , graph_(recovered)
        , borders_(findBorders(recovered, network, pslg, fill, graph_))
        , faces_(fill == FillRule::Hull
                     ? buildHullFaces(recovered, graph_,
                                      findHullSlivers(recovered, network, pslg), execution)
                     : buildFaces(recovered, graph_, execution))
        , marked_(markFaces(recovered, network, pslg, faces_, fill != FillRule::All, execution))
        , faceParent_(faces_.faceCount)
    {
        std::iota(faceParent_.begin(), faceParent_.end(), 0U);
        map_.messages = borders_.messages;
        map_.messages.insert(map_.messages.end(), marked_.messages.begin(),
                             marked_.messages.end());
    }

    RegionMap run()
    {
        joinFaces();
        numberRegions();
        describeRegions();
        sumAreas();
        markBoundary();
        if (fill_ == FillRule::EvenOdd) {
            countHoles();
        }
        return std::move(map_);
    }

private:
    bool removed(std::uint32_t face, std::uint32_t operand) const
    {
        return !marked_.hasRemoval.empty() && marked_.hasRemoval[face] != 0
            && std::binary_search(marked_.removed.begin(), marked_.removed.end(),
                                  std::pair(face, operand));
    }

    /// Whether the two sides of a link differ: in the operands that cover them after hole points,
    /// or in what region points say. cover is that of face `here`.
    bool differ(const FaceLink& link, std::uint32_t here, std::uint32_t beyond,
                const Cover& cover) const
    {
        if (link.subsegment == FaceLink::kNoSubsegment || fill_ == FillRule::All) {
            return true;
        }
        if (fill_ == FillRule::Hull && std::min(here, beyond) == 0) {
            return true; // open curves and constraints may lie on the hull
        }
        const auto border = borders_.of(link.subsegment);
        const bool leftToRight = link.left == here;
        for (const BorderCrossing& c : border) {
            const bool coversHere = cover.coversHere(c) && !removed(here, c.operand);
            const bool coversBeyond =
                cover.coversBeyond(c, leftToRight) && !removed(beyond, c.operand);
            if (coversHere != coversBeyond) {
                return true;
            }
        }
        return differByHoles(here, beyond, border, cover)
            || differByHoles(beyond, here, border, cover) || differByRegionPoints(here, beyond);
    }

    /// An operand without a border here covers both faces, but a hole point takes one away.
    bool differByHoles(std::uint32_t with, std::uint32_t without,
                       std::span<const BorderCrossing> border, const Cover& cover) const
    {
        if (marked_.hasRemoval.empty() || marked_.hasRemoval[with] == 0) {
            return false;
        }
        auto entry = std::lower_bound(marked_.removed.begin(), marked_.removed.end(),
                                      std::pair(with, 0U));
        for (; entry != marked_.removed.end() && entry->first == with; ++entry) {
            const std::uint32_t operand = entry->second;
            const bool crosses =
                std::any_of(border.begin(), border.end(),
                            [operand](const BorderCrossing& c) { return c.operand == operand; });
            if (!crosses && cover.covers(OperandId(operand)) && !removed(without, operand)) {
                return true;
            }
        }
        return false;
    }

    bool differByRegionPoints(std::uint32_t here, std::uint32_t beyond) const
    {
        if (marked_.regionPoint.empty()) {
            return false;
        }
        const auto valuesOf = [this](std::uint32_t face) {
            const std::uint32_t i = marked_.regionPoint[face];
            return i == MarkedFaces::kNoPoint
                ? std::pair(0.0, 0.0)
                : std::pair(network_.regions[i].attribute, network_.regions[i].maxArea);
        };
        return valuesOf(here) != valuesOf(beyond);
    }

    std::uint32_t rootOf(std::uint32_t face)
    {
        while (faceParent_[face] != face) {
            faceParent_[face] = faceParent_[faceParent_[face]];
            face = faceParent_[face];
        }
        return face;
    }

    /// First walk: joins faces between which nothing differs, and notes on which side of each
    /// border its operand covers.
    void joinFaces()
    {
        coversLeft_.assign(borders_.crossings.size(), 0);
        declaredHoles_.assign(network_.operands.size(), 0);
        Cover cover(fill_, network_.operands.size());
        walkFaces(faces_, borders_, cover, execution_,
                  [this](std::uint32_t face, const Cover& here, std::uint32_t) {
                      joinFace(face, here);
                      countDeclaredHoles(face, here);
                  });
    }

    void countDeclaredHoles(std::uint32_t face, const Cover& here)
    {
        auto hole = std::lower_bound(marked_.holes.begin(), marked_.holes.end(),
                                     std::pair(face, 0U));
        for (; hole != marked_.holes.end() && hole->first == face; ++hole) {
            declaredHoles_[hole->second] += here.covers(OperandId(hole->second)) ? 0 : 1;
        }
    }

    void joinFace(std::uint32_t face, const Cover& here)
    {
        for (const std::uint32_t i : faces_.linksOf(face)) {
            const FaceLink& link = faces_.links[i];
            const std::uint32_t beyond = faces_.across(i, face);
            if (link.left == face && link.subsegment != FaceLink::kNoSubsegment) {
                const std::uint32_t first = borders_.start[link.subsegment];
                const auto border = borders_.of(link.subsegment);
                for (std::uint32_t k = 0; k < border.size(); ++k) {
                    coversLeft_[first + k] = here.coversHere(border[k]) ? 1 : 0;
                }
            }
            if (face < beyond && !differ(link, face, beyond, here)) {
                const std::uint32_t p = rootOf(face);
                const std::uint32_t q = rootOf(beyond);
                faceParent_[std::max(p, q)] = std::min(p, q);
            }
        }
    }

    void numberRegions()
    {
        regionOfFace_.resize(faces_.faceCount);
        std::uint32_t count = 0;
        for (std::uint32_t f = 0; f < faces_.faceCount; ++f) {
            const std::uint32_t root = rootOf(f);
            regionOfFace_[f] = root == f ? count++ : regionOfFace_[root];
        }
        map_.regions.resize(count);
        std::vector<std::uint32_t> regionOf = faces_.faceOfTriangle;
        for (std::uint32_t& region : regionOf) {
            region = region == FaceGraph::kNoFace ? kNoRegion : regionOfFace_[region];
        }
        const auto numbers = orderOfRegions(recovered_.triangulation, regionOf, count);
        for (std::uint32_t& region : regionOfFace_) {
            region = numbers[region];
        }
    }

    /// Second walk: each region's operands, from the first of its faces that is reached.
    void describeRegions()
    {
        std::vector<std::uint8_t> described(map_.regions.size(), 0);
        Cover cover(fill_, network_.operands.size());
        walkFaces(faces_, borders_, cover, execution_,
                  [this, &described](std::uint32_t face, const Cover& here, std::uint32_t) {
                      const std::uint32_t r = regionOfFace_[face];
                      if (described[r] == 0) {
                          described[r] = 1;
                          describe(map_.regions[r], face, here);
                      }
                  });
        for (const Region& region : map_.regions) {
            map_.keptRegions += region.inside ? 1 : 0;
        }
    }

    void describe(Region& region, std::uint32_t face, const Cover& here) const
    {
        for (const OperandId operand : here.covering()) {
            if (!removed(face, operand.value)) {
                region.operands.push_back(operand);
            }
        }
        region.inside = !region.operands.empty();
        if (fill_ == FillRule::Hull && face != 0) {
            const bool hole = !marked_.hasRemoval.empty() && marked_.hasRemoval[face] != 0;
            region.inside = region.inside || !hole;
            if (region.inside && region.operands.empty() && network_.operands.size() == 1) {
                region.operands.push_back(OperandId(0U));
            }
        }
        if (!marked_.regionPoint.empty() && marked_.regionPoint[face] != MarkedFaces::kNoPoint) {
            const RegionPoint& point = network_.regions[marked_.regionPoint[face]];
            region.attribute = point.attribute;
            region.maxArea = point.maxArea;
        }
    }

    void sumAreas()
    {
        const Triangulation& t = recovered_.triangulation;
        map_.regionOfTriangle.assign(t.triangles.size(), RegionId());
        for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
            if (!t.isFinite(i)) {
                continue;
            }
            const RegionId region(regionOfFace_[faces_.faceOfTriangle[i]]);
            map_.regionOfTriangle[i] = region;
            const auto& v = t.triangles[i].v;
            map_.regions[region.index()].area +=
                0.5 * cross(t.points[v[1]] - t.points[v[0]], t.points[v[2]] - t.points[v[0]]);
        }
    }

    void markBoundary()
    {
        const std::size_t count = recovered_.constraints.subsegments.size();
        map_.isBoundary.resize(count);
        map_.isOutside.resize(count);
        for (std::size_t s = 0; s < count; ++s) {
            const FaceLink& link = faces_.links[s];
            const std::uint32_t left = regionOfFace_[link.left];
            const std::uint32_t right = regionOfFace_[link.right];
            map_.isBoundary[s] = left != right ? 1 : 0;
            map_.isOutside[s] = map_.regions[left].inside || map_.regions[right].inside ? 0 : 1;
        }
    }

    /// The borders of each operand, directed with the covered side on the left, form a clockwise
    /// loop around every hole.
    void countHoles()
    {
        struct Entry
        {
            std::uint32_t operand;
            DirectedSubsegment border;
        };
        std::vector<Entry> entries;
        for (std::uint32_t s = 0; s + 1 < borders_.start.size(); ++s) {
            for (std::uint32_t k = borders_.start[s]; k < borders_.start[s + 1]; ++k) {
                const std::uint32_t operand = borders_.crossings[k].operand;
                if (!network_.operands[operand].declaresHoles
                    && faces_.links[s].left != faces_.links[s].right) {
                    entries.push_back({operand, {s, coversLeft_[k] != 0}});
                }
            }
        }
        std::stable_sort(entries.begin(), entries.end(),
                         [](const Entry& a, const Entry& b) { return a.operand < b.operand; });
        std::vector<DirectedSubsegment> borders;
        for (std::size_t i = 0; i < entries.size();) {
            borders.clear();
            const std::uint32_t operand = entries[i].operand;
            for (; i < entries.size() && entries[i].operand == operand; ++i) {
                borders.push_back(entries[i].border);
            }
            std::size_t holes = 0;
            for (const auto& loop : graph_.loopsAroundOutside(borders)) {
                holes += signedArea(loop) < 0.0 ? 1 : 0;
            }
            map_.loopsMadeHoles += holes - std::min<std::size_t>(holes, declaredHoles_[operand]);
        }
        if (map_.loopsMadeHoles > 0) {
            const bool one = map_.loopsMadeHoles == 1;
            map_.messages.push_back(std::to_string(map_.loopsMadeHoles)
                                    + (one ? " loop inside others became a hole"
                                           : " loops inside others became holes")
                                    + "; the fill rule 'all' keeps "
                                    + (one ? "it." : "them."));
        }
    }

    double signedArea(const std::vector<DirectedSubsegment>& loop) const
    {
        const auto& points = recovered_.triangulation.points;
        const Vec2 origin = points[graph_.startOf(loop.front())];
        double twice = 0.0;
        for (const DirectedSubsegment& step : loop) {
            twice += cross(points[graph_.startOf(step)] - origin,
                           points[graph_.endOf(step)] - origin);
        }
        return 0.5 * twice;
    }

    const RecoveryResult& recovered_;
    const CurveNetwork& network_;
    FillRule fill_;
    Execution& execution_;
    SubsegmentGraph graph_;
    Borders borders_;
    FaceGraph faces_;
    MarkedFaces marked_;
    std::vector<std::uint32_t> faceParent_;
    std::vector<std::uint32_t> regionOfFace_;
    std::vector<std::uint8_t> coversLeft_; ///< by crossing
    /// By operand: hole points in places that parity leaves uncovered anyway.
    std::vector<std::uint32_t> declaredHoles_;
    RegionMap map_;
};

} // namespace

std::vector<std::uint32_t> outerSeeds(const Triangulation& triangulation)
{
    std::vector<std::uint32_t> seeds;
    for (std::uint32_t t = 0; t < triangulation.triangles.size(); ++t) {
        if (!triangulation.isDead(t) && triangulation.isGhost(t)) {
            seeds.push_back(t);
        }
    }
    return seeds;
}

RegionMap colorRegions(const RecoveryResult& recovered, const CurveNetwork& network,
                       const Pslg& pslg, FillRule fill, Execution& execution)
{
    return Coloring(recovered, network, pslg, fill, execution).run();
}

} // namespace tessera
