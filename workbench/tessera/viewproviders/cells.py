# SPDX-License-Identifier: MIT
"""How Booleans and imprints look in the tree and in the 3D view, and how they are edited."""

import FreeCAD
import FreeCADGui

from tessera.tools import cells, resources


class ViewProviderCells:
    """Base of the proxies of the view objects: each cell has a color of its own."""

    ICON = ""

    def __init__(self, view_object):
        view_object.Proxy = self
        self.paint(view_object)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps  # FreeCAD before 1.0
    __setstate__ = loads

    def attach(self, view_object):
        """Called by FreeCAD when the object gets its place in the 3D view, also after loading."""

    def getIcon(self):
        return resources.icon(self.ICON)

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

    def doubleClicked(self, view_object):
        """Opens the task panel."""
        document = FreeCADGui.getDocument(view_object.Object.Document)
        if document.getInEdit() is None:
            document.setEdit(view_object.Object.Name)
        return True

    def setEdit(self, view_object, mode=0):
        if mode != 0:
            return None
        if FreeCADGui.Control.activeDialog():
            FreeCAD.Console.PrintError(
                FreeCAD.Qt.translate("Tessera", "Close the open task panel first.") + "\n"
            )
            return False
        FreeCADGui.Control.showDialog(self.panel(view_object.Object))
        return True

    def unsetEdit(self, view_object, mode=0):
        if mode != 0:
            return None
        FreeCADGui.Control.closeDialog()
        return True


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
