// SPDX-License-Identifier: MIT
#pragma once

#include "occt/cad_input.h"

#include <TopoDS_Shape.hxx>

#include <span>

namespace tessera
{

/// The curves of a shape: the wires of each face (one operand a face, its outer wire
/// counter-clockwise), edges without a face (one operand), vertices without an edge (embedded).
/// Edges that share a vertex share a point; an edge that a face runs through twice (a slit) and
/// edges inside a face are constraints; degenerated edges are skipped. Straight edges have no
/// geometry, circles and ellipses an EllipseArc, all others an OcctCurve; where a curve has corners
/// it becomes several curves of the same source. Takes time linear in the number of edges. Throws
/// CadError(InvalidInput) if the shape is empty, not finite, or not in one plane: then with the
/// edges and the distance.
CadInput networkFromShape(const TopoDS_Shape& shape, const CadOptions& options = {});

/// The plane that networkFromShape() would choose for all shapes together; does not check that they
/// lie in it. Throws as above.
PlaneFrame planeOfShapes(std::span<const TopoDS_Shape> shapes);

} // namespace tessera
