// SPDX-License-Identifier: MIT
//
// Edges that run straight through a vertex are joined into lines (union-find), and pairs of lines
// that leave a vertex at less than 60 degrees are listed. Two lines have at most one such corner,
// but edges joined within rounding may have more: all are tried.

#include "refine/acute_arms.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tessera
{

namespace
{
constexpr double kStraight = 1e-7; ///< radians
/// Radians per coordinate over length: a few roundings of the two ends.
constexpr double kRounding = 8e-16;
constexpr double kCosine = 0.5; ///< of 60 degrees
/// Where more lines meet, each is compared with the next kNeighbors only, so that neither time nor
/// memory grows with the square of their number; lines are taken to end there.
constexpr std::size_t kMostArms = 256;
constexpr std::size_t kNeighbors = 16;
} // namespace

AcuteArms::AcuteArms(const MeshEditor& editor)
    : editor_(editor)
    , t_(editor.triangulation())
    , line_(editor.constMesh().edges.size())
{
    std::iota(line_.begin(), line_.end(), 0U);
    std::vector<std::uint8_t> seen(t_.points.size(), 0);
    for (const ConstrainedEdge& edge : editor.constMesh().edges) {
        for (const std::uint32_t v : {edge.a, edge.b}) {
            if (seen[v] == 0) {
                seen[v] = 1;
                joinAt(v);
            }
        }
    }
    for (std::uint32_t edge = 0; edge < line_.size(); ++edge) {
        line_[edge] = lineOf(edge);
    }
    for (Corner& corner : corners_) {
        corner.lines = std::minmax(line_[corner.lines.first], line_[corner.lines.second]);
    }
    std::sort(corners_.begin(), corners_.end(),
              [](const Corner& a, const Corner& b) { return a.lines < b.lines; });
}

bool AcuteArms::areAround(HalfEdge base) const
{
    const std::uint32_t baseLine = lineAt(base);
    const std::uint32_t apex = t_.apex(base);
    std::vector<std::uint32_t> lines;
    t_.forEachAround(apex, [&](HalfEdge h) {
        if (t_.isConstrained(h)) {
            lines.push_back(lineAt(h));
        }
    });
    return std::any_of(lines.begin(), lines.end(), [&](std::uint32_t line) {
        const bool endsAtApex = std::count(lines.begin(), lines.end(), line) == 1;
        return meetAcutely(std::minmax(baseLine, line), base, endsAtApex);
    });
}

std::uint32_t AcuteArms::lineOf(std::uint32_t edge)
{
    while (line_[edge] != edge) {
        line_[edge] = line_[line_[edge]];
        edge = line_[edge];
    }
    return edge;
}

std::uint32_t AcuteArms::lineAt(HalfEdge h) const
{
    const std::uint32_t edge = editor_.findRecord(t_.origin(h), t_.destination(h));
    return edge == MeshEditor::kNone ? edge : line_[edge];
}

void AcuteArms::measureArms(std::uint32_t v)
{
    arms_.clear();
    t_.forEachAround(v, [&](HalfEdge h) {
        if (!t_.isConstrained(h)
            || !(editor_.isKept(Topology::triangleOf(h))
                 || editor_.isKept(Topology::triangleOf(t_.twin(h))))) {
            return;
        }
        const std::uint32_t edge = editor_.findRecord(v, t_.destination(h));
        if (edge != MeshEditor::kNone) {
            arms_.push_back({t_.points[t_.destination(h)] - t_.points[v], edge});
        }
    });
}

/// Joins the edges that run straight through v, as far as rounded coordinates tell, and lists its
/// acute corners.
void AcuteArms::joinAt(std::uint32_t v)
{
    measureArms(v);
    const Vec2 p = t_.points[v];
    const double rounding = kRounding * (std::fabs(p.x) + std::fabs(p.y));
    const std::size_t reach = arms_.size() > kMostArms ? kNeighbors : arms_.size();
    for (std::size_t i = 0; i < arms_.size(); ++i) {
        for (std::size_t k = i + 1; k < std::min(arms_.size(), i + 1 + reach); ++k) {
            const Vec2 u = arms_[i].along;
            const Vec2 w = arms_[k].along;
            const double lu = length(u);
            const double lw = length(w);
            const double straight = kStraight + rounding / std::min(lu, lw);
            if (dot(u, w) < 0.0 && std::fabs(cross(u, w)) <= straight * lu * lw) {
                line_[lineOf(arms_[k].edge)] = lineOf(arms_[i].edge);
            }
            else if (dot(u, w) > kCosine * lu * lw) {
                corners_.push_back({{arms_[i].edge, arms_[k].edge}, v});
            }
        }
    }
}

bool AcuteArms::meetAcutely(Lines lines, HalfEdge base, bool endsAtApex) const
{
    const Vec2 a = t_.points[t_.origin(base)];
    const Vec2 b = t_.points[t_.destination(base)];
    const Vec2 apex = t_.points[t_.apex(base)];
    auto corner = std::lower_bound(corners_.begin(), corners_.end(), lines,
                                   [](const Corner& a, const Lines& b) { return a.lines < b; });
    for (; corner != corners_.end() && corner->lines == lines; ++corner) {
        const Vec2 at = t_.points[corner->vertex];
        const Vec2 u = midpoint(a, b) - at;
        const Vec2 w = apex - at;
        const double arm = length(w);
        const bool isBeyond = endsAtApex && length(u) > arm;
        if (dot(u, w) > kCosine * length(u) * arm && !isBeyond) {
            return true;
        }
    }
    return false;
}

} // namespace tessera
