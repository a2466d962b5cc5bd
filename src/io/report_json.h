// SPDX-License-Identifier: MIT
#pragma once

#include "io/check_mesh.h"
#include "pipeline.h"

#include <string>

namespace tessera
{

/// The report of a meshing run as JSON. report.seconds should be complete (read, write, total).
std::string formatReport(const MeshResult& result);

/// The report of checkMesh() as JSON.
std::string formatReport(const MeshCheck& check);

} // namespace tessera
