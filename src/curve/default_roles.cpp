// SPDX-License-Identifier: MIT
#include "curve/default_roles.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tessera
{

namespace
{

/// Half-open lists of the edges at each vertex.
struct Adjacency
{
    std::vector<std::uint32_t> start;
    std::vector<std::uint32_t> edges;

    std::span<const std::uint32_t> at(std::uint32_t vertex) const
    {
        return {edges.data() + start[vertex], start[vertex + 1] - start[vertex]};
    }
};

class EdgeClassifier
{
public:
    EdgeClassifier(std::span<const GraphEdge> edges, std::size_t vertexCount)
        : edges_(edges)
        , vertexCount_(vertexCount)
    {
        result_.classOf.assign(edges.size(), EdgeClass::Even);
        result_.component.assign(edges.size(), 0);
    }

    EdgeClasses run(EdgeClassOptions options)
    {
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            if (edges_[e].a == edges_[e].b) {
                result_.classOf[e] = EdgeClass::Loop;
            }
        }
        if (options.duplicatesOnce) {
            markRepeated();
        }
        buildAdjacency();
        peelTrees();
        if (options.cutBridges) {
            markBridges();
        }
        classifyComponents();
        return std::move(result_);
    }

private:
    bool remains(std::uint32_t e) const { return result_.classOf[e] == EdgeClass::Even; }
    std::uint32_t otherEnd(std::uint32_t e, std::uint32_t v) const
    {
        return edges_[e].a == v ? edges_[e].b : edges_[e].a;
    }

    void markRepeated()
    {
        const auto key = [this](std::uint32_t e) {
            return std::pair(std::min(edges_[e].a, edges_[e].b),
                             std::max(edges_[e].a, edges_[e].b));
        };
        std::vector<std::uint32_t> order(edges_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::sort(order.begin(), order.end(), [&key](std::uint32_t e, std::uint32_t f) {
            return std::pair(key(e), e) < std::pair(key(f), f);
        });
        for (std::size_t i = 1; i < order.size(); ++i) {
            if (remains(order[i]) && key(order[i]) == key(order[i - 1])) {
                result_.classOf[order[i]] = EdgeClass::Repeated;
            }
        }
    }

    void buildAdjacency()
    {
        adjacency_.start.assign(vertexCount_ + 1, 0);
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            if (remains(e)) {
                ++adjacency_.start[edges_[e].a + 1];
                ++adjacency_.start[edges_[e].b + 1];
            }
        }
        std::partial_sum(adjacency_.start.begin(), adjacency_.start.end(),
                         adjacency_.start.begin());
        adjacency_.edges.resize(adjacency_.start.back());
        std::vector<std::uint32_t> fill(adjacency_.start.begin(), adjacency_.start.end() - 1);
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            if (remains(e)) {
                adjacency_.edges[fill[edges_[e].a]++] = e;
                adjacency_.edges[fill[edges_[e].b]++] = e;
            }
        }
    }

    void peelTrees()
    {
        std::vector<std::uint32_t> degree(vertexCount_);
        std::vector<std::uint32_t> tips;
        for (std::uint32_t v = 0; v < vertexCount_; ++v) {
            degree[v] = static_cast<std::uint32_t>(adjacency_.at(v).size());
            if (degree[v] == 1) {
                tips.push_back(v);
            }
        }
        while (!tips.empty()) {
            const std::uint32_t v = tips.back();
            tips.pop_back();
            for (const std::uint32_t e : adjacency_.at(v)) {
                if (remains(e)) {
                    result_.classOf[e] = EdgeClass::Dangling;
                    --degree[v];
                    if (--degree[otherEnd(e, v)] == 1) {
                        tips.push_back(otherEnd(e, v));
                    }
                }
            }
        }
    }

    /// Depth-first search with low links (Tarjan 1974), without recursion.
    void markBridges()
    {
        struct Frame
        {
            std::uint32_t vertex;
            std::uint32_t entry; ///< edge by which it was reached; none at the root
            std::uint32_t position;
        };
        constexpr std::uint32_t kNone = 0xffffffffU;
        std::vector<std::uint32_t> order(vertexCount_, kNone);
        std::vector<std::uint32_t> low(vertexCount_, kNone);
        std::vector<std::uint32_t> bridges;
        std::vector<Frame> stack;
        std::uint32_t count = 0;
        for (std::uint32_t root = 0; root < vertexCount_; ++root) {
            if (order[root] != kNone || adjacency_.at(root).empty()) {
                continue;
            }
            order[root] = low[root] = count++;
            stack.push_back({root, kNone, 0});
            while (!stack.empty()) {
                Frame& frame = stack.back();
                const std::uint32_t v = frame.vertex;
                if (frame.position < adjacency_.at(v).size()) {
                    const std::uint32_t e = adjacency_.at(v)[frame.position++];
                    const std::uint32_t w = otherEnd(e, v);
                    if (e == frame.entry || !remains(e)) {
                        continue;
                    }
                    if (order[w] == kNone) {
                        order[w] = low[w] = count++;
                        stack.push_back({w, e, 0});
                    }
                    else {
                        low[v] = std::min(low[v], order[w]);
                    }
                    continue;
                }
                const std::uint32_t entry = frame.entry;
                stack.pop_back();
                if (entry != kNone) {
                    const std::uint32_t parent = stack.back().vertex;
                    low[parent] = std::min(low[parent], low[v]);
                    if (low[v] > order[parent]) {
                        bridges.push_back(entry);
                    }
                }
            }
        }
        for (const std::uint32_t e : bridges) {
            result_.classOf[e] = EdgeClass::Bridge;
        }
    }

    void classifyComponents()
    {
        constexpr std::uint32_t kNone = 0xffffffffU;
        std::vector<std::uint32_t> componentOf(vertexCount_, kNone);
        std::vector<std::uint8_t> isOdd;
        std::vector<std::uint32_t> stack;
        for (std::uint32_t root = 0; root < vertexCount_; ++root) {
            if (componentOf[root] != kNone) {
                continue;
            }
            const auto component = static_cast<std::uint32_t>(isOdd.size());
            isOdd.push_back(0);
            componentOf[root] = component;
            stack.push_back(root);
            while (!stack.empty()) {
                const std::uint32_t v = stack.back();
                stack.pop_back();
                std::uint32_t degree = 0;
                for (const std::uint32_t e : adjacency_.at(v)) {
                    if (!remains(e)) {
                        continue;
                    }
                    ++degree;
                    const std::uint32_t w = otherEnd(e, v);
                    if (componentOf[w] == kNone) {
                        componentOf[w] = component;
                        stack.push_back(w);
                    }
                }
                isOdd[component] |= static_cast<std::uint8_t>(degree & 1U);
            }
        }
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            if (remains(e)) {
                result_.component[e] = componentOf[edges_[e].a];
                if (isOdd[result_.component[e]] != 0) {
                    result_.classOf[e] = EdgeClass::Odd;
                }
            }
        }
    }

    std::span<const GraphEdge> edges_;
    std::size_t vertexCount_;
    Adjacency adjacency_;
    EdgeClasses result_;
};

/// The curves with the given role of one operand after another; f(first, last) gets a range of
/// curve indices that belong to one operand.
template<class Wanted, class F>
void forEachOperand(const CurveNetwork& network, Wanted wanted, F f)
{
    std::vector<std::uint32_t> order;
    for (std::uint32_t c = 0; c < network.curves.size(); ++c) {
        if (wanted(c)) {
            order.push_back(c);
        }
    }
    const auto operandOf = [&network](std::uint32_t c) { return network.curves[c].operand; };
    std::stable_sort(order.begin(), order.end(), [&operandOf](std::uint32_t c, std::uint32_t d) {
        return operandOf(c) < operandOf(d);
    });
    for (std::size_t i = 0; i < order.size();) {
        std::size_t j = i;
        while (j < order.size() && operandOf(order[j]) == operandOf(order[i])) {
            ++j;
        }
        f(std::span<const std::uint32_t>(order.data() + i, j - i));
        i = j;
    }
}

/// The curves' ends with vertices numbered from 0, so that each operand costs only its own size.
std::pair<std::vector<GraphEdge>, std::size_t> graphOf(const CurveNetwork& network,
                                                       std::span<const std::uint32_t> curves)
{
    std::vector<std::uint32_t> points;
    points.reserve(2 * curves.size());
    for (const std::uint32_t c : curves) {
        points.push_back(network.curves[c].start.value);
        points.push_back(network.curves[c].end.value);
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const auto number = [&points](PointId p) {
        return static_cast<std::uint32_t>(
            std::lower_bound(points.begin(), points.end(), p.value) - points.begin());
    };
    std::vector<GraphEdge> edges;
    edges.reserve(curves.size());
    for (const std::uint32_t c : curves) {
        edges.push_back({number(network.curves[c].start), number(network.curves[c].end)});
    }
    return {std::move(edges), points.size()};
}

Role roleOf(EdgeClass edgeClass)
{
    switch (edgeClass) {
        case EdgeClass::Even:
            return Role::Boundary;
        case EdgeClass::Odd:
            return Role::Outline;
        default:
            return Role::Constraint;
    }
}

} // namespace

EdgeClasses classifyEdges(std::span<const GraphEdge> edges, std::size_t vertexCount,
                          EdgeClassOptions options)
{
    return EdgeClassifier(edges, vertexCount).run(options);
}

void assignPolyRoles(CurveNetwork& network, OperandId operand,
                     std::span<const std::int32_t> settledMarkers)
{
    std::vector<std::uint8_t> settled;
    for (const NetworkCurve& c : network.curves) {
        const bool found = std::ranges::find(settledMarkers, c.marker) != settledMarkers.end();
        settled.push_back(found ? 1 : 0);
    }
    assignPolyRolesExcept(network, operand, settled);
}

void assignPolyRolesExcept(CurveNetwork& network, OperandId operand,
                           std::span<const std::uint8_t> settled)
{
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        NetworkCurve& curve = network.curves[c];
        curve.roleByConnection |= curve.operand == operand && settled[c] == 0;
    }
    renewPolyRoles(network);
}

void renewPolyRoles(CurveNetwork& network)
{
    const auto wanted = [&network](std::uint32_t c) { return network.curves[c].roleByConnection; };
    forEachOperand(network, wanted, [&network](std::span<const std::uint32_t> curves) {
        const auto [edges, vertexCount] = graphOf(network, curves);
        const EdgeClasses classes = classifyEdges(edges, vertexCount, {.duplicatesOnce = true});
        for (std::size_t i = 0; i < curves.size(); ++i) {
            network.curves[curves[i]].role = roleOf(classes.classOf[i]);
            network.curves[curves[i]].component = classes.component[i];
        }
    });
}

void settleChainRoles(CurveNetwork& network)
{
    const auto wanted = [&network](std::uint32_t c) {
        return network.curves[c].role == Role::Chain;
    };
    forEachOperand(network, wanted, [&network](std::span<const std::uint32_t> curves) {
        const auto [edges, vertexCount] = graphOf(network, curves);
        const EdgeClasses classes = classifyEdges(edges, vertexCount, {.cutBridges = true});
        for (std::size_t i = 0; i < curves.size(); ++i) {
            NetworkCurve& curve = network.curves[curves[i]];
            const bool closed = classes.classOf[i] == EdgeClass::Loop && curve.geometry;
            curve.role = closed ? Role::Boundary : roleOf(classes.classOf[i]);
            curve.component = classes.component[i];
        }
    });
}

} // namespace tessera
