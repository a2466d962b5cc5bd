# SPDX-License-Identifier: MIT
"""From a sketch to a mesh, as a user does it."""

import FreeCADGui
import pytest
import sketches
import window


def test_toolbar_and_menu(document):
    action = window.toolbar_action()
    assert not action.icon().isNull()
    menus = [a.text().replace("&", "") for a in window.main_window().menuBar().actions()]
    assert "Tessera" in menus


def test_command_needs_a_selection(document):
    sketch = sketches.plate(document)
    window.select()
    assert not FreeCADGui.Command.get(window.COMMAND).isActive()
    window.select(sketch)
    assert FreeCADGui.Command.get(window.COMMAND).isActive()


def test_whole_way(document, output):
    sketch = sketches.plate(document)
    window.show_from_above()
    panel = window.open_panel(sketch)
    window.picture(output / "panel.png")
    panel.mesh()
    assert "triangles" in panel.message
    (mesh,) = window.planar_meshes(document)
    area = sketches.fem_area(mesh.FemMesh)
    error = sketches.chord_error(15.0, mesh.Size.Value)
    assert area == pytest.approx(sketches.PLATE_AREA, abs=error)
    assert mesh.Triangles == mesh.FemMesh.FaceCount > 1000
    window.picture(output / "meshed.png")
    panel.press("Ok")
    assert window.Panel.find() is None
    window.picture(output / "done.png")
