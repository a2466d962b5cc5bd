// SPDX-License-Identifier: MIT
#include "region/dropped_curves.h"

#include "region/curve_names.h"
#include "region/open_outline.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

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

/// By subsegment: of the tree that hangs on the outlines, or of a chain that ends freely.
std::vector<std::uint8_t> danglingBorders(const RecoveryResult& recovered,
                                          const CurveNetwork& network, const Pslg& pslg)
{
    const auto& subsegments = recovered.constraints.subsegments;
    std::vector<std::uint32_t> degree(recovered.triangulation.points.size(), 0);
    std::vector<std::uint8_t> borders(subsegments.size(), 0);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> at; // (vertex, subsegment)
    for (std::uint32_t s = 0; s < subsegments.size(); ++s) {
        for (const ConstraintUse& use : recovered.constraints.usesOf(subsegments[s])) {
            const CurveId curve = pslg.segments[use.constraint.index()].curve;
            borders[s] |= network.curves[curve.index()].role == Role::Boundary;
        }
        for (const std::uint32_t v : {subsegments[s].a, subsegments[s].b}) {
            if (borders[s] != 0) {
                ++degree[v];
                at.emplace_back(v, s);
            }
        }
    }
    std::sort(at.begin(), at.end());
    std::vector<std::uint32_t> ends;
    for (std::uint32_t v = 0; v < degree.size(); ++v) {
        if (degree[v] == 1) {
            ends.push_back(v);
        }
    }
    std::vector<std::uint8_t> dangling(subsegments.size(), 0);
    while (!ends.empty()) {
        const std::uint32_t v = ends.back();
        ends.pop_back();
        for (auto i = std::lower_bound(at.begin(), at.end(), std::pair(v, 0U));
             i != at.end() && i->first == v; ++i) {
            const Subsegment& s = subsegments[i->second];
            if (dangling[i->second] == 0) {
                dangling[i->second] = 1;
                const std::uint32_t other = s.a == v ? s.b : s.a;
                if (--degree[other] == 1) {
                    ends.push_back(other);
                }
            }
        }
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
