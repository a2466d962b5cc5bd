// SPDX-License-Identifier: MIT
#pragma once

#include "refine/refine.h"
#include "sample/pslg.h"

namespace tessera
{

/// Joins what recovery and coloring found into the mesh that refine and optimize work on. Every
/// subsegment becomes a ConstrainedEdge; among its constraints the first on a curved geometry
/// represents it, so that new vertices are put on that curve.
WorkingMesh makeWorkingMesh(RecoveryResult&& recovered, const RegionMap& regions,
                            const CurveNetwork& network, const Pslg& pslg,
                            std::vector<VertexOrigin> origin);

} // namespace tessera
