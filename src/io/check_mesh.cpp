// SPDX-License-Identifier: MIT
#include "io/check_mesh.h"

#include "base/number_text.h"
#include "io/outline_check.h"
#include "mesh/second_order.h"
#include "predicates/predicates.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace tessera
{

namespace
{

constexpr std::uint32_t kNoNode = 0xffffffffU;

/// A side of an element, or a line element.
struct Side
{
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t middle;
    std::uint32_t cell;

    std::uint64_t key() const
    {
        return std::uint64_t {std::min(a, b)} << 32U | std::max(a, b);
    }
};

class Checker
{
public:
    explicit Checker(const RawMesh& mesh)
        : mesh_(mesh)
    {}

    MeshCheck run()
    {
        count();
        if (result_.triangles + result_.quads == 0) {
            add("The mesh has no triangles and no quadrangles.");
        }
        else if (project()) {
            checkElements();
            checkDuplicates();
            checkPlaces();
            collectSides();
            checkSides();
            checkLines();
            checkOutline();
            measure();
        }
        if (dropped_ > 0) {
            result_.problems.push_back(fmt::format("{} more problems are not listed.", dropped_));
        }
        return std::move(result_);
    }

private:
    using Cell = RawMesh::Cell;

    void add(std::string problem)
    {
        if (result_.problems.size() < MeshCheck::kMostListed) {
            result_.problems.push_back(std::move(problem));
        }
        else {
            ++dropped_;
        }
    }
    std::int64_t number(std::uint32_t node) const { return mesh_.nodeNumber[node]; }
    std::string name(const Cell& cell) const
    {
        std::string text = fmt::format("Element {} (nodes ", cell.number);
        const auto nodes = mesh_.nodesOfCell(cell);
        for (std::size_t i = 0; i < cornersOf(cell.kind); ++i) {
            text += fmt::format("{}{}", i == 0 ? "" : ", ", number(nodes[i]));
        }
        return text + ")";
    }
    std::string place(std::uint32_t node) const
    {
        return placeText(points_[node]);
    }

    void count()
    {
        result_.nodes = mesh_.nodes.size();
        used_.assign(mesh_.nodes.size(), 0);
        for (const Cell& cell : mesh_.cells) {
            const std::size_t corners = cornersOf(cell.kind);
            (corners == 2 ? result_.edges : corners == 3 ? result_.triangles : result_.quads) += 1;
            result_.order = std::max(result_.order, nodesOf(cell.kind) > corners ? 2 : 1);
            for (std::uint32_t node : mesh_.nodesOfCell(cell)) {
                used_[node] = 1;
            }
        }
        result_.unusedNodes = static_cast<std::size_t>(std::ranges::count(used_, 0));
    }

    /// Finds the axis that the used nodes do not move along; false if there is none.
    bool project()
    {
        std::array<bool, 3> constant {true, true, true};
        std::size_t first = kNoNode;
        for (std::size_t i = 0; i < used_.size(); ++i) {
            if (used_[i] == 0) {
                continue;
            }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (!std::isfinite(mesh_.nodes[i][axis])) {
                    add(fmt::format("Node {} has a coordinate that is not finite.",
                                    mesh_.nodeNumber[i]));
                    return false;
                }
                constant[axis] = constant[axis]
                    && (first == kNoNode || mesh_.nodes[i][axis] == mesh_.nodes[first][axis]);
            }
            first = first == kNoNode ? i : first;
        }
        std::size_t up = 3;
        for (std::size_t axis : {0U, 1U, 2U}) {
            up = constant[axis] ? axis : up;
        }
        if (up == 3) {
            add("The mesh is not plane, or its plane is not parallel to two axes.");
            return false;
        }
        for (const auto& node : mesh_.nodes) {
            points_.push_back({node[(up + 1) % 3], node[(up + 2) % 3]});
        }
        return true;
    }

    // Elements alone --------------------------------------------------------------------------

    void checkElements()
    {
        std::vector<std::uint32_t> sorted;
        for (const Cell& cell : mesh_.cells) {
            const auto nodes = mesh_.nodesOfCell(cell);
            sorted.assign(nodes.begin(), nodes.end());
            std::ranges::sort(sorted);
            if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end()) {
                add(fmt::format("{} has node {} twice.", name(cell), number(*twice)));
                oriented_ = false;
            }
            else if (!isEdge(cell.kind)) {
                checkShape(cell, nodes);
            }
        }
    }

    void checkShape(const Cell& cell, std::span<const std::uint32_t> nodes)
    {
        const std::size_t corners = cornersOf(cell.kind);
        int least = 1;
        int greatest = -1;
        for (std::size_t i = 0; i + 2 < corners || (corners == 4 && i < 4); ++i) {
            const int sign = orient2d(points_[nodes[i]], points_[nodes[(i + 1) % corners]],
                                      points_[nodes[(i + 2) % corners]]);
            least = std::min(least, sign);
            greatest = std::max(greatest, sign);
        }
        if (least > 0) {
            if (cell.kind == CellKind::Triangle6 && !hasPositiveJacobian(nodes)) {
                add(fmt::format("{} folds over: its sides are curved too far.", name(cell)));
            }
            return;
        }
        oriented_ = false;
        if (greatest < 0) {
            add(fmt::format("{} is clockwise.", name(cell)));
        }
        else if (corners == 3 || (least == 0 && greatest == 0)) {
            add(fmt::format("{} has no area.", name(cell)));
        }
        else {
            add(fmt::format("{} is not convex.", name(cell)));
        }
    }

    bool hasPositiveJacobian(std::span<const std::uint32_t> nodes) const
    {
        Nodes6 x;
        for (std::size_t i = 0; i < 6; ++i) {
            x[i] = points_[nodes[i]];
        }
        constexpr int kDeepest = 6;
        return isPositive(x, kDeepest);
    }

    /// Corners 0, 1, 2, then the middles of sides 0-1, 1-2, 2-0.
    using Nodes6 = std::array<Vec2, 6>;

    /// Twice the map's Jacobian determinant at corner i, up to a positive factor.
    static double cornerJacobian(const Nodes6& x, int i)
    {
        const Vec2 corner = x[static_cast<std::size_t>(i)];
        const std::size_t next = static_cast<std::size_t>((i + 1) % 3);
        const std::size_t last = static_cast<std::size_t>((i + 2) % 3);
        const Vec2 along = 4.0 * (x[3 + static_cast<std::size_t>(i)] - corner) - (x[next] - corner);
        const Vec2 back = 4.0 * (x[3 + last] - corner) - (x[last] - corner);
        return cross(along, back);
    }

    /// The lower bound over the triangle is sharpened by halving its sides.
    static bool isPositive(const Nodes6& x, int depth)
    {
        const Vec2 corner[] = {x[0], x[1], x[2]};
        const Vec2 middle[] = {x[4], x[5], x[3]}; // opposite the corners
        if (jacobianLowerBound(corner, middle) > 0.0) {
            return true;
        }
        for (int i = 0; i < 3; ++i) {
            if (!(cornerJacobian(x, i) > 0.0)) {
                return false;
            }
        }
        if (depth == 0) {
            return false;
        }
        return std::ranges::all_of(quarters(x),
                                   [&](const Nodes6& part) { return isPositive(part, depth - 1); });
    }

    /// The map restricted to the four triangles between the corners and the middles of the sides.
    static std::array<Nodes6, 4> quarters(const Nodes6& x)
    {
        const auto at = [&x](double u, double v) {
            const double w = 1.0 - u - v;
            const std::array<double, 6> f {w * (2.0 * w - 1.0), u * (2.0 * u - 1.0),
                                           v * (2.0 * v - 1.0), 4.0 * w * u, 4.0 * u * v,
                                           4.0 * v * w};
            Vec2 sum;
            for (std::size_t i = 0; i < 6; ++i) {
                sum = sum + f[i] * x[i];
            }
            return sum;
        };
        const auto part = [&at](Vec2 a, Vec2 b, Vec2 c) {
            const Vec2 ab = midpoint(a, b);
            const Vec2 bc = midpoint(b, c);
            const Vec2 ca = midpoint(c, a);
            return Nodes6 {at(a.x, a.y), at(b.x, b.y),   at(c.x, c.y),
                           at(ab.x, ab.y), at(bc.x, bc.y), at(ca.x, ca.y)};
        };
        constexpr Vec2 o {0.0, 0.0}, u {1.0, 0.0}, v {0.0, 1.0};
        constexpr Vec2 ou {0.5, 0.0}, uv {0.5, 0.5}, vo {0.0, 0.5};
        return {part(o, ou, vo), part(ou, u, uv), part(vo, uv, v), part(ou, uv, vo)};
    }

    // Elements together -----------------------------------------------------------------------

    void checkDuplicates()
    {
        struct Corners
        {
            std::array<std::uint32_t, 4> nodes;
            std::uint32_t cell;
        };
        std::vector<Corners> all;
        for (std::uint32_t c = 0; c < mesh_.cells.size(); ++c) {
            Corners corners {{kNoNode, kNoNode, kNoNode, kNoNode}, c};
            const auto nodes = mesh_.nodesOfCell(mesh_.cells[c]);
            std::copy_n(nodes.begin(), cornersOf(mesh_.cells[c].kind), corners.nodes.begin());
            std::ranges::sort(corners.nodes);
            all.push_back(corners);
        }
        std::ranges::sort(all, [](const Corners& a, const Corners& b) {
            return a.nodes != b.nodes ? a.nodes < b.nodes : a.cell < b.cell;
        });
        for (std::size_t i = 1; i < all.size(); ++i) {
            if (all[i].nodes == all[i - 1].nodes) {
                add(fmt::format("{} has the same nodes as element {}.",
                                name(mesh_.cells[all[i].cell]),
                                mesh_.cells[all[i - 1].cell].number));
                oriented_ = false;
            }
        }
    }

    void checkPlaces()
    {
        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < used_.size(); ++i) {
            if (used_[i] != 0) {
                order.push_back(i);
            }
        }
        std::ranges::sort(order, [this](std::uint32_t i, std::uint32_t j) {
            const Vec2 p = points_[i];
            const Vec2 q = points_[j];
            return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : i < j;
        });
        for (std::size_t i = 1; i < order.size(); ++i) {
            if (points_[order[i]] == points_[order[i - 1]]) {
                add(fmt::format("Nodes {} and {} are at the same place {}: their elements are not "
                                "connected.",
                                number(order[i - 1]), number(order[i]), place(order[i])));
            }
        }
    }

    void collectSides()
    {
        for (std::uint32_t c = 0; c < mesh_.cells.size(); ++c) {
            const Cell& cell = mesh_.cells[c];
            const auto nodes = mesh_.nodesOfCell(cell);
            const std::size_t corners = cornersOf(cell.kind);
            const bool second = nodes.size() > corners;
            if (isEdge(cell.kind)) {
                lines_.push_back({nodes[0], nodes[1], second ? nodes[2] : kNoNode, c});
                continue;
            }
            for (std::size_t i = 0; i < corners; ++i) {
                sides_.push_back({nodes[i], nodes[(i + 1) % corners],
                                  second ? nodes[corners + i] : kNoNode, c});
            }
        }
        std::ranges::sort(sides_, [](const Side& s, const Side& t) {
            return s.key() != t.key() ? s.key() < t.key() : s.cell < t.cell;
        });
    }

    void checkSides()
    {
        for (std::size_t i = 0; i < sides_.size();) {
            std::size_t end = i + 1;
            while (end < sides_.size() && sides_[end].key() == sides_[i].key()) {
                ++end;
            }
            const Side& side = sides_[i];
            if (end - i == 1) {
                outline_.push_back({side.a, side.b});
                outlineCell_.push_back(side.cell);
            }
            else if (end - i > 2) {
                add(fmt::format("The side between nodes {} and {} belongs to {} elements.",
                                number(side.a), number(side.b), end - i));
                oriented_ = false;
            }
            else {
                checkPair(side, sides_[i + 1]);
            }
            i = end;
        }
    }

    void checkPair(const Side& side, const Side& other)
    {
        if (side.a == other.a && oriented_) {
            add(fmt::format("Elements {} and {} lie on the same side of their common nodes {} and "
                            "{}: they overlap.",
                            mesh_.cells[side.cell].number, mesh_.cells[other.cell].number,
                            number(side.a), number(side.b)));
            oriented_ = false;
        }
        if (side.middle != other.middle) {
            add(fmt::format("Elements {} and {} have different mid nodes between nodes {} and {}.",
                            mesh_.cells[side.cell].number, mesh_.cells[other.cell].number,
                            number(side.a), number(side.b)));
        }
    }

    void checkLines()
    {
        for (const Side& line : lines_) {
            const auto side = std::ranges::lower_bound(sides_, line.key(), {}, &Side::key);
            if (side == sides_.end() || side->key() != line.key()) {
                add(fmt::format("{} is not a side of any triangle or quadrangle.",
                                name(mesh_.cells[line.cell])));
            }
            else if (side->middle != line.middle) {
                add(fmt::format("{} has another mid node than element {}.",
                                name(mesh_.cells[line.cell]), mesh_.cells[side->cell].number));
            }
        }
    }

    // Outline ---------------------------------------------------------------------------------

    std::string sideName(std::size_t side) const
    {
        return fmt::format("the side between nodes {} and {} (element {})",
                           number(outline_[side][0]), number(outline_[side][1]),
                           mesh_.cells[outlineCell_[side]].number);
    }

    /// But for third corners of needles, which are as near to the side opposite.
    std::vector<OutlineProblem> hangingNodes(double part) const
    {
        auto hanging = findHangingNodes(points_, outline_, part);
        std::erase_if(hanging, [this](const OutlineProblem& problem) {
            const auto nodes = mesh_.nodesOfCell(mesh_.cells[outlineCell_[problem.side[0]]]);
            return std::ranges::find(nodes, problem.node) != nodes.end();
        });
        return hanging;
    }

    /// A slit far narrower than the elements is more likely a node that should be on the side.
    void warnOfSlits()
    {
        constexpr double kNarrow = 1e-6;
        for (const OutlineProblem& problem : hangingNodes(kNarrow)) {
            const OutlineSide& side = outline_[problem.side[0]];
            const Vec2 a = points_[side[0]];
            const Vec2 chord = points_[side[1]] - a;
            const double away =
                std::abs(cross(chord, points_[problem.node] - a)) / tessera::length(chord);
            if (result_.warnings.size() < MeshCheck::kMostListed) {
                result_.warnings.push_back(fmt::format(
                    "Node {} at {} lies {:.3g} beside {}: there is a slit, or the node should be "
                    "on that side.",
                    number(problem.node), place(problem.node), away, sideName(problem.side[0])));
            }
        }
    }

    void checkOutline()
    {
        const auto hanging = hangingNodes(0.0);
        for (const OutlineProblem& problem : hanging) {
            add(fmt::format("Node {} at {} hangs on {}.", number(problem.node),
                            place(problem.node), sideName(problem.side[0])));
        }
        if (!hanging.empty()) {
            return; // each is a crossing, too
        }
        warnOfSlits();
        for (const OutlineProblem& problem : sweepOutline(points_, outline_)) {
            if (problem.kind == OutlineProblem::Kind::Crossing) {
                add(fmt::format("Elements overlap, or a node hangs, at {}: {} meets {}.",
                                place(outline_[problem.side[0]][0]), sideName(problem.side[0]),
                                sideName(problem.side[1])));
            }
            else if (oriented_) {
                add(fmt::format("Elements overlap at {}.", sideName(problem.side[0])));
            }
        }
    }

    // Figures ---------------------------------------------------------------------------------

    void measure()
    {
        Mesh corners;
        corners.nodes = points_;
        for (const Cell& cell : mesh_.cells) {
            const auto nodes = mesh_.nodesOfCell(cell);
            if (!isEdge(cell.kind)) {
                result_.area += areaOf(nodes, cornersOf(cell.kind));
            }
            if (cornersOf(cell.kind) == 3) {
                corners.triangles.push_back({nodes[0], nodes[1], nodes[2]});
            }
        }
        for (const OutlineSide& side : outline_) {
            result_.outlineLength += distance(points_[side[0]], points_[side[1]]);
        }
        result_.quality = measureQuality(corners, nullptr);
        result_.corners = std::move(corners);
    }

    double areaOf(std::span<const std::uint32_t> nodes, std::size_t corners) const
    {
        const Vec2 origin = points_[nodes[0]];
        double twice = 0.0;
        for (std::size_t i = 0; i < corners; ++i) {
            const Vec2 a = points_[nodes[i]] - origin;
            const Vec2 b = points_[nodes[(i + 1) % corners]] - origin;
            twice += cross(a, b);
            if (nodes.size() > corners) { // the parabola's segment, outside counted positive
                twice += 4.0 / 3.0 * cross(points_[nodes[corners + i]] - origin - a, b - a);
            }
        }
        return 0.5 * twice;
    }

    const RawMesh& mesh_;
    MeshCheck result_;
    std::size_t dropped_ = 0;
    bool oriented_ = true; ///< all elements counter-clockwise and each side used as it should be
    std::vector<Vec2> points_;
    std::vector<std::uint8_t> used_;
    std::vector<Side> sides_; ///< of elements, by key
    std::vector<Side> lines_; ///< line elements
    std::vector<OutlineSide> outline_;
    std::vector<std::uint32_t> outlineCell_;
};

} // namespace

MeshCheck checkMesh(const RawMesh& mesh)
{
    return Checker(mesh).run();
}

} // namespace tessera
