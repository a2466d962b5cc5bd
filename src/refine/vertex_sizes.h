// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "refine/mesh_editor.h"
#include "refine/narrow_places.h"
#include "refine/refine.h"
#include "sizing/size_field.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace tessera
{

/// The size that triangles at each vertex shall have: the size field, limited by the spacing of the
/// constrained edges and by narrow gaps, growing from there by at most kGrowth per length. On
/// constrained edges sizes grow as fast as the size field does, which they were sampled by, so that
/// their pieces are not split for growth alone.
class VertexSizes
{
public:
    static constexpr double kGrowth = 0.2;        ///< away from constrained edges
    static constexpr double kGrowthOnEdges = 0.5; ///< at most, however fast the size field grows

    VertexSizes(MeshEditor& editor, const SizeField& size, const RefineOptions& options);

    /// Finds the sizes on the triangulation of the boundary and splits constrained edges that are
    /// too long for them or encroached. Precondition: no interior vertex yet.
    void prepare(RefineReport& report, Execution& execution);

    double operator[](std::uint32_t vertex) const { return h_[vertex]; }
    void set(std::uint32_t vertex, double h)
    {
        if (vertex >= h_.size()) {
            h_.resize(vertex + 1, 0.0);
        }
        h_[vertex] = h;
    }
    /// Gives all further vertices up to end the size h.
    void append(std::uint32_t end, double h)
    {
        h_.reserve(end + end / 8);
        h_.resize(end, h);
    }
    void requireFew(std::size_t triangles) const
    {
        requireFewTriangles(static_cast<double>(triangles), options_);
    }
    /// The constant value of fieldAt() if the size field is uniform, else 0.
    double uniformSize() const { return std::min(size_.uniformSize(), areaSize_); }
    /// The size field itself, limited by the area limit of the whole mesh.
    double fieldAt(Vec2 p) const
    {
        const double h = size_.size(p);
        return h < areaSize_ ? h : areaSize_;
    }

private:
    void makeShells(RefineReport& report);
    double shellRadius(std::uint32_t v, const std::vector<std::uint32_t>& ends,
                       double equal) const;
    bool isShellEdge(std::uint32_t a, std::uint32_t b) const;
    bool isWorthSplitting(HalfEdge h) const;
    bool isBesideKept(HalfEdge h) const;
    void measureSpacing();
    bool isInHopelessGap(std::uint32_t triangle) const;
    void measureGaps();
    void measure();
    bool followNarrowPlaces(RefineReport& report);
    void leaveNarrowPlaces(RefineReport& report);
    double leastSize(std::uint32_t v) const;
    void limitGrowth(double growth);
    double leastPieces() const;
    std::size_t splitLongEdges(RefineReport& report);
    void lower(std::uint32_t vertex, double spacing);

    MeshEditor& editor_;
    const Triangulation& t_;
    const SizeField& size_;
    const RefineOptions& options_;
    double hopelessGap_;
    double areaSize_;
    double growthOnEdges_; ///< kGrowth .. kGrowthOnEdges
    std::vector<double> field_; ///< by vertex of the boundary: the size field there
    std::vector<double> h_;     ///< by vertex
    std::vector<double> least_; ///< by vertex of a narrow place that is followed: leastSize()
    NarrowChoice choice_;
    double mostPieces_ = std::numeric_limits<double>::infinity(); ///< else narrow places are left
    std::vector<double> shell_; ///< by vertex: longest arm of a corner below 60 degrees, else <= 0
};

} // namespace tessera
