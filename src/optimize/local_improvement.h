// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "optimize/optimize.h"
#include "optimize/star.h"
#include "refine/refine.h"
#include "sizing/size_field.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tessera
{

/// Improves a mesh where it is bad, by moving and merging free vertices.
class LocalImprovement
{
public:
    /// Counts what it does in report.
    LocalImprovement(WorkingMesh& mesh, const SizeField& size, OptimizeReport& report,
                     Execution& execution);

    /// From now on moves and merges that lower the mean quality of the mesh, or raise areas above
    /// their limits, are not made. O(n).
    void keepMeanAndAreas(const RefineOptions& options);
    /// Works on all bad triangles of the mesh.
    void improveAll();
    /// Works on the bad triangles at these vertices only, which are new.
    void improveAround(std::span<const std::uint32_t> vertices);

    /// The kept triangles around all vertices that were worked on so far, each once. Every bad
    /// triangle of the mesh is among them after improveAll().
    std::vector<std::uint32_t> touchedTriangles() const;

private:
    void run();
    void startList();
    void seedAll();
    void seedAgain();
    bool isLarge(const std::vector<std::uint32_t>& list) const;
    bool isBad(std::uint32_t triangle) const;
    void seed(std::uint32_t triangle);
    void seedAround(std::span<const std::uint32_t> vertices);
    void add(std::uint32_t vertex);
    void growList();
    void growLargeList();
    template<class F>
    void forEachListed(F&& f);
    bool isFree(std::uint32_t v) const;
    void smoothLaplace(std::uint32_t v);
    void searchPattern(std::uint32_t v);
    void tryCollapse(std::uint32_t v);
    bool moveIfBetter(Vec2 p, double now);
    bool mayMove(Vec2 p) const;
    bool mayMerge(int target) const;
    bool isAreaAllowed(double twiceArea) const;
    void legalizeStar();
    void legalizeSuspects();
    void unsettleRing();

    WorkingMesh& mesh_;
    Triangulation& t_;
    const SizeField& size_;
    OptimizeReport& report_;
    Execution& execution_;
    double scan_; ///< squared sine below which a triangle is bad
    std::optional<double> meanToKeep_;
    RefineOptions areaOptions_; ///< if there is a mean to keep
    bool changedOnly_ = false; ///< no triangle is bad whose corners are all settled
    Star star_;
    std::vector<std::uint32_t> list_; ///< vertices to work on, each once
    std::vector<std::uint8_t> mark_;  ///< by vertex: bits
    std::vector<std::uint32_t> touched_;
    std::vector<HalfEdge> suspects_;
    std::vector<std::uint32_t> flipped_; ///< corners around flips
};

} // namespace tessera
