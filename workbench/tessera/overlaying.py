# SPDX-License-Identifier: MIT
"""tessera.overlay(): Boolean operations on any number of shapes."""

import json

import numpy as np

from tessera.errors import InvalidOptionError
from tessera.imprinting import shape_from
from tessera.meshing import _FILLS, _RECOVERIES, Execution, _choice, _not_negative, _positive
from tessera.native import module as native
from tessera.result import name_of
from tessera.sources import Prepared, prepare

_PRIORITIES = {
    None: native.Priority.none,
    "first": native.Priority.first,
    "last": native.Priority.last,
}


class Polygon:
    """A connected part of a result.

    area      in the source's unit, squared
    operands  indices of the operands that cover it (cells), or of its owner (with a priority);
              otherwise ()
    rings     [(n, 2) float64]: the outline counter-clockwise, then the holes clockwise; a valid
              polygon by the rules of OGC
    """

    def __init__(self, data, index):
        self._data = data
        self._index = index
        self.area, operands, self.rings = data.part(index)
        self.operands = tuple(operands)

    @property
    def edge_curves(self):
        """By ring and edge (from each corner to the next): numbers of the input's curves that the
        edge lies on, counted from 0 through all operands."""
        return self._data.curves(self._index)


class Polygons:
    """The result of one operation: a sequence of Polygon with area, wkt, report and placement (4, 4),
    from the frame of the plane to space."""

    def __init__(self, data, base):
        self._data = data
        self._base = base
        self._items = [Polygon(data, index) for index in range(len(data))]
        self.report = json.loads(data.report)
        self.area = self.report["area"]
        self.placement = base @ np.asarray(data.matrix)

    def __len__(self):
        return len(self._items)

    def __getitem__(self, index):
        return self._items[index]

    def to_shape(self):
        """A Part.Compound with a face for each polygon, in order, bounded by the original curves
        trimmed: an arc stays an arc. Neighbors share edges and vertices. Needs FreeCAD."""
        shape = shape_from(self._data.brep())
        if not np.array_equal(self._base, np.eye(4)):
            import FreeCAD

            matrix = FreeCAD.Matrix(*self._base.ravel().tolist())
            shape.Placement = FreeCAD.Placement(matrix).multiply(shape.Placement)
        return shape

    def to_faces(self):
        """[Part.Face], one for each polygon, in order."""
        return self.to_shape().Faces

    @property
    def wkt(self):
        """Well-known text: one geometry, or a line for each cell or owner."""
        return self._data.wkt

    def write(self, path):
        """Writes .wkt or .poly, faces as .brep or .step in the frame of the first sketch, or the
        triangles in any format of tessera.Mesh.write()."""
        self._data.write(name_of(path))


class Overlay:
    """Operands that are combined as asked: union(), intersection(), difference(),
    symmetric_difference(), cells, theta. Each operation gives Polygons."""

    def __init__(self, run):
        self._run = run
        self._cells = None

    def union(self, priority=None):
        """What any operand covers. With priority "first" or "last" a polygon belongs to the first or
        last operand that covers it: none overlap."""
        return self._run("union", priority)

    def intersection(self):
        """What all operands cover."""
        return self._run("intersection", None)

    def difference(self):
        """What the first operand covers and no other one."""
        return self._run("difference", None)

    def symmetric_difference(self):
        """What an odd number of operands covers."""
        return self._run("xor", None)

    @property
    def cells(self):
        """Every cell of the arrangement that an operand covers, with the operands that do."""
        if self._cells is None:
            self._cells = self._run("cells", None)
        return self._cells

    @property
    def theta(self):
        """Areas {"o", "t", "s", "e"} of the paper's Algorithm 2: in both of two operands, in the
        first only, in the second only, in neither (inside the initial rectangle). None for another
        number of operands."""
        return self.cells.report.get("theta")


def prepare_overlay(sources):
    """Reads the sources, each as one operand, for a run that must not look at the document."""
    prepared = prepare(sources, False, (), ())
    prepared.network.join_operands()
    prepared.base = prepared.container @ prepared.base
    return prepared


def overlay(
    sources,
    *,
    fill="even-odd",
    weld=None,
    chord_error=None,
    recovery="cavity",
    time_limit=None,
    progress=None,
    execution=None,
):
    """Boolean operations on sketches, planar shapes or arrays; returns a tessera.Overlay.

    sources      a list of sources of one kind as tessera.mesh() takes them: each is one operand,
                 whatever number of faces it has, where the user sees it: bodies and parts that
                 contain it count; or what prepare_overlay() made of it.
    fill         what is inside an operand: "even-odd", "nonzero", "positive", "negative", "all".
    weld         ends of curves closer than this become one; None: 0 for arrays, the CAD tolerance
                 for shapes.
    chord_error  greatest distance of the polygons from curves, > 0; None: 1e-5 of the diagonal.
    recovery     "cavity" or "steiner" (the paper's); the result is the same.
    time_limit   seconds for each operation; progress, execution: as for tessera.mesh().

    Raises a subclass of tessera.Error.
    """
    options = native.OverlayOptions()
    options.fill = _choice("fill", fill, {k: v for k, v in _FILLS.items() if k != "hull"})
    options.weld = -1.0 if weld is None else _not_negative("weld", weld)
    options.chord_error = _positive("chord_error", chord_error)
    options.recovery = _choice("recovery", recovery, _RECOVERIES)
    if progress is not None and not callable(progress):
        raise InvalidOptionError("progress must be a function of (fraction, stage).")
    prepared = sources if isinstance(sources, Prepared) else prepare_overlay(sources)

    def run(operation, priority):
        options.operation = native.BooleanOperation.__members__[operation]
        options.priority = _choice("priority", priority, _PRIORITIES)
        handle = Execution() if execution is None else execution
        if time_limit is not None:
            handle.set_time_limit(_positive("time_limit", time_limit))
        with prepared.placed_errors():
            data = native.overlay(prepared.network, options, handle, progress)
        return Polygons(data, prepared.base)

    return Overlay(run)
