// SPDX-License-Identifier: MIT
//
// Places too narrow for the smallest pieces that refinement makes everywhere.
//
// Triangles with an edge on one side of a place and their apex on the other side tell its width w
// there; those joined by unconstrained edges make one place. With sizes that grow from w on both
// sides by g per length, 4 / (sqrt(3) h²) triangles per area, a place of the length L needs about
// 2 integral 4 / (sqrt(3) (w + g y)²) dy = 4.6 / (g w) per length, L / w times 23 for g = 0.2; a
// single point about 2 pi 4 / (sqrt(3) g²) log(h / w). Where sizes are small anyway (h, without the
// narrow places), 1 / h is taken off. On drawings and maps the meshes grew by 0.05 to 0.8 of that.
//
// Between two straight lines that meet at less than 60 degrees small angles stay near the corner,
// whatever is spent: such places come last, and end where gaps of other kinds begin.

#include "refine/narrow_places.h"

#include "base/number_text.h"
#include "refine/acute_arms.h"
#include "refine/gaps.h"
#include "refine/vertex_sizes.h"
#include "refine/wedges.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace tessera
{

namespace
{

/// Sizes from several places meet, so that the sum over all places is too much; measured.
constexpr double kMeasured = 0.25;
constexpr double kDensity = kMeasured * 2.31; ///< 4 / sqrt(3): triangles of edge h per h²
/// Each strip is counted from both of its sides.
constexpr double kPerLength = kDensity / VertexSizes::kGrowth;
constexpr double kPerPoint
    = 2.0 * std::numbers::pi * kDensity / (VertexSizes::kGrowth * VertexSizes::kGrowth);
/// What is left of the width is at least this: apexes met later are not much nearer.
constexpr double kMargin = 0.25;
/// A mesh that is large anyway is not doubled for narrow places.
constexpr double kMostForNarrowPlaces = 5e5;
/// At most, for a share of 1, between the arms of corners: small angles remain there in any case.
constexpr double kMostBetweenArms = 6e4;

/// The constrained edge of a triangle; kDead if there is none, or more than one: then there is a
/// corner and no gap.
HalfEdge baseOf(const Triangulation& t, std::uint32_t triangle)
{
    HalfEdge base = Topology::kDead;
    for (std::uint32_t side = 0; side < 3; ++side) {
        const HalfEdge edge = Topology::halfEdge(triangle, side);
        if (t.isConstrained(edge)) {
            if (base != Topology::kDead) {
                return Topology::kDead;
            }
            base = edge;
        }
    }
    return base;
}

/// The distance between the constrained edge of a triangle and its apex; infinite without a base.
double widthOf(const Triangulation& t, std::uint32_t triangle)
{
    const HalfEdge base = baseOf(t, triangle);
    if (base == Topology::kDead) {
        return std::numeric_limits<double>::infinity();
    }
    // Where two sides of a gap are divided alike, rounding decides whether a foot is on the edge.
    const Vec2 apex = t.points[t.apex(base)];
    return std::min({gapAbove(t, base).width, distance(apex, t.points[t.origin(base)]),
                     distance(apex, t.points[t.destination(base)])});
}

/// Where a constrained edge meets another one of its triangle at less than 60 degrees: how far their
/// other ends are apart; else 0.
double widthAtCorner(const Triangulation& t, HalfEdge edge)
{
    for (const HalfEdge open : {Topology::next(edge), Topology::prev(edge)}) {
        const HalfEdge arm = open == Topology::next(edge) ? Topology::prev(edge)
                                                          : Topology::next(edge);
        const Vec2 corner = t.points[t.apex(open)];
        const Vec2 u = t.points[t.origin(open)] - corner;
        const Vec2 w = t.points[t.destination(open)] - corner;
        if (!t.isConstrained(open) && t.isConstrained(arm)
            && std::fabs(std::atan2(cross(u, w), dot(u, w))) < kAcuteWedge) {
            return length(u - w);
        }
    }
    return 0.0;
}

/// Halfway between the apex and the nearest point of the base, of a triangle that has a width.
Vec2 middleOf(const Triangulation& t, std::uint32_t triangle)
{
    const HalfEdge base = baseOf(t, triangle);
    const Vec2 a = t.points[t.origin(base)];
    const Vec2 along = t.points[t.destination(base)] - a;
    const double foot = gapAbove(t, base).foot;
    return midpoint(foot > 0.0 ? a + std::min(foot, 1.0) * along : a, t.points[t.apex(base)]);
}

double costOf(std::span<const NarrowPlace> places)
{
    return std::accumulate(places.begin(), places.end(), 0.0,
                           [](double sum, const NarrowPlace& place) { return sum + place.cost; });
}

/// The share that pays for these places.
double shareFor(std::span<const NarrowPlace> places, double others)
{
    double betweenArms = 0.0;
    for (const NarrowPlace& place : places) {
        betweenArms += place.isBetweenArms ? place.cost : 0.0;
    }
    return 1.0001 * std::max(costOf(places) / others, betweenArms / kMostBetweenArms);
}

std::string narrowestOf(std::span<const NarrowPlace> places)
{
    const auto narrowest
        = std::min_element(places.begin(), places.end(),
                           [](const auto& a, const auto& b) { return a.width < b.width; });
    return "the narrowest is " + numberText(narrowest->width, 2) + " wide at "
        + placeText(narrowest->middle) + ".";
}

/// Rounded to two digits.
double roughly(double value)
{
    return std::strtod(numberText(value, 2).c_str(), nullptr);
}
double roughlyAtLeast(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::ceil(value / unit) * unit;
}

/// Its inverse is the mean of 1 / w where w goes from a to b linearly.
double logarithmicMean(double a, double b)
{
    return std::fabs(b - a) > 1e-3 * a ? (b - a) / std::log(b / a) : 0.5 * (a + b);
}

void putWidestFirst(NarrowPlace& place, std::span<const double> width)
{
    std::vector<std::size_t> order(place.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t {0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return width[place.triangles[a]] > width[place.triangles[b]];
    });
    NarrowPlace sorted = place;
    for (std::size_t i = 0; i < order.size(); ++i) {
        sorted.triangles[i] = place.triangles[order[i]];
        sorted.costs[i] = place.costs[order[i]];
    }
    place = std::move(sorted);
}

/// Beside its base a narrow triangle is divided finely from the foot of its apex to the ends, but not
/// towards triangles that are left.
FollowedTriangle reachOf(const Triangulation& t, std::uint32_t triangle,
                         std::span<const std::uint8_t> isLeft)
{
    const HalfEdge base = baseOf(t, triangle);
    const Vec2 a = t.points[t.origin(base)];
    const Vec2 b = t.points[t.destination(base)];
    const Vec2 foot = a + std::clamp(gapAbove(t, base).foot, 0.0, 1.0) * (b - a);
    const auto isLeftBeyond = [&](HalfEdge side) {
        return isLeft[Topology::triangleOf(t.twin(side))] != 0;
    };
    return {triangle, widthOf(t, triangle),
            {isLeftBeyond(Topology::prev(base)) ? foot : a,
             isLeftBeyond(Topology::next(base)) ? foot : b}};
}

/// Takes as many of the widest triangles off the place as cost at most limit; none if these are all.
NarrowPlace takeWidest(NarrowPlace& place, double limit, const Triangulation& t)
{
    std::size_t count = 0;
    double cost = 0.0;
    while (count < place.costs.size() && cost + place.costs[count] <= limit) {
        cost += place.costs[count++];
    }
    if (count == 0 || count == place.costs.size()) {
        return {};
    }
    const auto last = place.triangles.begin() + static_cast<std::ptrdiff_t>(count);
    const auto lastCost = place.costs.begin() + static_cast<std::ptrdiff_t>(count);
    NarrowPlace wide {{place.triangles.begin(), last}, {place.costs.begin(), lastCost},
                      cost, widthOf(t, last[-1]), middleOf(t, last[-1]), true};
    place.triangles.erase(place.triangles.begin(), last);
    place.costs.erase(place.costs.begin(), lastCost);
    place.cost -= cost;
    return wide;
}

} // namespace

std::vector<NarrowPlace> findNarrowPlaces(const MeshEditor& editor, std::span<const double> field,
                                          std::span<const double> sizes, double minAngle)
{
    const Triangulation& t = editor.triangulation();
    const double limit = hopelessGap(minAngle) * kSmallestPiece;
    // By triangle: its width where that is narrow, 0 once it belongs to a place, else infinite.
    constexpr double kWide = std::numeric_limits<double>::infinity();
    std::vector<double> width(t.triangles.size(), kWide);
    for (std::uint32_t i = 0; i < width.size(); ++i) {
        if (editor.isKept(i) && t.isFinite(i)) {
            // Splitting stops where the size at any corner makes the gap hopeless.
            const auto& v = t.triangles[i].v;
            const double size = std::max({field[v[0]], field[v[1]], field[v[2]]});
            const double w = widthOf(t, i);
            width[i] = w < limit * size ? w : kWide;
        }
    }
    if (std::all_of(width.begin(), width.end(), [](double w) { return w == kWide; })) {
        return {};
    }
    const AcuteArms arms(editor);
    std::vector<std::uint8_t> isBetweenArms(width.size(), 0);
    for (std::uint32_t i = 0; i < width.size(); ++i) {
        isBetweenArms[i] = width[i] < kWide && arms.areAround(baseOf(t, i)) ? 1 : 0;
    }
    std::vector<NarrowPlace> places;
    std::vector<std::uint8_t> seen(width.size(), 0);
    for (std::uint32_t first = 0; first < width.size(); ++first) {
        if (width[first] == kWide || seen[first] != 0) {
            continue;
        }
        NarrowPlace place {{first}, {}, 0.0, width[first], {}, isBetweenArms[first] != 0};
        std::uint32_t narrowest = first;
        seen[first] = 1;
        double depth = 0.0; // log of the size over the width
        const auto sizeAt = [&](std::uint32_t triangle) {
            const auto& v = t.triangles[triangle].v;
            return std::max({sizes[v[0]], sizes[v[1]], sizes[v[2]]});
        };
        for (std::size_t i = 0; i < place.triangles.size(); ++i) {
            const std::uint32_t triangle = place.triangles[i];
            depth = std::max(depth, std::log(sizeAt(triangle) / width[triangle]));
            if (width[triangle] < width[narrowest]) {
                narrowest = triangle;
            }
            double cost = 0.0;
            for (std::uint32_t side = 0; side < 3; ++side) {
                const HalfEdge h = Topology::halfEdge(triangle, side);
                if (t.isConstrained(h)) {
                    continue;
                }
                const std::uint32_t next = Topology::triangleOf(t.twin(h));
                if (width[next] == kWide) {
                    continue;
                }
                const double w = logarithmicMean(width[triangle], width[next]);
                const double density = std::max(0.0, 1.0 / w - 1.0 / sizeAt(triangle));
                // The constrained edge from its end on h to the foot of the other end of h.
                for (const HalfEdge base : {Topology::next(h), Topology::prev(h)}) {
                    if (t.isConstrained(base)) {
                        const Gap gap = gapAbove(t, base);
                        const double share = base == Topology::next(h) ? gap.foot : 1.0 - gap.foot;
                        const double l = distance(t.points[t.origin(base)],
                                                  t.points[t.destination(base)]);
                        cost += kPerLength * l * std::clamp(share, 0.0, 1.0) * density;
                    }
                }
                if (seen[next] == 0 && isBetweenArms[next] == isBetweenArms[first]) {
                    seen[next] = 1;
                    place.triangles.push_back(next);
                }
            }
            place.costs.push_back(cost);
        }
        place.cost = std::accumulate(place.costs.begin(), place.costs.end(), kPerPoint * depth);
        if (place.isBetweenArms) {
            putWidestFirst(place, width);
        }
        place.width = width[narrowest];
        place.middle = middleOf(t, narrowest);
        places.push_back(std::move(place));
    }
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
        return a.isBetweenArms != b.isBetweenArms ? b.isBetweenArms : a.cost < b.cost;
    });
    return places;
}

NarrowChoice chooseNarrowPlaces(std::vector<NarrowPlace> places, double others, double narrowShare,
                                const Triangulation& t)
{
    double left = std::min(narrowShare * others, kMostForNarrowPlaces);
    bool isBetweenArms = false; // such places come last
    std::vector<NarrowPlace> followed;
    std::vector<NarrowPlace> rest;
    for (NarrowPlace& place : places) {
        if (place.isBetweenArms) {
            left = isBetweenArms ? left : std::min(left, narrowShare * kMostBetweenArms);
            isBetweenArms = true;
            NarrowPlace wide = takeWidest(place, left, t);
            if (!wide.triangles.empty()) {
                left -= wide.cost;
                followed.push_back(std::move(wide));
            }
        }
        const bool isPayable = place.cost <= left;
        left -= isPayable ? place.cost : 0.0;
        (isPayable ? followed : rest).push_back(std::move(place));
    }
    const std::size_t count = followed.size();
    std::move(rest.begin(), rest.end(), std::back_inserter(followed));
    return {std::move(followed), count, others};
}

double NarrowChoice::spent() const
{
    return costOf(std::span(places).first(followed));
}

std::vector<FollowedTriangle> trianglesToFollow(const NarrowChoice& choice,
                                                const MeshEditor& editor)
{
    const Triangulation& t = editor.triangulation();
    std::vector<std::uint8_t> isFollowed(t.triangles.size(), 0);
    std::vector<std::uint8_t> isLeft(t.triangles.size(), 0);
    for (std::size_t i = 0; i < choice.places.size(); ++i) {
        for (const std::uint32_t triangle : choice.places[i].triangles) {
            (i < choice.followed ? isFollowed : isLeft)[triangle] = 1;
        }
    }
    std::vector<FollowedTriangle> follow;
    for (const NarrowPlace& place : std::span(choice.places).first(choice.followed)) {
        for (const std::uint32_t triangle : place.triangles) {
            follow.push_back(reachOf(t, triangle, isLeft));
        }
    }
    for (std::size_t i = 0; i < follow.size(); ++i) {
        const FollowedTriangle from = follow[i];
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge edge = Topology::halfEdge(from.triangle, side);
            const HalfEdge twin = t.twin(edge);
            const std::uint32_t next = Topology::triangleOf(twin);
            if (!t.isConstrained(edge) || !editor.isKept(next) || isFollowed[next] != 0) {
                continue;
            }
            const bool isWider = isLeft[next] != 0 ? widthOf(t, next) >= from.width
                                                   : widthAtCorner(t, twin) >= from.width;
            if (isWider) {
                isFollowed[next] = 1;
                follow.push_back({next, from.width, {from.reach[0], from.reach[1]}});
            }
        }
    }
    return follow;
}

std::vector<std::string> describeNarrowPlaces(const NarrowChoice& choice)
{
    const std::span<const NarrowPlace> followed(choice.places.data(), choice.followed);
    const auto left = std::span<const NarrowPlace>(choice.places).subspan(choice.followed);
    const double spent = choice.spent();
    std::vector<std::string> messages;
    if (spent > choice.others) {
        messages.push_back("Gaps far narrower than the size take most of the triangles; "
                           + narrowestOf(followed)
                           + " Close them with a weld tolerance, or leave them coarse with narrow"
                             " gaps = 0.");
    }
    if (!left.empty()) {
        std::size_t payable = 0;
        double further = 0.0;
        while (payable < left.size()
               && spent + further + left[payable].cost <= kMostForNarrowPlaces) {
            further += left[payable++].cost;
        }
        std::string text = "Gaps far narrower than the size are left coarse, with small angles; "
            + narrowestOf(left) + " Close them with a weld tolerance";
        if (choice.isUnderestimated) {
            text += ": to divide them finely takes far more triangles than the gaps are worth.";
        }
        else if (payable == 0) {
            text += ": to divide them finely takes more than "
                + numberText(kMostForNarrowPlaces)
                + " triangles, the most that is spent on such gaps.";
        }
        else {
            const std::string which = payable == left.size()
                ? "them"
                : std::to_string(payable) + " of " + std::to_string(left.size());
            text += ", or divide " + which + " finely with narrow gaps = "
                + numberText(roughlyAtLeast(shareFor(
                    std::span(choice.places).first(choice.followed + payable), choice.others)))
                + ", which takes about " + numberText(roughly(further)) + " triangles more.";
        }
        messages.push_back(std::move(text));
    }
    return messages;
}

std::vector<std::pair<std::uint32_t, double>> follow(std::span<const FollowedTriangle> triangles,
                                                     MeshEditor& editor)
{
    const Triangulation& t = editor.triangulation();
    WorkingMesh& mesh = editor.mesh();
    const auto lower = [&](HalfEdge inside, const FollowedTriangle& from, double piece) {
        const MeshEditor::RootSide on = editor.rootSideOf(inside);
        if (on.root == MeshEditor::kNone) {
            return;
        }
        const auto [begin, end] = std::minmax({editor.placeAlong(on.root, from.reach[0]),
                                               editor.placeAlong(on.root, from.reach[1])});
        const Vec2 start = t.points[editor.rootStart(on.root)];
        const Vec2 along = t.points[editor.rootEnd(on.root)] - start;
        const double whole = length(along);
        const double away = std::max(from.distanceTo(start + (begin / whole) * along),
                                     from.distanceTo(start + (end / whole) * along));
        mesh.followed.add(sideIndex(on), begin, end, piece + FollowedGaps::kGrowth * away);
    };
    std::vector<std::pair<std::uint32_t, double>> vertices;
    for (const FollowedTriangle& from : triangles) {
        const double piece = kMargin * from.width;
        if (!(piece > 0.0)) {
            continue;
        }
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            // The constrained edges that bound what the corner sees on this side.
            HalfEdge right = Topology::halfEdge(from.triangle, corner);
            const std::uint32_t v = t.origin(right);
            const double away = from.distanceTo(t.points[v]);
            vertices.emplace_back(v, piece + FollowedGaps::kGrowth * away);
            HalfEdge left = Topology::prev(right);
            while (!t.isConstrained(right) && t.twin(right) != left) {
                right = Topology::next(t.twin(right));
            }
            while (!t.isConstrained(left) && t.twin(left) != right) {
                left = Topology::prev(t.twin(left));
            }
            lower(right, from, piece);
            lower(left, from, piece);
        }
    }
    mesh.followed.finish();
    return vertices;
}

} // namespace tessera
