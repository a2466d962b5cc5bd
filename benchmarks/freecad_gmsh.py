# SPDX-License-Identifier: MIT
"""From a sketch to the FemMesh in the document: Tessera beside FreeCAD's own Gmsh tool.

Run by tools/bench-freecad inside FreeCAD, without its window. TESSERA_TRIANGLES (default 1000000) sets
the size. Prints wall seconds of both ways on the same face, triangles, and the ratio; the status is 0
if Tessera takes at most a fifteenth.
"""

import os
import sys
import time

import FreeCAD
import ObjectsFem
import Part
from femmesh import gmshtools

from tessera.objects import planar_mesh

SIDE = 100.0
LARGEST_RATIO = 1.0 / 15.0


def plate(document):
    """A square with a round hole in its middle, as a sketch and as a face."""
    sketch = document.addObject("Sketcher::SketchObject", "Plate")
    corners = [
        FreeCAD.Vector(x, y, 0) for x, y in ((0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE), (0, 0))
    ]
    for a, b in zip(corners, corners[1:]):
        sketch.addGeometry(Part.LineSegment(a, b), False)
    center = FreeCAD.Vector(SIDE / 2, SIDE / 2, 0)
    sketch.addGeometry(Part.Circle(center, FreeCAD.Vector(0, 0, 1), SIDE / 5), False)
    document.recompute()
    face = document.addObject("Part::Face", "Face")
    face.Sources = [sketch]
    document.recompute()
    return sketch, face


def by_tessera(document, sketch, size):
    began = time.perf_counter()
    made = planar_mesh.make_planar_mesh(sketch, size=size)
    document.recompute()
    return time.perf_counter() - began, made.FemMesh.TriangleCount


def by_gmsh(document, face, size):
    began = time.perf_counter()
    made = ObjectsFem.makeMeshGmsh(document, "Gmsh")
    made.Part = face
    made.CharacteristicLengthMax = size
    made.CharacteristicLengthMin = size
    made.ElementDimension = "2D"
    made.ElementOrder = "1st"
    made.Algorithm2D = "Frontal"
    error = gmshtools.GmshTools(made).create_mesh()
    if error:
        print(error)
    return time.perf_counter() - began, made.FemMesh.TriangleCount


def main():
    wanted = int(os.environ.get("TESSERA_TRIANGLES", "1000000"))
    document = FreeCAD.newDocument("Bench")
    sketch, face = plate(document)
    size = (4.0 / 3.0**0.5 * face.Shape.Area / wanted) ** 0.5
    ours, our_count = by_tessera(document, sketch, size)
    theirs, their_count = by_gmsh(document, face, size)
    per_triangle = (ours / our_count) / (theirs / their_count)
    print(f"Tessera: {our_count} triangles in {ours:.2f} s")
    print(f"FreeCAD's Gmsh tool: {their_count} triangles in {theirs:.2f} s")
    print(f"ratio of the times for each triangle: 1/{1.0 / per_triangle:.1f}")
    return 0 if per_triangle <= LARGEST_RATIO else 1


sys.stdout.flush()
STATUS = main()
sys.stdout.flush()
os._exit(STATUS)  # FreeCAD would stay and wait for commands
