// SPDX-License-Identifier: MIT
#pragma once

// From points and segments to the finished constrained triangulation, by Tessera and by CGAL:
// Constrained_Delaunay_triangulation_2, with inexact crossings (EPICK, Exact_predicates_tag) and
// with exact ones (EPECK, Exact_intersections_tag).

#include "../tests/cpp/recover/generators.h"
#include "section.h"

#include "base/execution.h"
#include "delaunay/delaunay.h"
#include "recover/recover.h"

#ifdef TESSERA_HAS_CGAL
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <cstddef>
#include <utility>
#include <vector>

namespace tessera::bench
{

/// Adds the vertices to those of the result.
inline void runTessera(Result& result, const test::RawPslg& raw, RecoveryStrategy strategy)
{
    Execution execution;
    DelaunayResult delaunay = triangulate(raw.points, execution);
    std::vector<ConstraintEnds> ends(raw.segments.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        ends[i] = {delaunay.vertexOfPoint[raw.segments[i].first],
                   delaunay.vertexOfPoint[raw.segments[i].second]};
    }
    const RecoveryResult recovery
        = recoverBoundaries(std::move(delaunay.triangulation), ends, strategy, execution);
    result.vertices += recovery.triangulation.vertexCount();
}

#ifdef TESSERA_HAS_CGAL
/// The same; the input is converted before.
template<class Kernel, class Tag>
Section::Run cgalRun(const test::RawPslg& raw)
{
    std::vector<typename Kernel::Point_2> points;
    for (const Vec2 p : raw.points) {
        points.emplace_back(p.x, p.y);
    }
    const std::vector<std::pair<std::size_t, std::size_t>> segments(raw.segments.begin(),
                                                                    raw.segments.end());
    return [points, segments](Result& result) {
        CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, Tag> mesh;
        mesh.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
        result.vertices += mesh.number_of_vertices();
    };
}

inline Section::Run cgalInexact(const test::RawPslg& raw)
{
    return cgalRun<CGAL::Exact_predicates_inexact_constructions_kernel,
                   CGAL::Exact_predicates_tag>(raw);
}

inline Section::Run cgalExact(const test::RawPslg& raw)
{
    return cgalRun<CGAL::Exact_predicates_exact_constructions_kernel,
                   CGAL::Exact_intersections_tag>(raw);
}
#endif

} // namespace tessera::bench
