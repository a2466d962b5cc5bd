// SPDX-License-Identifier: MIT
//
// Local improvement, driven by lists: only the surroundings of triangles below a scan angle are
// touched, so that the cost follows the number of bad triangles and not the size of the mesh.
//
// A round scans for bad triangles, smooths the vertices of their stars (guarded Laplace steps, then
// a pattern search for the stars that stay bad) and, in every second round, merges vertices of low
// degree or on short edges into a neighbor. After each move the star is made locally Delaunay again
// by flips. Constrained vertices stay where they are.
//
// Guarantees: a move or merge is made only if it raises the smallest angle of the triangles that it
// changes and each of them is strictly counter-clockwise, decided exactly; flips to the constrained
// Delaunay diagonal do not lower the smallest angle of their two triangles. So no triangle is ever
// inverted and the sequence of smallest angles of each touched patch rises: it ends.

#include "optimize/optimize.h"

#include "delaunay/delaunay.h"
#include "optimize/edits.h"
#include "optimize/star.h"
#include "refine/border_records.h"
#include "refine/delaunay_refinement.h"
#include "refine/mesh_editor.h"

#include <cmath>
#include <numbers>

namespace tessera
{

namespace
{

constexpr int kAttempts = 4;
constexpr int kRounds = 6;
constexpr double kScanAngle = 42.0;   ///< degrees: triangles below are worked on
constexpr double kSmoothAngle = 55.0; ///< stars below are smoothed when near such triangles
constexpr double kShortEdge = 0.68;   ///< of the size: candidates for merging

double squaredSine(double degrees)
{
    const double s = std::sin(degrees * std::numbers::pi / 180.0);
    return s * s;
}

class Optimizer
{
public:
    Optimizer(WorkingMesh& mesh, const SizeField& size, OptimizeReport& report,
              Execution& execution)
        : mesh_(mesh)
        , t_(mesh.triangulation)
        , size_(size)
        , report_(report)
        , execution_(execution)
        , scan_(squaredSine(kScanAngle))
        , smooth_(squaredSine(kSmoothAngle))
    {}

    void run()
    {
        mark_.assign(t_.points.size(), 0);
        for (int round = 0; round < kRounds; ++round) {
            execution_.report(static_cast<double>(round) / kRounds);
            listBadVertices();
            if (list_.empty()) {
                break;
            }
            ++report_.rounds;
            const std::size_t before = report_.moves + report_.collapses;
            for (int pass = 0; pass < 2; ++pass) {
                forEachListed([this](std::uint32_t v) { smoothLaplace(v); });
            }
            forEachListed([this](std::uint32_t v) { searchPattern(v); });
            if (round % 2 == 1) {
                forEachListed([this](std::uint32_t v) { tryCollapse(v); });
            }
            if (report_.moves + report_.collapses == before) {
                break;
            }
        }
    }

private:
    template<class F>
    void forEachListed(F&& f)
    {
        std::size_t steps = 0;
        for (const std::uint32_t v : list_) {
            if (++steps % 1024 == 0) {
                execution_.checkpoint();
            }
            f(v);
        }
    }

    bool isFree(std::uint32_t v) const
    {
        return mesh_.origin[v] == VertexOrigin::Interior && t_.incident[v] != Topology::kDead;
    }

    /// The free vertices of bad triangles and of two rings around them, ascending.
    void listBadVertices()
    {
        std::vector<std::uint32_t> ring;
        for (std::uint32_t i = 0; i < t_.triangles.size(); ++i) {
            if (!t_.isFinite(i) || mesh_.regionOfTriangle[i] == WorkingMesh::kOutside) {
                continue;
            }
            const auto& v = t_.triangles[i].v;
            if (squaredSineOfSmallest(t_.points[v[0]], t_.points[v[1]], t_.points[v[2]]) < scan_) {
                addAll({v, 3}, ring);
            }
        }
        for (int depth = 0; depth < 2; ++depth) {
            const std::vector<std::uint32_t> previous = std::move(ring);
            ring.clear();
            for (const std::uint32_t v : previous) {
                t_.forEachAround(v, [&](HalfEdge h) {
                    const std::uint32_t neighbor[1] = {t_.destination(h)};
                    if (neighbor[0] != Topology::kInfinite) {
                        addAll(neighbor, ring);
                    }
                });
            }
        }
        list_.clear();
        for (std::uint32_t v = 1; v < mark_.size(); ++v) {
            if (mark_[v] != 0) {
                mark_[v] = 0;
                if (isFree(v)) {
                    list_.push_back(v);
                }
            }
        }
    }

    void addAll(std::span<const std::uint32_t> vertices, std::vector<std::uint32_t>& ring)
    {
        for (const std::uint32_t v : vertices) {
            if (mark_[v] == 0) {
                mark_[v] = 1;
                ring.push_back(v);
            }
        }
    }

    void smoothLaplace(std::uint32_t v)
    {
        if (!isFree(v) || !star_.gather(t_, v)) {
            return;
        }
        const Vec2 old = t_.points[v];
        const double now = star_.quality(old);
        if (now >= smooth_) {
            return;
        }
        const Vec2 target = star_.average();
        if (!moveIfBetter(target, now)) {
            moveIfBetter(midpoint(old, target), now);
        }
    }

    bool moveIfBetter(Vec2 p, double now)
    {
        if (star_.quality(p, now) <= now || !isValidCenter(star_, p)) {
            return false;
        }
        t_.points[star_.center()] = p;
        ++report_.moves;
        legalizeStar();
        return true;
    }

    void legalizeStar()
    {
        suspects_.clear();
        for (int i = 0; i < star_.count(); ++i) {
            suspects_.push_back(star_.edge(i));
            suspects_.push_back(Topology::next(star_.edge(i)));
        }
        legalize(t_, suspects_);
    }

    /// Steps in eight directions, shrinking, for stars that stay bad.
    void searchPattern(std::uint32_t v)
    {
        if (!isFree(v) || !star_.gather(t_, v)) {
            return;
        }
        constexpr double kDiagonal = std::numbers::sqrt2 / 2.0;
        constexpr Vec2 kDirections[8] = {{1, 0}, {kDiagonal, kDiagonal}, {0, 1},
                                         {-kDiagonal, kDiagonal}, {-1, 0},
                                         {-kDiagonal, -kDiagonal}, {0, -1},
                                         {kDiagonal, -kDiagonal}};
        const Vec2 old = t_.points[v];
        const double now = star_.quality(old);
        if (now >= scan_) {
            return;
        }
        double reach = 0.0;
        for (int i = 0; i < star_.count(); ++i) {
            reach += std::sqrt(star_.squaredLengthTo(i, old));
        }
        double step = 0.12 * reach / star_.count();
        Vec2 best = old;
        double bestQuality = now;
        for (int i = 0; i < 4; ++i) {
            const Vec2 from = best;
            for (const Vec2 direction : kDirections) {
                const Vec2 p = from + step * direction;
                const double quality = star_.quality(p, bestQuality);
                if (quality > bestQuality) {
                    best = p;
                    bestQuality = quality;
                }
            }
            step *= best == from ? 0.4 : 1.0;
        }
        if (bestQuality > now) {
            moveIfBetter(best, now);
        }
    }

    /// Merges a vertex of degree 3 or 4, or on a short edge, into the neighbor that gives the best
    /// smallest angle, if that rises.
    void tryCollapse(std::uint32_t v)
    {
        if (!isFree(v) || !star_.gather(t_, v)) {
            return;
        }
        const Vec2 p = t_.points[v];
        const double now = star_.quality(p);
        if (now >= scan_) {
            return;
        }
        const double limit = kShortEdge * size_.size(p);
        double best = now;
        int target = -1;
        for (int i = 0; i < star_.count(); ++i) {
            if (star_.count() > 4 && star_.squaredLengthTo(i, p) > limit * limit) {
                continue;
            }
            const double quality = star_.qualityWithout(i, best);
            if (quality > best) {
                best = quality;
                target = i;
            }
        }
        if (target < 0 || !isValidCollapse(star_, target)) {
            return;
        }
        suspects_.clear();
        for (int i = star_.after(target); star_.after(i) != target; i = star_.after(i)) {
            suspects_.push_back(Topology::next(star_.edge(i)));
            suspects_.push_back(star_.edge(i));
        }
        const std::size_t freed = t_.freeList.size();
        collapse(t_, star_, target);
        for (std::size_t i = freed; i < t_.freeList.size(); ++i) {
            mesh_.regionOfTriangle[t_.freeList[i]] = WorkingMesh::kOutside;
        }
        ++report_.collapses;
        legalize(t_, suspects_);
    }

    WorkingMesh& mesh_;
    Triangulation& t_;
    const SizeField& size_;
    OptimizeReport& report_;
    Execution& execution_;
    double scan_;
    double smooth_;
    Star star_;
    std::vector<std::uint8_t> mark_;
    std::vector<std::uint32_t> list_;
    std::vector<HalfEdge> suspects_;
};

} // namespace

OptimizeReport optimize(WorkingMesh& mesh, const SizeField& size, const RefineOptions& options,
                        Execution& execution)
{
    OptimizeReport report;
    const BorderRecords border(mesh);
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        Optimizer(mesh, size, report, execution).run();
        MeshEditor editor(mesh);
        RefineReport refined;
        refineDelaunay(editor, size, options, refined, execution);
        report.interiorPoints += refined.interiorPoints;
        report.segmentSplits += refined.segmentSplits;
        if (refined.interiorPoints + refined.segmentSplits == 0) {
            break;
        }
    }
    report.unreached = findUnreached(mesh, options);
    return report;
}

OptimizeReport optimize(WorkingMesh& mesh, const SizeField& size, double minAngle,
                        Execution& execution)
{
    RefineOptions options;
    options.minAngle = minAngle;
    return optimize(mesh, size, options, execution);
}

} // namespace tessera
