# SPDX-License-Identifier: MIT
"""The command "Imprint faces"."""

import FreeCAD
import FreeCADGui

from tessera.tools import resources
from tessera.tools.selection import selected_sources

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class ImprintFaces:
    """Opens the task panel for the selected faces, sketches and planar shapes."""

    def GetResources(self):
        return {
            "Pixmap": resources.icon("tessera_imprint_faces"),
            "MenuText": QT_TRANSLATE_NOOP("Tessera_ImprintFaces", "Imprint faces"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "Tessera_ImprintFaces",
                "Divide the source and target faces of a sweep so that each piece of a source lies\n"
                "on one target. Select the faces first; those in the plane of the first one are\n"
                "taken for sources.",
            ),
        }

    def IsActive(self):
        return bool(not FreeCADGui.Control.activeDialog() and selected_sources())

    def Activated(self):
        from tessera.taskpanels.imprinted_faces import (
            ImprintedFacesPanel,
            split_by_plane,
            split_faces,
        )

        sources, targets = split_by_plane(split_faces(selected_sources()))
        if sources:
            FreeCADGui.Control.showDialog(ImprintedFacesPanel(sources, targets))
