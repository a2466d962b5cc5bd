# SPDX-License-Identifier: MIT
"""Sketches that the tests mesh, with the areas that their meshes must have."""

import math

import FreeCAD
import Part
from FreeCAD import Vector

PLATE_WIDTH, PLATE_HEIGHT, PLATE_RADIUS = 100.0, 60.0, 15.0
PLATE_AREA = PLATE_WIDTH * PLATE_HEIGHT - math.pi * PLATE_RADIUS**2


def new_sketch(document, name="Sketch"):
    return document.addObject("Sketcher::SketchObject", name)


def add_polygon(sketch, points, closed=True):
    """Lines between points (x, y)."""
    ends = [Vector(x, y, 0) for x, y in points]
    pairs = list(zip(ends, ends[1:] + (ends[:1] if closed else [])))
    for a, b in pairs:
        sketch.addGeometry(Part.LineSegment(a, b), False)


def add_rectangle(sketch, x, y, width, height):
    add_polygon(sketch, [(x, y), (x + width, y), (x + width, y + height), (x, y + height)])


def plate(document, name="Plate"):
    """A rectangle (Geometry 0 .. 3, from the lower edge counter-clockwise) with a round hole
    (Geometry 4, its radius held by constraint 0)."""
    import Sketcher

    sketch = new_sketch(document, name)
    add_rectangle(sketch, 0.0, 0.0, PLATE_WIDTH, PLATE_HEIGHT)
    center = Vector(PLATE_WIDTH / 2, PLATE_HEIGHT / 2, 0)
    sketch.addGeometry(Part.Circle(center, Vector(0, 0, 1), PLATE_RADIUS), False)
    sketch.addConstraint(Sketcher.Constraint("Radius", 4, PLATE_RADIUS))
    document.recompute()
    return sketch


def slit(document, name="Slit"):
    """A square of side 10 with two lines inside, 0.002 apart."""
    sketch = new_sketch(document, name)
    add_rectangle(sketch, 0.0, 0.0, 10.0, 10.0)
    for y in (5.0, 5.002):
        add_polygon(sketch, [(3.0, y), (7.0, y)], closed=False)
    document.recompute()
    return sketch


def write_sizes(path):
    """A .vtu file over the plate with the sizes 0.8 at its left edge and 8 at its right one, as the
    point data "size", beside others."""
    points = "0 0 0  100 0 0  100 60 0  0 60 0"
    path.write_text(
        '<?xml version="1.0"?><VTKFile type="UnstructuredGrid" version="0.1" '
        'byte_order="LittleEndian"><UnstructuredGrid>'
        '<Piece NumberOfPoints="4" NumberOfCells="2"><PointData>'
        '<DataArray type="Float64" Name="move" NumberOfComponents="3" format="ascii">'
        "0 0 0  0 0 0  0 0 0  0 0 0</DataArray>"
        '<DataArray type="Float64" Name="size" format="ascii">0.8 8 8 0.8</DataArray></PointData>'
        '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">'
        f"{points}</DataArray></Points>"
        '<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 0 2 3</DataArray>'
        '<DataArray type="Int64" Name="offsets" format="ascii">3 6</DataArray>'
        '<DataArray type="UInt8" Name="types" format="ascii">5 5</DataArray></Cells>'
        "</Piece></UnstructuredGrid></VTKFile>",
        encoding="ascii",
    )


def empty(document):
    sketch = new_sketch(document, "Empty")
    document.recompute()
    return sketch


def only_open(document):
    sketch = new_sketch(document, "Open")
    add_polygon(sketch, [(0, 0), (50, 0), (50, 30)], closed=False)
    document.recompute()
    return sketch


def zero_area(document):
    """A loop that runs back over itself."""
    sketch = new_sketch(document, "Flat")
    add_polygon(sketch, [(0, 0), (50, 0), (20, 0)])
    document.recompute()
    return sketch


def fem_area(fem):
    """Sum of the signed areas of a FemMesh's triangles in the plane z = 0, corners only; fails on
    one that is not positive."""
    total = 0.0
    nodes = fem.Nodes
    for face in fem.Faces:
        a, b, c = (nodes[n] for n in fem.getElementNodes(face)[:3])
        area = 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x))
        if not area > 0.0:
            raise AssertionError(f"triangle {face} has the area {area}")
        total += area
    return total


def chord_error(radius, size):
    """Greatest area between a circle and chords of about that size."""
    count = math.floor(2 * math.pi * radius / size)
    return radius**2 * (math.pi - 0.5 * count * math.sin(2 * math.pi / count))


def close_all_documents():
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
