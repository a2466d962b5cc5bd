# SPDX-License-Identifier: MIT
"""tessera.imprint(): the common refinement of the source and target faces of a sweep."""

import json
import math
import os
from contextlib import contextmanager
from typing import Any, NamedTuple, Tuple

import numpy as np

from tessera import arrays
from tessera.errors import Error, InvalidInputError, InvalidOptionError
from tessera.meshing import _FILLS, _RECOVERIES, Execution, _choice, _not_negative, _positive
from tessera.native import module as native
from tessera.result import name_of
from tessera.sources import _items, _looks_like_cad, _prefixes


class ImprintCell(NamedTuple):
    """A piece of the common refinement."""

    area: float
    sources: Tuple[int, ...]  #: indices into Imprint.sources; usually one
    targets: Tuple[int, ...]  #: indices into Imprint.targets; usually one
    rings: Any  #: [(n, 2) float64] in the common plane: outline counter-clockwise, holes clockwise


class ImprintSide(NamedTuple):
    """A source or a target: one face, sketch, polygon or line of a file."""

    name: str
    item: int  #: which of the given sources (or targets) it belongs to
    face: int  #: number of its face in the item's shape, from 1; 0: it has none
    area: float
    cells: Tuple[int, ...]  #: its history: indices into Imprint.cells


class Mismatch(NamedTuple):
    """A place that does not lie on exactly one source and one target."""

    kind: str  #: "source overlap", "target without source", "gap", ...
    area: float
    width: float  #: diameter of the largest circle in it
    at: Tuple[float, float, float]  #: the circle's center, in the plane of the first source
    sources: Tuple[int, ...]  #: that it lies on; of a gap, those beside it
    targets: Tuple[int, ...]


class Imprint:
    """The result of tessera.imprint().

    cells      [ImprintCell]; neighbors share every vertex and every edge
    sources    [ImprintSide], targets [ImprintSide]: each with the cells it consists of
    table      [(cell, source, target)]: which source piece lies on which target; None: on none
    closed     [Mismatch] that were within the tolerance
    left       [Mismatch] that were not
    placement  (4, 4) float64, from the common plane to space
    report     the dictionary that the command line writes as JSON (numbers from 1)
    """

    def __init__(self, data):
        self._data = data
        self.report = report = json.loads(data.report)
        self.placement = np.asarray(data.matrix)
        self.area = report["area"]
        self.cells = [
            ImprintCell(c["area"], _from_zero(c["sources"]), _from_zero(c["targets"]),
                        data.rings(i))
            for i, c in enumerate(report["cells"])
        ]
        origins = data.origins
        first_target = min(item for target, item, _ in origins if target)
        self.sources = _sides(report["sources"], [o for o in origins if not o[0]], 0)
        self.targets = _sides(report["targets"], [o for o in origins if o[0]], first_target)
        self.closed = _mismatches(report["closed"])
        self.left = _mismatches(report["left"])

    @property
    def table(self):
        return [
            (number, source, target)
            for number, cell in enumerate(self.cells)
            for source in cell.sources or (None,)
            for target in cell.targets or (None,)
        ]

    @property
    def messages(self):
        return self.report["messages"]

    @property
    def wkt(self):
        """Well-known text: a line for each cell."""
        return self._data.wkt

    def write(self, path):
        """Writes the imprinted faces as .brep or .step, or the cells as .wkt, .poly or in any format
        of tessera.Mesh.write()."""
        self._data.write(name_of(path))

    def to_shape(self):
        """A Part.Compound of two: of the sources and of the targets; in each a compound of faces for
        each of them, on its own plane, bounded by the original curves trimmed. Needs FreeCAD."""
        return shape_from(self._data.brep())

    def source_faces(self):
        """[[Part.Face, ...]] by source, in the order of its cells."""
        return self._faces(0)

    def target_faces(self):
        """[[Part.Face, ...]] by target, in the order of its cells."""
        return self._faces(1)

    def _faces(self, side):
        return [own.Faces for own in self.to_shape().SubShapes[side].SubShapes]


def shape_from(brep):
    """A Part shape from the text of a .brep file."""
    try:
        import Part
    except ModuleNotFoundError as error:
        raise Error(
            "Faces can only be made where FreeCAD runs; start the script with freecadcmd, or write "
            "the result to a file."
        ) from error

    shape = Part.Shape()
    shape.importBrepFromString(brep)
    return shape


def _from_zero(numbers):
    return tuple(number - 1 for number in numbers)


def _sides(entries, origins, first_item):
    return [
        ImprintSide(
            entry["name"], item - first_item, face, entry["area"], _from_zero(entry["cells"])
        )
        for entry, (_, item, face) in zip(entries, origins)
    ]


def _mismatches(entries):
    return [
        Mismatch(e["kind"], e["area"], e["width"], tuple(e["at"]), _from_zero(e["sources"]),
                 _from_zero(e["targets"]))
        for e in entries
    ]


class PreparedImprint:
    """The compiled input of an imprint: no longer looks at the document."""

    def __init__(self, data, items):
        self.data = data
        self.items = items  #: what was given, sources first

    def run(self, options, execution, progress):
        with _named_faces(self.items):
            return Imprint(native.imprint(self.data, options, execution, progress))


@contextmanager
def _named_faces(items):
    """Errors of the compiled module count the faces of an item; a link calls them as its object
    does."""
    try:
        yield
    except Error as error:
        error.places = [_named(place, items) for place in error.places]
        raise


def _named(place, items):
    item = items[place.source] if place.source is not None else None
    if isinstance(item, tuple) and len(item) == 2 and hasattr(item[0], "Shape") and place.element:
        faces = [item[1]] if isinstance(item[1], str) else [name for name in item[1] if name]
        if faces:
            return place._replace(element=faces[int(place.element[len("Face"):]) - 1])
    return place


def prepare_imprint(sources, targets, direction=None):
    """Reads and projects sources and targets. Raises tessera.Error; source of its places counts the
    given items, sources first."""
    given = _side_items(sources, "source"), _side_items(targets, "target")
    items = given[0] + given[1]
    sides = [native.ImprintSide.source] * len(given[0]) + [native.ImprintSide.target] * len(given[1])
    data = native.ImprintInput()
    flat = [_is_flat(item) for item in items]
    if any(flat) and not all(flat):
        raise InvalidInputError("Sources and targets must be all shapes, or all arrays and polygons.")
    if any(_looks_like_cad(item) for item in items):
        _add_cad(data, items, sides)
    else:
        for number, (item, side) in enumerate(zip(items, sides)):
            _add_plain(data, item, side, number)
    along = _direction(direction)
    with _named_faces(items):
        data.project(along)
    return PreparedImprint(data, items)


def _is_file(item):
    return isinstance(item, (str, os.PathLike))


def _is_flat(item):
    if _is_file(item):
        return os.fspath(item).lower().endswith((".wkt", ".poly"))
    return not _looks_like_cad(item)


def _side_items(given, side):
    if given is None or (hasattr(given, "__len__") and len(given) == 0):
        raise InvalidInputError(f"There is no {side}; give at least one.")
    if _is_file(given):
        return [given]
    if isinstance(given, (list, tuple)) and any(_is_file(item) for item in given):
        return list(given)
    return _items(given)


def _direction(direction):
    if direction is None:
        return None
    try:
        x, y, z = (float(value) for value in direction)
    except (TypeError, ValueError) as error:
        raise InvalidOptionError(
            f"direction must be three numbers, not {direction!r}."
        ) from error
    if not all(map(math.isfinite, (x, y, z))):
        raise InvalidOptionError(f"direction must be three finite numbers, not {direction!r}.")
    return (x, y, z)


def _add_plain(data, item, side, number):
    if _is_file(item):
        data.add_file(os.fspath(item), side)
        return
    network = native.NetworkInput()
    if arrays.is_points_and_segments(item):
        points = arrays.points_array(item[0], "points")
        segments = arrays.index_array(item[1], 2, "segments")
        markers = arrays.index_array(item[2] if len(item) == 3 else (), 0, "markers")
        network.add_segments(points, segments, markers, f"Segments{number + 1}", [])
    else:
        network.add_polygon(arrays.rings_of(item), f"Polygon{number + 1}", native.Role.boundary)
    data.add_network(network, side)


def _add_cad(data, items, sides):
    from tessera import shapes

    made = [None if _is_file(item) else shapes.make_source(item, False) for item in items]
    prefixes = iter(_prefixes([source for source in made if source is not None]))
    for source, item, side in zip(made, items, sides):
        if source is None:
            data.add_file(os.fspath(item), side)
        else:
            data.add_shape(source.native(next(prefixes), shapes.to_space(source)), side)


def imprint(
    sources,
    targets,
    *,
    direction=None,
    tolerance=None,
    fill="even-odd",
    chord_error=None,
    recovery="cavity",
    time_limit=None,
    progress=None,
    execution=None,
):
    """The common refinement of the source and target faces of a sweep; returns a tessera.Imprint.

    sources      a source or a list of them: sketches, planar shapes, (object, ["Face1", ...]), names
                 of .brep and .step files, on one or several parallel planes; or arrays as
                 tessera.mesh() takes them and names of .wkt and .poly files, in one plane. Each face
                 is a source of its own.
    targets      likewise.
    direction    (x, y, z) along which all are projected; None: the normal of the faces.
    tolerance    overlaps and gaps up to this width are closed, >= 0; None: 0 for arrays, the CAD
                 tolerance for shapes.
    fill         what is inside a source or target: "even-odd", "nonzero", "positive", "negative",
                 "all".
    chord_error  greatest distance of the rings from curves, > 0; None: 1e-5 of the diagonal, finer
                 for a small tolerance. Faces and areas are those of the true curves.
    recovery, time_limit, progress, execution: as for tessera.mesh().

    Raises a subclass of tessera.Error; source of its places counts sources, then targets.
    """
    options = native.ImprintOptions()
    options.tolerance = -1.0 if tolerance is None else _not_negative("tolerance", tolerance)
    options.fill = _choice("fill", fill, {k: v for k, v in _FILLS.items() if k != "hull"})
    options.chord_error = _positive("chord_error", chord_error)
    options.recovery = _choice("recovery", recovery, _RECOVERIES)
    if progress is not None and not callable(progress):
        raise InvalidOptionError("progress must be a function of (fraction, stage).")
    handle = Execution() if execution is None else execution
    if time_limit is not None:
        handle.set_time_limit(_positive("time_limit", time_limit))
    if isinstance(sources, PreparedImprint):
        prepared = sources
    else:
        prepared = prepare_imprint(sources, targets, direction)
    return prepared.run(options, handle, progress)
