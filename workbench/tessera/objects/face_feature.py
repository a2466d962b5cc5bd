# SPDX-License-Identifier: MIT
"""What document objects have in common whose shape is made of faces: Booleans and imprints."""

import FreeCAD

import tessera
from tessera.tools.plain_errors import RecomputeError, raising
from tessera.tools.stateless import Stateless

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
)


class FaceFeature(Stateless):
    """Base of the proxies. A subclass has Type, PROPERTIES, view_provider() and compute(obj), which
    sets the object's shape and results and may raise tessera.Error."""

    PROPERTIES = ()

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    @property
    def execute(self):
        """Called by FreeCAD, with the object, to recompute. An exception marks the object; its shape
        stays, and FreeCAD shows the message where the user looks for it."""
        return raising(self._recompute)

    def _recompute(self, obj):
        try:
            self.compute(obj)
        except (tessera.Error, ImportError) as error:
            return RecomputeError(f"{obj.Label}: {error}")
        return None

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
    proxy(obj)
    apply_values(obj, values)
    if FreeCAD.GuiUp:
        obj.Proxy.view_provider()(obj.ViewObject)
    return obj


def apply_values(obj, values):
    for name, value in values.items():
        setattr(obj, name, value)
