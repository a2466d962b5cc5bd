// SPDX-License-Identifier: MIT
#pragma once

#include "io/check_mesh.h"
#include "pipeline.h"

#include <cstdint>
#include <string>

namespace tessera
{

/// Greatest amount of memory that this process has held so far, bytes; 0 if not known.
std::uint64_t peakMemoryBytes();

/// The report of a meshing run as JSON. report.seconds should be complete (read, write, total).
std::string formatReport(const MeshResult& result);

/// The report of checkMesh() as JSON.
std::string formatReport(const MeshCheck& check);

} // namespace tessera
