// SPDX-License-Identifier: MIT
#pragma once

#include "base/execution.h"
#include "curve/curve_network.h"
#include "delaunay/delaunay.h"
#include "pipeline.h"
#include "recover/recover.h"
#include "region/boolean.h"
#include "region/region_outlines.h"
#include "sample/pslg.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tessera
{

/// What is wanted of an overlay: the less, the sooner it is there.
enum class OverlayForm : std::uint8_t
{
    Triangles, ///< and polygons
    Polygons,  ///< runs of segments near which there is nothing else need not be triangulated, and
               ///< the result may have no triangles
    Faces,     ///< on the original curves, with their areas; the polygons only have the topology of
               ///< the curves, so that chordError has no default
};

struct OverlayOptions
{
    BooleanOperation operation = BooleanOperation::Union;
    Priority priority = Priority::None;
    FillRule fill = FillRule::EvenOdd; ///< within each operand; not Hull
    double weld = 0.0;                 ///< end points closer than this are one; >= 0
    RecoveryStrategy recovery = RecoveryStrategy::Cavity;
    /// Greatest distance of the polygons from curved input, in its unit; 0: 1e-5 of the bounding
    /// box's diagonal. Straight input is not sampled.
    double chordError = 0.0;
    OverlayForm form = OverlayForm::Triangles;
};

/// Areas of the paper's Algorithm 2; e is what the initial rectangle has besides the others.
struct ThetaAreas
{
    double o = 0.0;
    double t = 0.0;
    double s = 0.0;
    double e = 0.0;
};

struct OverlayReport
{
    std::size_t inputPoints = 0;
    std::size_t inputSegments = 0; ///< straight curves
    std::size_t inputCurves = 0;
    std::size_t inputOperands = 0;
    RecoveryReport recovery;
    std::optional<ThetaAreas> theta; ///< two operands
    double area = 0.0;
    double weld = 0.0;
    std::size_t welded = 0;
    std::vector<std::string> messages;
    StageSeconds seconds; ///< refine and optimize stay 0
};

/// The regions of a Boolean operation, as triangles and as polygons, with everything they came from.
struct OverlayResult
{
    CurveNetwork input;
    /// Curved input, cut where it meets other curves; none: the input is straight.
    std::optional<CurveNetwork> arranged;
    std::vector<CurveId> parent; ///< by arranged curve: the input curve
    Pslg pslg;                   ///< of network()
    InitialRectangle rectangle {};
    /// Unless OverlayForm::Triangles, perhaps without triangles and vertexMap; then parts says
    /// nothing by triangle either.
    RecoveryResult recovered;
    BooleanParts parts;
    std::vector<VertexOrigin> origin; ///< by vertex: Crossing where curves cross
    Polygons polygons; ///< polygon i is the outline of parts.parts[i]; valid by OGC
    OverlayReport report;

    const CurveNetwork& network() const { return arranged ? *arranged : input; }
    Vec2 point(std::uint32_t vertex) const { return recovered.triangulation.points[vertex]; }
    CurveId inputCurveOf(ConstraintId constraint) const
    {
        const CurveId curve = pslg.segments[constraint.index()].curve;
        return arranged ? parent[curve.index()] : curve;
    }
    /// The input curves on which the edge between two vertices of a polygon lies, ascending.
    std::vector<CurveId> curvesOn(std::uint32_t a, std::uint32_t b) const;
};

/// By vertex, the input curves that run through it.
class CurvesThroughVertices
{
public:
    explicit CurvesThroughVertices(const OverlayResult& result);

    /// Ascending; empty for a vertex on no curve.
    std::span<const CurveId> of(std::uint32_t vertex) const
    {
        return {curves_.data() + start_[vertex], start_[vertex + 1] - start_[vertex]};
    }

private:
    std::vector<std::uint32_t> start_;
    std::vector<CurveId> curves_;
};

/// The paper's Algorithm 2 for any number of operands: arrange, sample, triangulate, recover, color,
/// then the outlines of what the operation keeps. Total: any finite curves, however they cross,
/// overlap or touch. An empty result is no error; a message says why it is empty. Throws Error. stages
/// is told of the rectangle, the points and the recovery, for pictures.
OverlayResult overlayNetwork(CurveNetwork network, const OverlayOptions& options,
                             Execution& execution, StageObserver* stages = nullptr);

} // namespace tessera
