// SPDX-License-Identifier: MIT
//
// Sizes at the boundary's vertices.
//
// Frontal placement starts from the constrained edges, so their lengths must fit the sizes beside
// them and each other. A vertex's size starts as the size field. It is lowered to the length of a
// constrained edge at it, to the distance of another vertex or of a constrained edge that it sees,
// where these are below kGapRatio of it. Then growth is limited along the edges of the
// triangulation (Dijkstra), constrained edges longer than kLongest times the mean size of their
// ends are split, and all is repeated until nothing changes.
//
// Corners below 60 degrees: between the arms nothing can be placed or moved, so the arms get about
// equal first edges (a shell). Those are not split for their length, and only from the shell outwards
// the distance between the arms counts as a gap. Then the smallest angle of the one triangle at the
// corner is the input angle, or above 40 degrees.
//
// Constrained edges were sampled by the size field, which may grow faster than free vertices shall:
// until all are divided, sizes grow at its rate. Else edges would be halved for growth alone (at a
// growth of 0.5 every sixth one; the mean quality was 0.9540 then instead of 0.9548, the share of
// edges below 0.7 of their size 30 % instead of 0.5 %).
//
// An edge is halved in one round as often as the sizes of its ends demand; sizes measured at the
// new vertices may demand more in the next round.
//
// Gaps lower a size to kSmallestPiece of the field at most; gaps so narrow that no angle there can
// be good do not lower it, except those that the share of triangles for them (narrowShare) pays
// for: these are followed as far as they go. Complexity: O(n log n) a round for n
// boundary vertices, at most kRounds rounds.

#include "refine/vertex_sizes.h"

#include "refine/gaps.h"
#include "refine/wedges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace tessera
{

namespace
{
constexpr double kGapRatio = 0.75;
constexpr double kLongest = 1.42;
constexpr int kRounds = 12;
/// Arms of a corner pass as equal up to this ratio. Where the corner has kSharpWedge or more, the
/// smallest angle of the triangle there is the input angle up to 41 degrees, and above 40.8 degrees
/// beyond that. Sharper ones need more equal arms for the triangles behind.
constexpr double kEqualArms = 1.5;
constexpr double kEqualArmsOfSharp = 1.02;
constexpr double kSharpWedge = std::numbers::pi / 6.0;
/// Triangles beside each piece of the constrained edges, as sizes grow on both sides of it.
constexpr double kPerPiece = 3.0;
} // namespace

VertexSizes::VertexSizes(MeshEditor& editor, const SizeField& size, const RefineOptions& options)
    : editor_(editor)
    , t_(editor.triangulation())
    , size_(size)
    , options_(options)
    , hopelessGap_(hopelessGap(options.minAngle))
    , areaSize_(sizeForArea(options.maxArea))
    , growthOnEdges_(std::clamp(size.gradientBound(), kGrowth, kGrowthOnEdges))
{}

void VertexSizes::prepare(RefineReport& report, Execution& execution)
{
    makeShells(report);
    for (int round = 0;; ++round) {
        execution.checkpoint();
        shell_.resize(t_.points.size(), 0.0);
        for (std::size_t v = field_.size(); v < t_.points.size(); ++v) {
            field_.push_back(v == Topology::kInfinite ? 0.0 : fieldAt(t_.points[v]));
        }
        measure();
        if (round == 0 && followNarrowPlaces(report)) {
            measure();
        }
        if (leastPieces() > mostPieces_) {
            leaveNarrowPlaces(report);
        }
        requireFewTriangles(leastPieces(), options_);
        // The last round may not split: every vertex needs a size.
        if (options_.freezeBoundary || round + 1 == kRounds || splitLongEdges(report) == 0) {
            break;
        }
    }
    limitGrowth(kGrowth);
}

void VertexSizes::measure()
{
    h_ = field_;
    measureSpacing();
    measureGaps();
    limitGrowth(growthOnEdges_);
}

/// Chooses the narrow places that the share of triangles for them suffices for.
bool VertexSizes::followNarrowPlaces(RefineReport& report)
{
    if (options_.freezeBoundary || options_.narrowShare <= 0.0) {
        return false;
    }
    std::vector<NarrowPlace> places = findNarrowPlaces(editor_, field_, h_, options_.minAngle);
    if (places.empty()) {
        return false;
    }
    const double others
        = estimateTriangles(editor_.constMesh(), size_, options_) + kPerPiece * leastPieces();
    NarrowChoice choice
        = chooseNarrowPlaces(std::move(places), others, options_.narrowShare, t_);
    least_.assign(t_.points.size(), 0.0);
    for (const auto& [v, piece] : follow(trianglesToFollow(choice, editor_), editor_)) {
        least_[v] = least_[v] > 0.0 ? std::min(least_[v], piece) : piece;
    }
    report.messages = describeNarrowPlaces(choice);
    mostPieces_ = others + choice.spent();
    choice_ = std::move(choice);
    return !editor_.constMesh().followed.empty();
}

/// Lines that only begin or end in a narrow place may run along others for their whole length: then
/// the pieces for the one place open the next, and the places cost many times what was estimated.
void VertexSizes::leaveNarrowPlaces(RefineReport& report)
{
    editor_.mesh().followed.clear();
    least_.clear();
    mostPieces_ = std::numeric_limits<double>::infinity();
    choice_.followed = 0;
    choice_.isUnderestimated = true;
    report.messages = describeNarrowPlaces(choice_);
    measure();
}

/// How low gaps may make the size of a vertex.
double VertexSizes::leastSize(std::uint32_t v) const
{
    if (v < least_.size() && least_[v] > 0.0) {
        return std::min(least_[v], kSmallestPiece * field_[v]);
    }
    const std::uint32_t root = editor_.rootOfVertex(v);
    return root != MeshEditor::kNone
        ? leastPiece(editor_, root, t_.points[v], field_[v])
        : std::min(kSmallestPiece * field_[v], kShareOfSpacing * editor_.spacingAt(v));
}

void VertexSizes::lower(std::uint32_t vertex, double spacing)
{
    if (spacing < kGapRatio * h_[vertex]) {
        h_[vertex] = spacing;
    }
}

void VertexSizes::measureSpacing()
{
    const auto isSplit = [this](std::uint32_t v) {
        return editor_.constMesh().origin[v] == VertexOrigin::SegmentSplit;
    };
    for (const ConstrainedEdge& edge : editor_.mesh().edges) {
        // Pieces made here fit the sizes already; they would only make their neighbors be halved.
        if (isSplit(edge.a) || isSplit(edge.b)) {
            continue;
        }
        const double spacing = distance(t_.points[edge.a], t_.points[edge.b]);
        lower(edge.a, spacing);
        lower(edge.b, spacing);
    }
}

/// Gives the arms of every corner below 60 degrees first edges of one length.
void VertexSizes::makeShells(RefineReport& report)
{
    shell_.assign(t_.points.size(), 0.0);
    std::vector<std::uint32_t> corners;
    const auto isKept = [this](std::uint32_t triangle) { return editor_.isKept(triangle); };
    for (const ConstrainedEdge& edge : editor_.mesh().edges) {
        for (const std::uint32_t v : {edge.a, edge.b}) {
            if (shell_[v] == 0.0) {
                shell_[v] = -1.0;
                forEachWedge(t_, v, isKept, [&](HalfEdge, HalfEdge, double angle) {
                    if (angle < kAcuteWedge && shell_[v] < 0.0) {
                        shell_[v] = 1.0;
                        corners.push_back(v);
                    }
                });
            }
        }
    }
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t v : corners) {
        ends.clear();
        double sharpest = kAcuteWedge;
        forEachWedge(t_, v, isKept, [&](HalfEdge arm, HalfEdge next, double angle) {
            if (angle < kAcuteWedge) {
                sharpest = std::min(sharpest, angle);
                ends.push_back(t_.destination(arm));
                ends.push_back(t_.destination(next));
            }
        });
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        const double equal = sharpest < kSharpWedge ? kEqualArmsOfSharp : kEqualArms;
        const double radius = shellRadius(v, ends, equal);
        shell_[v] = radius;
        for (const std::uint32_t end : ends) {
            const double arm = distance(t_.points[v], t_.points[end]);
            const HalfEdge edge = t_.findEdge(v, end);
            if (arm <= equal * radius) {
                shell_[v] = std::max(shell_[v], arm);
            }
            else if (!options_.freezeBoundary && edge != Topology::kDead
                && editor_.splitEdge(edge, radius / arm) != MeshEditor::kNone) {
                ++report.segmentSplits;
            }
        }
        shell_.resize(t_.points.size(), 0.0);
    }
}

/// The shortest arm, if the size field allows it, or less so as to leave no short rest on any arm.
/// Arms that are longer by no more than the ratio equal stay whole.
double VertexSizes::shellRadius(std::uint32_t v, const std::vector<std::uint32_t>& ends,
                                double equal) const
{
    double radius = std::numeric_limits<double>::infinity();
    for (const std::uint32_t end : ends) {
        const double arm = distance(t_.points[v], t_.points[end]);
        // An arm between two corners is cut from both sides.
        radius = std::min(radius, shell_[end] > 0.0 ? 0.4 * arm : arm);
    }
    // Pieces that were sampled by the size field stay as they are.
    const double field = fieldAt(t_.points[v]);
    radius = radius <= kLongest * field ? radius : field;
    for (const std::uint32_t end : ends) {
        const double arm = distance(t_.points[v], t_.points[end]);
        if (arm > equal * radius && arm < 1.5 * radius) {
            return 0.6 * radius;
        }
    }
    return radius;
}

bool VertexSizes::isShellEdge(std::uint32_t a, std::uint32_t b) const
{
    const double l = distance(t_.points[a], t_.points[b]);
    return (shell_[a] > 0.0 && l <= 1.05 * shell_[a])
        || (shell_[b] > 0.0 && l <= 1.05 * shell_[b]);
}

bool VertexSizes::isInHopelessGap(std::uint32_t triangle) const
{
    for (std::uint32_t side = 0; side < 3; ++side) {
        const HalfEdge edge = Topology::halfEdge(triangle, side);
        if (t_.isConstrained(edge)
            && isHopeless(editor_, edge, field_[t_.apex(edge)], hopelessGap_)) {
            return true;
        }
    }
    return false;
}

void VertexSizes::measureGaps()
{
    const auto lowerToGap = [this](std::uint32_t v, double gap) {
        lower(v, std::max(gap, leastSize(v)));
    };
    for (std::uint32_t i = 0; i < t_.triangles.size(); ++i) {
        if (!editor_.isKept(i) || isInHopelessGap(i)) {
            continue;
        }
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge h = Topology::halfEdge(i, side);
            const std::uint32_t a = t_.origin(h);
            const std::uint32_t b = t_.destination(h);
            const double l = std::sqrt(squaredLength(t_.points[b] - t_.points[a]));
            if (!t_.isConstrained(h)) {
                lowerToGap(a, l);
                lowerToGap(b, l);
                continue;
            }
            const Gap gap = gapAbove(t_, h);
            const bool atCorner = (shell_[a] > 0.0 && t_.isConstrained(Topology::prev(h)))
                || (shell_[b] > 0.0 && t_.isConstrained(Topology::next(h)));
            if (!atCorner) {
                lowerToGap(a, gap.width + growthOnEdges_ * gap.foot * l);
                lowerToGap(b, gap.width + growthOnEdges_ * (1.0 - gap.foot) * l);
                lowerToGap(t_.apex(h), gap.width);
            }
        }
    }
}

void VertexSizes::limitGrowth(double growth)
{
    using Entry = std::pair<double, std::uint32_t>;
    const auto spacing = [this](std::uint32_t u, std::uint32_t v) {
        return std::sqrt(squaredLength(t_.points[u] - t_.points[v]));
    };
    // Most vertices lower no other: one pass in the order of memory finds those that do.
    std::vector<Entry> sources;
    std::vector<std::uint8_t> isSource(h_.size(), 0);
    for (std::uint32_t i = 0; i < t_.triangles.size(); ++i) {
        if (!editor_.isKept(i)) {
            continue;
        }
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge edge = Topology::halfEdge(i, side);
            std::uint32_t low = t_.origin(edge);
            std::uint32_t high = t_.destination(edge);
            if (h_[low] > h_[high]) {
                std::swap(low, high);
            }
            if (isSource[low] == 0 && h_[low] + growth * spacing(low, high) < h_[high]) {
                isSource[low] = 1;
                sources.emplace_back(h_[low], low);
            }
        }
    }
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue(std::greater<>(),
                                                                         std::move(sources));
    const auto lowerNeighbors = [&](std::uint32_t v) {
        t_.forEachAround(v, [&](HalfEdge edge) {
            const std::uint32_t u = t_.destination(edge);
            if (u == Topology::kInfinite || h_[u] <= h_[v]) {
                return;
            }
            const double limit = h_[v] + growth * spacing(u, v);
            if (limit < h_[u] && isBesideKept(edge)) {
                h_[u] = limit;
                queue.emplace(limit, u);
            }
        });
    };
    while (!queue.empty()) {
        const Entry top = queue.top();
        queue.pop();
        if (top.first == h_[top.second]) {
            lowerNeighbors(top.second);
        }
    }
}

/// How many pieces constrained edges will have in the end; each has a triangle of its own.
double VertexSizes::leastPieces() const
{
    double pieces = 0.0;
    for (const ConstrainedEdge& edge : editor_.constMesh().edges) {
        const double l = distance(t_.points[edge.a], t_.points[edge.b]);
        const double ratio = l / (0.5 * kLongest * (h_[edge.a] + h_[edge.b]));
        pieces += ratio > 1.0 ? std::exp2(std::ceil(std::log2(ratio))) : 1.0; // by halving
    }
    return pieces;
}

std::size_t VertexSizes::splitLongEdges(RefineReport& report)
{
    std::size_t splits = 0;
    const std::size_t count = editor_.mesh().edges.size();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces;
    for (std::size_t i = 0; i < count; ++i) {
        const ConstrainedEdge edge = editor_.mesh().edges[i];
        pieces.assign(1, {edge.a, edge.b});
        while (!pieces.empty()) {
            const auto [a, b] = pieces.back();
            pieces.pop_back();
            const double l = distance(t_.points[a], t_.points[b]);
            if (!(l > kLongest * 0.5 * (h_[a] + h_[b])) || isShellEdge(a, b)) {
                continue;
            }
            const HalfEdge h = t_.findEdge(a, b);
            const std::uint32_t v = isWorthSplitting(h) ? editor_.splitEdge(h, 0.5) : MeshEditor::kNone;
            if (v != MeshEditor::kNone) {
                ++splits;
                shell_.push_back(0.0);
                field_.push_back(fieldAt(t_.points[v]));
                h_.push_back(
                    std::min(field_[v], std::min(h_[a], h_[b]) + 0.5 * growthOnEdges_ * l));
                pieces.emplace_back(a, v);
                pieces.emplace_back(v, b);
            }
        }
    }
    report.segmentSplits += splits;
    return splits;
}

bool VertexSizes::isWorthSplitting(HalfEdge h) const
{
    for (const HalfEdge side : {h, t_.twin(h)}) {
        const std::uint32_t triangle = Topology::triangleOf(side);
        if (editor_.isKept(triangle) && !isInHopelessGap(triangle)) {
            return true;
        }
    }
    return false;
}

bool VertexSizes::isBesideKept(HalfEdge h) const
{
    return editor_.isKept(Topology::triangleOf(h))
        || editor_.isKept(Topology::triangleOf(t_.twin(h)));
}

} // namespace tessera
