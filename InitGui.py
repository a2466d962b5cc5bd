# SPDX-License-Identifier: MIT
"""Run by FreeCAD when its window starts. FreeCAD runs this file by exec: names defined here are not
visible inside methods, so these import what they need."""

import FreeCAD
import FreeCADGui

from tessera.tools import resources


class TesseraWorkbench(FreeCADGui.Workbench):
    """Meshes for FEM from sketches and planar faces."""

    def __init__(self):
        from FreeCAD import Qt
        from tessera.tools import resources

        self.__class__.MenuText = Qt.translate("Tessera", "Tessera")
        self.__class__.ToolTip = Qt.translate(
            "Tessera", "Finite-element meshes from sketches and planar faces"
        )
        self.__class__.Icon = resources.icon("tessera")

    def Initialize(self):
        """Called when the workbench is shown for the first time."""
        from FreeCAD import Qt
        from tessera import commands

        names = commands.register()
        self.appendToolbar(Qt.QT_TRANSLATE_NOOP("Workbench", "Tessera"), names)
        self.appendMenu(Qt.QT_TRANSLATE_NOOP("Workbench", "Tessera"), names)

    def ContextMenu(self, recipient):
        """Called when the user right-clicks in the 3D view or the tree."""
        import FreeCADGui
        from tessera import commands

        if FreeCADGui.Selection.getSelection():
            self.appendContextMenu("", commands.NAMES)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addIconPath(resources.folder("icons"))
FreeCADGui.addLanguagePath(resources.folder("translations"))
FreeCADGui.addWorkbench(TesseraWorkbench())
