# SPDX-License-Identifier: MIT
"""Sketches, document objects and shapes of FreeCAD as text for the compiled module. Imported only
when such a source is given."""

import math

import FreeCAD
import numpy as np
import Part

from tessera.errors import InvalidInputError, Place
from tessera.native import module as native

# Before 1.0, FreeCAD marks every new point of a sketch as construction geometry.
_POINTS_CAN_BE_CONSTRUCTION = int(FreeCAD.Version()[0]) >= 1


def is_sketch(item):
    return hasattr(item, "getConstruction") and hasattr(item, "Geometry")


def is_document_object(item):
    return hasattr(item, "Shape") and hasattr(item, "Label")


def is_shape(item):
    return hasattr(item, "exportBrepToString")


def is_link(item):
    """(object, sub-element names), as a link property gives it."""
    if not isinstance(item, tuple) or len(item) != 2 or not hasattr(item[0], "Shape"):
        return False
    subs = [item[1]] if isinstance(item[1], str) else item[1]
    return isinstance(subs, (list, tuple)) and all(isinstance(sub, str) for sub in subs)


def is_cad(item):
    return is_sketch(item) or is_document_object(item) or is_shape(item) or is_link(item)


class CadSource:
    """One operand from FreeCAD: a shape, and what its edges are called.

    numbers maps "Edge7" or "Geometry3" to the edge's number in the shape, from 1.
    """

    def __init__(self, owner, label, shape, placement=None):
        self.owner = owner
        self.label = label
        self.shape = shape
        self.placement = placement  # of a sketch, whose shape is in its own frame
        self.elements = []
        self.vertex_elements = []
        self.roles = {}  # by edge number, where the user has set one

    @property
    def numbers(self):
        return {element: i + 1 for i, element in enumerate(self.elements) if element}

    @property
    def number_kind(self):
        """What a bare number means."""
        return "Geometry" if self.placement is not None else "Edge"

    def edge_number(self, element):
        """Number of "Geometry3" or "Edge7", or None; an edge of a sketch's Shape is looked up."""
        number = self.numbers.get(element)
        if number is None and is_sketch(self.owner) and element.startswith("Edge"):
            geometry = geometry_of_edge(self.owner, element)
            number = None if geometry is None else self.numbers.get(f"Geometry{geometry}")
        return number

    def native(self, prefix, transform):
        """What the compiled module takes; transform maps to the common frame, None: as it is."""
        shape = self.shape
        if transform is not None:
            shape = shape.copy()
            shape.Placement = transform.multiply(shape.Placement)
        result = native.Shape()
        result.brep = shape.exportBrepToString()
        result.name = prefix
        result.elements = self.elements
        join = (prefix + "_") if prefix else ""
        result.edge_names = [element and join + element for element in self.elements]
        result.vertex_names = [
            element and join + element for element in self.vertex_elements
        ]
        result.roles = list(self.roles.items())
        return result


def make_source(item, construction):
    """A CadSource from a sketch, an object, a link or a shape."""
    if is_link(item):
        owner, subs = item
        subs = [sub for sub in ([subs] if isinstance(subs, str) else subs) if sub]
        return _from_link(owner, subs) if subs else make_source(owner, construction)
    if is_sketch(item):
        return _from_sketch(item, construction)
    if is_document_object(item):
        return _from_shape(item, item.Label, item.Shape)
    return _from_shape(item, "", item)


def to_space(source):
    """The placement that brings a source's shape from where it is given to where the user sees it,
    the bodies and parts that contain it included; None: it is there."""
    own = source.placement or FreeCAD.Placement()
    placement = container_placement(source.owner).multiply(own)
    return None if placement.isIdentity() else placement


def container_placement(owner):
    """Where the body or part lies that contains an object; a shape has none."""
    if not hasattr(owner, "getGlobalPlacement"):
        return FreeCAD.Placement()
    return owner.getGlobalPlacement().multiply(owner.Placement.inverse())


def same_place(a, b):
    """Equal but for what a file's decimals change."""
    return all(
        math.isclose(x, y, rel_tol=1e-12, abs_tol=1e-9)
        for x, y in zip(a.toMatrix().A, b.toMatrix().A)
    )


def between_containers(owner, home):
    """The placement that brings what an object's container holds into another container, whose own
    placement is home; None: it is the same one."""
    container = container_placement(owner)
    return None if same_place(container, home) else home.inverse().multiply(container)


def _from_shape(owner, label, shape):
    if shape.isNull():
        name = label or "The shape"
        raise InvalidInputError(f"{name} is empty; choose a sketch or a planar face.")
    source = CadSource(owner, label, shape)
    source.elements = [f"Edge{i + 1}" for i in range(len(shape.Edges))]
    return source


def _from_link(owner, subs):
    shapes = []
    for sub in subs:
        try:
            shapes.append(owner.Shape.getElement(sub))
        except Exception as error:
            raise InvalidInputError(
                f"{owner.Label} has no {sub} any more; choose the element again."
            ) from error
    # Not makeCompound(), which ends the process on Debian 13.
    source = CadSource(owner, owner.Label, Part.Compound(shapes))
    numbers = {}
    for i, edge in enumerate(owner.Shape.Edges):
        numbers.setdefault(edge.hashCode(), []).append((edge, i + 1))
    for edge in source.shape.Edges:
        known = numbers.get(edge.hashCode(), ())
        number = next((n for other, n in known if other.isSame(edge)), None)
        source.elements.append(f"Edge{number}" if number else "")
    return source


def _from_sketch(sketch, construction):
    shapes = []
    edges = []
    vertices = []
    roles = {}
    for index, geometry, is_construction in sketch_geometry(sketch):
        if is_construction and not construction:
            continue
        try:
            shape = geometry.toShape()
        except Exception as error:
            point = _a_point_of(geometry)
            place = Place(
                (point.x, point.y), tuple(sketch.Placement.multVec(point)), None, f"Geometry{index}"
            )
            raise InvalidInputError(
                f"{sketch.Label}: Geometry{index} has no shape ({error}); redraw or delete it.",
                [place],
            ) from error
        shapes.append(shape)
        if shape.ShapeType == "Vertex":
            vertices.append(f"Geometry{index}")
            continue
        edges.append(f"Geometry{index}")
        if is_construction:
            roles[len(edges)] = native.Role.constraint
    if not shapes:
        raise InvalidInputError(f"{sketch.Label} has no geometry; draw a closed outline.")
    source = CadSource(sketch, sketch.Label, Part.Compound(shapes), sketch.Placement)
    source.elements = edges
    source.roles = roles
    # Vertices of edges have numbers too; those of points are the ones on no edge.
    source.vertex_elements = [""] * len(source.shape.Vertexes)
    alone = [i for i, shape in enumerate(shapes) if shape.ShapeType == "Vertex"]
    by_hash = {}
    for number, vertex in enumerate(source.shape.Vertexes):
        by_hash.setdefault(vertex.hashCode(), []).append((vertex, number))
    for element, i in zip(vertices, alone):
        for vertex, number in by_hash.get(shapes[i].hashCode(), ()):
            if vertex.isSame(shapes[i]):
                source.vertex_elements[number] = element
    return source


def sketch_geometry(sketch):
    """(index, geometry, is construction) of what the user drew: helpers that show the poles or axes
    of a curve are left out."""
    facades = getattr(sketch, "GeometryFacadeList", None) or []
    for index, geometry in enumerate(sketch.Geometry):
        internal = facades[index].InternalType if index < len(facades) else "None"
        if internal == "None":
            marked = _POINTS_CAN_BE_CONSTRUCTION or not isinstance(geometry, Part.Point)
            yield index, geometry, marked and bool(sketch.getConstruction(index))


def _a_point_of(geometry):
    for name in ("StartPoint", "Center", "Location"):
        point = getattr(geometry, name, None)
        if point is not None:
            return point
    return FreeCAD.Vector()


def _signature(edge):
    """Middle and length of an edge: enough to tell the edges of one sketch apart."""
    middle = edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter))
    return np.array([middle.x, middle.y, middle.z, edge.Length])


def _nearest(signature, candidates, tolerance):
    """Index of the candidate within the tolerance, or None."""
    if not candidates:
        return None
    distance = np.abs(np.array(candidates) - signature).max(axis=1)
    best = int(distance.argmin())
    return best if distance[best] <= tolerance else None


def _tolerance(sketch):
    return 1e-7 * (1.0 + sketch.Shape.BoundBox.DiagonalLength)


def _sketch_signatures(sketch):
    indices = []
    signatures = []
    for index, geometry, is_construction in sketch_geometry(sketch):
        if is_construction:
            continue
        shape = geometry.toShape()
        if shape.ShapeType == "Edge":
            shape.Placement = sketch.Placement.multiply(shape.Placement)
            indices.append(index)
            signatures.append(_signature(shape))
    return indices, signatures


def geometry_of_edge(sketch, name):
    """Index in Geometry of the edge "Edge3" of the sketch's Shape, or None."""
    edges = sketch.Shape.Edges
    number = int(name[len("Edge"):]) if name[len("Edge"):].isdigit() else 0
    if not 1 <= number <= len(edges):
        return None
    indices, signatures = _sketch_signatures(sketch)
    found = _nearest(_signature(edges[number - 1]), signatures, _tolerance(sketch))
    return None if found is None else indices[found]


def edge_of_geometry(sketch, index):
    """Name, as "Edge3", of the edge of the sketch's Shape that shows Geometry[index], or None (for
    construction geometry, or before a recompute): what a selection in the 3D view needs."""
    indices, signatures = _sketch_signatures(sketch)
    if index not in indices:
        return None
    edges = [_signature(edge) for edge in sketch.Shape.Edges]
    found = _nearest(signatures[indices.index(index)], edges, _tolerance(sketch))
    return None if found is None else f"Edge{found + 1}"
