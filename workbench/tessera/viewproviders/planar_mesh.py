# SPDX-License-Identifier: MIT
"""How a planar mesh looks in the tree and in the 3D view, and how it is edited."""

import FreeCAD
import FreeCADGui

from tessera.tools import resources

#: Display mode with the edges of the triangles; named so by FreeCAD.
_FACES_AND_EDGES = "Faces & Wireframe"
_COLOR = (0.62, 0.83, 0.82)


class ViewProviderPlanarMesh:
    """Proxy of the view object."""

    def __init__(self, view_object):
        view_object.Proxy = self
        view_object.DisplayMode = _FACES_AND_EDGES
        _paint(view_object)
        view_object.LineWidth = 1.0
        view_object.BackfaceCulling = False

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps  # FreeCAD before 1.0
    __setstate__ = loads

    def attach(self, view_object):
        """Called by FreeCAD when the object gets its place in the 3D view, also after loading."""

    def getIcon(self):
        return resources.icon("tessera_planar_mesh")

    def doubleClicked(self, view_object):
        """Opens the task panel."""
        document = FreeCADGui.getDocument(view_object.Object.Document)
        if document.getInEdit() is None:
            document.setEdit(view_object.Object.Name)
        return True

    def setEdit(self, view_object, mode=0):
        if mode != 0:
            return None
        from tessera.taskpanels.planar_mesh import PlanarMeshPanel, Target

        if FreeCADGui.Control.activeDialog():
            FreeCAD.Console.PrintError(
                FreeCAD.Qt.translate("Tessera", "Close the open task panel first.") + "\n"
            )
            return False
        FreeCADGui.Control.showDialog(PlanarMeshPanel([Target.of_object(view_object.Object)]))
        return True

    def unsetEdit(self, view_object, mode=0):
        if mode != 0:
            return None
        FreeCADGui.Control.closeDialog()
        return True


def _paint(view_object):
    """Matt: a shiny plane is white when seen from above."""
    if "ShapeAppearance" in view_object.PropertiesList:
        material = view_object.ShapeAppearance[0]
    else:  # before FreeCAD 1.0
        material = view_object.ShapeMaterial
    material.DiffuseColor = _COLOR
    material.SpecularColor = (0.0, 0.0, 0.0)
    if "ShapeAppearance" in view_object.PropertiesList:
        view_object.ShapeAppearance = (material,)
    else:
        view_object.ShapeMaterial = material
