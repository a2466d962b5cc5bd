# SPDX-License-Identifier: MIT
"""How Booleans and imprints look in the tree and in the 3D view, and how they are edited."""

import FreeCAD

from tessera.tools import cells
from tessera.viewproviders.panel_opener import PanelOpener


class ViewProviderCells(PanelOpener):
    """Base of the proxies of the view objects: each cell has a color of its own."""

    def __init__(self, view_object):
        super().__init__(view_object)
        self.paint(view_object)

    def updateData(self, obj, name):
        """Called by FreeCAD after each change of a property of the object."""
        if name in ("FaceCells", "Shape") and not obj.Document.Restoring:
            self.paint(obj.ViewObject)

    @staticmethod
    def paint(view_object):
        """Matt: a shiny plane is white when seen from above."""
        numbers = getattr(view_object.Object, "FaceCells", [])
        if not numbers or len(numbers) != len(view_object.Object.Shape.Faces):
            return
        if "ShapeAppearance" in view_object.PropertiesList:
            view_object.ShapeAppearance = tuple(_matt(cells.color(number)) for number in numbers)
            return
        material = view_object.ShapeMaterial  # before FreeCAD 1.0
        material.SpecularColor = (0.0, 0.0, 0.0)
        view_object.ShapeMaterial = material
        view_object.DiffuseColor = [(*cells.color(number), 0.0) for number in numbers]


def _matt(color):
    material = FreeCAD.Material()
    material.DiffuseColor = color
    material.SpecularColor = (0.0, 0.0, 0.0)
    return material


class ViewProviderBoolean(ViewProviderCells):
    ICON = "tessera_boolean"

    @staticmethod
    def panel(obj):
        from tessera.taskpanels.boolean import BooleanPanel

        return BooleanPanel.of_object(obj)


class ViewProviderImprintedFaces(ViewProviderCells):
    ICON = "tessera_imprint_faces"

    @staticmethod
    def panel(obj):
        from tessera.taskpanels.imprinted_faces import ImprintedFacesPanel

        return ImprintedFacesPanel.of_object(obj)
