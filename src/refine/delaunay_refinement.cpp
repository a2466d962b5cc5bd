// SPDX-License-Identifier: MIT
//
// Delaunay refinement after Ruppert (1995) and Shewchuk (2002), with off-centers (Üngör 2004) and
// the treatment of small input angles by Miller, Pav and Walkington (2003).
//
// A bad triangle gets its circumcenter or off-center; if that point cannot be seen from the
// triangle or lies in the diametral circle of a constrained edge, the edge is split instead.
// Constrained edges are split lazily: an obtuse triangle on an edge is no reason if its angles are
// good. Edges at an apex of less than 60 degrees are split on concentric shells (distances that are
// powers of two), and a triangle whose shortest edge joins two such edges is left alone: with that
// Ruppert's argument for termination holds for any input angles.
//
// Guarantees: ends always, whatever rounding does. No constrained edge is split below
// kLastShare of kSmallestPiece of the size there, or of a share of short subsegments around, so
// their pieces are finite in number. No point is inserted nearer to a vertex that it sees than
// kSmallestDistance of the spacing there: the length of constrained edges and the distances that
// stood before, which new points inherit unchanged. All distances in a convex part between
// constrained edges thus have one positive bound, and only finitely many points fit. Moreover the
// number of insertions is bounded by a multiple of the estimated number of triangles. (Without the
// bound a triangle 1 wide and 1e-17 high is filled down to the smallest double: points beside each
// other round into the same column.) For input angles of at least 60 degrees and gaps above that
// floor no angle below 20.7 degrees remains in theory (Ruppert), 30 in practice; what remains is
// listed by findUnreached().
//
// Pieces end at kSmallestPiece until nothing else helps. Then the few bad triangles that are left away
// from acute corners, beside the end of a gap that is followed or beside lines divided finely for
// their other side only, may have pieces down to kLastShare of that.
//
// Where constrained edges may not be split, triangles that are too large get their circumcenter or
// incenter all the same if it is a share of the size away from edges and vertices.
//
// Complexity: O(m log m) for m insertions.

#include "refine/delaunay_refinement.h"

#include "predicates/predicates.h"
#include "refine/acute_arms.h"
#include "refine/gaps.h"
#include "refine/triangle_shape.h"
#include "refine/wedges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

namespace tessera
{

namespace
{

constexpr double kSmallestDistance = 1.0 / 64.0; ///< of the spacing, between a point and a vertex
constexpr double kLargestRadius = 0.95;       ///< circumradius / size of an acceptable triangle
/// Distances of points from constrained edges that may not be split and from vertices there, as
/// shares of the size.
constexpr double kFromFrozenEdge = 0.4;
constexpr double kFromVertexBesideFrozen = 0.7;
/// The last bad triangles may have pieces so much shorter than the rest.
constexpr double kLastShare = 1.0 / 4096.0;
constexpr std::size_t kShortSplits = 1024;      ///< at least so many such splits
constexpr std::size_t kEdgesPerShortSplit = 32; ///< and one for so many constrained edges
constexpr std::size_t kMostTogether = 64; ///< more bad neighbors are a gap that was left coarse
constexpr std::size_t kCheckpointEvery = 256;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

double nearestPowerOfTwo(double x)
{
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(1.0, mantissa * mantissa < 0.5 ? exponent - 1 : exponent);
}

struct BadTriangle
{
    double badness; ///< cosine of the smallest angle
    std::uint32_t triangle;
    std::uint32_t v[3];

    friend bool operator<(const BadTriangle& a, const BadTriangle& b)
    {
        return a.badness != b.badness ? a.badness < b.badness : a.triangle > b.triangle;
    }
};

class DelaunayRefiner
{
public:
    DelaunayRefiner(MeshEditor& editor, const SizeField& size, const RefineOptions& options,
                    RefineReport& report, Execution& execution)
        : editor_(editor)
        , t_(editor.triangulation())
        , size_(size)
        , options_(options)
        , report_(report)
        , execution_(execution)
        , cosineLimit_(std::cos(options.minAngle * std::numbers::pi / 180.0))
        , hopelessGap_(hopelessGap(options.minAngle))
    {}

    void run(std::span<const std::uint32_t> candidates)
    {
        for (const std::uint32_t triangle : candidates) {
            judge(triangle);
        }
        if (large_.empty() && skinny_.empty() && givenUp_.empty()) {
            return;
        }
        measureSpacing();
        workLeft_ = 20.0 * static_cast<double>(t_.triangles.size())
            + 200.0 * static_cast<double>(editor_.mesh().edges.size()) + 1000.0;
        improveAll();
        if (!givenUp_.empty() && !options_.freezeBoundary && options_.narrowShare > 0.0) {
            improveLast();
        }
    }

private:
    /// Until no bad triangle is left that anything can be done for.
    void improveAll()
    {
        bool extended = false;
        std::size_t steps = 0;
        while (!large_.empty() || !skinny_.empty()) {
            if (++steps % kCheckpointEvery == 0) {
                execution_.checkpoint();
                requireFewTriangles(static_cast<double>(t_.triangles.size()), options_);
            }
            if (workLeft_ <= 0.0) {
                if (extended) {
                    break;
                }
                extended = true;
                workLeft_ = 20.0 * estimateTriangles(editor_.mesh(), size_);
            }
            const bool isLarge = !large_.empty();
            const BadTriangle bad = isLarge ? large_.back() : skinny_.top();
            isLarge ? large_.pop_back() : skinny_.pop();
            if (isCurrent(bad)) {
                workLeft_ -= 1.0;
                if (!improve(bad, isLarge) && !isLarge) {
                    givenUp_.push_back(bad);
                }
            }
        }
    }

    /// Tries those given up once more, now with short pieces, if no acute corner explains them. Takes
    /// all back unless there are fewer of them in the end.
    void improveLast()
    {
        arms_.emplace(editor_);
        shortSplitsLeft_ = kShortSplits + editor_.mesh().edges.size() / kEdgesPerShortSplit;
        std::vector<std::uint8_t> isBad(t_.triangles.size(), 0);
        for (const BadTriangle& bad : givenUp_) {
            if (isCurrent(bad) && isWorthShortPieces(bad.triangle)) {
                isBad[bad.triangle] = 1;
            }
        }
        std::vector<std::uint32_t> group;
        for (const BadTriangle& bad : givenUp_) {
            if (isBad[bad.triangle] == 0) {
                continue;
            }
            collectNeighbors(bad.triangle, isBad, group);
            if (group.size() <= kMostTogether) {
                std::for_each(group.begin(), group.end(), [this](auto i) { judge(i); });
            }
        }
        if (skinny_.empty() && large_.empty()) {
            return;
        }
        const std::size_t before = countUnexplained();
        const WorkingMesh saved = editor_.constMesh();
        const RefineReport savedReport = report_;
        improveAll();
        if (countUnexplained() >= before) {
            editor_.mesh() = saved;
            report_ = savedReport;
        }
    }

    /// Bad triangles that no acute corner explains.
    std::size_t countUnexplained() const
    {
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < t_.triangles.size(); ++i) {
            if (editor_.isKept(i) && t_.isFinite(i)) {
                const TriangleShape s = shapeOf(t_, i);
                const bool isBad = s.cosineOfSmallest() > cosineLimit_ && !isExempt(s);
                count += isBad && !arms_->concern(i) ? 1 : 0;
            }
        }
        return count;
    }

    /// Moves those bad triangles to group that can be reached from the first without crossing others
    /// or constrained edges.
    void collectNeighbors(std::uint32_t first, std::vector<std::uint8_t>& isBad,
                          std::vector<std::uint32_t>& group) const
    {
        isBad[first] = 0;
        group.assign(1, first);
        for (std::size_t i = 0; i < group.size(); ++i) {
            for (std::uint32_t side = 0; side < 3; ++side) {
                const HalfEdge h = Topology::halfEdge(group[i], side);
                const std::uint32_t next = Topology::triangleOf(t_.twin(h));
                if (!t_.isConstrained(h) && isBad[next] != 0) {
                    isBad[next] = 0;
                    group.push_back(next);
                }
            }
        }
    }

    bool isCurrent(const BadTriangle& bad) const
    {
        const auto& v = t_.triangles[bad.triangle].v;
        return v[0] == bad.v[0] && v[1] == bad.v[1] && v[2] == bad.v[2]
            && editor_.isKept(bad.triangle);
    }

    /// Of a vertex on constrained edges the length of the shortest of them, else its distance from
    /// its nearest neighbor.
    void measureSpacing()
    {
        spacing_.assign(t_.points.size(), kInfinite);
        for (std::uint32_t i = 0; i < t_.triangles.size(); ++i) {
            if (!editor_.isKept(i)) {
                continue;
            }
            for (std::uint32_t side = 0; side < 3; ++side) {
                const HalfEdge h = Topology::halfEdge(i, side);
                const std::uint32_t ends[2] = {t_.origin(h), t_.destination(h)};
                const double l = squaredDistance(t_.points[ends[0]], t_.points[ends[1]]);
                for (const std::uint32_t v : ends) {
                    if (t_.isConstrained(h) || editor_.isFree(v)) {
                        spacing_[v] = std::min(spacing_[v], l);
                    }
                }
            }
        }
        for (std::uint32_t v = 1; v < spacing_.size(); ++v) {
            if (spacing_[v] == kInfinite && t_.incident[v] != Topology::kDead) {
                spacing_[v] = squaredDistanceOfNearest(v); // an input point on no edge
            }
            spacing_[v] = std::sqrt(spacing_[v]);
        }
    }

    double squaredDistanceOfNearest(std::uint32_t v) const
    {
        double nearest = kInfinite;
        t_.forEachAround(v, [&](HalfEdge h) {
            if (t_.destination(h) != Topology::kInfinite) {
                nearest = std::min(nearest,
                                   squaredDistance(t_.points[v], t_.points[t_.destination(h)]));
            }
        });
        return nearest;
    }

    double leastSpacing(const TriangleShape& s) const
    {
        return std::min({spacing_[s.v[0]], spacing_[s.v[1]], spacing_[s.v[2]]});
    }

    /// Queues the triangle if it is too large or skinny.
    void judge(std::uint32_t triangle)
    {
        if (!editor_.isKept(triangle) || !t_.isFinite(triangle)) {
            return;
        }
        const TriangleShape s = shapeOf(t_, triangle);
        const auto& v = t_.triangles[triangle].v;
        BadTriangle bad {s.cosineOfSmallest(), triangle, {v[0], v[1], v[2]}};
        if (isTooLarge(s, triangle)) {
            large_.push_back(bad);
        }
        else if (bad.badness > cosineLimit_ && !isExempt(s)) {
            if (!isInHopelessGap(triangle, 1.0) || isWorthShortPieces(triangle)) {
                skinny_.push(bad);
            }
            else if (!arms_) {
                givenUp_.push_back(bad);
            }
        }
    }

    bool isWorthShortPieces(std::uint32_t triangle) const
    {
        return arms_ && shortSplitsLeft_ > 0 && !arms_->concern(triangle)
            && !isInHopelessGap(triangle, kLastShare);
    }

    double areaLimit(std::uint32_t triangle) const
    {
        return areaLimitOf(options_, editor_.constMesh().regionOfTriangle[triangle]);
    }

    bool isTooLarge(const TriangleShape& s, std::uint32_t triangle) const
    {
        const double limitOfArea = areaLimit(triangle);
        if (limitOfArea > 0.0 && s.area > limitOfArea) {
            return true;
        }
        const Vec2 center = (1.0 / 3.0) * (s.p[0] + s.p[1] + s.p[2]);
        const double limit = kLargestRadius * size_.size(center);
        // Of flat and of needle triangles the radius says nothing about size: they are skinny.
        const double squaredLimit = limit * limit;
        return s.squared[0] * 16.0 > squaredLimit && s.squared[1] > squaredLimit
            && s.squared[2] > squaredLimit && s.circumradius() > limit;
    }

    /// Two constrained edges at v make less than a limit (radians) with kept triangles in between.
    bool isAcuteApex(std::uint32_t v) const
    {
        bool acute = false;
        if (editor_.constMesh().origin[v] != VertexOrigin::SegmentSplit) {
            forEachWedge(
                t_, v, [this](std::uint32_t triangle) { return editor_.isKept(triangle); },
                [&](HalfEdge, HalfEdge, double angle) { acute = acute || angle < kAcuteWedge; });
        }
        return acute;
    }

    double angleAt(std::uint32_t apex, std::uint32_t a, std::uint32_t b) const
    {
        const Vec2 u = t_.points[a] - t_.points[apex];
        const Vec2 w = t_.points[b] - t_.points[apex];
        return std::fabs(std::atan2(cross(u, w), dot(u, w)));
    }

    /// The smallest angle is an input angle, or the shortest edge runs between two constrained
    /// edges that meet at less than 60 degrees: refinement cannot help.
    bool isExempt(const TriangleShape& s) const
    {
        if (editor_.findRecord(s.v[0], s.v[1]) != MeshEditor::kNone
            && editor_.findRecord(s.v[0], s.v[2]) != MeshEditor::kNone) {
            return true;
        }
        const std::uint32_t r = editor_.rootOfVertex(s.v[1]);
        const std::uint32_t q = editor_.rootOfVertex(s.v[2]);
        if (r == MeshEditor::kNone || q == MeshEditor::kNone || r == q) {
            return false;
        }
        for (const std::uint32_t apex : {editor_.rootStart(r), editor_.rootEnd(r)}) {
            if (apex != MeshEditor::kNone
                && (apex == editor_.rootStart(q) || apex == editor_.rootEnd(q))
                && isAcuteApex(apex) && angleAt(apex, s.v[1], s.v[2]) < kAcuteWedge) {
                return true;
            }
        }
        return false;
    }

    /// If pieces may be shorter than usual by this share.
    bool isInHopelessGap(std::uint32_t triangle, double share) const
    {
        for (std::uint32_t side = 0; side < 3; ++side) {
            const HalfEdge edge = Topology::halfEdge(triangle, side);
            if (t_.isConstrained(edge) && !editor_.isFree(t_.apex(edge))
                && isHopeless(editor_, edge, size_.size(t_.points[t_.apex(edge)]),
                              share * hopelessGap_)) {
                return true;
            }
        }
        return false;
    }

    /// Circumcenter; for skinny triangles the nearer of it and the off-center on the bisector of
    /// the shortest edge.
    Vec2 newPoint(const TriangleShape& s, bool isLarge) const
    {
        const Vec2 b = s.p[1] - s.p[0];
        const Vec2 c = s.p[2] - s.p[0];
        const double alongC = 0.5 * (s.squared[2] / cross(b, c));
        const double alongB = 0.5 * (s.squared[1] / cross(b, c));
        const Vec2 center
            = s.p[0] + Vec2 {alongC * c.y - alongB * b.y, alongB * b.x - alongC * c.x};
        if (isLarge) {
            return center;
        }
        const Vec2 middle = midpoint(s.p[1], s.p[2]);
        const Vec2 toCenter = center - middle;
        const double shortest = std::sqrt(s.squared[0]);
        // Distance at which the new triangle on the shortest edge has the wanted angle and a bit.
        const double angle = std::max(options_.minAngle, 20.0) * std::numbers::pi / 180.0;
        const double wanted = 0.5 * shortest / std::tan(0.5 * angle) * 0.95;
        const double far = length(toCenter);
        return far > wanted && dot(toCenter, s.p[0] - middle) > 0.0
            ? middle + (wanted / far) * toCenter
            : center;
    }

    /// Whether anything was inserted for it.
    bool improve(const BadTriangle& bad, bool isLarge)
    {
        const TriangleShape s = shapeOf(t_, bad.triangle);
        const Vec2 p = newPoint(s, isLarge);
        if (!isFinite(p)) {
            return false;
        }
        const VisibleWalk found = editor_.walk(Topology::halfEdge(bad.triangle, 0), p);
        encroached_.clear();
        if (found.kind != VisibleWalk::Kind::Lost
            && found.location.kind == Location::Kind::Edge
            && t_.isConstrained(found.location.edge)) {
            encroached_.emplace_back(t_.origin(found.location.edge),
                                     t_.destination(found.location.edge));
        }
        else if (found.kind == VisibleWalk::Kind::Reached
                 && found.location.kind != Location::Kind::Vertex) {
            collectEncroached(p, found.location);
            if (encroached_.empty()) {
                const double spacing = leastSpacing(s);
                if (!(nearest_ >= kSmallestDistance * spacing)) {
                    return false;
                }
                insertInside(p, found.location, spacing);
                return true;
            }
        }
        if (options_.freezeBoundary) {
            return isLarge
                && (insertBesideFrozen(bad, s, p) || insertBesideFrozen(bad, s, s.incenter()));
        }
        const bool mayBeShort = isWorthShortPieces(bad.triangle);
        bool anySplit = false;
        for (std::size_t i = 0; i < encroached_.size(); ++i) {
            const HalfEdge edge = t_.findEdge(encroached_[i].first, encroached_[i].second);
            if (edge != Topology::kDead && t_.isConstrained(edge)) {
                anySplit = split(edge, mayBeShort) || anySplit;
            }
        }
        if (anySplit && isCurrent(bad)) {
            judge(bad.triangle);
        }
        return anySplit;
    }

    void insertInside(Vec2 p, const Location& where, double spacing)
    {
        const std::uint32_t v = editor_.insertInside(p, where);
        spacing_.resize(v + 1, spacing);
        ++report_.interiorPoints;
        judgeStar(v);
    }

    /// A point in the diametral circles of constrained edges that may not be split, not near them.
    /// Where these are far longer than the size, hardly any point is outside of the circles.
    bool insertBesideFrozen(const BadTriangle& bad, const TriangleShape& s, Vec2 p)
    {
        const VisibleWalk found = editor_.walk(Topology::halfEdge(bad.triangle, 0), p);
        if (found.kind != VisibleWalk::Kind::Reached
            || found.location.kind == Location::Kind::Vertex
            || (found.location.kind == Location::Kind::Edge
                && t_.isConstrained(found.location.edge))) {
            return false;
        }
        encroached_.clear();
        collectEncroached(p, found.location);
        const double size = std::min(size_.size(p), sizeForArea(areaLimit(bad.triangle)));
        const auto isClearOf = [&](const std::pair<std::uint32_t, std::uint32_t>& ends) {
            const Vec2 a = t_.points[ends.first];
            const Vec2 along = t_.points[ends.second] - a;
            return std::fabs(cross(along, p - a)) >= kFromFrozenEdge * size * length(along);
        };
        const bool isClear = std::all_of(encroached_.begin(), encroached_.end(), isClearOf);
        if (!isClear || !(nearest_ >= kFromVertexBesideFrozen * size)) {
            return false;
        }
        insertInside(p, found.location, leastSpacing(s));
        return true;
    }

    void judgeStar(std::uint32_t v)
    {
        t_.forEachAround(v, [&](HalfEdge h) { judge(Topology::triangleOf(h)); });
    }

    /// The constrained edges around the conflict region of p whose diametral circle contains p; and
    /// how near p is to the corners of that region, of which one is the nearest vertex it sees.
    void collectEncroached(Vec2 p, const Location& where)
    {
        double nearest = std::numeric_limits<double>::infinity();
        region_.assign(1, Topology::triangleOf(where.edge));
        if (where.kind == Location::Kind::Edge) {
            region_.push_back(Topology::triangleOf(t_.twin(where.edge)));
        }
        for (std::size_t i = 0; i < region_.size(); ++i) {
            for (std::uint32_t side = 0; side < 3; ++side) {
                const HalfEdge h = Topology::halfEdge(region_[i], side);
                const Vec2 a = t_.points[t_.origin(h)];
                const Vec2 b = t_.points[t_.destination(h)];
                nearest = std::min(nearest, squaredDistance(a, p));
                if (t_.isConstrained(h)) {
                    if (dot(a - p, b - p) < 0.0) {
                        encroached_.emplace_back(t_.origin(h), t_.destination(h));
                    }
                    continue;
                }
                const std::uint32_t neighbor = Topology::triangleOf(t_.twin(h));
                if (t_.isGhost(neighbor)
                    || std::find(region_.begin(), region_.end(), neighbor) != region_.end()) {
                    continue;
                }
                const auto& v = t_.triangles[neighbor].v;
                if (incircle(t_.points[v[0]], t_.points[v[1]], t_.points[v[2]], p) > 0) {
                    region_.push_back(neighbor);
                }
            }
        }
        nearest_ = std::sqrt(nearest);
    }

    /// Splits a constrained edge in the middle, or on the shell around an acute apex.
    bool split(HalfEdge edge, bool mayBeShort)
    {
        if (options_.freezeBoundary) {
            return false;
        }
        const std::uint32_t a = t_.origin(edge);
        const std::uint32_t b = t_.destination(edge);
        const double whole = distance(t_.points[a], t_.points[b]);
        double fraction = 0.5;
        if (isAcuteApex(a) != isAcuteApex(b)) {
            fraction = nearestPowerOfTwo(0.5 * whole) / whole; // 0.35 .. 0.71
            if (isAcuteApex(b)) {
                edge = t_.twin(edge);
            }
        }
        const double piece = std::min(fraction, 1.0 - fraction) * whole;
        const Vec2 middle = midpoint(t_.points[a], t_.points[b]);
        const std::uint32_t record = editor_.findRecord(a, b);
        if (record == MeshEditor::kNone) {
            return false;
        }
        const std::uint32_t root = editor_.constMesh().edges[record].useSet;
        const double least = leastPiece(editor_, root, middle, size_.size(middle));
        const bool isShort = piece < least;
        if (isShort && (!mayBeShort || piece < kLastShare * least || shortSplitsLeft_ == 0)) {
            return false;
        }
        const std::uint32_t v = editor_.splitEdge(edge, fraction);
        if (v == MeshEditor::kNone) {
            return false;
        }
        if (isShort) {
            --shortSplitsLeft_;
        }
        spacing_.resize(v + 1, std::min(piece, std::min(spacing_[a], spacing_[b])));
        workLeft_ -= 1.0;
        ++report_.segmentSplits;
        judgeStar(v);
        return true;
    }

    MeshEditor& editor_;
    const Triangulation& t_;
    const SizeField& size_;
    const RefineOptions& options_;
    RefineReport& report_;
    Execution& execution_;
    double cosineLimit_;
    double hopelessGap_;
    double workLeft_ = 0.0;
    std::vector<BadTriangle> givenUp_;
    std::optional<AcuteArms> arms_; ///< once only short pieces can help
    std::size_t shortSplitsLeft_ = 0;
    std::vector<BadTriangle> large_;
    std::priority_queue<BadTriangle> skinny_;
    std::vector<double> spacing_; ///< by vertex
    double nearest_ = 0.0;        ///< of collectEncroached()
    std::vector<std::uint32_t> region_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> encroached_;
};

} // namespace

void refineDelaunay(MeshEditor& editor, const SizeField& size, const RefineOptions& options,
                    std::span<const std::uint32_t> candidates, RefineReport& report,
                    Execution& execution)
{
    DelaunayRefiner(editor, size, options, report, execution).run(candidates);
}

} // namespace tessera
