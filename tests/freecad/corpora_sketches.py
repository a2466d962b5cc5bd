# SPDX-License-Identifier: MIT
"""Meshes every sketch and every planar face of FreeCAD files and compares with FreeCAD's areas."""

from dataclasses import dataclass, field

import FreeCAD
import numpy as np
import Part

import tessera
from tessera import shapes


@dataclass
class Row:
    """One file."""

    name: str
    sketches: int = 0
    faces: int = 0
    curves: int = 0
    crossings: int = 0
    touches: int = 0
    welded: int = 0
    compared: int = 0  #: with a known area
    deviation: float = 0.0  #: greatest, of order 2, as a part of the area
    arrange_seconds: float = 0.0
    seconds: float = 0.0
    curved_faces: int = 0
    refused: list = field(default_factory=list)  #: (label, message)
    wrong: list = field(default_factory=list)  #: (label, area, FreeCAD's area, bound)


def files(folder):
    return sorted(path for path in folder.iterdir() if path.suffix.lower() == ".fcstd")


def measure(path):
    document = FreeCAD.openDocument(str(path))
    row = Row(path.stem)
    try:
        for thing in document.Objects:
            if shapes.is_sketch(thing):
                _measure_sketch(thing, row)
            else:
                _measure_faces(thing, row)
    finally:
        FreeCAD.closeDocument(document.Name)
    return row


def _measure_sketch(sketch, row):
    try:
        area = Part.makeFace(sketch.Shape, "Part::FaceMakerBullseye").Area
    except (Part.OCCError, ValueError, RuntimeError):
        area = None  # open, or crossing itself
    row.sketches += _measure(sketch, sketch.Label, area, row)


def _measure_faces(thing, row):
    shape = getattr(thing, "Shape", None)
    if shape is None or shape.isNull():
        return
    for number, face in enumerate(shape.Faces, 1):
        if not face.Surface.isPlanar():
            row.curved_faces += 1
            continue
        link = (thing, [f"Face{number}"])
        row.faces += _measure(link, f"{thing.Label} Face{number}", face.Area, row)


def _measure(source, label, area, row):
    """Returns whether it could be meshed."""
    try:
        mesh = tessera.mesh(source, order=2)
    except tessera.Error as error:
        row.refused.append((label, str(error)))
        return False
    report = mesh.report
    row.curves += report["input"]["curves"]
    row.crossings += report["crossings"]
    row.touches += report["touches"]
    row.welded += report["welded"]
    row.arrange_seconds += report["seconds"]["arrange"] + report["seconds"]["sample"]
    row.seconds += report["seconds"]["total"]
    if area is not None:
        row.compared += 1
        deviation, bound = straight_deviation(mesh, area), chord_bound(mesh)
        # What FreeCAD's own numerical integration and tolerances leave open.
        if deviation > bound + 1e-7 * area:
            row.wrong.append((label, report["area"], area, bound))
        row.deviation = max(row.deviation, abs(report["area"] / area - 1.0))
    return True


def straight_deviation(mesh, area):
    """How far the area of the straight triangles is from the given one."""
    a, b, c = (mesh.nodes[mesh.triangles[:, i]] for i in range(3))
    u, v = b - a, c - a
    return abs(0.5 * np.sum(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) - area)


def chord_bound(mesh):
    """What the chords can cut off or add: 2/3 x chord x height for a parabola over each edge, and a
    little more for other curves."""
    ends = mesh.nodes[mesh.edges]
    chords = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    heights = np.hypot(*(mesh.nodes[mesh.edge_mid_nodes] - ends.mean(axis=1)).T)
    return 1.1 * 2.0 / 3.0 * float(np.sum(chords * heights))


HEADER = """\
| file | sketches meshed | planar faces meshed | curves | crossings | touches | welds | areas compared | greatest \
deviation | arrange + sample, ms | total, ms |
| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |
"""


def table(rows):
    """As Markdown."""
    lines = [
        f"| {row.name} | {row.sketches} | {row.faces} | {row.curves} | {row.crossings} "
        f"| {row.touches} | {row.welded} | {row.compared} "
        f"| {f'{row.deviation:.1e}' if row.compared else ''} "
        f"| {1000 * row.arrange_seconds:.1f} | {1000 * row.seconds:.0f} |\n"
        for row in rows
    ]
    return HEADER + "".join(lines)


def refusals(rows):
    """What could not be meshed, and why; as Markdown."""
    return "".join(
        f"- {row.name}: {label}: {message}\n" for row in rows for label, message in row.refused
    )
