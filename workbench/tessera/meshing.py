# SPDX-License-Identifier: MIT
"""tessera.mesh(): checks the options and runs the mesher."""

import os

from tessera.errors import InvalidOptionError
from tessera.native import module as native
from tessera.result import Mesh
from tessera.sizes import local_sizes, number, positive
from tessera.sources import Prepared, prepare

Execution = native.Execution
VERSION = native.version
#: Default of narrow_gaps.
NARROW_GAPS = native.MeshOptions().narrow_gaps

_FILLS = {
    "even-odd": native.FillRule.even_odd,
    "nonzero": native.FillRule.nonzero,
    "positive": native.FillRule.positive,
    "negative": native.FillRule.negative,
    "all": native.FillRule.all,
    "hull": native.FillRule.hull,
}
_RECOVERIES = {"steiner": native.Recovery.steiner, "cavity": native.Recovery.cavity}


def mesh(
    source,
    size=None,
    *,
    count=None,
    min_size=None,
    growth=0.3,
    curvature=None,
    chord_error=None,
    gap=None,
    size_at=(),
    size_on=(),
    size_in=(),
    size_expr=(),
    size_from=None,
    order=1,
    fill="even-odd",
    min_angle=30.0,
    max_area=None,
    weld=None,
    constraint=(),
    boundary=(),
    ignore=(),
    construction=False,
    recovery="cavity",
    refine=True,
    optimize=True,
    freeze_boundary=False,
    narrow_gaps=NARROW_GAPS,
    threads=None,
    stages=None,
    time_limit=None,
    progress=None,
    execution=None,
):
    """Meshes a sketch, a planar shape or arrays with triangles; returns a tessera.Mesh.

    source        a sketch, a document object with a Shape, (object, ["Face1", ...]), a shape;
                  (points, segments) or (points, segments, markers) with points (n, 2) and segments
                  (m, 2) of indices from 0; a polygon (n, 2), or a list of its outline and holes; or
                  a list of any one kind: each item is one operand, and what any of them covers is
                  meshed; or what tessera.sources.prepare() made of these, for a run on another
                  thread that must not look at the document. Lengths in the source's unit (FreeCAD:
                  mm).
    size          target edge length, > 0; None: diagonal of the bounding box / 40.
    count         number of triangles to aim for, instead of size: finds the size, which the report
                  names.
    min_size      nowhere smaller, > 0; None: no bound.
    growth        greatest change of the edge length per length, 0 < growth <= 1.
    curvature     pieces for a full turn of a curve, 3 .. 10000; None: 20.
    chord_error   greatest distance between a curve and its pieces, > 0; None: no bound.
    gap           elements across narrow gaps between curves, > 0; None: gaps make no difference.
    size_at       [(x, y, size)] at points in the frame of the plane, or [(place, size)] at points in
                  space and vertices: "Vertex3", (object, "Vertex3"). Wherever a size at a place is
                  given, two more forms are taken: (..., size, radius), which holds up to the
                  radius, and (..., size, radius, far_size, far_radius), which then grows linearly.
    size_on       {curve: size} or [(curve or list of curves, size)]; curves as for constraint.
    size_in       {operand: size} or [(operand, size)]: numbers from 0 or names; or the region
                  around a place: [((x, y), size)]; or a face of a shape: "Face2",
                  (object, "Face2").
    size_expr     text in x and y, or a list of texts: "0.1 + 0.05*x".
    size_from     sizes at the nodes of another mesh: "FILE.vtu:ARRAY", (nodes, triangles, sizes) or
                  (tessera.Mesh, sizes); or a list of these.
    order         1, or 2 for triangles with mid nodes on the curves.
    fill          what is inside: "even-odd", "nonzero", "positive", "negative", "all", "hull".
    min_angle     in degrees, 0 .. 33; smaller angles of the input stay.
    max_area      of a triangle, > 0; None: no bound.
    weld          ends of curves closer than this become one; None: 0 for arrays, the CAD tolerance
                  for shapes.
    constraint    curves that are kept in the mesh but bound nothing; boundary: curves that bound;
                  ignore: curves that are left out. The last of these that names a curve counts.
                  Numbers (of Geometry in a sketch, of edges from 1 in a shape, of segments from 0),
                  names ("Edge7", "Geometry3", "Sketch_Geometry3"), and for constraint also further
                  FreeCAD objects, links and shapes.
    construction  True: construction geometry of sketches joins as constraints.
    recovery      "cavity" or "steiner" (the paper's); the mesh is the same.
    refine        False: no interior points, straight curves stay whole.
    optimize      False: points are not moved afterwards.
    freeze_boundary  True: no new nodes on straight curves, on others only what size and curvature
                  ask for.
    narrow_gaps   triangles that may be spent on gaps far narrower than the size, as a multiple of
                  the others, >= 0; 0 leaves them coarse.
    threads       to use, 1 .. 1024; None: as many as there are cores. The mesh is the same.
    stages        folder for a picture of each stage.
    time_limit    seconds.
    progress      called as progress(fraction, stage) a few times a second, at last with 1.0. When it
                  returns False the run ends with a CancelledError; any other answer, None too, goes
                  on. An exception that it raises ends the run and is passed on.
    execution     a tessera.Execution, whose cancel() ends the run from another thread.

    Raises a subclass of tessera.Error.
    """
    options = native.MeshOptions()
    options.size = _positive("size", size)
    if size is not None and count is not None:
        raise InvalidOptionError("size and count exclude each other; give one.")
    options.count = _whole("count", count, 10**9)
    options.min_size = _positive("min_size", min_size)
    options.growth = number("growth", growth)
    options.min_angle = number("min_angle", min_angle)
    options.max_area = _positive("max_area", max_area)
    options.weld = -1.0 if weld is None else _not_negative("weld", weld)
    options.order = _choice("order", order, {1: 1, 2: 2})
    options.fill = _choice("fill", fill, _FILLS)
    options.recovery = _choice("recovery", recovery, _RECOVERIES)
    options.refine = bool(refine)
    options.optimize = bool(optimize)
    options.freeze_boundary = bool(freeze_boundary)
    options.narrow_gaps = _not_negative("narrow_gaps", narrow_gaps)
    if progress is not None and not callable(progress):
        raise InvalidOptionError("progress must be a function of (fraction, stage).")
    run = Execution() if execution is None else execution
    if not isinstance(run, Execution):
        raise InvalidOptionError(
            f"execution must be a tessera.Execution, not a {type(run).__name__}."
        )
    run.set_threads(_whole("threads", threads, 1024))
    if time_limit is not None:
        run.set_time_limit(_positive("time_limit", time_limit))
    if isinstance(source, Prepared):
        prepared = source
    else:
        prepared = prepare(source, bool(construction), constraint, boundary, ignore)
    folder = "" if stages is None else _folder("stages", stages)
    with prepared.placed_errors():
        options.sizes = local_sizes(
            prepared, curvature, chord_error, gap, size_at, size_on, size_in, size_expr, size_from
        )
        data = native.mesh(prepared.network, options, run, progress, folder)
    return Mesh(data, prepared.base)


def _folder(name, value):
    try:
        return os.fspath(value)
    except TypeError as error:
        raise InvalidOptionError(f"{name} must be the name of a folder, not {value!r}.") from error


def _positive(name, value):
    """0.0, which the compiled module takes for "choose", if the value is None."""
    return 0.0 if value is None else positive(name, value)


def _whole(name, value, most):
    """0, which the compiled module takes for "choose", if the value is None."""
    if value is None:
        return 0
    result = positive(name, value)
    if result != int(result) or result > most:
        raise InvalidOptionError(f"{name} must be a whole number up to {most}, not {value!r}.")
    return int(result)


def _not_negative(name, value):
    result = number(name, value)
    if result < 0.0:
        raise InvalidOptionError(f"{name} must not be negative, and is {result:g}.")
    return result


def _choice(name, value, choices):
    try:
        return choices[value]
    except (KeyError, TypeError) as error:
        names = ", ".join(repr(choice) for choice in choices)
        raise InvalidOptionError(f"{name} must be one of {names}, not {value!r}.") from error
