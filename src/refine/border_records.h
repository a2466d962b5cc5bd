// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/refine.h"

namespace tessera
{

/// Makes constrained edges, with records, of the edges on the border of the kept triangles that lie
/// on no constraint (the hull of a point set), and takes both away again when it goes out of scope.
/// The records' useSet is above that of all others.
class BorderRecords
{
public:
    BorderRecords(WorkingMesh& mesh, const Execution& execution);
    ~BorderRecords();
    BorderRecords(const BorderRecords&) = delete;
    BorderRecords& operator=(const BorderRecords&) = delete;

private:
    WorkingMesh& mesh_;
    std::uint32_t firstUseSet_ = 0;
};

} // namespace tessera
