// SPDX-License-Identifier: MIT
//
// Local improvement, driven by lists: only the surroundings of triangles below a scan angle are
// touched, so that the cost follows the number of bad triangles and not the size of the mesh.
//
// A round lists the vertices of bad triangles and of two rings around them and smooths them (guarded
// Laplace steps, then a pattern search for the stars that stay bad); every second round merges
// vertices of low degree or on short edges into a neighbor. After each move the star is made locally
// Delaunay again by flips. The next round looks for bad triangles around the same vertices only, from
// the third one on only where a vertex has moved or an edge has been flipped. A star in which nothing
// has changed since Laplace steps failed is passed over.
// Constrained vertices stay where they are.
//
// Guarantees: a move or merge is made only if it raises the smallest angle of the triangles that it
// changes and each of them is strictly counter-clockwise, decided exactly; flips to the constrained
// Delaunay diagonal do not lower the smallest angle of their two triangles. So no triangle is ever
// inverted and the sequence of smallest angles of each touched patch rises: it ends.
//
// The smallest angle alone is no good guide beside edges that stay whole though far longer than the
// size: the farther the apex of the triangle on one moves away, the better, so that free vertices
// are merged, and crowded far from the edge (mean quality 0.912 -> 0.745 on a plate with such
// sides). After keepMeanAndAreas() moves must not lower the sum of qualities in the star either,
// merges not the sum of their differences from the mean.

#include "optimize/local_improvement.h"

#include "base/parallel.h"
#include "delaunay/delaunay.h"
#include "optimize/edits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tessera
{

namespace
{

constexpr int kRounds = 6;
constexpr int kRings = 2;
constexpr double kShortEdge = 0.68; ///< of the size: candidates for merging
/// Squared sines: triangles below 42 degrees are bad; stars below 55 degrees near them are smoothed.
constexpr double kScan = 0.44773576836617335;
/// Where the size field keeps many triangles below that, rounds after the first look below 38: costs
/// a quarter less and leaves a better mean (growth 0.3: 0.9622 instead of 0.9614).
constexpr double kScanOfRest = 0.37903905220016616;
constexpr double kSmooth = 0.67101007166283436;

constexpr std::size_t kTrianglePiece = 1 << 15;
constexpr std::size_t kVertexPiece = 1 << 12;

constexpr std::uint8_t kListed = 1;
constexpr std::uint8_t kTouched = 2;
constexpr std::uint8_t kReached = 4;
/// Laplace steps do not help the star, in which nothing has changed since they were tried.
constexpr std::uint8_t kSettled = 8;

} // namespace

LocalImprovement::LocalImprovement(WorkingMesh& mesh, const SizeField& size,
                                   OptimizeReport& report, Execution& execution)
    : mesh_(mesh)
    , t_(mesh.triangulation)
    , size_(size)
    , report_(report)
    , execution_(execution)
    , scan_(kScan)
{}

void LocalImprovement::keepMeanAndAreas(const RefineOptions& options)
{
    areaOptions_ = options;
    double sum = 0.0;
    double count = 0.0;
    for (std::uint32_t i = 0; i < t_.triangles.size(); ++i) {
        if (mesh_.regionOfTriangle[i] != WorkingMesh::kOutside && t_.isFinite(i)) {
            const auto& v = t_.triangles[i].v;
            sum += qualityOf(t_.points[v[0]], t_.points[v[1]], t_.points[v[2]]);
            count += 1.0;
        }
    }
    meanToKeep_ = count > 0.0 ? sum / count : 0.0;
}

void LocalImprovement::improveAll()
{
    scan_ = kScan;
    changedOnly_ = false;
    startList();
    seedAll();
    run();
}

void LocalImprovement::improveAround(std::span<const std::uint32_t> vertices)
{
    scan_ = kScan;
    changedOnly_ = true;
    startList();
    for (const std::uint32_t v : vertices) {
        if (star_.gather(t_, v)) {
            unsettleRing();
        }
    }
    seedAround(vertices);
    run();
}

std::vector<std::uint32_t> LocalImprovement::touchedTriangles() const
{
    if (isLarge(touched_)) {
        const auto find = [&](std::size_t begin, std::size_t end,
                              std::vector<std::uint32_t>& triangles) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto& v = t_.triangles[i].v;
                if (mesh_.regionOfTriangle[i] != WorkingMesh::kOutside
                    && ((mark_[v[0]] | mark_[v[1]] | mark_[v[2]]) & kTouched) != 0) {
                    triangles.push_back(static_cast<std::uint32_t>(i));
                }
            }
        };
        return collectPieces<std::uint32_t>(execution_, t_.triangles.size(), kTrianglePiece, find);
    }
    const auto isTouchedBefore = [this](std::uint32_t v, std::uint32_t center) {
        return v < center && (mark_[v] & kTouched) != 0;
    };
    const auto find = [&](std::size_t begin, std::size_t end,
                          std::vector<std::uint32_t>& triangles) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t center = touched_[i];
            t_.forEachAround(center, [&](HalfEdge h) {
                const std::uint32_t triangle = Topology::triangleOf(h);
                // Each triangle once: with the first of its corners.
                if (mesh_.regionOfTriangle[triangle] != WorkingMesh::kOutside
                    && !isTouchedBefore(t_.destination(h), center)
                    && !isTouchedBefore(t_.apex(h), center)) {
                    triangles.push_back(triangle);
                }
            });
        }
    };
    return collectPieces<std::uint32_t>(execution_, touched_.size(), kVertexPiece, find);
}

void LocalImprovement::run()
{
    for (int round = 0; round < kRounds && !list_.empty(); ++round) {
        growList();
        ++report_.rounds;
        const std::size_t before = report_.moves + report_.collapses;
        for (int pass = 0; pass < 2; ++pass) {
            forEachListed([this](std::uint32_t v) { smoothLaplace(v); });
        }
        if (round > 0) {
            forEachListed([this](std::uint32_t v) { searchPattern(v); });
        }
        if (round % 2 == 1) {
            forEachListed([this](std::uint32_t v) { tryCollapse(v); });
        }
        if (report_.moves + report_.collapses == before) {
            break;
        }
        changedOnly_ = changedOnly_ || round > 0;
        seedAgain();
        if (scan_ > kScanOfRest && isLarge(list_)) {
            scan_ = kScanOfRest;
            seedAgain();
        }
    }
    startList();
}

/// The list of the next round: bad triangles around the vertices of this one.
void LocalImprovement::seedAgain()
{
    const std::vector<std::uint32_t> previous = list_;
    startList();
    if (isLarge(previous)) {
        seedAll();
    }
    else {
        seedAround(previous);
    }
}

void LocalImprovement::seedAll()
{
    const auto find = [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& bad) {
        for (std::size_t i = begin; i < end; ++i) {
            if (isBad(static_cast<std::uint32_t>(i))) {
                bad.push_back(static_cast<std::uint32_t>(i));
            }
        }
    };
    for (const std::uint32_t triangle :
         collectPieces<std::uint32_t>(execution_, t_.triangles.size(), kTrianglePiece, find)) {
        seed(triangle);
    }
}

/// Going through the whole mesh in order costs less than going through this list.
bool LocalImprovement::isLarge(const std::vector<std::uint32_t>& list) const
{
    return list.size() > mark_.size() / 16;
}

void LocalImprovement::startList()
{
    for (const std::uint32_t v : list_) {
        mark_[v] &= static_cast<std::uint8_t>(~kListed);
    }
    list_.clear();
    mark_.resize(t_.points.size(), 0);
}

bool LocalImprovement::isBad(std::uint32_t triangle) const
{
    if (mesh_.regionOfTriangle[triangle] == WorkingMesh::kOutside) {
        return false;
    }
    const auto& v = t_.triangles[triangle].v;
    if (changedOnly_ && (mark_[v[0]] & mark_[v[1]] & mark_[v[2]] & kSettled) != 0) {
        return false;
    }
    return squaredSineOfSmallest(t_.points[v[0]], t_.points[v[1]], t_.points[v[2]]) < scan_;
}

void LocalImprovement::seed(std::uint32_t triangle)
{
    for (const std::uint32_t v : t_.triangles[triangle].v) {
        add(v);
    }
}

void LocalImprovement::seedAround(std::span<const std::uint32_t> vertices)
{
    const auto find = [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& bad) {
        for (std::size_t i = begin; i < end; ++i) {
            t_.forEachAround(vertices[i], [&](HalfEdge h) {
                if (isBad(Topology::triangleOf(h))) {
                    bad.push_back(Topology::triangleOf(h));
                }
            });
        }
    };
    for (const std::uint32_t triangle :
         collectPieces<std::uint32_t>(execution_, vertices.size(), kVertexPiece, find)) {
        seed(triangle);
    }
}

void LocalImprovement::add(std::uint32_t vertex)
{
    std::uint8_t& mark = mark_[vertex];
    if ((mark & kListed) == 0) {
        list_.push_back(vertex);
        if ((mark & kTouched) == 0) {
            touched_.push_back(vertex);
        }
        mark |= kListed | kTouched;
    }
}

/// Adds kRings rings of vertices around those in the list and orders it, for the sake of the caches.
void LocalImprovement::growList()
{
    if (isLarge(list_)) {
        growLargeList();
        return;
    }
    std::size_t begin = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        const std::size_t end = list_.size();
        for (std::size_t i = begin; i < end; ++i) {
            t_.forEachAround(list_[i], [this](HalfEdge h) {
                if (t_.destination(h) != Topology::kInfinite) {
                    add(t_.destination(h));
                }
            });
        }
        begin = end;
    }
    std::sort(list_.begin(), list_.end());
}

/// The same by passes over all triangles.
void LocalImprovement::growLargeList()
{
    for (int ring = 0; ring < kRings; ++ring) {
        for (std::uint32_t i = 0; i < t_.triangles.size(); ++i) {
            const auto& v = t_.triangles[i].v;
            if (mesh_.regionOfTriangle[i] != WorkingMesh::kOutside
                && ((mark_[v[0]] | mark_[v[1]] | mark_[v[2]]) & kListed) != 0) {
                for (const std::uint32_t corner : v) {
                    mark_[corner] |= kReached;
                }
            }
        }
        for (std::uint32_t v = 1; v < mark_.size(); ++v) {
            if ((mark_[v] & kReached) != 0) {
                mark_[v] &= static_cast<std::uint8_t>(~kReached);
                add(v);
            }
        }
    }
    list_.clear();
    for (std::uint32_t v = 1; v < mark_.size(); ++v) {
        if ((mark_[v] & kListed) != 0) {
            list_.push_back(v);
        }
    }
}

template<class F>
void LocalImprovement::forEachListed(F&& f)
{
    std::size_t steps = 0;
    for (const std::uint32_t v : list_) {
        if (++steps % 1024 == 0) {
            execution_.checkpoint();
        }
        f(v);
    }
}

bool LocalImprovement::isFree(std::uint32_t v) const
{
    return mesh_.origin[v] == VertexOrigin::Interior && t_.incident[v] != Topology::kDead;
}

void LocalImprovement::smoothLaplace(std::uint32_t v)
{
    if ((mark_[v] & kSettled) != 0) {
        return;
    }
    if (isFree(v) && star_.gather(t_, v)) {
        const Vec2 old = t_.points[v];
        const double now = star_.quality(old);
        if (now < kSmooth) {
            const Vec2 target = star_.average();
            if (moveIfBetter(target, now) || moveIfBetter(midpoint(old, target), now)) {
                return;
            }
        }
    }
    mark_[v] |= kSettled;
}

bool LocalImprovement::moveIfBetter(Vec2 p, double now)
{
    if (star_.quality(p, now) <= now || !mayMove(p) || !isValidCenter(star_, p)) {
        return false;
    }
    t_.points[star_.center()] = p;
    ++report_.moves;
    legalizeStar();
    return true;
}

bool LocalImprovement::mayMove(Vec2 p) const
{
    return !meanToKeep_
        || (star_.sumOfQualities(p) >= star_.sumOfQualities(t_.points[star_.center()])
            && isAreaAllowed(star_.largestTwiceArea(p)));
}

/// A merge takes two triangles away: the mean does not fall if the sum falls by twice it at most.
bool LocalImprovement::mayMerge(int target) const
{
    return !meanToKeep_
        || (star_.sumOfQualitiesWithout(target) + 2.0 * *meanToKeep_
                >= star_.sumOfQualities(t_.points[star_.center()])
            && isAreaAllowed(star_.largestTwiceAreaWithout(target)));
}

/// Of a triangle in the star after a change: within the limit or no larger than the largest now.
bool LocalImprovement::isAreaAllowed(double twiceArea) const
{
    const std::uint32_t triangle = Topology::triangleOf(star_.edge(0)); // all are in one region
    const double limit = areaLimitOf(areaOptions_, mesh_.regionOfTriangle[triangle]);
    return !(limit > 0.0 && twiceArea > 2.0 * limit)
        || twiceArea <= star_.largestTwiceArea(t_.points[star_.center()]);
}

void LocalImprovement::legalizeStar()
{
    suspects_.clear();
    for (int i = 0; i < star_.count(); ++i) {
        suspects_.push_back(star_.edge(i));
        suspects_.push_back(Topology::next(star_.edge(i)));
    }
    unsettleRing();
    legalizeSuspects();
}

void LocalImprovement::legalizeSuspects()
{
    flipped_.clear();
    legalize(t_, suspects_, &flipped_);
    for (const std::uint32_t v : flipped_) {
        mark_[v] &= static_cast<std::uint8_t>(~kSettled);
    }
}

void LocalImprovement::unsettleRing()
{
    mark_[star_.center()] &= static_cast<std::uint8_t>(~kSettled);
    for (int i = 0; i < star_.count(); ++i) {
        mark_[star_.vertex(i)] &= static_cast<std::uint8_t>(~kSettled);
    }
}

/// Steps in eight directions, shrinking, for stars that stay bad.
void LocalImprovement::searchPattern(std::uint32_t v)
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
            if (quality > bestQuality && mayMove(p)) {
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
void LocalImprovement::tryCollapse(std::uint32_t v)
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
        if (quality > best && mayMerge(i)) {
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
    unsettleRing();
    legalizeSuspects();
}

} // namespace tessera
