# SPDX-License-Identifier: MIT
"""Run by freecadcmd: documents as users have them, into the folder TESSERA_ODD_DOCUMENTS."""

import os
import sys

import FreeCAD
import Part
from FreeCAD import Vector

FOLDER = os.environ["TESSERA_ODD_DOCUMENTS"]


def add_rectangle(sketch, width, height, construction=False):
    corners = [Vector(0, 0), Vector(width, 0), Vector(width, height), Vector(0, height)]
    for a, b in zip(corners, corners[1:] + corners[:1]):
        sketch.addGeometry(Part.LineSegment(a, b), construction)


def save(document, name):
    document.recompute()
    document.saveAs(os.path.join(FOLDER, name + ".FCStd"))


def only_construction():
    document = FreeCAD.newDocument()
    add_rectangle(document.addObject("Sketcher::SketchObject", "Sketch"), 10, 5, True)
    save(document, "construction")


def rotated_in_a_body():
    document = FreeCAD.newDocument()
    body = document.addObject("PartDesign::Body", "Body")
    body.Placement = FreeCAD.Placement(
        Vector(100, 20, -5), FreeCAD.Rotation(Vector(1, 2, 3), 40)
    )
    sketch = body.newObject("Sketcher::SketchObject", "Sketch")
    sketch.Placement = FreeCAD.Placement(Vector(1, 2, 3), FreeCAD.Rotation(Vector(1, 0, 0), 90))
    add_rectangle(sketch, 10, 5)
    sketch.addGeometry(Part.Circle(Vector(5, 2.5, 0), Vector(0, 0, 1), 1))
    save(document, "rotated")


def same_labels():
    preferences = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document")
    preferences.SetBool("DuplicateLabels", True)
    document = FreeCAD.newDocument()
    for width in (10, 20):
        sketch = document.addObject("Sketcher::SketchObject", "Sketch")
        add_rectangle(sketch, width, 5)
        sketch.Label = "Träger Ø12 / 断面"
    document.addObject("Sketcher::SketchObject", "Empty")
    save(document, "Gehäuse größer")


def no_sketch():
    document = FreeCAD.newDocument()
    document.addObject("Part::Box", "Box")
    save(document, "box")


status = 1
try:
    only_construction()
    rotated_in_a_body()
    same_labels()
    no_sketch()
    with open(os.path.join(FOLDER, "broken.FCStd"), "w") as stream:
        stream.write("no document")
    status = 0
finally:
    sys.stdout.flush()
    os._exit(status)
