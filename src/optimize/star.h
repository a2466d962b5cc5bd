// SPDX-License-Identifier: MIT
#pragma once

#include "base/vec2.h"
#include "delaunay/triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

namespace tessera
{

/// Squared sine of the smallest angle of a triangle, 0 .. 0.75, rounded; negative if clockwise. It
/// orders triangles as their smallest angle does, without a root.
inline double squaredSineOfSmallest(Vec2 a, Vec2 b, Vec2 c)
{
    const double ab = squaredLength(b - a);
    const double bc = squaredLength(c - b);
    const double ca = squaredLength(a - c);
    const double twiceArea = cross(b - a, c - a);
    // The two longer edges; ratios first, so that no power of a length above the second occurs.
    const double longest = std::max({ab, bc, ca});
    const double middle = std::max(std::min(ab, bc), std::min(std::max(ab, bc), ca));
    return middle > 0.0 ? twiceArea / longest * (std::abs(twiceArea) / middle) : 0.0;
}

/// 4 sqrt(3) area / sum of squared edges: 1 for an equilateral triangle, negative if clockwise, 0
/// for a point.
inline double qualityOf(Vec2 a, Vec2 b, Vec2 c)
{
    constexpr double kTwiceRootOfThree = 2.0 * std::numbers::sqrt3;
    const double squares = squaredLength(b - a) + squaredLength(c - b) + squaredLength(a - c);
    return squares > 0.0 ? kTwiceRootOfThree * (cross(b - a, c - a) / squares) : 0.0;
}

/// The ring of vertices around an interior vertex, counter-clockwise.
class Star
{
public:
    static constexpr int kMost = 48;

    /// False if the vertex has more neighbors than fit or a ghost triangle.
    bool gather(const Triangulation& t, std::uint32_t vertex)
    {
        count_ = 0;
        center_ = vertex;
        const HalfEdge first = t.incident[vertex];
        if (first == Topology::kDead) {
            return false;
        }
        HalfEdge h = first;
        do {
            const std::uint32_t neighbor = t.destination(h);
            if (count_ == kMost || neighbor == Topology::kInfinite) {
                return false;
            }
            edge_[count_] = h;
            vertex_[count_] = neighbor;
            ring_[count_++] = t.points[neighbor];
            h = t.nextAround(h);
        } while (h != first);
        return true;
    }

    std::uint32_t center() const { return center_; }
    int count() const { return count_; }
    HalfEdge edge(int i) const { return edge_[i]; } ///< from the center to vertex(i)
    std::uint32_t vertex(int i) const { return vertex_[i]; }
    Vec2 ring(int i) const { return ring_[i]; }
    int after(int i) const { return i + 1 == count_ ? 0 : i + 1; }

    Vec2 average() const
    {
        Vec2 sum;
        for (int i = 0; i < count_; ++i) {
            sum = sum + ring_[i];
        }
        return (1.0 / count_) * sum;
    }
    /// Smallest over the triangles of squaredSineOfSmallest with the center at p; stops early
    /// below the given bound.
    double quality(Vec2 p, double bound = -1.0) const
    {
        double worst = 1.0;
        Vec2 previous = ring_[count_ - 1];
        for (int i = 0; i < count_; ++i) {
            worst = std::min(worst, squaredSineOfSmallest(p, previous, ring_[i]));
            if (worst <= bound) {
                return worst;
            }
            previous = ring_[i];
        }
        return worst;
    }
    /// As quality() after the center has been merged into ring vertex target.
    double qualityWithout(int target, double bound = -1.0) const
    {
        double worst = 1.0;
        for (int i = after(target); after(i) != target; i = after(i)) {
            worst = std::min(worst,
                             squaredSineOfSmallest(ring_[target], ring_[i], ring_[after(i)]));
            if (worst <= bound) {
                return worst;
            }
        }
        return worst;
    }
    /// Sum of qualityOf() over the triangles with the center at p.
    double sumOfQualities(Vec2 p) const
    {
        double sum = 0.0;
        for (int i = 0; i < count_; ++i) {
            sum += qualityOf(p, ring_[i], ring_[after(i)]);
        }
        return sum;
    }
    /// As sumOfQualities() after the center has been merged into ring vertex target.
    double sumOfQualitiesWithout(int target) const
    {
        double sum = 0.0;
        for (int i = after(target); after(i) != target; i = after(i)) {
            sum += qualityOf(ring_[target], ring_[i], ring_[after(i)]);
        }
        return sum;
    }
    /// Twice the largest area of the triangles with the center at p.
    double largestTwiceArea(Vec2 p) const
    {
        double largest = 0.0;
        for (int i = 0; i < count_; ++i) {
            largest = std::max(largest, cross(ring_[i] - p, ring_[after(i)] - p));
        }
        return largest;
    }
    /// As largestTwiceArea() after the center has been merged into ring vertex target.
    double largestTwiceAreaWithout(int target) const
    {
        double largest = 0.0;
        for (int i = after(target); after(i) != target; i = after(i)) {
            largest = std::max(largest, cross(ring_[i] - ring_[target],
                                              ring_[after(i)] - ring_[target]));
        }
        return largest;
    }
    double squaredLengthTo(int i, Vec2 p) const { return squaredLength(ring_[i] - p); }

private:
    std::uint32_t center_ = 0;
    int count_ = 0;
    HalfEdge edge_[kMost];
    std::uint32_t vertex_[kMost];
    Vec2 ring_[kMost];
};

} // namespace tessera
