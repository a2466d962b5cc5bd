// SPDX-License-Identifier: MIT
#pragma once

#include "io/raw_mesh.h"
#include "mesh/quality.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tessera
{

/// What checkMesh() found. A mesh is valid if there are no problems.
struct MeshCheck
{
    /// A sentence each, with the file's numbers of elements and nodes. At most kMostListed, then
    /// one that counts the rest.
    std::vector<std::string> problems;
    static constexpr std::size_t kMostListed = 1000;
    /// What is allowed but hardly meant: nodes so close beside a side that they seem to hang on it.
    /// At most kMostListed.
    std::vector<std::string> warnings;

    std::size_t nodes = 0;       ///< in the file
    std::size_t unusedNodes = 0; ///< of no element; allowed
    std::size_t edges = 0;       ///< line elements
    std::size_t triangles = 0;
    std::size_t quads = 0;
    int order = 1;       ///< 2 if any element has mid nodes
    double area = 0.0;   ///< of all elements, curved sides included
    double outlineLength = 0.0; ///< of the sides that one element has, by their chords
    QualityReport quality; ///< of the triangles, by their corners
    Mesh corners;          ///< these triangles in the mesh's plane

    bool valid() const { return problems.empty(); }
};

/// Proves that a plane mesh is what a finite-element solver needs:
/// - every element strictly counter-clockwise (quadrangles strictly convex), the Jacobian of 6-node
///   triangles positive, no node twice in an element, no element twice;
/// - conforming: a side belongs to one or two elements, which run through it in opposite directions
///   and have the same mid node; no node lies inside the side of another element (hanging node,
///   also if rounding put it beside); no two nodes at one place;
/// - no overlaps: no two outline sides cross or touch but at common nodes, and every part of the
///   plane is covered at most once;
/// - line elements are sides of elements.
/// The plane must be parallel to two axes. All decisions on straight sides are exact. O(n log n).
MeshCheck checkMesh(const RawMesh& mesh);

} // namespace tessera
