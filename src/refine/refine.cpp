// SPDX-License-Identifier: MIT

#include "refine/refine.h"

#include "refine/border_records.h"
#include "refine/delaunay_refinement.h"
#include "refine/front.h"
#include "refine/lattice.h"
#include "refine/mesh_editor.h"
#include "refine/vertex_sizes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace tessera
{

namespace
{

/// Two rows of free points between boundary and lattice take up the misfit: measured at 1e5
/// triangles, 1st percentile of the smallest angles 45.0 degrees with 0.8 h, 47.2 with 2.6 h, 47.3
/// with 5.2 h.
constexpr double kClearance = 2.6;
/// Below this share of the coordinates rounding may disturb a lattice.
constexpr double kSmallestSpacing = 1e-9;

/// Fills what is far enough from the boundary with a lattice where the size is uniform.
LatticePatch placeLattice(MeshEditor& editor, VertexSizes& sizes, Execution& execution)
{
    const double h = sizes.uniformSize();
    Box2 box;
    for (std::uint32_t v = 1; v < editor.triangulation().points.size(); ++v) {
        box.add(editor.triangulation().points[v]);
    }
    const double largest = std::max({std::fabs(box.min.x), std::fabs(box.min.y),
                                     std::fabs(box.max.x), std::fabs(box.max.y)});
    if (!(h > kSmallestSpacing * largest && h < box.diagonal())) {
        return {};
    }
    const HexLattice lattice {box.min, h};
    return insertLattice(editor, sizes, lattice,
                         findLatticeRuns(editor, sizes, lattice, kClearance), execution);
}

} // namespace

bool hasAreaLimits(const RefineOptions& options)
{
    return options.maxArea > 0.0
        || std::any_of(options.regionMaxArea.begin(), options.regionMaxArea.end(),
                       [](double area) { return area > 0.0; });
}

RefineReport refine(WorkingMesh& mesh, const SizeField& size, const RefineOptions& options,
                    Execution& execution)
{
    if (!(options.minAngle >= 0.0 && options.minAngle <= 33.0)) {
        throw Error(ErrorKind::InvalidOption,
                    "The smallest angle must be between 0 and 33 degrees.");
    }
    if (!(options.narrowShare >= 0.0 && std::isfinite(options.narrowShare))) {
        throw Error(ErrorKind::InvalidOption,
                    "The share of triangles for narrow gaps must be a finite number of at least 0.");
    }
    RefineReport report;
    const BorderRecords border(mesh, execution);
    MeshEditor editor(mesh);
    VertexSizes sizes(editor, size, options);
    sizes.prepare(report, execution);
    const LatticePatch patch = placeLattice(editor, sizes, execution);
    report.interiorPoints += patch.points;
    FrontResult front
        = placeFrontal(editor, sizes, patch.firstTriangle, patch.endTriangle, execution);
    report.interiorPoints += front.points;
    releaseRim(editor, patch);
    RefineOptions rest = options;
    std::vector<std::uint32_t> candidates = std::move(front.open);
    // Beside a frozen boundary optimize() inserts nothing for small angles.
    const bool leavesAngles = options.optimizeFollows && !options.freezeBoundary;
    if (leavesAngles) {
        rest.minAngle = 0.0;
    }
    if (!leavesAngles || hasAreaLimits(options)) {
        candidates.resize(mesh.triangulation.triangles.size());
        std::iota(candidates.begin(), candidates.end(), 0U);
    }
    refineDelaunay(editor, size, rest, candidates, report, execution);
    if (!options.optimizeFollows) {
        report.unreached = findUnreached(mesh, options, execution);
    }
    return report;
}

} // namespace tessera
