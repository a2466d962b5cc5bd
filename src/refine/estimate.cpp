// SPDX-License-Identifier: MIT
//
// The number of triangles before they are made, and the targets that were missed after.
//
// An equilateral triangle of edge h covers sqrt(3)/4 h², so the number is the integral of
// 4 / (sqrt(3) h²) over the kept area. Each kept triangle is divided into four, level by level,
// until the Lipschitz bound says that h changes little across a part, so that steep fields are not
// missed. Where the parts become too many, a systematic sample of them stands for all: the cost is
// bounded by kMostParts evaluations of the size field a level, at most kDeepest levels.

#include "refine/refine.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <numeric>

namespace tessera
{

namespace
{

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMostTriangles = 1e12;
constexpr std::size_t kMostParts = 2048;
constexpr int kDeepest = 60;

/// A part of a triangle with the integral over it by the midpoint rule; stands for weight parts.
struct Part
{
    Vec2 a, b, c;
    double largest; ///< size allowed
    double count;
    double weight;
};

class Integral
{
public:
    explicit Integral(const SizeField& size)
        : size_(size)
        , gradient_(size.gradientBound())
    {}

    /// largest bounds the size.
    void add(Vec2 a, Vec2 b, Vec2 c, double largest, double weight = 1.0)
    {
        const Vec2 center = (1.0 / 3.0) * (a + b + c);
        const double h = std::min(size_.size(center), largest);
        const double area = 0.5 * std::fabs(cross(b - a, c - a));
        const double count = 4.0 / std::numbers::sqrt3 * area / (h * h);
        const double reach
            = std::max({distance(center, a), distance(center, b), distance(center, c)});
        // h is not followed further in parts that are surely smaller than one triangle.
        const double least = h - gradient_ * reach;
        if (least > 0.75 * h || (least > 0.0 && count * h * h < 0.1 * least * least)) {
            sum_ += weight * count;
        }
        else {
            parts_.push_back({a, b, c, largest, count, weight});
        }
    }

    double finish()
    {
        for (int depth = 0; depth < kDeepest && !parts_.empty() && sum_ < kMostTriangles;
             ++depth) {
            thin();
            const std::vector<Part> parts = std::move(parts_);
            parts_.clear();
            for (const Part& p : parts) {
                const Vec2 ab = midpoint(p.a, p.b);
                const Vec2 bc = midpoint(p.b, p.c);
                const Vec2 ca = midpoint(p.c, p.a);
                add(p.a, ab, ca, p.largest, p.weight);
                add(ab, p.b, bc, p.largest, p.weight);
                add(ca, bc, p.c, p.largest, p.weight);
                add(ab, bc, ca, p.largest, p.weight);
            }
        }
        for (const Part& p : parts_) {
            sum_ += p.weight * p.count;
        }
        return std::min(sum_, kMostTriangles);
    }

private:
    /// Keeps at most kMostParts, at equal steps of the cumulated integral, so that each stands for
    /// the same share of it.
    void thin()
    {
        if (parts_.size() <= kMostParts) {
            return;
        }
        double total = 0.0;
        for (const Part& p : parts_) {
            total += p.weight * p.count;
        }
        const double step = total / kMostParts;
        double next = 0.5 * step;
        double cumulated = 0.0;
        std::size_t kept = 0;
        for (const Part& p : parts_) {
            const double share = p.weight * p.count;
            cumulated += share;
            int hits = 0;
            for (; next < cumulated; next += step) {
                ++hits;
            }
            if (hits > 0) {
                parts_[kept] = p;
                parts_[kept++].weight = p.weight * hits * step / share;
            }
        }
        parts_.resize(kept);
    }

    const SizeField& size_;
    double gradient_;
    double sum_ = 0.0;
    std::vector<Part> parts_;
};

/// Targets that triangles miss.
struct Misses
{
    std::vector<Unreached> angles;
    std::vector<Unreached> areas;

    void add(const WorkingMesh& mesh, const RefineOptions& options, double tangentLimit,
             std::uint32_t triangle)
    {
        const Triangulation& t = mesh.triangulation;
        if (!t.isFinite(triangle) || mesh.regionOfTriangle[triangle] == WorkingMesh::kOutside) {
            return;
        }
        const auto& v = t.triangles[triangle].v;
        const Vec2 p[3] = {t.points[v[0]], t.points[v[1]], t.points[v[2]]};
        double squared[3] = {squaredLength(p[2] - p[1]), squaredLength(p[0] - p[2]),
                             squaredLength(p[1] - p[0])};
        const double twiceArea = cross(p[1] - p[0], p[2] - p[0]);
        const Vec2 center = (1.0 / 3.0) * (p[0] + p[1] + p[2]);
        if (squared[1] < squared[0]) {
            std::swap(squared[0], squared[1]);
        }
        if (squared[2] < squared[0]) {
            std::swap(squared[0], squared[2]);
        }
        const double twiceDot = squared[1] + squared[2] - squared[0];
        if (twiceArea < 0.5 * tangentLimit * twiceDot) {
            angles.push_back({"min_angle", center,
                              std::atan2(twiceArea, 0.5 * twiceDot) * kDegrees, options.minAngle});
        }
        const double areaLimit = areaLimitOf(options, mesh.regionOfTriangle[triangle]);
        if (areaLimit > 0.0 && 0.5 * twiceArea > areaLimit) {
            areas.push_back({"max_area", center, 0.5 * twiceArea, areaLimit});
        }
    }
};

} // namespace

double areaLimitOf(const RefineOptions& options, std::uint32_t region)
{
    double limit = options.maxArea;
    if (region < options.regionMaxArea.size() && options.regionMaxArea[region] > 0.0) {
        limit = limit > 0.0 ? std::min(limit, options.regionMaxArea[region])
                            : options.regionMaxArea[region];
    }
    return limit;
}

double sizeForArea(double area)
{
    // Equilateral triangles of that area have this edge; most are not quite equilateral.
    return area > 0.0 ? std::sqrt(area) * std::sqrt(4.0 / std::numbers::sqrt3) * 0.9
                      : std::numeric_limits<double>::infinity();
}

void requireFewTriangles(double triangles, const RefineOptions& options)
{
    if (options.maxTriangles > 0.0 && triangles > options.maxTriangles) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "The mesh would have more than %.3g triangles, which is all that fits into the "
                      "free memory; choose a larger size.",
                      options.maxTriangles);
        throw Error(ErrorKind::TooLarge, text);
    }
}

double estimateTriangles(const WorkingMesh& mesh, const SizeField& size,
                         const RefineOptions& options)
{
    const Triangulation& t = mesh.triangulation;
    const double uniform = size.uniformSize();
    Integral integral(size);
    double inside = 0.0;
    for (std::uint32_t i = 0; i < t.triangles.size(); ++i) {
        if (!t.isFinite(i) || mesh.regionOfTriangle[i] == WorkingMesh::kOutside) {
            continue;
        }
        const auto& v = t.triangles[i].v;
        const Vec2 a = t.points[v[0]];
        const Vec2 b = t.points[v[1]];
        const Vec2 c = t.points[v[2]];
        const double largest = sizeForArea(areaLimitOf(options, mesh.regionOfTriangle[i]));
        if (uniform > 0.0) {
            const double h = std::min(uniform, largest);
            inside += 2.0 / std::numbers::sqrt3 * (cross(b - a, c - a) / h / h);
        }
        else {
            integral.add(a, b, c, largest);
        }
    }
    inside += integral.finish();
    return std::min(inside + static_cast<double>(mesh.edges.size()), kMostTriangles);
}

std::vector<Unreached> findUnreached(const WorkingMesh& mesh, const RefineOptions& options,
                                     const Execution& execution)
{
    std::vector<std::uint32_t> all(mesh.triangulation.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    return findUnreached(mesh, options, all, execution);
}

std::vector<Unreached> findUnreached(const WorkingMesh& mesh, const RefineOptions& options,
                                     std::span<const std::uint32_t> triangles,
                                     const Execution& execution)
{
    constexpr std::size_t kPiece = 1 << 14;
    const double tangentLimit = std::tan(options.minAngle / kDegrees);
    std::vector<Misses> misses((triangles.size() + kPiece - 1) / kPiece);
    forEachPiece(execution, triangles.size(), kPiece,
                 [&](std::size_t piece, std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) {
                         misses[piece].add(mesh, options, tangentLimit, triangles[i]);
                     }
                 });
    Misses all;
    for (const Misses& part : misses) {
        all.angles.insert(all.angles.end(), part.angles.begin(), part.angles.end());
        all.areas.insert(all.areas.end(), part.areas.begin(), part.areas.end());
    }
    std::stable_sort(all.angles.begin(), all.angles.end(),
                     [](const auto& a, const auto& b) { return a.value < b.value; });
    std::stable_sort(all.areas.begin(), all.areas.end(), [](const auto& a, const auto& b) {
        return a.value / a.target > b.value / b.target;
    });
    all.angles.insert(all.angles.end(), all.areas.begin(), all.areas.end());
    return all.angles;
}

} // namespace tessera
