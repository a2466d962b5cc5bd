// SPDX-License-Identifier: MIT
#include "region/dropped_curves.h"

#include "region/free_ends.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>

namespace tessera
{

namespace
{

/// More free ends than these are no outline with gaps.
constexpr std::size_t kMostEndsOfAnOutline = 1000;

/// Names of curves, each once in the order of the curves; how many have none.
struct NamedCurves
{
    std::vector<std::string> names;
    std::size_t nameless = 0;

    bool empty() const { return names.empty() && nameless == 0; }
};

NamedCurves namesOf(const CurveNetwork& network, const std::vector<std::uint8_t>& wanted)
{
    NamedCurves result;
    std::set<std::string> known;
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
        if (wanted[c] == 0) {
            continue;
        }
        const bool named = c < network.curveNames.size() && !network.curveNames[c].empty();
        if (!named) {
            ++result.nameless;
        }
        else if (known.insert(network.curveNames[c]).second) {
            result.names.push_back(network.curveNames[c]);
        }
    }
    return result;
}

/// "Edge3, Edge5, Edge6 and 12 more", "3 curves".
std::string listOf(const NamedCurves& curves)
{
    constexpr std::size_t kShown = 3;
    std::string text;
    const std::size_t shown = std::min(kShown, curves.names.size());
    for (std::size_t i = 0; i < shown; ++i) {
        text += (i == 0 ? "" : ", ") + curves.names[i];
    }
    const std::size_t more = curves.names.size() - shown + curves.nameless;
    if (more == 0) {
        return text;
    }
    return shown > 0 ? text + " and " + std::to_string(more) + " more"
                     : std::to_string(more) + (more == 1 ? " curve" : " curves");
}

} // namespace

std::vector<std::string> describeDroppedCurves(const RecoveryResult& recovered,
                                               const CurveNetwork& network, const Pslg& pslg,
                                               const RegionMap& regions)
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
    const std::vector<FreeEnd> ends = findFreeEnds(network, outside);
    if (whole.empty() || ends.size() > kMostEndsOfAnOutline) {
        return messages;
    }
    if (const auto pair = closestPair(ends, network)) {
        messages.push_back("If that was meant as an outline: it is open at "
                           + describePair(*pair, network)
                           + "; close the gap, or raise the weld tolerance to that.");
    }
    return messages;
}

} // namespace tessera
