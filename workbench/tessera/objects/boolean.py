# SPDX-License-Identifier: MIT
"""A Boolean of sketches and planar shapes, as faces on their curves.

The class path and the property names are stored in users' files: they never change.
"""

import FreeCAD
import Part

import tessera
from tessera.objects.face_feature import NORMAL, READ_ONLY, FaceFeature, make_feature
from tessera.tools import cells, kept_cells
from tessera.tools.request import FILLS

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

#: Values of the property Operation and the method of tessera.Overlay that does it.
OPERATIONS = {
    "Union": "union",
    "Intersection": "intersection",
    "Difference": "difference",
    "Symmetric difference": "symmetric_difference",
    "Cells": "cells",
}
#: Values of the property Priority.
PRIORITIES = {"None": None, "First": "first", "Last": "last"}
FILL_RULES = {name: fill for name, fill in FILLS.items() if fill != "hull"}


class Boolean(FaceFeature):
    """Proxy of the document object."""

    Type = "Tessera::Boolean"
    MEANING = ("Operation", "Priority", "Fill")
    PROPERTIES = (
        (
            "Sources",
            "App::PropertyLinkSubListGlobal",
            "Boolean",
            QT_TRANSLATE_NOOP(
                "App::Property", "Sketches and planar shapes, or some of their faces; each an operand"
            ),
            None,
            NORMAL,
        ),
        (
            "Operation",
            "App::PropertyEnumeration",
            "Boolean",
            QT_TRANSLATE_NOOP(
                "App::Property", "What is kept; a difference is the first source less the others"
            ),
            list(OPERATIONS),
            NORMAL,
        ),
        (
            "Priority",
            "App::PropertyEnumeration",
            "Boolean",
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Union: to which source a place belongs that several cover; None: to all as one",
            ),
            list(PRIORITIES),
            NORMAL,
        ),
        (
            "Fill",
            "App::PropertyEnumeration",
            "Boolean",
            QT_TRANSLATE_NOOP("App::Property", "Which parts between the curves of a source are in it"),
            list(FILL_RULES),
            NORMAL,
        ),
        (
            "Weld",
            "App::PropertyLength",
            "Boolean",
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Ends of curves closer than this become one; 0: the tolerance of the sources",
            ),
            None,
            NORMAL,
        ),
        (
            "CellSources",
            "App::PropertyStringList",
            "Result",
            QT_TRANSLATE_NOOP(
                "App::Property", "By kept face: numbers of the sources that cover it, from 1"
            ),
            None,
            READ_ONLY,
        ),
    )

    def view_provider(self):
        from tessera.viewproviders.cells import ViewProviderBoolean

        return ViewProviderBoolean

    def compute(self, obj):
        items = cells.items_of(obj.Sources)
        polygons = combine(items, obj.Operation, obj.Priority, obj.Fill, obj.Weld.Value)
        numbers, warnings = self.kept(obj, cells_of(polygons, items), labels_of(items))
        faces = polygons.to_faces()
        obj.Shape = Part.Compound([faces[number] for number in numbers])
        obj.Cells = len(polygons)
        obj.Area = sum((face.Area for face in obj.Shape.Faces), 0.0)
        obj.FaceCells = numbers
        obj.CellSources = ["+".join(str(o + 1) for o in polygons[n].operands) for n in numbers]
        if numbers:
            self.tell(obj, warnings, polygons.report["messages"])
        else:
            self.tell(obj, polygons.report["messages"], [])


def cells_of(polygons, items):
    """The polygons of combine() as cells to be found again."""
    names = [cells.name_of(item) for item in items]
    return [
        kept_cells.Cell(polygon.rings, kept_cells.cover(names[o] for o in polygon.operands))
        for polygon in polygons
    ]


def labels_of(items):
    """What the user calls the names in the covers of cells_of()."""
    return {cells.name_of(item): cells.label_of(item) for item in items}


def combine(items, operation, priority="None", fill="Even-odd", weld=0.0):
    """tessera.Polygons of what the values of the properties ask for. Raises tessera.Error."""
    if not items:
        raise tessera.InvalidInputError("There is no source; add sketches or planar shapes.")
    overlay = tessera.overlay(items, fill=FILL_RULES[fill], weld=weld or None)
    if operation == "Cells":
        return overlay.cells
    if operation == "Union":
        return overlay.union(priority=PRIORITIES[priority])
    return getattr(overlay, OPERATIONS[operation])()


def make_boolean(sources, operation="Union", **values):
    """For macros: a Boolean of document objects, or links (object, ["Face1"]), as a document object
    beside the first; values: further properties. Call the document's recompute()."""
    links = [source if isinstance(source, tuple) else (source, [""]) for source in sources]
    if not links:
        raise tessera.InvalidInputError("There is no source; add sketches or planar shapes.")
    if operation not in OPERATIONS:
        raise tessera.InvalidOptionError(
            f"operation must be one of {', '.join(map(repr, OPERATIONS))}, not {operation!r}."
        )
    values = {"Sources": links, "Operation": operation, **values}
    label = translate("Tessera", "{} of {}").format(
        operation, ", ".join(owner.Label for owner, _ in links)
    )
    return make_feature(links[0][0].Document, "Boolean", label, Boolean, values)
