// SPDX-License-Identifier: MIT
#include "mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tessera
{

namespace
{

constexpr double kDegrees = 180.0 / std::numbers::pi;

double percentile(std::vector<double>& values, double fraction)
{
    const auto at = static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at),
                     values.end());
    return values[at];
}

QualityReport::Conformity measureConformity(const Mesh& mesh, const SizeField& size)
{
    std::vector<double> ratios;
    ratios.reserve(mesh.triangles.size() * 3 / 2 + mesh.edges.size());
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
        const Vec2 p = mesh.nodes[a];
        const Vec2 q = mesh.nodes[b];
        ratios.push_back(std::sqrt(squaredLength(q - p)) / size.size(midpoint(p, q)));
    };
    // Two triangles run along an inner edge in opposite directions: one of them has a < b. An
    // outline edge is run along once, as it is stored.
    for (const auto& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            if (t[i] < t[(i + 1) % 3]) {
                add(t[i], t[(i + 1) % 3]);
            }
        }
    }
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        if (mesh.edgeIsOutline[e] != 0 && mesh.edges[e][0] > mesh.edges[e][1]) {
            add(mesh.edges[e][0], mesh.edges[e][1]);
        }
    }
    const auto [min, max] = std::minmax_element(ratios.begin(), ratios.end());
    QualityReport::Conformity result;
    result.min = *min;
    result.max = *max;
    result.p05 = percentile(ratios, 0.05);
    result.median = percentile(ratios, 0.5);
    result.p95 = percentile(ratios, 0.95);
    return result;
}

} // namespace

double triangleQuality(Vec2 a, Vec2 b, Vec2 c)
{
    const double edges = squaredLength(b - a) + squaredLength(c - b) + squaredLength(a - c);
    return edges > 0.0 ? 2.0 * std::numbers::sqrt3 * cross(b - a, c - a) / edges : 0.0;
}

AngleRange triangleAngles(Vec2 a, Vec2 b, Vec2 c)
{
    const auto angle = [](Vec2 u, Vec2 v) {
        return std::atan2(std::abs(cross(u, v)), dot(u, v)) * kDegrees;
    };
    const double at[3] = {angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)};
    return {*std::min_element(at, at + 3), *std::max_element(at, at + 3)};
}

QualityReport measureQuality(const Mesh& mesh, const SizeField* size)
{
    QualityReport report;
    if (mesh.triangles.empty()) {
        return report;
    }
    std::vector<double> smallest;
    smallest.reserve(mesh.triangles.size());
    double sum = 0.0;
    report.minAngle = 180.0;
    report.minQuality = 1.0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        const Vec2 a = mesh.nodes[v[0]];
        const Vec2 b = mesh.nodes[v[1]];
        const Vec2 c = mesh.nodes[v[2]];
        const double q = triangleQuality(a, b, c);
        const AngleRange angles = triangleAngles(a, b, c);
        sum += q;
        smallest.push_back(angles.smallest);
        report.minQuality = std::min(report.minQuality, q);
        report.maxAngle = std::max(report.maxAngle, angles.largest);
        if (angles.smallest < report.minAngle) {
            report.minAngle = angles.smallest;
            report.worstTriangle = t;
        }
    }
    report.meanQuality = sum / static_cast<double>(mesh.triangles.size());
    report.angleP01 = percentile(smallest, 0.01);
    if (size != nullptr) {
        report.sizeConformity = measureConformity(mesh, *size);
    }
    return report;
}

} // namespace tessera
