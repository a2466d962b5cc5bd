// SPDX-License-Identifier: MIT
#include "region/dropped_curves.h"

#include "region/curve_names.h"
#include "region/open_outline.h"

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

} // namespace

std::vector<std::string> describeDroppedCurves(const RecoveryResult& recovered,
                                               const CurveNetwork& network, const Pslg& pslg,
                                               const RegionMap& regions,
                                               std::span<const CurveId> parent)
{
    std::vector<std::uint8_t> outside(network.curves.size(), 0);
    std::vector<std::uint8_t> inside(network.curves.size(), 0);
    const auto& subsegments = recovered.constraints.subsegments;
    for (std::size_t s = 0; s < subsegments.size(); ++s) {
        for (const ConstraintUse& use : recovered.constraints.usesOf(subsegments[s])) {
            const CurveId curve = pslg.segments[use.constraint.index()].curve;
            if (network.curves[curve.index()].role == Role::Constraint) {
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
