# SPDX-License-Identifier: MIT
"""The command "Mesh sketch"."""

import FreeCAD
import FreeCADGui

from tessera.tools import resources
from tessera.tools.selection import selected_sources

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class MeshSketch:
    """Opens the task panel for the selected sketches and planar shapes."""

    def GetResources(self):
        return {
            "Pixmap": resources.icon("tessera_mesh_sketch"),
            "MenuText": QT_TRANSLATE_NOOP("Tessera_MeshSketch", "Mesh sketch"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "Tessera_MeshSketch",
                "Mesh the selected sketches or planar faces with triangles.\n"
                "Select one or more of them first.",
            ),
        }

    def IsActive(self):
        return bool(not FreeCADGui.Control.activeDialog() and selected_sources())

    def Activated(self):
        from tessera.taskpanels.planar_mesh import PlanarMeshPanel, Target

        targets = [Target(source, faces) for source, faces in selected_sources()]
        if targets:
            FreeCADGui.Control.showDialog(PlanarMeshPanel(targets))
