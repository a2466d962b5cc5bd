// SPDX-License-Identifier: MIT
#include "region/dropped_curves.h"

#include "curve/default_roles.h"
#include "region/curve_names.h"
#include "region/open_outline.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>

namespace tessera
{

namespace
{

/// Both ends are those of one straight curve, which no one means as an outline.
bool isStraightLine(const OutlineFlaw& flaw, const CurveNetwork& network,
                    std::span<const CurveId> parent)
{
    const std::uint32_t a = flaw.places[0].curve;
    const std::uint32_t b = flaw.places[1].curve;
    return flaw.kind == OutlineFlaw::Kind::Gap && !network.curves[a].geometry
        && (a == b || (!parent.empty() && parent[a] == parent[b]));
}

/// By subsegment: a border in a tree that hangs on the outlines, or of a chain that ends freely.
std::vector<std::uint8_t> danglingBorders(const RecoveryResult& recovered,
                                          const CurveNetwork& network, const Pslg& pslg)
{
    const ConstraintMap& map = recovered.constraints;
    std::vector<GraphEdge> edges;
    std::vector<std::size_t> subsegmentOf;
    for (std::size_t s = 0; s < map.subsegments.size(); ++s) {
        const auto uses = map.usesOf(map.subsegments[s]);
        if (std::any_of(uses.begin(), uses.end(), [&](const ConstraintUse& use) {
                const CurveId curve = pslg.segments[use.constraint.index()].curve;
                return network.curves[curve.index()].role == Role::Boundary;
            })) {
            edges.push_back({map.subsegments[s].a, map.subsegments[s].b});
            subsegmentOf.push_back(s);
        }
    }
    const EdgeClasses classes
        = classifyEdges(edges, recovered.triangulation.points.size(), {});
    std::vector<std::uint8_t> dangling(map.subsegments.size(), 0);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        dangling[subsegmentOf[i]] = classes.classOf[i] == EdgeClass::Dangling ? 1 : 0;
    }
    return dangling;
}

} // namespace

std::vector<std::string> describeDroppedCurves(const RecoveryResult& recovered,
                                               const CurveNetwork& network, const Pslg& pslg,
                                               const RegionMap& regions,
                                               std::span<const CurveId> parent)
{
    std::vector<std::uint8_t> outside(network.curves.size(), 0);
    std::vector<std::uint8_t> inside(network.curves.size(), 0);
    const std::vector<std::uint8_t> dangling = danglingBorders(recovered, network, pslg);
    const auto& subsegments = recovered.constraints.subsegments;
    for (std::size_t s = 0; s < subsegments.size(); ++s) {
        for (const ConstraintUse& use : recovered.constraints.usesOf(subsegments[s])) {
            const CurveId curve = pslg.segments[use.constraint.index()].curve;
            const Role role = network.curves[curve.index()].role;
            if (role == Role::Constraint
                || (role == Role::Boundary && (dangling[s] != 0 || regions.isOutside[s] == 0))) {
                (regions.isOutside[s] != 0 ? outside : inside)[curve.index()] = 1;
            }
        }
    }
    // Pieces of one curve of the input have one name; it is partly outside if any of them differ.
    const NamedCurves dropped = namesOf(network, outside);
    if (dropped.empty()) {
        return {};
    }
    const std::vector<std::string> keptNames = namesOf(network, inside).names;
    const std::set<std::string> kept(keptNames.begin(), keptNames.end());
    NamedCurves whole;
    NamedCurves partial;
    for (const std::string& name : dropped.names) {
        (kept.contains(name) ? partial : whole).names.push_back(name);
    }
    whole.nameless = dropped.nameless;
    std::string text = "Outside the outline, and therefore left out: ";
    text += whole.empty() ? "" : listOf(whole);
    text += whole.empty() || partial.empty() ? "" : "; ";
    text += partial.empty() ? "" : "parts of " + listOf(partial);
    std::vector<std::string> messages {text + "."};
    if (whole.empty()) {
        return messages;
    }
    const auto flaw = findOutlineFlaw(recovered, network, pslg, parent, outside);
    if (flaw && !isStraightLine(*flaw, network, parent)) {
        const bool gap = flaw->kind == OutlineFlaw::Kind::Gap;
        messages.push_back(std::string("If that was meant as an outline: ")
                           + (gap ? "it is open at " : "") + flaw->what + "; " + flaw->remedy
                           + (flaw->meshedByAll() ? ", or choose the fill rule 'all'." : "."));
    }
    return messages;
}

} // namespace tessera
