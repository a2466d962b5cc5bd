// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "region/boolean.h"
#include "region/no_inside.h"

#include <string>

namespace tessera
{

/// Why a Boolean operation kept nothing, for the user: there are only open curves, the operands have
/// nothing in common, ... Precondition: colorBoolean() of the same arguments gave no part. As dear as
/// that.
std::string whyEmpty(const RecoveryResult& recovered, const CurveNetwork& network, const Pslg& pslg,
                     const BooleanOptions& options, const ArrangedInput& input,
                     Execution& execution);

} // namespace tessera
