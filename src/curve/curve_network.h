// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"
#include "base/vec2.h"
#include "curve/curve.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tessera
{

/// What a curve does (paper, section 3: boundary or constrained).
enum class Role : std::uint8_t
{
    Boundary,   ///< separates inside from outside
    Constraint, ///< kept in the mesh, separates nothing
    Outline,    ///< of its component (NetworkCurve::component) only the outer outline is boundary,
                ///< the rest constraint
    Chain,      ///< boundary if it lies on a closed chain of such curves of its operand, otherwise
                ///< constraint; arrange() decides, once end points are welded
    Ignored,    ///< not meshed
};

/// How the boundary loops of one operand make its inside.
enum class FillRule : std::uint8_t
{
    EvenOdd,  ///< crossed an odd number of times on the way in (the paper's rules 1 and 2)
    NonZero,  ///< winding number not 0
    Positive, ///< winding number > 0 (counter-clockwise loops)
    Negative, ///< winding number < 0
    All,      ///< every bounded face of all curves, whatever their role; hole points ignored
    Hull,     ///< the whole convex hull
};

/// One curve of the input between two points of the network.
struct NetworkCurve
{
    /// Null: the straight line between the end points.
    std::shared_ptr<const Curve> geometry;
    PointId start; ///< position of geometry->point(first()), up to the weld tolerance
    PointId end;
    OperandId operand;
    Role role = Role::Boundary;
    std::int32_t marker = 0; ///< .poly boundary marker, 0 none
    std::uint32_t source = 0; ///< edge, geometry or segment number in the input; names groups
    /// Role::Outline only: curves of one operand with the same number that also hang together in
    /// the plane share an outline.
    std::uint32_t component = 0;
    /// The role follows from how the segments of a .poly connect: arrange() decides it anew when it
    /// has welded end points.
    bool roleByConnection = false;
};

/// Others are left out of everything; arrange() takes their points away.
inline bool isMeshed(const NetworkCurve& curve)
{
    return curve.role != Role::Ignored;
}

/// A point that removes the face around it (.poly holes) from its operand.
struct HolePoint
{
    Vec2 position;
    OperandId operand;
};

/// A point that gives the face around it an attribute and a largest triangle area (.poly regions).
struct RegionPoint
{
    Vec2 position;
    OperandId operand;
    double attribute = 0.0;
    double maxArea = 0.0; ///< 0: none
};

struct Operand
{
    std::string name; ///< sketch label, file name with line, ...
    /// The input says which loops are holes (inner wires of a face, inner rings of a POLYGON), so
    /// that the user need not be told that loops inside others became holes.
    bool declaresHoles = false;
};

/// A point that becomes a node whatever the curves do.
struct EmbeddedPoint
{
    PointId point;
    OperandId operand;
    std::string name; ///< of its node group; empty: none
};

/// The input: planar curves with shared end points, which may cross, overlap and touch. Everything
/// lies in the x-y plane of the sketch or face.
struct CurveNetwork
{
    std::vector<Vec2> points;
    std::vector<NetworkCurve> curves;
    std::vector<Operand> operands;
    std::vector<EmbeddedPoint> embedded;
    std::vector<HolePoint> holes;
    std::vector<RegionPoint> regions;
    /// Name of each curve's edge group by source number of its operand; may be empty.
    std::vector<std::string> curveNames; ///< by CurveId; empty or missing: none
    /// Points from here on were made by arrange(), where curves cross or touch; none of an input.
    std::size_t firstCrossing = std::numeric_limits<std::size_t>::max();

    PointId addPoint(Vec2 p)
    {
        points.push_back(p);
        return PointId(points.size() - 1);
    }
};

} // namespace tessera
