// SPDX-License-Identifier: MIT
#include "imprint/empty_overlay.h"

#include "base/error.h"
#include "region/no_inside.h"

#include <algorithm>

namespace tessera
{

namespace
{

std::string whyNothingIsCovered(const RecoveryResult& recovered, const CurveNetwork& network,
                                const Pslg& pslg, FillRule fill, const ArrangedInput& input)
{
    const auto isUsed = [](const NetworkCurve& curve) { return curve.role != Role::Ignored; };
    if (std::none_of(network.curves.begin(), network.curves.end(), isUsed)) {
        return "There are no curves; draw closed outlines.";
    }
    return explainNoInside(recovered, network, pslg, fill, input).what();
}

std::string whyOthersTakeAll(BooleanOperation operation, std::size_t operands)
{
    switch (operation) {
        case BooleanOperation::Intersection:
            return "No place is covered by all " + std::to_string(operands) + " operands.";
        case BooleanOperation::Difference:
            return "No place is covered by the first operand alone.";
        case BooleanOperation::SymmetricDifference:
        case BooleanOperation::Union:
        case BooleanOperation::Cells:
            break;
    }
    return "Each place is covered by an even number of operands.";
}

} // namespace

std::string whyEmpty(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
                     const BooleanOptions& options, const ArrangedInput& input,
                     Execution& execution)
{
    BooleanOptions all = options;
    all.operation = BooleanOperation::Union;
    const bool covered =
        !colorBoolean(recovered, network, pslg, all, execution).parts.empty();
    return "The result is empty. "
        + (covered ? whyOthersTakeAll(options.operation, network.operands.size())
                   : whyNothingIsCovered(recovered, network, pslg, options.fill, input));
}

} // namespace tessera
