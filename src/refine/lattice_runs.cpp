// SPDX-License-Identifier: MIT
//
// Which lattice points are usable.
//
// The points too close to a constrained edge fill a capsule around it; a row of the lattice cuts it
// in one interval. The intervals of all edges, sorted and merged row by row, leave the runs of free
// points in between. Free points that are lattice neighbors are less than the clearance apart from
// each other and no constrained edge can pass between them, so each connected set of runs lies in
// one region, found by locating one of its points.

#include "refine/lattice_runs.h"

#include "delaunay/delaunay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tessera
{

namespace
{

struct Interval
{
    std::int64_t row;
    std::int64_t first;
    std::int64_t last;
};

class Blocked
{
public:
    explicit Blocked(const HexLattice& lattice)
        : lattice_(lattice)
    {}

    void addCapsule(Vec2 a, Vec2 b, double radius)
    {
        const double low = std::min(a.y, b.y) - radius - lattice_.origin.y;
        const double high = std::max(a.y, b.y) + radius - lattice_.origin.y;
        const auto first = static_cast<std::int64_t>(std::ceil(low / lattice_.rowHeight()));
        const auto last = static_cast<std::int64_t>(std::floor(high / lattice_.rowHeight()));
        for (std::int64_t row = first; row <= last; ++row) {
            addRow(a, b, radius, row);
        }
    }

    /// Sorted by row and first, touching intervals joined.
    std::vector<Interval> merged()
    {
        std::sort(intervals_.begin(), intervals_.end(), [](const Interval& a, const Interval& b) {
            return a.row != b.row ? a.row < b.row : a.first < b.first;
        });
        std::vector<Interval> result;
        for (const Interval& interval : intervals_) {
            if (!result.empty() && result.back().row == interval.row
                && interval.first <= result.back().last + 1) {
                result.back().last = std::max(result.back().last, interval.last);
            }
            else {
                result.push_back(interval);
            }
        }
        return result;
    }

private:
    /// The capsule is convex: its part of the row lies between the extremes of the parts of its two
    /// disks and of the rectangle between them.
    void addRow(Vec2 a, Vec2 b, double radius, std::int64_t row)
    {
        const double y = lattice_.origin.y + static_cast<double>(row) * lattice_.rowHeight();
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        const auto include = [&](double x) {
            low = std::min(low, x);
            high = std::max(high, x);
        };
        for (const Vec2 center : {a, b}) {
            const double rest = radius * radius - (y - center.y) * (y - center.y);
            if (rest >= 0.0) {
                include(center.x - std::sqrt(rest));
                include(center.x + std::sqrt(rest));
            }
        }
        const Vec2 along = b - a;
        const double l = length(along);
        if (l > 0.0) {
            const Vec2 n {-along.y / l * radius, along.x / l * radius};
            for (const Vec2 side : {n, Vec2 {-n.x, -n.y}}) {
                const double s = (y - a.y - side.y) / along.y;
                if (s >= 0.0 && s <= 1.0) {
                    include(a.x + side.x + s * along.x);
                }
            }
        }
        if (low <= high) {
            const double shift = 0.5 * static_cast<double>(row);
            intervals_.push_back({row, indexOf(std::floor(columnOf(low) - shift)),
                                  indexOf(std::ceil(columnOf(high) - shift))});
        }
    }

    double columnOf(double x) const { return (x - lattice_.origin.x) / lattice_.h; }
    static std::int64_t indexOf(double i) { return static_cast<std::int64_t>(i); }

    const HexLattice& lattice_;
    std::vector<Interval> intervals_;
};

class RunFinder
{
public:
    RunFinder(const MeshEditor& editor, const VertexSizes& sizes, const HexLattice& lattice,
              double clearance)
        : editor_(editor)
        , t_(editor.triangulation())
        , sizes_(sizes)
        , lattice_(lattice)
        , clearance_(clearance)
    {}

    std::vector<LatticeRun> run()
    {
        findFree();
        joinRows();
        locateSets();
        return std::move(runs_);
    }

private:
    double radiusFor(double sizeThere) const
    {
        const double finer = std::max(0.0, lattice_.h - sizeThere) / VertexSizes::kGrowth;
        return clearance_ * lattice_.h + finer;
    }

    void findFree()
    {
        Blocked blocked(lattice_);
        std::vector<std::uint8_t> onEdge(t_.points.size(), 0);
        for (const ConstrainedEdge& edge : editor_.constMesh().edges) {
            onEdge[edge.a] = 1;
            onEdge[edge.b] = 1;
            blocked.addCapsule(t_.points[edge.a], t_.points[edge.b],
                               radiusFor(std::min(sizes_[edge.a], sizes_[edge.b])));
        }
        for (std::uint32_t v = 1; v < t_.points.size(); ++v) {
            if (onEdge[v] == 0 && t_.incident[v] != Topology::kDead) {
                blocked.addCapsule(t_.points[v], t_.points[v], radiusFor(sizes_[v]));
            }
        }
        const std::vector<Interval> taken = blocked.merged();
        for (std::size_t k = 0; k + 1 < taken.size(); ++k) {
            if (taken[k].row == taken[k + 1].row) {
                runs_.push_back({taken[k].row, taken[k].last + 1, taken[k + 1].first - 1});
            }
        }
    }

    std::uint32_t rootOf(std::uint32_t run)
    {
        while (parent_[run] != run) {
            parent_[run] = parent_[parent_[run]];
            run = parent_[run];
        }
        return run;
    }

    /// Unites runs of neighboring rows that have neighboring points.
    void joinRows()
    {
        parent_.resize(runs_.size());
        std::iota(parent_.begin(), parent_.end(), 0U);
        std::size_t below = 0;
        for (std::size_t k = 0; k < runs_.size(); ++k) {
            const LatticeRun& run = runs_[k];
            while (runs_[below].row < run.row - 1
                   || (runs_[below].row == run.row - 1 && runs_[below].last < run.first)) {
                ++below;
            }
            // Point (i, row) has the neighbors i and i + 1 in the row below.
            for (std::size_t m = below;
                 runs_[m].row == run.row - 1 && runs_[m].first <= run.last + 1; ++m) {
                const std::uint32_t a = rootOf(static_cast<std::uint32_t>(k));
                const std::uint32_t b = rootOf(static_cast<std::uint32_t>(m));
                parent_[std::max(a, b)] = std::min(a, b);
            }
        }
    }

    void locateSets()
    {
        HalfEdge hint = editor_.anyEdge();
        std::size_t kept = 0;
        for (std::uint32_t k = 0; k < runs_.size(); ++k) {
            const std::uint32_t root = rootOf(k);
            if (root == k) {
                const Location where
                    = locate(t_, lattice_.point(runs_[k].first, runs_[k].row), hint);
                hint = where.edge;
                runs_[k].region
                    = editor_.constMesh().regionOfTriangle[Topology::triangleOf(where.edge)];
            }
            regionOfRoot_.push_back(root == k ? runs_[k].region : regionOfRoot_[root]);
        }
        for (std::uint32_t k = 0; k < runs_.size(); ++k) {
            if (regionOfRoot_[k] != WorkingMesh::kOutside) {
                runs_[kept] = runs_[k];
                runs_[kept++].region = regionOfRoot_[k];
            }
        }
        runs_.resize(kept);
    }

    const MeshEditor& editor_;
    const Triangulation& t_;
    const VertexSizes& sizes_;
    HexLattice lattice_;
    double clearance_;
    std::vector<LatticeRun> runs_;
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint32_t> regionOfRoot_;
};

} // namespace

std::vector<LatticeRun> findLatticeRuns(const MeshEditor& editor, const VertexSizes& sizes,
                                        const HexLattice& lattice, double clearance)
{
    return RunFinder(editor, sizes, lattice, clearance).run();
}

} // namespace tessera
