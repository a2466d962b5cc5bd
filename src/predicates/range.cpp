// SPDX-License-Identifier: MIT
#include "predicates/range.h"

#include "base/error.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tessera
{
namespace
{

[[noreturn]] void refuse(Vec2 point, const std::string& what)
{
    throw Error(ErrorKind::InvalidInput, "The point " + placeText(point) + " has a coordinate "
                    + what,
                {{point}});
}

} // namespace

void checkRange(std::span<const Vec2> points)
{
    double greatest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t smallestAt = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!isFinite(points[i])) {
            throw Error(ErrorKind::InvalidInput,
                        "Point " + std::to_string(i)
                            + ", counted from 0, has a coordinate that is not a finite number; "
                              "correct it.",
                        {{points[i]}});
        }
        for (const double value : {std::fabs(points[i].x), std::fabs(points[i].y)}) {
            if (value > kMaxMagnitude) {
                refuse(points[i], "beyond 1e150; scale the input down.");
            }
            greatest = std::max(greatest, value);
            if (value != 0.0 && value < smallest) {
                smallest = value;
                smallestAt = i;
            }
        }
    }
    if (smallest < kMinMagnitude) {
        refuse(points[smallestAt],
               "closer to zero than 1e-150; make it zero or scale the input up.");
    }
    if (greatest > smallest * kMaxSpan) {
        refuse(points[smallestAt],
               "more than 1e60 times smaller than the input's largest; make it zero.");
    }
}

} // namespace tessera
