// SPDX-License-Identifier: MIT
//
// Chains of polygons are spatially coherent: between two places where the direction changes its
// quadrant a run of segments stays in the box of its two ends, and so does every part of it. Where
// the box of a part meets no other one, the part can be replaced by its chord within the box without
// anything else noticing: the plane is divided in the same way. Boxes that meet are halved until
// they are apart or hold one segment, so that crossings, touches and overlaps are found between the
// segments of the input, by boundary recovery as ever.
//
// Guarantees. Decisions are comparisons of coordinates of the input: exact. A crossing of two
// segments, correctly rounded, stays in the boxes of both, so that no rounding carries it into the
// box of a chord. The boxes of neighbors share their common end, and may share a side through it if
// no chord runs along that side, because then only the common end is on both hulls. Coincident
// points of different ids, points on no segment and hole points count as boxes too.
//
// Cost: O(n), plus the pairs of boxes that meet; gives up when these are many, or when the runs are
// short (rough outlines): then there is no coherence to use.
#include "imprint/contraction.h"

#include "base/box2.h"
#include "recover/constraint_map.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tessera
{

namespace
{

constexpr std::size_t kFewest = 64;          ///< segments for which it is worth the trouble
constexpr std::size_t kMeanRun = 4;          ///< segments a run, at least
constexpr std::size_t kVisitsPerSegment = 4; ///< pairs of boxes looked at, at most

class Contractor
{
public:
    Contractor(const Pslg& pslg, const CurveNetwork& network, Execution& execution)
        : pslg_(pslg)
        , network_(network)
        , execution_(execution)
        , count_(static_cast<std::uint32_t>(pslg.segments.size()))
        , visitsLeft_(kVisitsPerSegment * pslg.segments.size())
    {}

    std::optional<Contraction> run()
    {
        if (count_ < kFewest) {
            return std::nullopt;
        }
        countDegrees();
        if (!findRuns() || !addObstacles() || !separate()) {
            return std::nullopt;
        }
        return take();
    }

private:
    /// Segments first .. last - 1, or a point that no chord may pass.
    struct Run
    {
        std::uint32_t first;
        std::uint32_t last;
        Vec2 from;
        Vec2 to;
        Box2 box;

        bool isPoint() const { return first == last; }
        bool isChord() const { return last - first > 1; }
    };

    Vec2 startOf(std::uint32_t segment) const
    {
        return pslg_.points[pslg_.segments[segment].a.index()];
    }
    Vec2 endOf(std::uint32_t segment) const
    {
        return pslg_.points[pslg_.segments[segment].b.index()];
    }

    static Box2 boxOf(Vec2 a, Vec2 b)
    {
        return {{std::min(a.x, b.x), std::min(a.y, b.y)},
                {std::max(a.x, b.x), std::max(a.y, b.y)}};
    }

    Run runOf(std::uint32_t first, std::uint32_t last) const
    {
        const Vec2 from = startOf(first);
        const Vec2 to = endOf(last - 1);
        return {first, last, from, to, boxOf(from, to)};
    }

    void countDegrees()
    {
        degree_.assign(pslg_.points.size(), 0);
        for (const PslgSegment& segment : pslg_.segments) {
            for (const PointId p : {segment.a, segment.b}) {
                degree_[p.index()] = static_cast<std::uint8_t>(
                    std::min(degree_[p.index()] + 1, 3));
            }
        }
    }

    /// Whether the two may be replaced by one segment that does what both do.
    bool sameKind(CurveId c, CurveId d) const
    {
        if (c == d) {
            return true;
        }
        const NetworkCurve& curve = network_.curves[c.index()];
        const NetworkCurve& other = network_.curves[d.index()];
        return curve.operand == other.operand && curve.role == other.role
            && curve.component == other.component;
    }

    /// Marks where runs begin: the greatest ones that stay in a quadrant of directions.
    bool findRuns()
    {
        begins_.assign(count_ + 1U, 0);
        begins_[count_] = 1;
        Vec2 direction {}; // signs of those of the run so far
        for (std::uint32_t s = 0; s < count_; ++s) {
            const PslgSegment& segment = pslg_.segments[s];
            const Vec2 step = endOf(s) - startOf(s);
            const Vec2 signs {double((step.x > 0.0) - (step.x < 0.0)),
                              double((step.y > 0.0) - (step.y < 0.0))};
            const bool isPoint = signs.x == 0.0 && signs.y == 0.0;
            const bool goesOn = s > 0 && !isPoint && pslg_.segments[s - 1].b == segment.a
                && degree_[segment.a.index()] == 2 && !beforeIsPoint_
                && signs.x * direction.x >= 0.0 && signs.y * direction.y >= 0.0
                && sameKind(pslg_.segments[s - 1].curve, segment.curve);
            if (goesOn) {
                direction = {signs.x != 0.0 ? signs.x : direction.x,
                             signs.y != 0.0 ? signs.y : direction.y};
            }
            else {
                begins_[s] = 1;
                direction = signs;
                runs_.push_back({s, s, {}, {}, {}});
                if (runs_.size() * kMeanRun > count_) {
                    return false;
                }
            }
            beforeIsPoint_ = isPoint;
        }
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            runs_[i] = runOf(runs_[i].first, i + 1 < runs_.size() ? runs_[i + 1].first : count_);
        }
        return true;
    }

    bool addObstacles()
    {
        const auto add = [this](Vec2 p) { runs_.push_back({0, 0, p, p, {p, p}}); };
        for (std::size_t p = 0; p < pslg_.points.size(); ++p) {
            if (degree_[p] == 0) {
                add(pslg_.points[p]);
            }
        }
        for (const HolePoint& hole : network_.holes) {
            add(hole.position);
        }
        for (const RegionPoint& region : network_.regions) {
            add(region.position);
        }
        return runs_.size() * kMeanRun <= count_;
    }

    /// Compares the runs' boxes, in the order of their left sides.
    bool separate()
    {
        std::sort(runs_.begin(), runs_.end(), [](const Run& r, const Run& s) {
            return r.box.min.x != s.box.min.x ? r.box.min.x < s.box.min.x : r.first < s.first;
        });
        std::vector<std::uint32_t> open; // those that reach as far as the one under way
        for (std::uint32_t i = 0; i < runs_.size(); ++i) {
            execution_.checkpoint();
            std::erase_if(open, [&](std::uint32_t o) {
                return runs_[o].box.max.x < runs_[i].box.min.x;
            });
            for (const std::uint32_t o : open) {
                if (!separatePair(runs_[o], runs_[i])) {
                    return false;
                }
            }
            open.push_back(i);
        }
        return true;
    }

    /// Halves two runs until their parts are apart. A part that is halved never becomes a piece, so
    /// any two pieces end as a pair that was looked at, or within one.
    bool separatePair(const Run& r, const Run& s)
    {
        stack_.assign({{r, s}});
        while (!stack_.empty()) {
            if (visitsLeft_-- == 0) {
                return false;
            }
            auto [a, b] = stack_.back();
            stack_.pop_back();
            if (!a.box.overlaps(b.box) || (!a.isChord() && !b.isChord()) || meetAtEnd(a, b)) {
                continue;
            }
            if (a.last - a.first < b.last - b.first) {
                std::swap(a, b);
            }
            const std::uint32_t middle = a.first + (a.last - a.first) / 2;
            begins_[middle] = 1;
            stack_.push_back({runOf(a.first, middle), b});
            stack_.push_back({runOf(middle, a.last), b});
        }
        return true;
    }

    /// Whether a common end is all that the two share, whatever becomes of each within its box.
    bool meetAtEnd(const Run& a, const Run& b) const
    {
        const Box2 common {{std::max(a.box.min.x, b.box.min.x), std::max(a.box.min.y, b.box.min.y)},
                           {std::min(a.box.max.x, b.box.max.x), std::min(a.box.max.y, b.box.max.y)}};
        const bool flatX = common.min.x == common.max.x;
        const bool flatY = common.min.y == common.max.y;
        for (const Vec2 p : {a.from, a.to}) {
            if ((p != b.from && p != b.to) || !common.contains(p)) {
                continue;
            }
            if (flatX && flatY) {
                return true;
            }
            if ((flatX || flatY) && leavesLine(a, p, flatX) && leavesLine(b, p, flatX)) {
                return true;
            }
        }
        return false;
    }

    /// Whether a chord's run has only its end p on the vertical (or horizontal) line through p.
    bool leavesLine(const Run& run, Vec2 p, bool vertical) const
    {
        if (!run.isChord()) {
            return true;
        }
        const Vec2 next = p == run.from ? endOf(run.first) : startOf(run.last - 1);
        return vertical ? next.x != p.x : next.y != p.y;
    }

    std::optional<Contraction> take() const
    {
        Contraction result;
        for (std::uint32_t s = 0; s <= count_; ++s) {
            if (begins_[s] != 0) {
                result.firstSegment.push_back(s);
            }
        }
        if (result.pieceCount() * kMeanRun > count_) {
            return std::nullopt;
        }
        std::vector<PointId> newPoint(pslg_.points.size());
        const auto keep = [&](PointId p) {
            if (!newPoint[p.index()].valid()) {
                newPoint[p.index()] = PointId(result.point.size());
                result.point.push_back(p.value);
                result.pslg.points.push_back(pslg_.points[p.index()]);
            }
            return newPoint[p.index()];
        };
        for (std::size_t i = 0; i < result.pieceCount(); ++i) {
            const PslgSegment& first = pslg_.segments[result.firstSegment[i]];
            const PslgSegment& last = pslg_.segments[result.firstSegment[i + 1] - 1];
            const PointId a = keep(first.a);
            result.pslg.segments.push_back({a, keep(last.b), first.curve, first.ta, last.tb});
        }
        for (std::size_t p = 0; p < degree_.size(); ++p) {
            if (degree_[p] == 0) {
                keep(PointId(p));
            }
        }
        return result;
    }

    const Pslg& pslg_;
    const CurveNetwork& network_;
    Execution& execution_;
    std::uint32_t count_;
    std::size_t visitsLeft_;
    bool beforeIsPoint_ = false;
    std::vector<std::uint8_t> degree_; ///< by point, at most 3
    std::vector<std::uint8_t> begins_; ///< by segment, one more: a piece begins here
    std::vector<Run> runs_;
    std::vector<std::pair<Run, Run>> stack_;
};

class Expander
{
public:
    Expander(const Contraction& contraction, const Pslg& pslg, const RecoveryResult& recovered,
             std::span<const std::uint32_t> vertexOfPoint)
        : contraction_(contraction)
        , pslg_(pslg)
        , from_(recovered)
    {
        numberVertices(vertexOfPoint);
    }

    ExpandedOverlay run(const Polygons& polygons)
    {
        expandConstraints();
        expandPolygons(polygons);
        return std::move(result_);
    }

private:
    void numberVertices(std::span<const std::uint32_t> vertexOfPoint)
    {
        const std::vector<Vec2>& contracted = from_.triangulation.points;
        std::vector<std::uint32_t> contractedVertex(pslg_.points.size(), 0);
        for (std::size_t p = 0; p < contraction_.point.size(); ++p) {
            contractedVertex[contraction_.point[p]] = vertexOfPoint[p];
        }
        expanded_.assign(contracted.size(), 0);
        std::vector<Vec2>& points = result_.recovered.triangulation.points;
        points.reserve(pslg_.points.size() + contracted.size());
        points.push_back(contracted.empty() ? Vec2 {} : contracted.front());
        const auto add = [&points](Vec2 p) {
            points.push_back(p);
            return static_cast<std::uint32_t>(points.size() - 1);
        };
        result_.vertexOfPoint.resize(pslg_.points.size());
        for (std::size_t p = 0; p < pslg_.points.size(); ++p) {
            const std::uint32_t v = contractedVertex[p];
            if (v != 0 && expanded_[v] != 0) {
                result_.vertexOfPoint[p] = expanded_[v];
                continue;
            }
            result_.vertexOfPoint[p] = add(pslg_.points[p]);
            if (v != 0) {
                expanded_[v] = result_.vertexOfPoint[p];
            }
        }
        result_.recovered.firstCrossing = static_cast<std::uint32_t>(points.size());
        for (std::size_t v = from_.firstCrossing; v < contracted.size(); ++v) {
            expanded_[v] = add(contracted[v]);
        }
    }

    void expandConstraints()
    {
        RecoveryResult& recovered = result_.recovered;
        recovered.report = from_.report;
        ConstraintMap& map = recovered.constraints;
        map.chainStart.reserve(pslg_.segments.size() + 1);
        map.chainVertices.reserve(2 * pslg_.segments.size()
                                  + from_.constraints.chainVertices.size());
        for (std::size_t i = 0; i < contraction_.pieceCount(); ++i) {
            if (!contraction_.isChord(i)) {
                map.chainStart.push_back(static_cast<std::uint32_t>(map.chainVertices.size()));
                for (const std::uint32_t v : from_.constraints.chainOf(ConstraintId(i))) {
                    map.chainVertices.push_back(expanded_[v]);
                }
                continue;
            }
            for (std::uint32_t s = contraction_.firstSegment[i];
                 s < contraction_.firstSegment[i + 1]; ++s) {
                map.chainStart.push_back(static_cast<std::uint32_t>(map.chainVertices.size()));
                map.chainVertices.push_back(result_.vertexOfPoint[pslg_.segments[s].a.index()]);
                map.chainVertices.push_back(result_.vertexOfPoint[pslg_.segments[s].b.index()]);
            }
        }
        map.chainStart.push_back(static_cast<std::uint32_t>(map.chainVertices.size()));
        addSubsegments(map, recovered.triangulation.points.size());
    }

    void expandPolygons(const Polygons& polygons)
    {
        Polygons& out = result_.polygons;
        out.polygonStart = polygons.polygonStart;
        out.loopStart.reserve(polygons.loopStart.size());
        for (std::size_t l = 0; l + 1 < polygons.loopStart.size(); ++l) {
            const std::size_t begin = polygons.loopStart[l];
            const std::size_t size = polygons.loopStart[l + 1] - begin;
            for (std::size_t k = 0; k < size; ++k) {
                appendSide(polygons.vertices[begin + k],
                           polygons.vertices[begin + (k + 1) % size]);
            }
            out.loopStart.push_back(static_cast<std::uint32_t>(out.vertices.size()));
        }
    }

    /// A side of a loop without its end.
    void appendSide(std::uint32_t a, std::uint32_t b)
    {
        std::vector<std::uint32_t>& out = result_.polygons.vertices;
        out.push_back(expanded_[a]);
        const Subsegment* side = findSubsegment(from_.constraints, a, b);
        const ConstraintUse use = from_.constraints.usesOf(*side).front();
        if (!contraction_.isChord(use.constraint.index())) {
            return;
        }
        const std::uint32_t first = contraction_.firstSegment[use.constraint.index()];
        const std::uint32_t last = contraction_.firstSegment[use.constraint.index() + 1];
        const auto append = [&](std::uint32_t segment) {
            out.push_back(result_.vertexOfPoint[pslg_.segments[segment].a.index()]);
        };
        if ((a < b) == use.forward) {
            for (std::uint32_t s = first + 1; s < last; ++s) {
                append(s);
            }
        }
        else {
            for (std::uint32_t s = last - 1; s > first; --s) {
                append(s);
            }
        }
    }

    const Contraction& contraction_;
    const Pslg& pslg_;
    const RecoveryResult& from_;
    std::vector<std::uint32_t> expanded_; ///< by vertex of the contraction
    ExpandedOverlay result_;
};

} // namespace

std::optional<Contraction> contract(const Pslg& pslg, const CurveNetwork& network,
                                    Execution& execution)
{
    return Contractor(pslg, network, execution).run();
}

bool isExpandable(const Contraction& contraction, const RecoveryResult& recovered)
{
    if (recovered.report.snapPixel != 0.0) {
        return false;
    }
    for (std::size_t i = 0; i < contraction.pieceCount(); ++i) {
        if (!contraction.isChord(i)) {
            continue;
        }
        const auto chain = recovered.constraints.chainOf(ConstraintId(i));
        if (chain.size() != 2
            || findSubsegment(recovered.constraints, chain[0], chain[1])->useCount != 1) {
            return false;
        }
    }
    return true;
}

ExpandedOverlay expand(const Contraction& contraction, const Pslg& pslg,
                       const RecoveryResult& recovered,
                       std::span<const std::uint32_t> vertexOfPoint, const Polygons& polygons)
{
    return Expander(contraction, pslg, recovered, vertexOfPoint).run(polygons);
}

std::vector<double> runAreas(const Contraction& contraction, const Pslg& pslg)
{
    std::vector<double> areas(contraction.pieceCount(), 0.0);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const std::uint32_t first = contraction.firstSegment[i];
        const Vec2 from = pslg.points[pslg.segments[first].a.index()];
        Vec2 before {};
        for (std::uint32_t s = first; s < contraction.firstSegment[i + 1]; ++s) {
            const Vec2 step = pslg.points[pslg.segments[s].b.index()] - from;
            areas[i] += 0.5 * cross(before, step);
            before = step;
        }
    }
    return areas;
}

} // namespace tessera
