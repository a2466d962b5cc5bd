// SPDX-License-Identifier: MIT
#include "region/curve_names.h"

#include <algorithm>
#include <set>

namespace tessera
{

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

} // namespace tessera
