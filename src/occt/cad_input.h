// SPDX-License-Identifier: MIT
#pragma once

#include "base/error.h"
#include "curve/curve_network.h"
#include "occt/plane_frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tessera
{

/// What edges that belong to no face become.
enum class LooseEdges : std::uint8_t
{
    ByChain,    ///< closed chains boundary, open chains constraint
    Boundary,   ///< all boundary
    Constraint, ///< all constraint
    Ignored,    ///< none; only faces are meshed
};

/// How a shape becomes a CurveNetwork.
struct CadOptions
{
    /// The plane to work in; none: the shape's own (the global x-y axes if it is parallel to them).
    std::optional<PlaneFrame> plane {};
    LooseEdges looseEdges = LooseEdges::ByChain;
    /// Operands are called name, or name_Face3 if there are several; empty: "Face3", "Edges".
    std::string name {};
    /// Names of the edge groups by edge number - 1; missing or empty: "Edge7", or "name_Edge7".
    std::vector<std::string> edgeNames {};
    /// Names of the node groups of loose vertices by vertex number - 1; missing or empty: none.
    std::vector<std::string> vertexNames {};
    /// Edge numbers (from 1) whose role is set by the caller.
    std::vector<std::pair<std::uint32_t, Role>> edgeRoles {};
};

/// The curves of a shape. NetworkCurve::source is the edge number from 1, as FreeCAD counts
/// ("Edge7"); CurveNetwork::curveNames is filled.
struct CadInput
{
    CurveNetwork network;
    PlaneFrame frame;         ///< where the network's plane lies in space
    double defaultWeld = 0.0; ///< max(20 x greatest vertex tolerance, 1e-7 x diagonal)
};

/// What places()[i] of a CadError points at.
struct CadPlace
{
    std::uint32_t edge = 0;               ///< edge number; 0: none
    std::array<double, 3> point {};       ///< in space
};

/// A refused shape. Positions of its places are the x and y of space.
class CadError: public Error
{
public:
    CadError(ErrorKind kind, const std::string& message, std::vector<CadPlace> where = {})
        : Error(kind, message, positionsOf(where))
        , where_(std::move(where))
    {}

    const std::vector<CadPlace>& where() const noexcept { return where_; }
    /// Index of the shape among several.
    std::size_t shape() const noexcept { return shape_; }
    void setShape(std::size_t shape) { shape_ = shape; }
    /// Number of the face of the shape that was read by itself, from 1; 0: the shape as a whole.
    std::uint32_t face() const noexcept { return face_; }
    void setFace(std::uint32_t face) { face_ = face; }

private:
    static std::vector<ErrorPlace> positionsOf(const std::vector<CadPlace>& where)
    {
        std::vector<ErrorPlace> places;
        for (const CadPlace& place : where) {
            places.push_back({{place.point[0], place.point[1]}});
        }
        return places;
    }

    std::vector<CadPlace> where_;
    std::size_t shape_ = 0;
    std::uint32_t face_ = 0;
};

} // namespace tessera
