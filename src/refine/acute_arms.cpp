// SPDX-License-Identifier: MIT
//
// Subsegments that run straight through a vertex are joined into lines (union-find), and pairs of lines
// that leave a vertex at less than 60 degrees are listed. Two lines have at most one such corner,
// but subsegments joined within rounding may have more: all are tried.

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
constexpr double kNear = 3.0;           ///< of the longest edge of a triangle
constexpr std::size_t kMostNear = 64;  ///< vertices that are looked at for one triangle
} // namespace

AcuteArms::AcuteArms(const MeshEditor& editor)
    : editor_(editor)
    , t_(editor.triangulation())
    , line_(editor.rootCount())
    , isCorner_(t_.points.size(), 0)
{
    std::iota(line_.begin(), line_.end(), 0U);
    std::vector<std::uint8_t> seen(t_.points.size(), 0);
    for (std::uint32_t root = 0; root < line_.size(); ++root) {
        for (const std::uint32_t v : {editor.rootStart(root), editor.rootEnd(root)}) {
            if (v != MeshEditor::kNone && seen[v] == 0) {
                seen[v] = 1;
                joinAt(v);
            }
        }
    }
    for (std::uint32_t root = 0; root < line_.size(); ++root) {
        line_[root] = lineOf(root);
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
    const std::vector<std::uint32_t> lines = linesAt(t_.apex(base));
    return std::any_of(lines.begin(), lines.end(), [&](std::uint32_t line) {
        const bool endsAtApex = std::count(lines.begin(), lines.end(), line) == 1;
        return meetAcutely(std::minmax(baseLine, line), base, endsAtApex);
    });
}

bool AcuteArms::concern(std::uint32_t triangle) const
{
    return isNearCorner(triangle) || holdAll(triangle);
}

bool AcuteArms::isNearCorner(std::uint32_t triangle) const
{
    const auto& v = t_.triangles[triangle].v;
    const Vec2 p[] = {t_.points[v[0]], t_.points[v[1]], t_.points[v[2]]};
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        longest = std::max(longest, squaredLength(p[(i + 1) % 3] - p[i]));
    }
    const auto isNear = [&](std::uint32_t u) {
        return std::any_of(p, p + 3, [&](Vec2 q) {
            return squaredLength(t_.points[u] - q) <= kNear * kNear * longest;
        });
    };
    std::vector<std::uint32_t> near(v, v + 3);
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (near[i] < isCorner_.size() && isCorner_[near[i]] != 0) { // else it is a new vertex
            return true;
        }
        t_.forEachAround(near[i], [&](HalfEdge h) {
            const std::uint32_t u = t_.destination(h);
            if (u != Topology::kInfinite && near.size() < kMostNear && isNear(u)
                && std::find(near.begin(), near.end(), u) == near.end()) {
                near.push_back(u);
            }
        });
    }
    return false;
}

/// Whether all corners of the triangle lie on two arms of one corner, in the angle between them.
bool AcuteArms::holdAll(std::uint32_t triangle) const
{
    const auto& v = t_.triangles[triangle].v;
    const std::vector<std::uint32_t> at[] = {linesAt(v[0]), linesAt(v[1]), linesAt(v[2])};
    const auto isOn = [&](std::size_t i, const Lines& lines) {
        return std::any_of(at[i].begin(), at[i].end(), [&](std::uint32_t line) {
            return line == lines.first || line == lines.second;
        });
    };
    const auto areAcuteAround = [&](Vec2 corner) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 u = t_.points[v[i]] - corner;
            const Vec2 w = t_.points[v[(i + 1) % 3]] - corner;
            if (!(dot(u, w) > kCosine * length(u) * length(w))) {
                return false;
            }
        }
        return true;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        for (const std::uint32_t a : at[i]) {
            for (const std::uint32_t b : at[(i + 1) % 3]) {
                const Lines lines = std::minmax(a, b);
                if (isOn((i + 2) % 3, lines) && anyCorner(lines, areAcuteAround)) {
                    return true;
                }
            }
        }
    }
    return false;
}

std::uint32_t AcuteArms::lineOf(std::uint32_t root)
{
    while (line_[root] != root) {
        line_[root] = line_[line_[root]];
        root = line_[root];
    }
    return root;
}

std::uint32_t AcuteArms::lineAt(HalfEdge h) const
{
    const MeshEditor::RootSide on = editor_.rootSideOf(h);
    return on.root == MeshEditor::kNone ? on.root : line_[on.root];
}

/// Once for each constrained edge at v.
std::vector<std::uint32_t> AcuteArms::linesAt(std::uint32_t v) const
{
    std::vector<std::uint32_t> lines;
    if (!editor_.isFree(v)) {
        t_.forEachAround(v, [&](HalfEdge h) {
            if (t_.isConstrained(h)) {
                lines.push_back(lineAt(h));
            }
        });
    }
    return lines;
}

template<class F>
bool AcuteArms::anyCorner(const Lines& lines, F&& isAround) const
{
    auto corner = std::lower_bound(corners_.begin(), corners_.end(), lines,
                                   [](const Corner& a, const Lines& b) { return a.lines < b; });
    for (; corner != corners_.end() && corner->lines == lines; ++corner) {
        if (isAround(t_.points[corner->vertex])) {
            return true;
        }
    }
    return false;
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
        const MeshEditor::RootSide on = editor_.rootSideOf(h);
        if (on.root != MeshEditor::kNone) {
            arms_.push_back({t_.points[t_.destination(h)] - t_.points[v], on.root});
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
                line_[lineOf(arms_[k].root)] = lineOf(arms_[i].root);
            }
            else if (dot(u, w) > kCosine * lu * lw) {
                corners_.push_back({{arms_[i].root, arms_[k].root}, v});
                isCorner_[v] = 1;
            }
        }
    }
}

bool AcuteArms::meetAcutely(Lines lines, HalfEdge base, bool endsAtApex) const
{
    const Vec2 a = t_.points[t_.origin(base)];
    const Vec2 b = t_.points[t_.destination(base)];
    const Vec2 apex = t_.points[t_.apex(base)];
    return anyCorner(lines, [&](Vec2 corner) {
        const Vec2 u = midpoint(a, b) - corner;
        const Vec2 w = apex - corner;
        const double arm = length(w);
        const bool isBeyond = endsAtApex && length(u) > arm;
        return dot(u, w) > kCosine * length(u) * arm && !isBeyond;
    });
}

} // namespace tessera
