// SPDX-License-Identifier: MIT
#include "region/subsegment_graph.h"

#include <algorithm>
#include <utility>

namespace tessera
{

namespace
{

constexpr std::uint32_t kNone = 0xffffffffU;

bool lexicographicallyLess(Vec2 a, Vec2 b)
{
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

/// The half-edge out of v from which ranks count: the first to a greater neighbor after a smaller
/// one. A hull vertex without smaller neighbors starts behind the ghosts instead.
HalfEdge firstAround(const Triangulation& t, std::uint32_t v)
{
    const auto isGreater = [&t, v](std::uint32_t w) {
        return w != Topology::kInfinite && lexicographicallyLess(t.points[v], t.points[w]);
    };
    HalfEdge afterGhost = t.incident[v];
    HalfEdge afterSmaller = Topology::kDead;
    t.forEachAround(v, [&](HalfEdge h) {
        const HalfEdge following = t.nextAround(h);
        const std::uint32_t w = t.destination(h);
        if (!isGreater(w) && isGreater(t.destination(following))) {
            (w == Topology::kInfinite ? afterGhost : afterSmaller) = following;
        }
    });
    return afterSmaller != Topology::kDead ? afterSmaller : afterGhost;
}

} // namespace

SubsegmentGraph::SubsegmentGraph(const RecoveryResult& recovered)
    : recovered_(recovered)
{
    const auto& subsegments = recovered.constraints.subsegments;
    halfEdge_.assign(subsegments.size(), Topology::kDead);
    firstAt_.assign(recovered.triangulation.points.size() + 1, 0);
    for (const Subsegment& s : subsegments) {
        ++firstAt_[s.a + 1];
    }
    for (std::size_t v = 1; v < firstAt_.size(); ++v) {
        firstAt_[v] += firstAt_[v - 1];
    }
    findHalfEdges();
}

/// Subsegments are sorted by a, then b.
void SubsegmentGraph::findHalfEdges()
{
    const auto& subsegments = recovered_.constraints.subsegments;
    const Triangulation& t = recovered_.triangulation;
    for (std::uint32_t triangle = 0; triangle < t.triangles.size(); ++triangle) {
        if (t.isDead(triangle)) {
            continue;
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            const HalfEdge h = Topology::halfEdge(triangle, i);
            if (!t.isConstrained(h) || t.origin(h) > t.destination(h)) {
                continue;
            }
            const auto begin = subsegments.begin() + firstAt_[t.origin(h)];
            const auto end = subsegments.begin() + firstAt_[t.origin(h) + 1];
            const auto found = std::lower_bound(
                begin, end, t.destination(h),
                [](const Subsegment& s, std::uint32_t b) { return s.b < b; });
            halfEdge_[static_cast<std::size_t>(found - subsegments.begin())] = h;
        }
    }
}

void SubsegmentGraph::rankAroundVertices() const
{
    const auto& subsegments = recovered_.constraints.subsegments;
    const Triangulation& t = recovered_.triangulation;
    if (rankAtA_.size() == subsegments.size()) {
        return;
    }
    rankAtA_.assign(subsegments.size(), 0);
    rankAtB_.assign(subsegments.size(), 0);
    if (t.triangles.empty()) {
        return;
    }
    // The subsegments that end at each vertex, then one turn around each vertex that has some.
    const std::size_t vertexCount = t.points.size();
    std::vector<std::uint32_t> start(vertexCount + 1, 0);
    for (const Subsegment& s : subsegments) {
        ++start[s.b + 1];
    }
    for (std::size_t v = 0; v < vertexCount; ++v) {
        start[v + 1] += start[v];
    }
    std::vector<std::uint32_t> endingAt(start.back());
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (std::uint32_t s = 0; s < subsegments.size(); ++s) {
        endingAt[fill[subsegments[s].b]++] = s;
    }
    std::vector<std::uint32_t> subsegmentTo(vertexCount, kNone);
    for (std::uint32_t v = 0; v < vertexCount; ++v) {
        const bool isolated = firstAt_[v] == firstAt_[v + 1] && start[v] == start[v + 1];
        if (isolated || t.incident[v] == Topology::kDead) {
            continue;
        }
        const auto forEachAt = [&](auto f) {
            for (std::uint32_t s = firstAt_[v]; s < firstAt_[v + 1]; ++s) {
                f(subsegments[s].b, s);
            }
            for (std::uint32_t i = start[v]; i < start[v + 1]; ++i) {
                f(subsegments[endingAt[i]].a, endingAt[i]);
            }
        };
        forEachAt([&](std::uint32_t w, std::uint32_t s) { subsegmentTo[w] = s; });
        const HalfEdge first = firstAround(t, v);
        HalfEdge h = first;
        std::uint32_t rank = 0;
        do {
            const std::uint32_t s = subsegmentTo[t.destination(h)];
            if (s != kNone) {
                (subsegments[s].a == v ? rankAtA_ : rankAtB_)[s] = rank++;
            }
            h = t.nextAround(h);
        } while (h != first);
        forEachAt([&](std::uint32_t w, std::uint32_t) { subsegmentTo[w] = kNone; });
    }
}

std::uint32_t SubsegmentGraph::startOf(DirectedSubsegment s) const
{
    const Subsegment& ends = recovered_.constraints.subsegments[s.subsegment];
    return s.forward ? ends.a : ends.b;
}

std::uint32_t SubsegmentGraph::endOf(DirectedSubsegment s) const
{
    return startOf({s.subsegment, !s.forward});
}

/// The ends of a subset of subsegments, sorted around their vertices.
class SubsetTracer
{
public:
    SubsetTracer(const SubsegmentGraph& graph, std::span<const std::uint32_t> subset)
    {
        graph.rankAroundVertices();
        spokes_.reserve(2 * subset.size());
        for (std::uint32_t i = 0; i < subset.size(); ++i) {
            const Subsegment& s = graph.recovered_.constraints.subsegments[subset[i]];
            spokes_.push_back({s.a, graph.rankAtA_[subset[i]], subset[i], i, true});
            spokes_.push_back({s.b, graph.rankAtB_[subset[i]], subset[i], i, false});
        }
        std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& p, const Spoke& q) {
            return p.vertex != q.vertex ? p.vertex < q.vertex : p.rank < q.rank;
        });
        place_.resize(2 * subset.size());
        blockBegin_.resize(spokes_.size());
        blockEnd_.resize(spokes_.size());
        for (std::uint32_t begin = 0; begin < spokes_.size();) {
            std::uint32_t end = begin;
            while (end < spokes_.size() && spokes_[end].vertex == spokes_[begin].vertex) {
                ++end;
            }
            for (std::uint32_t i = begin; i < end; ++i) {
                blockBegin_[i] = begin;
                blockEnd_[i] = end;
                place_[2 * spokes_[i].local + (spokes_[i].atA ? 0U : 1U)] = i;
            }
            begin = end;
        }
    }

    /// An end of a subsegment, as seen from its vertex.
    struct Spoke
    {
        std::uint32_t vertex;
        std::uint32_t rank;
        std::uint32_t subsegment;
        std::uint32_t local; ///< index in the subset
        bool atA;
    };

    std::size_t size() const { return spokes_.size(); }
    const Spoke& spoke(std::uint32_t i) const { return spokes_[i]; }
    bool startsBlock(std::uint32_t i) const { return blockBegin_[i] == i; }
    std::uint32_t blockBegin(std::uint32_t i) const { return blockBegin_[i]; }
    std::uint32_t blockEnd(std::uint32_t i) const { return blockEnd_[i]; }
    DirectedSubsegment outward(std::uint32_t i) const
    {
        return {spokes_[i].subsegment, spokes_[i].atA};
    }
    /// The other end's spoke.
    std::uint32_t twin(std::uint32_t i) const
    {
        return place_[2 * spokes_[i].local + (spokes_[i].atA ? 1U : 0U)];
    }
    std::uint32_t nextAround(std::uint32_t i) const
    {
        return i + 1 == blockEnd_[i] ? blockBegin_[i] : i + 1;
    }
    std::uint32_t placeOf(std::uint32_t local, bool atA) const
    {
        return place_[2 * local + (atA ? 0U : 1U)];
    }

private:
    std::vector<Spoke> spokes_;
    std::vector<std::uint32_t> place_;
    std::vector<std::uint32_t> blockBegin_;
    std::vector<std::uint32_t> blockEnd_;
};

std::vector<std::vector<DirectedSubsegment>>
SubsegmentGraph::outerContours(std::span<const std::uint32_t> subset) const
{
    const SubsetTracer tracer(*this, subset);
    const auto& points = recovered_.triangulation.points;
    // Each part's lexicographically smallest vertex: its first spoke by rank is the lowest by angle
    // (all lie to the right), so that the outside is on that spoke's right.
    std::vector<std::uint8_t> reached(tracer.size(), 0);
    std::vector<std::uint32_t> stack;
    std::vector<std::vector<DirectedSubsegment>> contours;
    for (std::uint32_t root = 0; root < tracer.size(); ++root) {
        if (reached[root] != 0 || !tracer.startsBlock(root)) {
            continue;
        }
        std::uint32_t smallest = root;
        reached[root] = 1;
        stack.push_back(root);
        while (!stack.empty()) {
            const std::uint32_t begin = stack.back();
            stack.pop_back();
            if (lexicographicallyLess(points[tracer.spoke(begin).vertex],
                                      points[tracer.spoke(smallest).vertex])) {
                smallest = begin;
            }
            for (std::uint32_t i = begin; i < tracer.blockEnd(begin); ++i) {
                const std::uint32_t other = tracer.blockBegin(tracer.twin(i));
                if (reached[other] == 0) {
                    reached[other] = 1;
                    stack.push_back(other);
                }
            }
        }
        std::vector<DirectedSubsegment> contour;
        std::uint32_t i = smallest;
        do {
            contour.push_back(tracer.outward(i));
            i = tracer.nextAround(tracer.twin(i));
        } while (i != smallest);
        contours.push_back(std::move(contour));
    }
    return contours;
}

std::vector<std::vector<DirectedSubsegment>>
SubsegmentGraph::loopsAroundOutside(std::span<const DirectedSubsegment> borders) const
{
    std::vector<std::uint32_t> subset;
    subset.reserve(borders.size());
    for (const DirectedSubsegment& border : borders) {
        subset.push_back(border.subsegment);
    }
    const SubsetTracer tracer(*this, subset);
    std::vector<std::uint8_t> traced(borders.size(), 0);
    std::vector<std::vector<DirectedSubsegment>> loops;
    for (std::uint32_t first = 0; first < borders.size(); ++first) {
        if (traced[first] != 0) {
            continue;
        }
        std::vector<DirectedSubsegment> loop;
        std::uint32_t local = first;
        while (traced[local] == 0) {
            traced[local] = 1;
            loop.push_back(borders[local]);
            const std::uint32_t arrival = tracer.placeOf(local, !borders[local].forward);
            local = tracer.spoke(tracer.nextAround(arrival)).local;
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

} // namespace tessera
