// SPDX-License-Identifier: MIT

#include "refine/refine.h"

#include "refine/delaunay_refinement.h"
#include "refine/front.h"
#include "refine/mesh_editor.h"
#include "refine/vertex_sizes.h"

namespace tessera
{

RefineReport refine(WorkingMesh& mesh, const SizeField& size, const RefineOptions& options,
                    Execution& execution)
{
    if (!(options.minAngle >= 0.0 && options.minAngle <= 33.0)) {
        throw Error(ErrorKind::InvalidOption,
                    "The smallest angle must be between 0 and 33 degrees.");
    }
    RefineReport report;
    MeshEditor editor(mesh);
    VertexSizes sizes(editor, size, options);
    sizes.prepare(report, execution);
    report.interiorPoints += placeFrontal(editor, sizes, execution);
    refineDelaunay(editor, size, options, report, execution);
    report.unreached = findUnreached(mesh, options);
    return report;
}

} // namespace tessera
