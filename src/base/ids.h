// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace tessera
{

/// A 32-bit index that cannot be mixed up with an index of another kind.
template<class Tag>
struct Id
{
    static constexpr std::uint32_t kNone = 0xffffffffU;

    std::uint32_t value = kNone;

    constexpr Id() = default;
    constexpr explicit Id(std::uint32_t v)
        : value(v)
    {}
    constexpr explicit Id(std::size_t v)
        : value(static_cast<std::uint32_t>(v))
    {}
    constexpr bool valid() const { return value != kNone; }
    constexpr std::size_t index() const { return value; }
    friend constexpr auto operator<=>(Id, Id) = default;
};

using PointId = Id<struct PointTag>;           ///< point of a CurveNetwork or a Pslg
using CurveId = Id<struct CurveTag>;           ///< curve of a CurveNetwork
using OperandId = Id<struct OperandTag>;       ///< input shape: sketch, face, .wkt line, .poly
using ConstraintId = Id<struct ConstraintTag>; ///< segment of a Pslg; kept for ever
using SubsegmentId = Id<struct SubsegmentTag>; ///< mesh edge that lies on constraints
using VertexId = Id<struct VertexTag>;         ///< vertex of a Triangulation
using TriangleId = Id<struct TriangleTag>;     ///< triangle of a Triangulation
using RegionId = Id<struct RegionTag>;         ///< region of a RegionMap

} // namespace tessera

template<class Tag>
struct std::hash<tessera::Id<Tag>>
{
    std::size_t operator()(tessera::Id<Tag> id) const noexcept { return id.value; }
};
