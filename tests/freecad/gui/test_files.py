# SPDX-License-Identifier: MIT
"""What comes back from files looks as before."""

import zipfile

import FreeCAD
import pytest
import sketches
import window
from PySide import QtGui

from tessera.objects import planar_mesh
from tessera.viewproviders.planar_mesh import ViewProviderPlanarMesh


def meshed(document):
    obj = planar_mesh.make_planar_mesh(sketches.plate(document), size=10.0)
    document.recompute()
    assert obj.Triangles > 0
    return obj


def test_looks(document):
    view = meshed(document).ViewObject
    assert view.DisplayMode == "Faces & Wireframe"
    assert view.Proxy.getIcon().endswith("tessera_planar_mesh.svg")
    assert view.ShapeColor[:3] == pytest.approx((0.62, 0.83, 0.82))
    window.show_from_above()
    window.wait(0.5)
    image = view_image()
    colors = {image.pixelColor(x, y).getRgb()[:3] for x in range(90, 110) for y in range(20, 130)}
    assert any(b > r + 30 and g > r + 30 for r, g, b in colors), "the mesh has its color"
    assert any(max(color) < 80 for color in colors), "the edges of the triangles are drawn"


def view_image():
    """The middle of the screen, where the 3D view is: the left part of the plate."""
    screen = QtGui.QApplication.primaryScreen().grabWindow(0).toImage()
    return screen.copy(500, 330, 200, 150)


def test_save_and_reload(document, tmp_path, output):
    obj = meshed(document)
    obj.ViewObject.DisplayMode = "Wireframe"
    name, count = obj.Name, obj.Triangles
    opened = window.reopen(document, tmp_path / "plate.FCStd")
    obj = opened.getObject(name)
    assert isinstance(obj.Proxy, planar_mesh.PlanarMesh)
    assert isinstance(obj.ViewObject.Proxy, ViewProviderPlanarMesh)
    assert obj.ViewObject.DisplayMode == "Wireframe"
    assert obj.FemMesh.FaceCount == obj.Triangles == count
    obj.ViewObject.DisplayMode = "Faces & Wireframe"
    window.show_from_above()
    window.picture(output / "reloaded.png")
    panel = window.double_click(obj)
    panel.set_size("5 mm")
    panel.mesh()
    panel.press("Ok")
    assert obj.FemMesh.FaceCount > 2 * count
    window.undo(opened)
    assert obj.FemMesh.FaceCount == obj.Triangles == count


def test_file_written_without_a_window(document, tmp_path):
    name = meshed(document).Name
    path = tmp_path / "plate.FCStd"
    document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)
    bare = tmp_path / "bare.FCStd"
    with zipfile.ZipFile(path) as full, zipfile.ZipFile(bare, "w") as target:
        for entry in full.namelist():
            if entry != "GuiDocument.xml":
                target.writestr(entry, full.read(entry))
    opened = FreeCAD.openDocument(str(bare))
    window.wait(0.3)
    obj = opened.getObject(name)
    assert isinstance(obj.ViewObject.Proxy, ViewProviderPlanarMesh)
    assert "triangles" in window.double_click(obj).message


def test_failed_recompute_is_shown_in_the_tree(document, output):
    obj = meshed(document)
    count = obj.Triangles
    for index in (4, 3):
        obj.Source.delGeometry(index)
    document.recompute()
    assert not obj.isValid()
    assert obj.getStatusString() not in ("", "Valid")
    assert obj.FemMesh.FaceCount == count
    window.show_from_above()
    window.picture(output / "failed.png")


@pytest.mark.parametrize("visible", [True, False])
def test_visibility_is_kept(document, tmp_path, visible):
    obj = meshed(document)
    obj.ViewObject.Visibility = visible
    name = obj.Name
    opened = window.reopen(document, tmp_path / "plate.FCStd")
    assert opened.getObject(name).ViewObject.Visibility is visible
