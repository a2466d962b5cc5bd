// SPDX-License-Identifier: MIT
//
// Measures in pieces that several threads share; what the pieces find is put together in their
// order, so the figures do not depend on the number of threads. Angles are compared by tangents and
// become degrees at the end only.

#include "mesh/quality.h"

#include "base/parallel.h"
#include "mesh/select.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace tessera
{

namespace
{

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::size_t kPiece = 1 << 15;

/// Three angles of a triangle compared without inverse functions.
struct Shape
{
    double quality;
    double tangentOfSmallest;
    double cotangentOfLargest;
};

Shape shapeOf(Vec2 a, Vec2 b, Vec2 c)
{
    double edge[3] = {squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)};
    const double twiceArea = cross(b - a, c - a);
    const double sum = edge[0] + edge[1] + edge[2];
    const double shortest = std::min({edge[0], edge[1], edge[2]});
    const double longest = std::max({edge[0], edge[1], edge[2]});
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    if (!(sum > 0.0 && sum < kInfinite)) {
        return {0.0, 0.0, kInfinite};
    }
    return {2.0 * std::numbers::sqrt3 * twiceArea / sum,
            2.0 * std::abs(twiceArea) / (sum - 2.0 * shortest),
            0.5 * (sum - 2.0 * longest) / std::abs(twiceArea)};
}

/// Finds the bin of 5 degrees by the tangent.
class AngleBins
{
public:
    AngleBins()
    {
        for (int i = 0; i <= QualityReport::kAngleBins; ++i) {
            bound_[i] = std::tan(60.0 / QualityReport::kAngleBins * i / kDegrees);
        }
    }
    int find(double tangent) const
    {
        // Tangents grow faster than angles: the bin of a proportional angle is never too high.
        auto bin = static_cast<int>(std::min(tangent / bound_[QualityReport::kAngleBins], 1.0)
                                    * (QualityReport::kAngleBins - 1));
        while (bin + 1 < QualityReport::kAngleBins && tangent >= bound_[bin + 1]) {
            ++bin;
        }
        return bin;
    }

private:
    double bound_[QualityReport::kAngleBins + 1];
};

/// What one piece of the triangles shows.
struct Partial
{
    double qualitySum = 0.0;
    double minQuality = 1.0;
    double cotangentOfLargest = std::numeric_limits<double>::infinity();
    std::array<std::size_t, QualityReport::kAngleBins> angles {};
    std::array<std::size_t, QualityReport::kQualityBins> qualities {};
    std::vector<std::pair<double, std::uint32_t>> worst; ///< tangents with triangles, ascending

    void add(const Shape& shape, std::uint32_t triangle, const AngleBins& bins)
    {
        qualitySum += shape.quality;
        minQuality = std::min(minQuality, shape.quality);
        cotangentOfLargest = std::min(cotangentOfLargest, shape.cotangentOfLargest);
        ++angles[static_cast<std::size_t>(bins.find(shape.tangentOfSmallest))];
        constexpr int kLast = QualityReport::kQualityBins - 1;
        const int bin = static_cast<int>(shape.quality * QualityReport::kQualityBins);
        ++qualities[static_cast<std::size_t>(std::clamp(bin, 0, kLast))];
        addWorst({shape.tangentOfSmallest, triangle});
    }

    void addWorst(const std::pair<double, std::uint32_t>& candidate)
    {
        if (worst.size() == QualityReport::kWorst) {
            if (!(candidate < worst.back())) {
                return;
            }
            worst.pop_back();
        }
        worst.insert(std::upper_bound(worst.begin(), worst.end(), candidate), candidate);
    }
};

Partial joined(const std::vector<Partial>& partials)
{
    Partial all;
    for (const Partial& partial : partials) {
        all.qualitySum += partial.qualitySum;
        all.minQuality = std::min(all.minQuality, partial.minQuality);
        all.cotangentOfLargest = std::min(all.cotangentOfLargest, partial.cotangentOfLargest);
        for (std::size_t i = 0; i < all.angles.size(); ++i) {
            all.angles[i] += partial.angles[i];
        }
        for (std::size_t i = 0; i < all.qualities.size(); ++i) {
            all.qualities[i] += partial.qualities[i];
        }
        for (const auto& candidate : partial.worst) {
            all.addWorst(candidate);
        }
    }
    return all;
}

/// Edge length / size of some edges.
struct EdgeRatios
{
    std::vector<float> values;
    double min = std::numeric_limits<double>::infinity();
    double max = 0.0;

    void add(const Mesh& mesh, const SizeField& size, std::uint32_t a, std::uint32_t b)
    {
        const Vec2 p = mesh.nodes[a];
        const Vec2 q = mesh.nodes[b];
        const double ratio = std::sqrt(squaredLength(q - p)) / size.size(midpoint(p, q));
        values.push_back(static_cast<float>(ratio));
        min = std::min(min, ratio);
        max = std::max(max, ratio);
    }
};

/// Two triangles run along an inner edge in opposite directions: one of them has a < b. An outline
/// edge is run along once, as it is stored.
EdgeRatios ratiosOfTriangles(const Mesh& mesh, const SizeField& size, std::size_t begin,
                             std::size_t end)
{
    EdgeRatios ratios;
    ratios.values.reserve((end - begin) * 8 / 5);
    for (std::size_t i = begin; i < end; ++i) {
        const auto& t = mesh.triangles[i];
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t a = t[side];
            const std::uint32_t b = t[side == 2 ? 0 : side + 1];
            if (a < b) {
                ratios.add(mesh, size, a, b);
            }
        }
    }
    return ratios;
}

EdgeRatios ratiosOfOutline(const Mesh& mesh, const SizeField& size)
{
    EdgeRatios ratios;
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        if (mesh.edgeIsOutline[e] != 0 && mesh.edges[e][0] > mesh.edges[e][1]) {
            ratios.add(mesh, size, mesh.edges[e][0], mesh.edges[e][1]);
        }
    }
    return ratios;
}

QualityReport::Conformity measureConformity(const Mesh& mesh, const SizeField& size,
                                            const Execution& execution)
{
    const std::size_t pieces = (mesh.triangles.size() + kPiece - 1) / kPiece;
    std::vector<EdgeRatios> ratios(pieces + 1);
    forEachPiece(execution, mesh.triangles.size(), kPiece,
                 [&](std::size_t piece, std::size_t begin, std::size_t end) {
                     execution.checkpoint();
                     ratios[piece] = ratiosOfTriangles(mesh, size, begin, end);
                 });
    ratios.back() = ratiosOfOutline(mesh, size);
    ValuePieces values;
    QualityReport::Conformity result {std::numeric_limits<double>::infinity()};
    for (EdgeRatios& piece : ratios) {
        values.push_back(std::move(piece.values));
        result.min = std::min(result.min, piece.min);
        result.max = std::max(result.max, piece.max);
    }
    constexpr double kFractions[] = {0.05, 0.5, 0.95};
    const std::vector<float> at = percentiles(values, kFractions, execution);
    result.p05 = at[0];
    result.median = at[1];
    result.p95 = at[2];
    return result;
}

} // namespace

double triangleQuality(Vec2 a, Vec2 b, Vec2 c)
{
    return shapeOf(a, b, c).quality;
}

AngleRange triangleAngles(Vec2 a, Vec2 b, Vec2 c)
{
    const auto angle = [](Vec2 u, Vec2 v) {
        return std::atan2(std::abs(cross(u, v)), dot(u, v)) * kDegrees;
    };
    const double at[3] = {angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)};
    return {*std::min_element(at, at + 3), *std::max_element(at, at + 3)};
}

QualityReport measureQuality(const Mesh& mesh, const SizeField* size, const Execution& execution)
{
    QualityReport report;
    if (mesh.triangles.empty()) {
        return report;
    }
    const AngleBins bins;
    const std::size_t count = mesh.triangles.size();
    std::vector<Partial> partials((count + kPiece - 1) / kPiece);
    ValuePieces tangents(partials.size());
    forEachPiece(execution, count, kPiece, [&](std::size_t piece, std::size_t begin, std::size_t end) {
        execution.checkpoint();
        // Of its own, because threads that write side by side slow each other down.
        Partial partial;
        std::vector<float> tangentsOfPiece;
        tangentsOfPiece.reserve(end - begin);
        for (std::size_t t = begin; t < end; ++t) {
            const auto& v = mesh.triangles[t];
            const Shape shape = shapeOf(mesh.nodes[v[0]], mesh.nodes[v[1]], mesh.nodes[v[2]]);
            partial.add(shape, static_cast<std::uint32_t>(t), bins);
            tangentsOfPiece.push_back(static_cast<float>(shape.tangentOfSmallest));
        }
        partials[piece] = std::move(partial);
        tangents[piece] = std::move(tangentsOfPiece);
    });
    const Partial all = joined(partials);
    constexpr double kOnePercent[] = {0.01};
    report.angleP01 = std::atan(percentiles(tangents, kOnePercent, execution)[0]) * kDegrees;
    report.maxAngle = std::atan2(1.0, all.cotangentOfLargest) * kDegrees;
    report.minQuality = all.minQuality;
    report.meanQuality = all.qualitySum / static_cast<double>(count);
    report.angleHistogram = all.angles;
    report.qualityHistogram = all.qualities;
    for (const auto& [tangent, triangle] : all.worst) {
        const auto& v = mesh.triangles[triangle];
        const Vec2 a = mesh.nodes[v[0]];
        const Vec2 b = mesh.nodes[v[1]];
        const Vec2 c = mesh.nodes[v[2]];
        report.worst.push_back({triangle, (1.0 / 3.0) * (a + b + c),
                                triangleAngles(a, b, c).smallest, triangleQuality(a, b, c)});
    }
    report.minAngle = report.worst.front().angle;
    if (size != nullptr) {
        report.sizeConformity = measureConformity(mesh, *size, execution);
    }
    return report;
}

} // namespace tessera
