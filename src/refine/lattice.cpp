// SPDX-License-Identifier: MIT
//
// Triangles straight from a lattice, without inserting points one by one (about seven times faster
// than bulk insertion of the same points in Hilbert order).
//
// 1. Number the points of the runs, write the triangles between neighboring rows and link them to
//    each other. Half-edges without a neighbor are the rim.
// 2. Insert the rim's points into the triangulation, loop by loop, each next to the one before.
//    A rim edge's diametral circle contains no lattice point and, by the clearance of 0.75 h, no
//    other vertex; so every rim edge is a Delaunay edge and present.
// 3. Constrain the rim edges, remove the triangles inside the rim and link the lattice's triangles
//    in their place.
//
// Threads share the writing by blocks of rows; where a triangle goes does not depend on them.
//
// Should an edge of the rim be missing in step 3 (rounding at the limit of the coordinates'
// resolution), the lattice's triangles are dropped and the rim's points stay as ordinary points.
// Complexity: O(n), with 24 bytes written per triangle and 16 per point; locating only along the
// rim.

#include "refine/lattice.h"

#include "base/huge_pages.h"
#include "base/parallel.h"
#include "delaunay/delaunay.h"

#include <algorithm>
#include <numeric>

namespace tessera
{

namespace
{

constexpr std::uint32_t kUnlinked = 0xffffffffU;
constexpr std::uint32_t kTraced = 0xfffffffeU;

class LatticeBuilder
{
public:
    LatticeBuilder(MeshEditor& editor, VertexSizes& sizes, const HexLattice& lattice,
                   std::vector<LatticeRun> runs, Execution& execution)
        : editor_(editor)
        , t_(editor.mesh().triangulation)
        , sizes_(sizes)
        , lattice_(lattice)
        , runs_(std::move(runs))
        , execution_(execution)
    {}

    LatticePatch build()
    {
        numberPoints();
        collectPairs();
        if (patch_.firstTriangle == patch_.endTriangle) {
            return {};
        }
        makeRoomForAll();
        execution_.checkpoint();
        writePoints();
        writeTriangles();
        execution_.checkpoint();
        traceRim();
        if (!findRimEdges() || !carve()) {
            dropTriangles();
            return {};
        }
        return std::move(patch_);
    }

private:
    HalfEdge half(std::uint32_t slot, std::uint32_t side) const
    {
        return Topology::halfEdge(slot, side);
    }
    std::uint32_t& link(HalfEdge h) { return t_.triangles[h >> 2].link[h & 3U]; }
    std::uint32_t vertexOf(const LatticeRun& run, std::int64_t i) const
    {
        return firstVertex_ + run.base + static_cast<std::uint32_t>(i - run.first);
    }

    void numberPoints()
    {
        firstVertex_ = static_cast<std::uint32_t>(t_.points.size());
        endVertex_ = firstVertex_;
        for (LatticeRun& run : runs_) {
            run.base = endVertex_ - firstVertex_;
            endVertex_ += static_cast<std::uint32_t>(run.last - run.first + 1);
        }
    }

    /// The first writing to new memory costs more than the rest: threads share it array by array.
    void makeRoomForAll()
    {
        const auto extend = [](auto& array, std::size_t size, const auto& value) {
            reserveOnHugePages(array, size + size / 8);
            array.resize(size, value);
        };
        WorkingMesh& mesh = editor_.mesh();
        runTogether(
            execution_, [&] { extend(t_.triangles, patch_.endTriangle, Topology::Triangle {}); },
            [&] { extend(t_.points, endVertex_, Vec2 {}); },
            [&] { extend(mesh.regionOfTriangle, patch_.endTriangle, 0U); },
            [&] { sizes_.append(endVertex_, lattice_.h); },
            [&] { extend(t_.incident, endVertex_, Topology::kDead); },
            // By lattice point: the half-edge of the inverted triangle below (i, j), (i + 1, j).
            [&] { below_.assign(endVertex_ - firstVertex_, kUnlinked); },
            [&] {
                extend(mesh.origin, endVertex_, VertexOrigin::Interior);
                inserted_.assign(endVertex_ - firstVertex_, 0);
            });
    }

    void writePoints()
    {
        constexpr std::size_t kRuns = 64;
        forEachPiece(execution_, runs_.size(), kRuns,
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                         for (std::size_t k = begin; k < end; ++k) {
                             const LatticeRun& run = runs_[k];
                             for (std::int64_t i = run.first; i <= run.last; ++i) {
                                 t_.points[vertexOf(run, i)] = lattice_.point(i, run.row);
                             }
                         }
                     });
    }

    /// Calls f(lower run, upper run) for all pairs of neighboring rows that may share triangles,
    /// ordered by lower row.
    template<class F>
    void forEachPair(F&& f) const
    {
        std::size_t above = 0;
        for (const LatticeRun& lower : runs_) {
            while (above < runs_.size()
                   && (runs_[above].row < lower.row + 1
                       || (runs_[above].row == lower.row + 1
                           && runs_[above].last < lower.first - 1))) {
                ++above;
            }
            for (std::size_t m = above; m < runs_.size() && runs_[m].row == lower.row + 1
                 && runs_[m].first <= lower.last;
                 ++m) {
                f(lower, runs_[m]);
            }
        }
    }

    /// Upright triangles (i, j), (i + 1, j), (i, j + 1) of a pair of runs: i in [first, last].
    struct Span
    {
        std::int64_t first;
        std::int64_t last;
        std::uint32_t count() const
        {
            return last < first ? 0 : static_cast<std::uint32_t>(last - first + 1);
        }
    };
    static Span upright(const LatticeRun& lower, const LatticeRun& upper)
    {
        return {std::max(lower.first, upper.first), std::min(lower.last - 1, upper.last)};
    }
    /// Inverted triangles (i + 1, j), (i + 1, j + 1), (i, j + 1).
    static Span inverted(const LatticeRun& lower, const LatticeRun& upper)
    {
        return {std::max(lower.first - 1, upper.first), std::min(lower.last, upper.last) - 1};
    }

    /// Two runs that share triangles, the first of which goes into slot.
    struct Pair
    {
        const LatticeRun* lower;
        const LatticeRun* upper;
        std::uint32_t slot;
    };

    /// Blocks of pairs that threads write on their own: each begins with a new row.
    struct Block
    {
        std::size_t begin;
        std::size_t end;
    };

    void writeTriangles()
    {
        std::vector<std::uint32_t>& region = editor_.mesh().regionOfTriangle;
        const std::vector<Block> blocks = divideIntoBlocks();
        forEachPiece(execution_, blocks.size(), 1, [&](std::size_t b, std::size_t, std::size_t) {
            execution_.checkpoint();
            for (std::size_t k = blocks[b].begin; k < blocks[b].end; ++k) {
                const bool isFirstRow
                    = b > 0 && pairs_[k].lower->row == pairs_[blocks[b].begin].lower->row;
                const std::uint32_t end = writePair(pairs_[k], !isFirstRow);
                std::fill(region.begin() + pairs_[k].slot, region.begin() + end,
                          pairs_[k].lower->region);
            }
        });
        for (std::size_t b = 1; b < blocks.size(); ++b) {
            linkToBlockBelow(blocks[b]);
        }
        collectRim();
    }

    void collectPairs()
    {
        patch_.firstTriangle = static_cast<std::uint32_t>(t_.triangles.size());
        patch_.endTriangle = patch_.firstTriangle;
        forEachPair([&](const LatticeRun& lower, const LatticeRun& upper) {
            const std::uint32_t count
                = upright(lower, upper).count() + inverted(lower, upper).count();
            if (count > 0) {
                pairs_.push_back({&lower, &upper, patch_.endTriangle});
                patch_.endTriangle += count;
            }
        });
    }

    std::vector<Block> divideIntoBlocks() const
    {
        constexpr std::uint32_t kBlock = 1 << 16;
        std::vector<Block> blocks;
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            if (k == 0
                || (pairs_[k].lower->row != pairs_[k - 1].lower->row
                    && pairs_[k].slot - pairs_[blocks.back().begin].slot >= kBlock)) {
                blocks.push_back({k, k});
            }
            blocks.back().end = k + 1;
        }
        return blocks;
    }

    /// Links the upright triangles of the block's first row, whose neighbors below lie in the block
    /// before.
    void linkToBlockBelow(const Block& block)
    {
        const std::int64_t row = pairs_[block.begin].lower->row;
        for (std::size_t k = block.begin; k < block.end && pairs_[k].lower->row == row; ++k) {
            const std::uint32_t end
                = k + 1 < pairs_.size() ? pairs_[k + 1].slot : patch_.endTriangle;
            for (std::uint32_t slot = pairs_[k].slot; slot < end; ++slot) {
                const auto& v = t_.triangles[slot].v;
                if (v[1] == v[0] + 1) { // upright
                    connect(half(slot, 2), below_[v[0] - firstVertex_]);
                }
            }
        }
    }

    void collectRim()
    {
        constexpr std::size_t kPiece = 1 << 15;
        const auto find = [&](std::size_t begin, std::size_t end, std::vector<HalfEdge>& rim) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto slot = patch_.firstTriangle + static_cast<std::uint32_t>(i);
                for (std::uint32_t side = 0; side < 3; ++side) {
                    if (link(half(slot, side)) == kUnlinked) {
                        rim.push_back(half(slot, side));
                    }
                }
            }
        };
        patch_.rim = collectPieces<HalfEdge>(
            execution_, patch_.endTriangle - patch_.firstTriangle, kPiece, find);
    }

    /// Upright and inverted triangles alternate from left to right. Returns the next free slot.
    std::uint32_t writePair(const Pair& pair, bool linksBelow)
    {
        const LatticeRun& lower = *pair.lower;
        const LatticeRun& upper = *pair.upper;
        std::uint32_t nextSlot = pair.slot;
        const Span up = upright(lower, upper);
        const Span down = inverted(lower, upper);
        const std::int64_t first = std::min(up.count() ? up.first : down.first,
                                            down.count() ? down.first : up.first);
        const std::int64_t last = std::max(up.count() ? up.last : down.last,
                                           down.count() ? down.last : up.last);
        HalfEdge leftOpen = kUnlinked; // edge (i, j)-(i, j+1) of the inverted triangle i - 1
        for (std::int64_t i = first; i <= last; ++i) {
            HalfEdge slant = kUnlinked; // edge (i + 1, j)-(i, j + 1) of the upright triangle i
            if (i >= up.first && i <= up.last) {
                const std::uint32_t slot = nextSlot++;
                const std::uint32_t a = vertexOf(lower, i);
                t_.triangles[slot] = {{a, a + 1, vertexOf(upper, i)},
                                      {kUnlinked, kUnlinked, kUnlinked}};
                connect(half(slot, 1), leftOpen);
                if (linksBelow) {
                    connect(half(slot, 2), below_[a - firstVertex_]);
                }
                t_.incident[a] = half(slot, 2);
                slant = half(slot, 0);
            }
            leftOpen = kUnlinked;
            if (i >= down.first && i <= down.last) {
                const std::uint32_t slot = nextSlot++;
                const std::uint32_t c = vertexOf(upper, i);
                const std::uint32_t a = vertexOf(lower, i + 1);
                t_.triangles[slot] = {{a, c + 1, c}, {kUnlinked, kUnlinked, kUnlinked}};
                connect(half(slot, 1), slant);
                below_[c - firstVertex_] = half(slot, 0);
                t_.incident[a] = half(slot, 2);
                leftOpen = half(slot, 2);
            }
        }
        return nextSlot;
    }

    void connect(HalfEdge a, HalfEdge b)
    {
        if (b != kUnlinked) {
            link(a) = b;
            link(b) = a;
        }
    }

    /// Walks along every loop of the rim and inserts its vertices.
    void traceRim()
    {
        for (const HalfEdge start : patch_.rim) {
            HalfEdge h = start;
            while (link(h) == kUnlinked) {
                link(h) = kTraced;
                insertRimVertex(t_.origin(h));
                h = Topology::next(h);
                while (link(h) < kTraced) {
                    h = Topology::next(link(h));
                }
            }
        }
    }

    void insertRimVertex(std::uint32_t v)
    {
        if (inserted_[v - firstVertex_] != 0) {
            return;
        }
        inserted_[v - firstVertex_] = 1;
        const Vec2 p = t_.points[v];
        VisibleWalk found {VisibleWalk::Kind::Lost, {}};
        if (hint_ != kUnlinked) {
            found = editor_.walk(hint_, p);
        }
        if (found.kind != VisibleWalk::Kind::Reached) {
            found.location = locate(t_, p, hint_ != kUnlinked ? hint_ : editor_.anyEdge());
        }
        editor_.insertIsolated(v, found.location);
        hint_ = t_.incident[v];
    }

    /// The rim's edges in the triangulation; false if one is missing.
    bool findRimEdges()
    {
        inside_.reserve(patch_.rim.size());
        for (const HalfEdge h : patch_.rim) {
            const HalfEdge edge = t_.findEdge(t_.origin(h), t_.destination(h));
            if (edge == Topology::kDead || t_.isConstrained(edge)) {
                return false;
            }
            inside_.push_back(edge);
        }
        return true;
    }

    /// Removes the triangles inside the rim and links the lattice's triangles to those outside.
    bool carve()
    {
        for (const HalfEdge h : inside_) {
            t_.setConstrained(h, true);
        }
        if (!collectInside()) {
            for (const HalfEdge h : inside_) {
                t_.setConstrained(h, false);
            }
            return false;
        }
        for (std::size_t i = 0; i < inside_.size(); ++i) {
            const HalfEdge outside = t_.twin(inside_[i]);
            const HalfEdge h = patch_.rim[i];
            t_.join(h, outside, true);
            t_.incident[t_.origin(h)] = h;
        }
        for (const std::uint32_t triangle : carved_) {
            t_.triangles[triangle].v[0] = Topology::kDead;
            t_.freeList.push_back(triangle);
            editor_.mesh().regionOfTriangle[triangle] = WorkingMesh::kOutside;
        }
        patch_.points = countUsedPoints();
        return true;
    }

    std::size_t countUsedPoints() const
    {
        constexpr std::size_t kPiece = 1 << 17;
        const std::size_t count = endVertex_ - firstVertex_;
        std::vector<std::size_t> used((count + kPiece - 1) / kPiece);
        forEachPiece(execution_, count, kPiece,
                     [&](std::size_t piece, std::size_t begin, std::size_t end) {
                         const auto first = t_.incident.begin() + firstVertex_;
                         used[piece] = static_cast<std::size_t>(
                             std::count_if(first + static_cast<std::ptrdiff_t>(begin),
                                           first + static_cast<std::ptrdiff_t>(end),
                                           [](HalfEdge h) { return h != Topology::kDead; }));
                     });
        return std::accumulate(used.begin(), used.end(), std::size_t {0});
    }

    bool collectInside()
    {
        std::vector<std::uint8_t> seen(t_.triangles.size(), 0);
        for (const HalfEdge h : inside_) {
            visit(Topology::triangleOf(h), seen);
        }
        for (std::size_t i = 0; i < carved_.size(); ++i) {
            if (!editor_.isKept(carved_[i])) {
                return false;
            }
            for (std::uint32_t side = 0; side < 3; ++side) {
                const HalfEdge h = half(carved_[i], side);
                if (!t_.isConstrained(h)) {
                    visit(Topology::triangleOf(t_.twin(h)), seen);
                }
            }
        }
        return true;
    }

    void visit(std::uint32_t triangle, std::vector<std::uint8_t>& seen)
    {
        if (seen[triangle] == 0) {
            seen[triangle] = 1;
            carved_.push_back(triangle);
        }
    }

    void dropTriangles()
    {
        for (std::uint32_t v = firstVertex_; v < t_.points.size(); ++v) {
            if (inserted_[v - firstVertex_] == 0) {
                t_.incident[v] = Topology::kDead;
            }
        }
        for (std::uint32_t slot = patch_.firstTriangle; slot < patch_.endTriangle; ++slot) {
            t_.triangles[slot].v[0] = Topology::kDead;
            t_.freeList.push_back(slot);
            editor_.mesh().regionOfTriangle[slot] = WorkingMesh::kOutside;
        }
    }

    MeshEditor& editor_;
    Triangulation& t_;
    VertexSizes& sizes_;
    HexLattice lattice_;
    std::vector<LatticeRun> runs_;
    Execution& execution_;
    LatticePatch patch_;
    std::uint32_t firstVertex_ = 0;
    std::uint32_t endVertex_ = 0;
    std::vector<Pair> pairs_;
    HalfEdge hint_ = kUnlinked;
    std::vector<HalfEdge> below_;
    std::vector<std::uint8_t> inserted_; ///< by lattice point
    std::vector<HalfEdge> inside_;       ///< by rim edge: the same edge in the old triangulation
    std::vector<std::uint32_t> carved_;
};

} // namespace

LatticePatch insertLattice(MeshEditor& editor, VertexSizes& sizes, const HexLattice& lattice,
                           std::vector<LatticeRun> runs, Execution& execution)
{
    return LatticeBuilder(editor, sizes, lattice, std::move(runs), execution).build();
}

void releaseRim(MeshEditor& editor, const LatticePatch& patch)
{
    Triangulation& t = editor.mesh().triangulation;
    for (const HalfEdge h : patch.rim) {
        t.setConstrained(h, false);
    }
    std::vector<HalfEdge> suspects = patch.rim;
    legalize(t, suspects);
}

} // namespace tessera
