// SPDX-License-Identifier: MIT
//
// Local improvement first, because it mends most bad triangles without adding points. Where angles
// below the wanted one remain, Delaunay refinement inserts points, and their surroundings are
// improved again.
//
// Beside a frozen boundary refine() has inserted what helps, as it does without optimization; here
// only moves and merges follow that raise smallest angles and keep the mean quality, so that
// neither is below what refine() made.

#include "optimize/optimize.h"

#include "optimize/local_improvement.h"
#include "refine/border_records.h"
#include "refine/delaunay_refinement.h"
#include "refine/mesh_editor.h"

#include <numeric>

namespace tessera
{

namespace
{
constexpr int kAttempts = 4;

/// What may not reach the targets: small angles are always tried to improve, large areas need not be.
std::vector<std::uint32_t> suspects(const WorkingMesh& mesh, const RefineOptions& options,
                                    const LocalImprovement& improvement)
{
    if (!hasAreaLimits(options)) {
        return improvement.touchedTriangles();
    }
    std::vector<std::uint32_t> all(mesh.triangulation.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    return all;
}
} // namespace

OptimizeReport optimize(WorkingMesh& mesh, const SizeField& size, const RefineOptions& options,
                        Execution& execution)
{
    OptimizeReport report;
    const BorderRecords border(mesh, execution);
    LocalImprovement improvement(mesh, size, report, execution);
    if (options.freezeBoundary) {
        improvement.keepMeanAndAreas(options);
    }
    improvement.improveAll();
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const std::vector<std::uint32_t> candidates = suspects(mesh, options, improvement);
        report.unreached = findUnreached(mesh, options, candidates, execution);
        if (report.unreached.empty() || attempt + 1 == kAttempts || options.freezeBoundary) {
            break;
        }
        const std::size_t firstNew = mesh.triangulation.points.size();
        MeshEditor editor(mesh);
        RefineReport refined;
        refineDelaunay(editor, size, options, candidates, refined, execution);
        report.interiorPoints += refined.interiorPoints;
        report.segmentSplits += refined.segmentSplits;
        std::vector<std::uint32_t> added(mesh.triangulation.points.size() - firstNew);
        if (added.empty()) {
            break;
        }
        std::iota(added.begin(), added.end(), static_cast<std::uint32_t>(firstNew));
        improvement.improveAround(added);
    }
    return report;
}

OptimizeReport optimize(WorkingMesh& mesh, const SizeField& size, double minAngle,
                        Execution& execution)
{
    RefineOptions options;
    options.minAngle = minAngle;
    return optimize(mesh, size, options, execution);
}

} // namespace tessera
