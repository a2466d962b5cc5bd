# SPDX-License-Identifier: MIT
"""Faces that the tests imprint on each other: three strips of a plate as sources; as targets a disk
in the middle of the same plate, higher up, and three pieces around it."""

import Part
from FreeCAD import Vector

#: Pairs of a source and a target that lie on each other, each pair in one piece.
CELLS = 10
HEIGHT = 10.0


def _polygon(z, *corners):
    points = [Vector(x, y, z) for x, y in corners]
    return Part.Face(Part.makePolygon([*points, points[0]]))


def _objects(document, name, faces):
    made = []
    for number, face in enumerate(faces):
        obj = document.addObject("Part::Feature", f"{name}{number + 1}")
        obj.Shape = face
        made.append(obj)
    document.recompute()
    return made


def sources(document):
    return _objects(
        document,
        "Source",
        [
            _polygon(0, (0, 0), (3, 0), (5, 8), (0, 8)),
            _polygon(0, (3, 0), (9, 0), (7, 8), (5, 8)),
            _polygon(0, (9, 0), (12, 0), (12, 8), (7, 8)),
        ],
    )


def targets(document):
    disk = Part.Face(Part.Wire(Part.makeCircle(2.5, Vector(6, 4, HEIGHT))))
    around = [
        _polygon(HEIGHT, (0, 0), (12, 0), (12, 4), (0, 4)),
        _polygon(HEIGHT, (0, 4), (6, 4), (6, 8), (0, 8)),
        _polygon(HEIGHT, (6, 4), (12, 4), (12, 8), (6, 8)),
    ]
    return _objects(document, "Target", [disk] + [face.cut(disk).Faces[0] for face in around])
