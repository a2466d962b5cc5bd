// SPDX-License-Identifier: MIT
#include "io/append_network.h"

#include "base/error.h"

#include <iterator>

namespace tessera
{

namespace
{

template<class T>
void moveBehind(std::vector<T>& to, std::vector<T>& from)
{
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

} // namespace

void appendNetwork(CurveNetwork& network, CurveNetwork more)
{
    constexpr std::size_t kMost = 0xfffffffeU;
    if (network.points.size() + more.points.size() > kMost
        || network.curves.size() + more.curves.size() > kMost) {
        throw Error(ErrorKind::TooLarge,
                    "The inputs together have more than 2^32 - 2 points or curves; mesh fewer of "
                    "them at a time.");
    }
    const auto points = static_cast<std::uint32_t>(network.points.size());
    const auto operands = static_cast<std::uint32_t>(network.operands.size());
    for (NetworkCurve& curve : more.curves) {
        curve.start.value += points;
        curve.end.value += points;
        curve.operand.value += operands;
    }
    for (EmbeddedPoint& embedded : more.embedded) {
        embedded.point.value += points;
        embedded.operand.value += operands;
    }
    for (HolePoint& hole : more.holes) {
        hole.operand.value += operands;
    }
    for (RegionPoint& region : more.regions) {
        region.operand.value += operands;
    }
    if (!network.curveNames.empty() || !more.curveNames.empty()) {
        network.curveNames.resize(network.curves.size());
        more.curveNames.resize(more.curves.size());
    }
    moveBehind(network.points, more.points);
    moveBehind(network.curves, more.curves);
    moveBehind(network.operands, more.operands);
    moveBehind(network.embedded, more.embedded);
    moveBehind(network.holes, more.holes);
    moveBehind(network.regions, more.regions);
    moveBehind(network.curveNames, more.curveNames);
}

} // namespace tessera
