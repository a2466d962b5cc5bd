// SPDX-License-Identifier: MIT
#include "region/borders.h"

#include "curve/default_roles.h"
#include "region/fill_rules.h"

#include <algorithm>
#include <utility>

namespace tessera
{

namespace
{

/// Set in the component number of curves that lost Role::Boundary, to keep them apart from others.
constexpr std::uint32_t kReread = 0x80000000U;
constexpr std::uint32_t kUnnumbered = 0xffffffffU;

/// A constraint with its curve's role settled.
struct SettledConstraint
{
    Role role = Role::Constraint;
    bool turned = false; ///< runs against its curve
    std::uint32_t component = 0;
};

struct Use
{
    std::uint32_t subsegment;
    BorderCrossing crossing;
};

class BorderFinder
{
public:
    BorderFinder(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
                 FillRule fill, const SubsegmentGraph& graph)
        : map_(recovered.constraints)
        , network_(network)
        , pslg_(pslg)
        , fill_(fill)
        , graph_(graph)
        , settled_(pslg.segments.size())
        , number_(recovered.triangulation.points.size(), kUnnumbered)
    {}

    Borders run()
    {
        for (std::uint32_t c = 0; c < settled_.size(); ++c) {
            const NetworkCurve& curve = curveOf(c);
            settled_[c].role = fill_ == FillRule::All ? Role::Outline : curve.role;
            settled_[c].component = fill_ == FillRule::All ? 0 : curve.component;
        }
        if (fill_ != FillRule::All) {
            forEachOperand([this](std::span<const std::uint32_t> c) { settleBoundary(c); });
        }
        collectBoundaryUses();
        collectOutlineUses();
        return joinUses();
    }

private:
    const NetworkCurve& curveOf(std::uint32_t constraint) const
    {
        return network_.curves[pslg_.segments[constraint].curve.index()];
    }
    std::uint32_t operandOf(std::uint32_t constraint) const
    {
        return curveOf(constraint).operand.value;
    }
    /// The vertices at the constraint's ends; equal for one without length.
    std::pair<std::uint32_t, std::uint32_t> endsOf(std::uint32_t constraint) const
    {
        const auto chain = map_.chainOf(ConstraintId(constraint));
        return {chain.front(), chain.back()};
    }

    /// Calls f with the boundary constraints of one operand after another.
    template<class F>
    void forEachOperand(F f)
    {
        std::vector<std::uint32_t> order;
        for (std::uint32_t c = 0; c < settled_.size(); ++c) {
            if (settled_[c].role == Role::Boundary && endsOf(c).first != endsOf(c).second) {
                order.push_back(c);
            }
        }
        const auto less = [this](std::uint32_t c, std::uint32_t d) {
            return operandOf(c) < operandOf(d);
        };
        if (!std::is_sorted(order.begin(), order.end(), less)) {
            std::stable_sort(order.begin(), order.end(), less);
        }
        for (std::size_t i = 0; i < order.size();) {
            std::size_t j = i;
            while (j < order.size() && operandOf(order[j]) == operandOf(order[i])) {
                ++j;
            }
            f(std::span<const std::uint32_t>(order.data() + i, j - i));
            i = j;
        }
    }

    void settleBoundary(std::span<const std::uint32_t> constraints)
    {
        // Vertices numbered from 0, so that an operand costs its own size only.
        std::uint32_t vertexCount = 0;
        std::vector<GraphEdge> edges;
        edges.reserve(constraints.size());
        const auto numberOf = [this, &vertexCount](std::uint32_t v) {
            if (number_[v] == kUnnumbered) {
                number_[v] = vertexCount++;
            }
            return number_[v];
        };
        for (const std::uint32_t c : constraints) {
            const auto [a, b] = endsOf(c);
            const std::uint32_t first = numberOf(a);
            edges.push_back({first, numberOf(b)});
        }
        for (const std::uint32_t c : constraints) {
            number_[endsOf(c).first] = number_[endsOf(c).second] = kUnnumbered;
        }
        std::vector<std::int32_t> outMinusIn(vertexCount, 0);
        std::vector<std::uint8_t> isOdd(vertexCount, 0);
        for (const GraphEdge& edge : edges) {
            ++outMinusIn[edge.a];
            --outMinusIn[edge.b];
            isOdd[edge.a] ^= 1U;
            isOdd[edge.b] ^= 1U;
        }
        if (std::find(isOdd.begin(), isOdd.end(), 1) != isOdd.end()) {
            rereadOpenBoundary(constraints, edges, vertexCount);
        }
        else if (fill_ != FillRule::EvenOdd && fill_ != FillRule::Hull
                 && std::any_of(outMinusIn.begin(), outMinusIn.end(),
                                [](std::int32_t d) { return d != 0; })) {
            turnHeadToTail(constraints, edges, vertexCount);
        }
    }

    void rereadOpenBoundary(std::span<const std::uint32_t> constraints,
                            std::span<const GraphEdge> edges, std::size_t vertexCount)
    {
        const EdgeClasses classes = classifyEdges(edges, vertexCount, {});
        std::vector<std::uint32_t> closed;
        std::vector<GraphEdge> closedEdges;
        for (std::size_t i = 0; i < constraints.size(); ++i) {
            SettledConstraint& settled = settled_[constraints[i]];
            if (classes.classOf[i] == EdgeClass::Dangling) {
                settled.role = Role::Constraint;
            }
            else if (classes.classOf[i] == EdgeClass::Odd) {
                settled.role = Role::Outline;
                settled.component = kReread | classes.component[i];
            }
            else {
                closed.push_back(constraints[i]);
                closedEdges.push_back(edges[i]);
            }
        }
        const std::string& name = network_.operands[operandOf(constraints.front())].name;
        borders_.messages.push_back("The boundary of " + (name.empty() ? "an operand" : name)
                                    + " does not close everywhere; its open parts were kept as"
                                      " constraints.");
        if (fill_ != FillRule::EvenOdd && fill_ != FillRule::Hull) {
            turnHeadToTail(closed, closedEdges, vertexCount);
        }
    }

    /// Walks closed trails, which use up graphs with even degrees, and turns what lies against the
    /// walk. It goes on in an edge's own direction while there is one, so that loops that already
    /// run head to tail stay as they are.
    void turnHeadToTail(std::span<const std::uint32_t> constraints,
                        std::span<const GraphEdge> edges, std::size_t vertexCount)
    {
        std::vector<std::vector<std::uint32_t>> leaving(vertexCount);
        std::vector<std::vector<std::uint32_t>> entering(vertexCount);
        for (std::size_t i = edges.size(); i-- > 0;) {
            leaving[edges[i].a].push_back(static_cast<std::uint32_t>(i));
            entering[edges[i].b].push_back(static_cast<std::uint32_t>(i));
        }
        std::vector<std::uint8_t> walked(edges.size(), 0);
        const auto take = [&walked](std::vector<std::uint32_t>& list) {
            while (!list.empty() && walked[list.back()] != 0) {
                list.pop_back();
            }
            return list.empty() ? 0xffffffffU : list.back();
        };
        for (std::uint32_t first = 0; first < edges.size(); ++first) {
            if (walked[first] != 0) {
                continue;
            }
            walked[first] = 1;
            std::uint32_t v = edges[first].b;
            for (;;) {
                const std::uint32_t along = take(leaving[v]);
                const std::uint32_t against = along == 0xffffffffU ? take(entering[v]) : along;
                if (against == 0xffffffffU) {
                    break;
                }
                walked[against] = 1;
                settled_[constraints[against]].turned = along == 0xffffffffU;
                v = along != 0xffffffffU ? edges[along].b : edges[against].a;
            }
        }
    }

    void collectBoundaryUses()
    {
        uses_.reserve(map_.uses.size());
        for (std::uint32_t s = 0; s < map_.subsegments.size(); ++s) {
            for (const ConstraintUse& use : map_.usesOf(map_.subsegments[s])) {
                const std::uint32_t c = use.constraint.value;
                if (settled_[c].role == Role::Boundary) {
                    const bool forward = use.forward != settled_[c].turned;
                    uses_.push_back({s, {operandOf(c), forward ? 1 : -1}});
                }
            }
        }
    }

    /// Operand, component and subsegment of everything with Role::Outline, once each.
    void collectOutlineUses()
    {
        struct Part
        {
            std::uint32_t operand;
            std::uint32_t component;
            std::uint32_t subsegment;
            auto operator<=>(const Part&) const = default;
        };
        std::vector<Part> parts;
        for (std::uint32_t s = 0; s < map_.subsegments.size(); ++s) {
            for (const ConstraintUse& use : map_.usesOf(map_.subsegments[s])) {
                const std::uint32_t c = use.constraint.value;
                if (settled_[c].role == Role::Outline) {
                    parts.push_back({operandOf(c), settled_[c].component, s});
                }
            }
        }
        std::sort(parts.begin(), parts.end());
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        std::vector<std::uint32_t> subset;
        for (std::size_t i = 0; i < parts.size();) {
            subset.clear();
            std::size_t j = i;
            for (; j < parts.size() && parts[j].operand == parts[i].operand
                 && parts[j].component == parts[i].component;
                 ++j) {
                subset.push_back(parts[j].subsegment);
            }
            addContours(parts[i].operand, subset);
            i = j;
        }
    }

    void addContours(std::uint32_t operand, const std::vector<std::uint32_t>& subset)
    {
        // The inside lies on the left of the contour. Negative counts clockwise loops, so there a
        // contour has to count -1 to cover.
        const std::int32_t covers = fill_ == FillRule::Negative ? -1 : 1;
        for (const auto& contour : graph_.outerContours(subset)) {
            for (const DirectedSubsegment& step : contour) {
                uses_.push_back({step.subsegment, {operand, step.forward ? covers : -covers}});
            }
        }
    }

    Borders joinUses()
    {
        const auto less = [](const Use& p, const Use& q) {
            return p.subsegment != q.subsegment ? p.subsegment < q.subsegment
                                                : p.crossing.operand < q.crossing.operand;
        };
        if (!std::is_sorted(uses_.begin(), uses_.end(), less)) {
            std::stable_sort(uses_.begin(), uses_.end(), less);
        }
        const bool parity = fill_ == FillRule::EvenOdd || fill_ == FillRule::Hull;
        borders_.start.reserve(map_.subsegments.size() + 1);
        borders_.start.push_back(0);
        borders_.crossings.reserve(uses_.size());
        std::size_t i = 0;
        for (std::uint32_t s = 0; s < map_.subsegments.size(); ++s) {
            while (i < uses_.size() && uses_[i].subsegment == s) {
                BorderCrossing sum {uses_[i].crossing.operand, 0};
                std::uint32_t count = 0;
                for (; i < uses_.size() && uses_[i].subsegment == s
                     && uses_[i].crossing.operand == sum.operand;
                     ++i) {
                    sum.leftMinusRight += uses_[i].crossing.leftMinusRight;
                    ++count;
                }
                if (parity ? outerAcross(true, count) != true : sum.leftMinusRight != 0) {
                    borders_.crossings.push_back(sum);
                }
            }
            borders_.start.push_back(static_cast<std::uint32_t>(borders_.crossings.size()));
        }
        return std::move(borders_);
    }

    const ConstraintMap& map_;
    const CurveNetwork& network_;
    const Pslg& pslg_;
    FillRule fill_;
    const SubsegmentGraph& graph_;
    std::vector<SettledConstraint> settled_;
    std::vector<std::uint32_t> number_; ///< by vertex, within the operand that is looked at
    std::vector<Use> uses_;
    Borders borders_;
};

} // namespace

Borders findBorders(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
                    FillRule fill, const SubsegmentGraph& graph)
{
    return BorderFinder(recovered, network, pslg, fill, graph).run();
}

} // namespace tessera
