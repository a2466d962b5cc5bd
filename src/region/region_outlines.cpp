// SPDX-License-Identifier: MIT
//
// A border is a half-edge of a part's triangle whose twin is in no or another part. The border that
// follows it lies at its end, after turning through the part. Where the part has several corners at
// one vertex, that would give loops that pass the vertex twice; there each corner is followed by the
// next one after turning through the outside instead, so that each loop goes around one connected
// piece of the outside: simple loops that meet at vertices only.
#include "region/region_outlines.h"

#include "predicates/predicates.h"

#include <algorithm>
#include <utility>

namespace tessera
{

namespace
{

class OutlineTracer
{
public:
    OutlineTracer(const Triangulation& triangulation, std::span<const std::uint32_t> partOfTriangle,
                  std::size_t partCount)
        : t_(triangulation)
        , partOf_(partOfTriangle)
        , partCount_(partCount)
    {}

    Polygons run()
    {
        collectBorders();
        traced_.assign(4 * t_.triangles.size(), 0);
        findManyCorners();
        linkCorners();
        for (std::uint32_t part = 0; part < partCount_; ++part) {
            tracePart(part);
        }
        return std::move(polygons_);
    }

private:
    /// A border that follows another one after turning through the outside.
    struct Link
    {
        HalfEdge border;
        HalfEdge next;
        bool operator<(const Link& other) const { return border < other.border; }
    };

    bool isBorder(HalfEdge h) const
    {
        return partOf_[Topology::triangleOf(h)] != partOf_[Topology::triangleOf(t_.twin(h))];
    }

    /// By part, a counting sort.
    void collectBorders()
    {
        start_.assign(partCount_ + 1, 0);
        std::vector<HalfEdge> all;
        for (std::uint32_t triangle = 0; triangle < t_.triangles.size(); ++triangle) {
            const std::uint32_t part = partOf_[triangle];
            if (part == kNoPart) {
                continue;
            }
            for (std::uint32_t i = 0; i < 3; ++i) {
                const HalfEdge h = Topology::halfEdge(triangle, i);
                if (isBorder(h)) {
                    all.push_back(h);
                    ++start_[part + 1];
                }
            }
        }
        for (std::size_t p = 0; p < partCount_; ++p) {
            start_[p + 1] += start_[p];
        }
        borders_.resize(all.size());
        std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
        for (const HalfEdge h : all) {
            borders_[fill[partOf_[Topology::triangleOf(h)]]++] = h;
        }
    }

    /// A part has as many corners at a vertex as borders that leave it.
    void findManyCorners()
    {
        std::vector<std::uint32_t> lastPart(t_.points.size(), kNoPart);
        hasManyCorners_.assign(t_.points.size(), 0);
        for (std::uint32_t part = 0; part < partCount_; ++part) {
            for (std::uint32_t i = start_[part]; i < start_[part + 1]; ++i) {
                const std::uint32_t vertex = t_.origin(borders_[i]);
                if (lastPart[vertex] == part && hasManyCorners_[vertex] == 0) {
                    hasManyCorners_[vertex] = 1;
                    manyCorners_.push_back(vertex);
                }
                lastPart[vertex] = part;
            }
        }
    }

    /// One turn around each vertex for all parts that have corners there.
    void linkCorners()
    {
        std::vector<HalfEdge> arrived(manyCorners_.empty() ? 0 : partCount_, Topology::kDead);
        std::vector<HalfEdge> firstLeaving(arrived.size(), Topology::kDead);
        std::vector<std::uint32_t> touched;
        for (const std::uint32_t vertex : manyCorners_) {
            touched.clear();
            t_.forEachAround(vertex, [&](HalfEdge out) {
                const HalfEdge in = t_.twin(out);
                const std::uint32_t ended = partOf_[Topology::triangleOf(in)];
                const std::uint32_t begun = partOf_[Topology::triangleOf(out)];
                if (ended == begun) {
                    return;
                }
                if (ended != kNoPart) {
                    arrived[ended] = in;
                    touched.push_back(ended);
                }
                if (begun != kNoPart) {
                    if (arrived[begun] != Topology::kDead) {
                        links_.push_back({arrived[begun], out});
                        arrived[begun] = Topology::kDead;
                    }
                    else {
                        firstLeaving[begun] = out;
                    }
                }
            });
            for (const std::uint32_t part : touched) {
                if (arrived[part] != Topology::kDead) {
                    links_.push_back({arrived[part], firstLeaving[part]});
                    arrived[part] = Topology::kDead;
                }
            }
        }
        std::sort(links_.begin(), links_.end());
    }

    HalfEdge next(HalfEdge h) const
    {
        if (hasManyCorners_[t_.destination(h)] != 0) {
            return std::lower_bound(links_.begin(), links_.end(), Link {h, 0})->next;
        }
        HalfEdge out = Topology::next(h);
        while (!isBorder(out)) {
            out = Topology::next(t_.twin(out));
        }
        return out;
    }

    /// Adds the part's loops, the counter-clockwise one first.
    void tracePart(std::uint32_t part)
    {
        traceLoops(part);
        loops_.clear();
        std::size_t outer = 0;
        std::size_t begin = 0;
        for (const std::size_t size : loopSizes_) {
            loops_.emplace_back(loopVertices_.data() + begin, size);
            begin += size;
            if (loopSizes_.size() > 1 && isCounterClockwise(loops_.back())) {
                outer = loops_.size() - 1;
            }
        }
        std::swap(loops_.front(), loops_[outer]);
        for (const auto& loop : loops_) {
            polygons_.vertices.insert(polygons_.vertices.end(), loop.begin(), loop.end());
            polygons_.loopStart.push_back(static_cast<std::uint32_t>(polygons_.vertices.size()));
        }
        polygons_.polygonStart.push_back(
            static_cast<std::uint32_t>(polygons_.loopStart.size() - 1));
    }

    void traceLoops(std::uint32_t part)
    {
        loopSizes_.clear();
        loopVertices_.clear();
        for (std::uint32_t i = start_[part]; i < start_[part + 1]; ++i) {
            const std::size_t begin = loopVertices_.size();
            for (HalfEdge h = borders_[i]; traced_[h] == 0; h = next(h)) {
                traced_[h] = 1;
                loopVertices_.push_back(t_.origin(h));
            }
            if (loopVertices_.size() > begin) {
                loopSizes_.push_back(loopVertices_.size() - begin);
            }
        }
    }

    bool isCounterClockwise(std::span<const std::uint32_t> loop) const
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
    std::span<const std::uint32_t> partOf_;
    std::size_t partCount_;
    std::vector<std::uint32_t> start_; ///< of a part's borders
    std::vector<HalfEdge> borders_;
    std::vector<std::uint8_t> traced_; ///< by half-edge
    std::vector<std::uint8_t> hasManyCorners_; ///< by vertex
    std::vector<std::uint32_t> manyCorners_;
    std::vector<Link> links_; ///< by border
    std::vector<std::uint32_t> loopVertices_; ///< of the part under way, as the next two
    std::vector<std::size_t> loopSizes_;
    std::vector<std::span<const std::uint32_t>> loops_;
    Polygons polygons_;
};

} // namespace

Polygons partOutlines(const Triangulation& triangulation,
                      std::span<const std::uint32_t> partOfTriangle, std::size_t partCount)
{
    return OutlineTracer(triangulation, partOfTriangle, partCount).run();
}

} // namespace tessera
