# SPDX-License-Identifier: MIT
"""What users start from the toolbar and the menu."""

NAMES = ["Tessera_MeshSketch", "Tessera_Boolean", "Tessera_ImprintFaces"]


def register():
    """Makes the commands known to FreeCAD; returns their names in the order of the toolbar."""
    import FreeCADGui

    from tessera.commands.boolean import BooleanOfSketches
    from tessera.commands.imprint_faces import ImprintFaces
    from tessera.commands.mesh_sketch import MeshSketch

    FreeCADGui.addCommand("Tessera_MeshSketch", MeshSketch())
    FreeCADGui.addCommand("Tessera_Boolean", BooleanOfSketches())
    FreeCADGui.addCommand("Tessera_ImprintFaces", ImprintFaces())
    return NAMES
