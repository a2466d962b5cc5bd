# SPDX-License-Identifier: MIT
"""What document objects have in common whose shape is made of faces: Booleans and imprints."""

import FreeCAD

from tessera.errors import InvalidInputError
from tessera.tools import kept_cells
from tessera.tools.links import (
    CONTAINER_PLACEMENTS,
    containers_moved,
    note_containers,
    refuse_cycle,
    stay_in_space,
)
from tessera.tools.plain_errors import recomputing
from tessera.tools.stateless import Stateless

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

NORMAL, READ_ONLY, HIDDEN = 0, 1, 1 | 4

#: (name, type, group, description, default, attributes) of results.
RESULTS = (
    (
        "KeptCells",
        "App::PropertyVectorList",
        "Cells",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Points in the frame of the plane: only faces with one of them are kept; none: all",
        ),
        None,
        NORMAL,
    ),
    (
        "KeptCellCovers",
        "App::PropertyStringList",
        "Cells",
        QT_TRANSLATE_NOOP(
            "App::Property", "By point of KeptCells: the sources that cover the cell it stands for"
        ),
        None,
        READ_ONLY,
    ),
    (
        "Cells",
        "App::PropertyInteger",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Number of cells before any are left out"),
        None,
        READ_ONLY,
    ),
    (
        "Area",
        "App::PropertyArea",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Area of the cells that are kept"),
        None,
        READ_ONLY,
    ),
    (
        "Messages",
        "App::PropertyStringList",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "What there is to say about the sources"),
        None,
        READ_ONLY,
    ),
    (
        "FaceCells",
        "App::PropertyIntegerList",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "By face of the shape: the number of its cell, from 0"),
        None,
        HIDDEN,
    ),
    CONTAINER_PLACEMENTS,
)


class FaceFeature(Stateless):
    """Base of the proxies. A subclass has Type, PROPERTIES, view_provider() and compute(obj), which
    sets the object's results with the help of kept() and tell(), and may raise tessera.Error. MEANING: properties
    that change what a cell is."""

    PROPERTIES = ()
    MEANING = ()

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def mustExecute(self, obj):
        """Asked by FreeCAD at every recompute: moving the part that contains a source does not touch
        the source."""
        return containers_moved(obj, counts_itself=True)

    @property
    def execute(self):
        """Called by FreeCAD, with the object, to recompute; after an error its shape stays."""
        return recomputing(self._recompute)

    def _recompute(self, obj):
        refuse_cycle(obj, obj.OutList)
        self.compute(obj)
        stay_in_space(obj)
        note_containers(obj, counts_itself=True)

    def onChanged(self, obj, name):
        """Called by FreeCAD after each change of a property, also by undo and redo."""
        if name not in ("KeptCells", *self.MEANING):
            return
        if obj.Document.Restoring or obj.Document.Transacting:
            return
        if getattr(obj, "KeptCellCovers", None):
            obj.KeptCellCovers = []

    @staticmethod
    def kept(obj, found_cells, labels):
        """Numbers of the cells that the object keeps, and messages; notes what covers them."""
        kept = kept_cells.read(obj.KeptCells, obj.KeptCellCovers)
        found = kept_cells.find(found_cells, kept, labels)
        if found.are_lost:
            raise InvalidInputError(" ".join(found.messages))
        covers = [one.text for one in found.kept]
        if covers != obj.KeptCellCovers:
            obj.KeptCellCovers = covers
        return found.numbers, found.messages

    @staticmethod
    def tell(obj, warnings, messages):
        """Sets the messages; warnings stand in FreeCAD's report view as well."""
        obj.Messages = [*warnings, *messages]
        for text in warnings:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {text}\n")

    def onDocumentRestored(self, obj):
        self.add_properties(obj)
        if FreeCAD.GuiUp and obj.ViewObject is not None and obj.ViewObject.Proxy is None:
            # The file was written without a window.
            self.view_provider()(obj.ViewObject)

    def add_properties(self, obj):
        """Adds the properties that are missing: an older file may lack some."""
        known = set(obj.PropertiesList)
        for name, kind, group, description, default, attributes in (*self.PROPERTIES, *RESULTS):
            if name not in known:
                obj.addProperty(kind, name, group, description, attributes)
                if default is not None:
                    setattr(obj, name, default)


def make_feature(document, name, label, proxy, values):
    """A new document object with the properties set; recompute it."""
    obj = document.addObject("Part::FeaturePython", name)
    obj.Label = label
    try:
        proxy(obj)
        apply_values(obj, values)
    except Exception:
        document.removeObject(obj.Name)  # nothing half-made stays behind
        raise
    if FreeCAD.GuiUp:
        obj.Proxy.view_provider()(obj.ViewObject)
    return obj


def apply_values(obj, values):
    for name, value in values.items():
        setattr(obj, name, value)
