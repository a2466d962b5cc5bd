// SPDX-License-Identifier: MIT

// Proof that the constraints are in the mesh, from the result and the input alone.
//
// Checked, exactly: chains start and end where they should and never go backward; every vertex of a
// chain is within the rounding bound of the segment (one unit in the last place, or half a
// pixel, in x and in y); consecutive vertices are joined by a mesh edge that is constrained; every
// constrained edge is a subsegment; subsegments, uses and chains tell the same, with directions.

#include "predicates/predicates.h"
#include "recover/recover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tessera
{
namespace
{

bool isBackward(double step, double way)
{
    return (step < 0.0 && way > 0.0) || (step > 0.0 && way < 0.0);
}

class ConstraintVerifier
{
public:
    ConstraintVerifier(const RecoveryResult& result, std::span<const ConstraintEnds> constraints,
                       std::span<const Vec2> inputPoints)
        : result_(result)
        , mesh_(result.triangulation)
        , map_(result.constraints)
        , constraints_(constraints)
        , input_(inputPoints)
    {}

    std::vector<std::string> run()
    {
        checkVertexMap();
        checkMapShape();
        if (problems_.empty()) {
            for (std::size_t c = 0; c < constraints_.size(); ++c) {
                checkChain(c);
            }
            checkSubsegments();
        }
        return std::move(problems_);
    }

private:
    static constexpr std::size_t kMaxProblems = 50;

    template<class... Parts>
    void problem(const Parts&... parts)
    {
        if (problems_.size() < kMaxProblems) {
            std::string text;
            (append(text, parts), ...);
            problems_.push_back(text);
        }
    }
    static void append(std::string& text, const char* part) { text += part; }
    static void append(std::string& text, std::size_t part) { text += std::to_string(part); }

    bool exists(std::uint32_t vertex) const
    {
        return vertex != Topology::kInfinite && vertex < mesh_.points.size();
    }

    /// Half a pixel, or a unit in the last place: half of one could not be added exactly.
    double bound(double coordinate) const
    {
        if (result_.report.snapPixel > 0.0) {
            return 0.5 * result_.report.snapPixel;
        }
        const double magnitude = std::fabs(coordinate);
        return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
    }

    void checkVertexMap()
    {
        if (result_.vertexMap.size() != input_.size()) {
            problem("The vertex map has ", result_.vertexMap.size(), " entries for ",
                    input_.size(), " input vertices.");
            return;
        }
        for (std::size_t v = 1; v < input_.size(); ++v) {
            const std::uint32_t now = result_.vertexMap[v];
            if (!exists(now) || now >= result_.firstCrossing) {
                problem("Input vertex ", v, " has become ", now, ", which is none.");
                continue;
            }
            const Vec2 p = mesh_.points[now];
            const bool snapped = result_.report.snapPixel > 0.0;
            if (snapped ? std::fabs(p.x - input_[v].x) > bound(p.x)
                        || std::fabs(p.y - input_[v].y) > bound(p.y)
                        : p != input_[v]) {
                problem("Input vertex ", v, " has moved.");
            }
        }
    }

    void checkMapShape()
    {
        if (map_.chainStart.size() != constraints_.size() + 1 || map_.chainStart[0] != 0
            || map_.chainStart.back() != map_.chainVertices.size()
            || !std::is_sorted(map_.chainStart.begin(), map_.chainStart.end())) {
            problem("The chains are not laid out by constraint.");
        }
        for (const std::uint32_t v : map_.chainVertices) {
            if (!exists(v)) {
                problem("A chain runs through vertex ", v, ", which does not exist.");
            }
        }
        for (const Subsegment& s : map_.subsegments) {
            if (!exists(s.a) || !exists(s.b) || s.a >= s.b || s.useCount == 0
                || std::size_t {s.firstUse} + s.useCount > map_.uses.size()) {
                problem("Subsegment ", s.a, " - ", s.b, " is malformed.");
                continue;
            }
            const auto uses = map_.usesOf(s);
            if (!std::is_sorted(uses.begin(), uses.end(),
                                [](const ConstraintUse& p, const ConstraintUse& q) {
                                    return p.constraint < q.constraint;
                                })) {
                problem("The uses of subsegment ", s.a, " - ", s.b, " are not sorted.");
            }
        }
        const auto before = [](const Subsegment& s, const Subsegment& t) {
            return std::pair(s.a, s.b) < std::pair(t.a, t.b);
        };
        if (!std::is_sorted(map_.subsegments.begin(), map_.subsegments.end(), before)) {
            problem("The subsegments are not sorted.");
        }
    }

    void checkChain(std::size_t c)
    {
        const auto chain = map_.chainOf(ConstraintId(c));
        const ConstraintEnds ends = constraints_[c];
        if (chain.empty() || chain.front() != result_.vertexMap[ends.a]
            || chain.back() != result_.vertexMap[ends.b]) {
            problem("The chain of constraint ", c, " does not join its ends.");
            return;
        }
        if (chain.front() == chain.back() && chain.size() != 1) {
            problem("The chain of constraint ", c, " leaves its only vertex.");
        }
        for (std::size_t i = 0; i < chain.size(); ++i) {
            checkDistance(c, chain[i]);
            if (i > 0) {
                checkPiece(c, chain[i - 1], chain[i]);
            }
        }
        steps_ += chain.empty() ? 0 : chain.size() - 1;
    }

    /// The box of the rounding bound around the vertex meets the original segment.
    void checkDistance(std::size_t c, std::uint32_t vertex)
    {
        const Vec2 a = input_[constraints_[c].a];
        const Vec2 b = input_[constraints_[c].b];
        const Vec2 p = mesh_.points[vertex];
        const Vec2 half {bound(p.x), bound(p.y)};
        const Vec2 low = p - half;
        const Vec2 high = p + half;
        bool close = low.x <= std::max(a.x, b.x) && std::min(a.x, b.x) <= high.x
            && low.y <= std::max(a.y, b.y) && std::min(a.y, b.y) <= high.y;
        if (close && a != b) {
            const int sides[4] = {orient2d(a, b, low), orient2d(a, b, {high.x, low.y}),
                                  orient2d(a, b, high), orient2d(a, b, {low.x, high.y})};
            close = *std::min_element(sides, sides + 4) <= 0
                && *std::max_element(sides, sides + 4) >= 0;
        }
        if (!close) {
            problem("Vertex ", vertex, " in the chain of constraint ", c,
                    " is further from it than rounding explains.");
        }
    }

    void checkPiece(std::size_t c, std::uint32_t u, std::uint32_t v)
    {
        const Vec2 step = mesh_.points[v] - mesh_.points[u];
        const Vec2 way = input_[constraints_[c].b] - input_[constraints_[c].a];
        if (isBackward(step.x, way.x) || isBackward(step.y, way.y) || u == v) {
            problem("The chain of constraint ", c, " goes backward from vertex ", u, " to ", v,
                    ".");
        }
        if (!mesh_.triangles.empty()) {
            const HalfEdge edge = mesh_.findEdge(u, v);
            if (edge == Topology::kDead || !mesh_.isConstrained(edge)) {
                problem("Piece ", u, " - ", v, " of constraint ", c,
                        " is not a constrained mesh edge.");
            }
        }
        const Subsegment* s = findSubsegment(std::min(u, v), std::max(u, v));
        if (s == nullptr || !names(*s, c, u < v)) {
            problem("Subsegment ", u, " - ", v, " does not name constraint ", c, ".");
        }
    }

    bool names(const Subsegment& s, std::size_t c, bool forward) const
    {
        const auto uses = map_.usesOf(s);
        const auto at = std::lower_bound(uses.begin(), uses.end(), ConstraintId(c),
                                         [](const ConstraintUse& use, ConstraintId id) {
                                             return use.constraint < id;
                                         });
        return at != uses.end() && at->constraint.index() == c && at->forward == forward;
    }

    const Subsegment* findSubsegment(std::uint32_t a, std::uint32_t b) const
    {
        const auto at = std::lower_bound(map_.subsegments.begin(), map_.subsegments.end(),
                                         std::pair(a, b), [](const Subsegment& s, const auto& key) {
                                             return std::pair(s.a, s.b) < key;
                                         });
        return at != map_.subsegments.end() && at->a == a && at->b == b ? &*at : nullptr;
    }

    /// As every piece of every chain is told by a use, equal numbers mean that no use is invented.
    void checkSubsegments()
    {
        if (map_.uses.size() != steps_) {
            problem("The subsegments name ", map_.uses.size(), " pieces, the chains have ", steps_,
                    ".");
        }
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            for (std::uint32_t i = 0; i < 3 && !mesh_.isDead(t); ++i) {
                const HalfEdge edge = Topology::halfEdge(t, i);
                const std::uint32_t u = mesh_.origin(edge);
                const std::uint32_t v = mesh_.destination(edge);
                if (mesh_.isConstrained(edge)
                    && findSubsegment(std::min(u, v), std::max(u, v)) == nullptr) {
                    problem("Constrained edge ", u, " - ", v, " lies on no constraint.");
                }
            }
        }
    }

    const RecoveryResult& result_;
    const Triangulation& mesh_;
    const ConstraintMap& map_;
    std::span<const ConstraintEnds> constraints_;
    std::span<const Vec2> input_;
    std::size_t steps_ = 0; ///< pieces of all chains
    std::vector<std::string> problems_;
};

} // namespace

std::vector<std::string> verifyConstraints(const RecoveryResult& result,
                                           std::span<const ConstraintEnds> constraints,
                                           std::span<const Vec2> inputPoints)
{
    return ConstraintVerifier(result, constraints, inputPoints).run();
}

} // namespace tessera
