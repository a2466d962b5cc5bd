// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"
#include "curve/curve_network.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// What an edge of a graph does for closing loops.
enum class EdgeClass : std::uint8_t
{
    Loop,     ///< both ends at one vertex
    Repeated, ///< joins the same vertices as an earlier edge; only with duplicatesOnce
    Dangling, ///< in a tree that hangs off the rest, or in a component that is a tree
    Bridge,   ///< on no cycle, but joins parts that have cycles; only with cutBridges
    Even,     ///< in a component in which every degree is even: closed chains
    Odd,      ///< in a component with cycles and a vertex of odd degree
};

/// An edge between two vertices, by number.
struct GraphEdge
{
    std::uint32_t a;
    std::uint32_t b;
};

/// How classifyEdges() treats repeated edges and bridges.
struct EdgeClassOptions
{
    bool duplicatesOnce = false; ///< repeated edges count once; the later ones are Repeated
    bool cutBridges = false;     ///< bridges are cut before components and degrees are looked at
};

struct EdgeClasses
{
    std::vector<EdgeClass> classOf; ///< by edge
    /// By edge: a number that the Even or Odd edges of one component share; else meaningless.
    std::vector<std::uint32_t> component;
};

/// Peels dangling trees off (and cuts bridges, if asked), then looks at the degrees of what remains
/// of each component. Vertex numbers are below vertexCount. O(edges log edges + vertices).
EdgeClasses classifyEdges(std::span<const GraphEdge> edges, std::size_t vertexCount,
                          EdgeClassOptions options);

/// The roles of one .poly: by point index, duplicate segments once, dangling trees are constraints;
/// of each remaining component all segments are boundary if every degree is even, otherwise they
/// get Role::Outline. Repeated and zero-length segments become constraints. Segments with one of
/// the settled markers keep the role they have, and the others are looked at without them.
void assignPolyRoles(CurveNetwork& network, OperandId operand,
                     std::span<const std::int32_t> settledMarkers = {});

/// The same, with the curves c that keep their role given by settled[c].
void assignPolyRolesExcept(CurveNetwork& network, OperandId operand,
                           std::span<const std::uint8_t> settled);

/// Decides the roles anew that these two have given (NetworkCurve::roleByConnection), after points
/// have been joined.
void renewPolyRoles(CurveNetwork& network);

/// Settles every Role::Chain: a curve on a closed chain becomes Boundary (Outline where chains
/// branch so that degrees are odd), one on no closed chain a Constraint. By point index, so weld
/// end points first.
void settleChainRoles(CurveNetwork& network);

} // namespace tessera
