// SPDX-License-Identifier: MIT
#include "recover/snap_message.h"

#include "base/number_text.h"

namespace tessera
{

std::string describeSnapping(const RecoveryReport& report)
{
    if (!(report.snapPixel > 0.0)) {
        return {};
    }
    return "Lines lie too close to each other for double precision: points were rounded to a grid of "
        + numberText(report.snapPixel) + ", by up to " + numberText(report.maxDisplacement)
        + ". Where that matters, draw nearer to the origin or remove details that small.";
}

} // namespace tessera
