// SPDX-License-Identifier: MIT
#include "predicates/range.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace tessera
{
namespace
{

[[noreturn]] void refuse(std::span<const Vec2> points, std::size_t i, const std::string& what)
{
    throw Error(ErrorKind::InvalidInput, "Point " + std::to_string(i) + " " + what,
                {{points[i], static_cast<std::uint32_t>(i)}});
}

} // namespace

void checkRange(std::span<const Vec2> points)
{
    double greatest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t smallestAt = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isFinite(points[i])) {
            refuse(points, i, "has a coordinate that is not a finite number; correct it.");
        }
        for (const double value : {std::fabs(points[i].x), std::fabs(points[i].y)}) {
            if (value > kMaxMagnitude) {
                refuse(points, i, "has a coordinate beyond 1e150; scale the input down.");
            }
            greatest = std::max(greatest, value);
            if (value != 0.0 && value < smallest) {
                smallest = value;
                smallestAt = i;
            }
        }
    }
    if (smallest < kMinMagnitude) {
        refuse(points, smallestAt,
               "has a coordinate closer to zero than 1e-150; make it zero or scale the input up.");
    }
    if (greatest > smallest * kMaxSpan) {
        refuse(points, smallestAt,
               "has a coordinate more than 1e60 times smaller than the input's largest; make it "
               "zero.");
    }
}

} // namespace tessera
