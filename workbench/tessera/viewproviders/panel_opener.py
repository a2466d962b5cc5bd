# SPDX-License-Identifier: MIT
"""What all of the workbench's objects do in the tree: show an icon, open their task panel."""

import FreeCAD
import FreeCADGui

from tessera.tools import resources
from tessera.tools.stateless import Stateless


class PanelOpener(Stateless):
    """Base of the proxies of view objects. A subclass has ICON and panel(obj)."""

    ICON = ""

    def __init__(self, view_object):
        view_object.Proxy = self

    def attach(self, view_object):
        """Called by FreeCAD when the object gets its place in the 3D view, also after loading."""

    def getIcon(self):
        return resources.icon(self.ICON)

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
