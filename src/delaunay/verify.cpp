// SPDX-License-Identifier: MIT

// Proof of a triangulation's invariants, from the arrays alone.
//
// Checked: records (vertices in range, slots), links (mutual, same edge, same constrained bit),
// stars (one cycle around each vertex), Euler's formula and connectedness (so a sphere), strict
// orientation of all finite triangles (so, with a locally convex outer boundary, an embedding whose
// outline is the convex hull), and on request that no unconstrained edge has the opposite vertex
// strictly inside its circle (Delaunay's lemma for the constrained Delaunay triangulation: local
// implies global). All signs are exact. O(n) time and memory.

#include "delaunay/delaunay.h"
#include "predicates/predicates.h"

namespace tessera
{
namespace
{

class Verifier
{
public:
    Verifier(const Triangulation& triangulation, bool checkDelaunay)
        : t_(triangulation)
        , checkDelaunay_(checkDelaunay)
    {}

    std::vector<std::string> run()
    {
        checkRecords();
        if (problems_.empty()) {
            if (live_ == 0) {
                checkCollinear();
            }
            else {
                checkStars();
            }
            if (live_ != 0 && problems_.empty()) {
                checkSphere();
                checkGeometry();
            }
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

    void checkRecords()
    {
        if (t_.incident.size() != t_.points.size()) {
            problem("There are ", t_.points.size(), " points but ", t_.incident.size(),
                    " incident entries.");
        }
        std::size_t dead = 0;
        for (std::uint32_t triangle = 0; triangle < t_.triangles.size(); ++triangle) {
            if (t_.isDead(triangle)) {
                ++dead;
                continue;
            }
            ++live_;
            checkRecord(triangle);
        }
        for (const std::uint32_t slot : t_.freeList) {
            if (slot >= t_.triangles.size() || !t_.isDead(slot)) {
                problem("Free slot ", slot, " is not a dead triangle.");
            }
        }
        if (t_.freeList.size() != dead) {
            problem(dead, " triangles are dead but ", t_.freeList.size(), " slots are free.");
        }
    }

    void checkRecord(std::uint32_t triangle)
    {
        const Topology::Triangle& record = t_.triangles[triangle];
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (record.v[i] >= t_.points.size()) {
                problem("Triangle ", triangle, " has vertex ", record.v[i],
                        ", which does not exist.");
                return;
            }
            if (record.v[i] == record.v[Topology::next3(i)]) {
                problem("Triangle ", triangle, " has vertex ", record.v[i], " twice.");
            }
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            checkLink(Topology::halfEdge(triangle, i));
        }
    }

    void checkLink(HalfEdge edge)
    {
        const HalfEdge twin = t_.twin(edge);
        if (Topology::triangleOf(twin) >= t_.triangles.size() || Topology::sideOf(twin) > 2
            || t_.isDead(Topology::triangleOf(twin))) {
            problem("Half-edge ", edge, " is linked to ", twin, ", which does not exist.");
            return;
        }
        if (t_.twin(twin) != edge) {
            problem("Half-edges ", edge, " and ", twin, " are not mutual.");
        }
        if (t_.origin(twin) != t_.destination(edge) || t_.destination(twin) != t_.origin(edge)) {
            problem("Half-edges ", edge, " and ", twin, " have different ends.");
        }
        if (t_.isConstrained(twin) != t_.isConstrained(edge)) {
            problem("Half-edges ", edge, " and ", twin, " differ in being constrained.");
        }
    }

    /// No triangles: all vertices on one line.
    void checkCollinear()
    {
        for (std::size_t v = 3; v < t_.points.size(); ++v) {
            if (orient2d(t_.points[1], t_.points[2], t_.points[v]) != 0) {
                problem("Vertex ", v, " is off the others' line, but there are no triangles.");
            }
        }
        for (std::size_t v = 0; v < t_.incident.size(); ++v) {
            if (t_.incident[v] != Topology::kDead) {
                problem("Vertex ", v, " has an incident half-edge, but there are no triangles.");
            }
        }
    }

    /// Every half-edge out of a vertex is met in one turn around it.
    void checkStars()
    {
        std::vector<std::uint32_t> degree(t_.points.size(), 0);
        for (std::uint32_t triangle = 0; triangle < t_.triangles.size(); ++triangle) {
            for (std::uint32_t i = 0; i < 3 && !t_.isDead(triangle); ++i) {
                ++degree[t_.triangles[triangle].v[i]];
            }
        }
        for (std::uint32_t v = 0; v < t_.points.size(); ++v) {
            const HalfEdge first = t_.incident[v];
            if (first == Topology::kDead && degree[v] == 0) {
                continue; // a vertex that was removed
            }
            ++used_;
            if (Topology::triangleOf(first) >= t_.triangles.size() || Topology::sideOf(first) > 2
                || t_.isDead(Topology::triangleOf(first)) || t_.origin(first) != v) {
                problem("The incident half-edge of vertex ", v, " does not start there.");
                continue;
            }
            std::uint32_t met = 0;
            HalfEdge h = first;
            do {
                ++met;
                h = t_.nextAround(h);
            } while (h != first && met <= degree[v]);
            if (met != degree[v]) {
                problem("The triangles around vertex ", v, " are not one cycle.");
            }
        }
    }

    void checkSphere()
    {
        if (2 * used_ != live_ + 4) { // V - E + F = 2 with 2 E = 3 F
            problem(live_, " triangles and ", used_,
                    " vertices (with infinity) violate Euler's formula.");
        }
        std::vector<std::uint8_t> seen(t_.triangles.size(), 0);
        std::vector<std::uint32_t> open {Topology::triangleOf(t_.incident[0])};
        seen[open.back()] = 1;
        std::size_t reached = 0;
        while (!open.empty()) {
            const std::uint32_t triangle = open.back();
            open.pop_back();
            ++reached;
            for (std::uint32_t i = 0; i < 3; ++i) {
                const std::uint32_t other
                    = Topology::triangleOf(t_.twin(Topology::halfEdge(triangle, i)));
                if (seen[other] == 0) {
                    seen[other] = 1;
                    open.push_back(other);
                }
            }
        }
        if (reached != live_) {
            problem("Only ", reached, " of ", live_, " triangles are connected.");
        }
    }

    void checkGeometry()
    {
        for (std::uint32_t triangle = 0; triangle < t_.triangles.size(); ++triangle) {
            if (t_.isDead(triangle)) {
                continue;
            }
            if (t_.isGhost(triangle)) {
                checkHull(triangle);
                continue;
            }
            const auto& v = t_.triangles[triangle].v;
            if (orient2d(t_.points[v[0]], t_.points[v[1]], t_.points[v[2]]) <= 0) {
                problem("Triangle ", triangle, " (", v[0], ", ", v[1], ", ", v[2],
                        ") is not counter-clockwise.");
            }
            for (std::uint32_t i = 0; i < 3 && checkDelaunay_; ++i) {
                checkEdge(Topology::halfEdge(triangle, i));
            }
        }
    }

    /// The hull turns left, or runs on straight, at the start of the ghost's hull edge.
    void checkHull(std::uint32_t ghost)
    {
        HalfEdge hull = Topology::halfEdge(ghost, 0);
        while (t_.apex(hull) != Topology::kInfinite) {
            hull = Topology::next(hull);
        }
        const HalfEdge behind = Topology::next(t_.twin(Topology::next(hull)));
        if (t_.apex(behind) != Topology::kInfinite) {
            problem("Ghost ", ghost, " is not followed by a ghost around infinity.");
            return;
        }
        const Vec2 a = t_.points[t_.destination(behind)];
        const Vec2 b = t_.points[t_.destination(hull)];
        const Vec2 c = t_.points[t_.origin(hull)];
        const int turn = orient2d(a, b, c);
        if (turn < 0 || (turn == 0 && !strictlyBetween(a, c, b))) {
            problem("The hull is not convex at vertex ", t_.destination(hull), ".");
        }
    }

    void checkEdge(HalfEdge edge)
    {
        const HalfEdge twin = t_.twin(edge);
        if (twin < edge || t_.isConstrained(edge) || t_.isGhost(Topology::triangleOf(twin))) {
            return;
        }
        if (incircle(t_.points[t_.apex(edge)], t_.points[t_.origin(edge)],
                     t_.points[t_.destination(edge)], t_.points[t_.apex(twin)])
            > 0) {
            problem("Edge ", t_.origin(edge), " - ", t_.destination(edge), " is not Delaunay.");
        }
    }

    const Triangulation& t_;
    bool checkDelaunay_;
    std::size_t live_ = 0; ///< triangles, ghosts included
    std::size_t used_ = 0; ///< vertices in triangles, infinity included
    std::vector<std::string> problems_;
};

} // namespace

std::vector<std::string> verify(const Triangulation& triangulation, bool checkDelaunay)
{
    return Verifier(triangulation, checkDelaunay).run();
}

} // namespace tessera
