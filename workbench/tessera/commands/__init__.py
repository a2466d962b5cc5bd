# SPDX-License-Identifier: MIT
"""What users start from the toolbar and the menu."""

NAMES = ["Tessera_MeshSketch"]


def register():
    """Makes the commands known to FreeCAD; returns their names in the order of the toolbar."""
    import FreeCADGui

    from tessera.commands.mesh_sketch import MeshSketch

    FreeCADGui.addCommand("Tessera_MeshSketch", MeshSketch())
    return NAMES
