# SPDX-License-Identifier: MIT
"""The command "Boolean of sketches"."""

import FreeCAD
import FreeCADGui

from tessera.tools import resources
from tessera.tools.selection import selected_sources

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class BooleanOfSketches:
    """Opens the task panel for the selected sketches and planar shapes."""

    def GetResources(self):
        return {
            "Pixmap": resources.icon("tessera_boolean"),
            "MenuText": QT_TRANSLATE_NOOP("Tessera_Boolean", "Boolean of sketches"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "Tessera_Boolean",
                "Faces from the union, intersection, difference or the cells of the selected\n"
                "sketches and planar shapes, however they cross. Select them first.",
            ),
        }

    def IsActive(self):
        return bool(not FreeCADGui.Control.activeDialog() and selected_sources())

    def Activated(self):
        from tessera.taskpanels.boolean import BooleanPanel

        sources = selected_sources()
        if sources:
            FreeCADGui.Control.showDialog(BooleanPanel(sources))
