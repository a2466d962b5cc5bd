// SPDX-License-Identifier: MIT
#pragma once

#include "base/ids.h"
#include "curve/curve_network.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tessera
{

/// What an edge of a graph is for closing loops.
enum class EdgeClass : std::uint8_t
{
    Loop,      ///< zero length or repeats an earlier edge (only when duplicates count once)
    Dangling,  ///< in a tree that hangs off the rest, or a component that is a tree
    Bridge,    ///< joins two parts that hold cycles, is on no cycle itself
    Even,      ///< in a component in which every vertex has even degree: closed chains
    Odd,       ///< in a component with cycles and a vertex of odd degree
};

struct GraphEdge
{
    std::uint32_t a;
    std::uint32_t b;
};

/// How classifyEdges() treats repeated edges and bridges.
struct EdgeClassOptions
{
    bool duplicatesOnce = false; ///< later edges between the same vertices are Loop, not counted
    bool cutBridges = false;     ///< bridges are left out before degrees and components are looked at
};

struct EdgeClasses
{
    std::vector<EdgeClass> classOf;         ///< by edge
    std::vector<std::uint32_t> component;   ///< by edge; of Even and Odd edges, else meaningless
};

/// Peels dangling trees off (and bridges, if asked), then looks at the degrees of each remaining
/// component. Vertices are any numbers below vertexCount. O(edges + vertices).
EdgeClasses classifyEdges(std::span<const GraphEdge> edges, std::size_t vertexCount,
                          EdgeClassOptions options);

/// The roles of one .poly: by point index, duplicate segments once, dangling trees are constraints;
/// of each remaining component all segments are boundary if every degree is even, otherwise they
/// get Role::Outline. Repeated and zero-length segments become constraints.
void assignPolyRoles(CurveNetwork& network, OperandId operand);

/// Settles every Role::Chain: a curve on a closed chain becomes Boundary (or Outline where chains
/// branch with odd degree), one on no closed chain a Constraint. By point index, so weld first.
void settleChainRoles(CurveNetwork& network);

} // namespace tessera
