# SPDX-License-Identifier: MIT
"""The task panel's fields for sizes at places and for roles of edges."""

import FreeCAD
import pytest
import sketches
import window
from FreeCAD import Vector

from tessera.objects import planar_mesh
from tessera.taskpanels.sizes import point_arrays


def longest_edge_near(fem, point, radius):
    """Of the triangles with all corners that near."""
    near = {n for n, node in fem.Nodes.items() if node.distanceToPoint(point) < radius}
    lengths = [0.0]
    for face in fem.Faces:
        corners = fem.getElementNodes(face)[:3]
        if set(corners) <= near:
            places = [fem.getNodeById(n) for n in corners]
            lengths += [places[i].distanceToPoint(places[i - 1]) for i in range(3)]
    return max(lengths)


def test_size_at_selected_edges(document, output):
    sketch = sketches.plate(document)
    before = document.UndoCount
    window.show_from_above()
    panel = window.open_panel(sketch)
    panel.set_size("6 mm")
    panel.widget("addSizeButton").click()
    assert panel.sizes() == []
    assert "Select edges" in panel.message
    window.select((sketch, "Edge5"))
    panel.widget("addSizeButton").click()
    ((where, size, *rest),) = panel.sizes()
    assert where == "Edge5" and size.endswith("mm") and rest == ["", "", ""]
    panel.type_cell(0, 1, "0.5 mm")
    panel.type_cell(0, 2, "2")
    window.select()
    panel.mesh()
    assert "triangles" in panel.message
    (mesh,) = window.planar_meshes(document)
    assert longest_edge_near(mesh.FemMesh, Vector(66, 30, 0), 1.0) < 0.8
    assert longest_edge_near(mesh.FemMesh, Vector(95, 5, 0), 8.0) > 3.0
    window.picture(output / "local-sizes.png")
    panel.press("Ok")
    assert document.UndoCount == before + 1
    name = mesh.Name
    window.undo(document)
    assert document.getObject(name) is None
    window.redo(document)
    assert document.getObject(name).RefinedSize.Value == 0.5


def test_several_rows_and_their_undo(document, output):
    sketch = sketches.plate(document)
    panel = window.open_panel(sketch)
    panel.set_size("6 mm")
    panel.mesh()
    panel.press("Ok")
    (mesh,) = window.planar_meshes(document)
    coarse, undo_count = mesh.Triangles, document.UndoCount

    panel = window.double_click(mesh)
    window.select((sketch, "Edge1", "Edge2"))
    panel.widget("addSizeButton").click()
    panel.type_cell(0, 1, "1 mm")
    window.select((sketch, "Vertex4"))
    panel.widget("addSizeButton").click()
    panel.type_cell(1, 1, "0.3 mm")
    panel.type_cell(1, 2, "2 mm")
    panel.type_cell(1, 3, "3 mm")
    panel.type_cell(1, 4, "2 cm")
    window.select()
    panel.widget("addPointButton").click()
    panel.type_cell(2, 0, "20; 45")
    panel.type_cell(2, 1, "0.2 mm")
    shown = panel.sizes()
    assert [row[0] for row in shown] == ["Edge1, Edge2", "Vertex4", "Point 20; 45"]
    assert all(cell for cell in shown[1])
    panel.mesh()
    fine = mesh.Triangles
    assert fine > 2 * coarse
    assert longest_edge_near(mesh.FemMesh, Vector(20, 45, 0), 0.5) < 0.4
    window.show_from_above()
    window.picture(output / "local-sizes-rows.png")
    assert mesh.RefinedFarDistance2.Value == pytest.approx(20.0)
    assert [tuple(p) for p in mesh.RefinedPoints3] == [(20, 45, 0)]
    panel.press("Cancel")
    assert mesh.Triangles == coarse and mesh.FemMesh.FaceCount == coarse
    assert not planar_mesh.local_sizes_of(mesh)

    panel = window.double_click(mesh)
    assert panel.sizes() == []
    for edge in ("Edge1", "Edge3"):
        window.select((sketch, edge))
        panel.widget("addSizeButton").click()
    panel.press("Ok")
    window.wait_until(lambda: window.Panel.find() is None, 20)
    assert document.UndoCount == undo_count + 1
    both = mesh.Triangles
    panel = window.double_click(mesh)
    panel.widget("sizeTable").selectRow(0)
    panel.widget("removeSizeButton").click()
    assert [row[0] for row in panel.sizes()] == ["Edge3"]
    panel.mesh()
    panel.press("Ok")
    assert coarse < mesh.Triangles < both
    assert "RefinedSize2" not in mesh.PropertiesList
    window.undo(document)
    assert mesh.FemMesh.FaceCount == both
    assert len(planar_mesh.local_sizes_of(mesh)) == 2
    window.undo(document)
    assert mesh.FemMesh.FaceCount == coarse
    window.redo(document, 2)
    assert coarse < mesh.FemMesh.FaceCount < both


@pytest.mark.parametrize("column, text", [(1, "abc"), (1, ""), (1, "5 kg"), (3, "x"), (0, "7")])
def test_what_means_nothing_is_told(document, column, text):
    panel = window.open_panel(sketches.plate(document))
    panel.set_size("20 mm")
    panel.widget("addPointButton").click()
    panel.type_cell(0, column, text)
    assert f"'{text}'" in panel.message
    panel.mesh()
    assert f"'{text}' cannot be used" in panel.message
    assert not window.planar_meshes(document)
    panel.type_cell(0, column, {0: "50; 50", 1: "3", 3: ""}[column])
    panel.mesh()
    assert "triangles" in panel.message
    panel.press("Cancel")


def test_fields_that_hold_everywhere(document, output, tmp_path):
    sketch = sketches.plate(document)
    panel = window.open_panel(sketch)
    panel.set_size("6 mm")
    panel.mesh()
    (mesh,) = window.planar_meshes(document)
    counts = [mesh.Triangles]

    def finer(change, undo):
        change()
        panel.mesh()
        assert mesh.Triangles > counts[0], panel.message
        undo()
        panel.mesh()
        assert mesh.Triangles == counts[0]

    turn = panel.widget("curvatureField")
    finer(lambda: turn.setValue(90), lambda: turn.setValue(20))
    chord = "chordErrorField"
    finer(lambda: panel.type_length(chord, "0.01 mm"), lambda: panel.type_length(chord, "0 mm"))
    gap = panel.widget("gapField")
    finer(lambda: gap.setValue(8), lambda: gap.setValue(0))
    text = panel.widget("expressionField")
    finer(lambda: text.setText("1 + 0.05*x"), lambda: text.setText(""))

    file = tmp_path / "sizes.vtu"
    sketches.write_sizes(file)
    name = panel.widget("fileField")
    name.setText(str(file))
    panel.mesh()
    assert "FILE.vtu:ARRAY" in panel.message
    array = panel.widget("arrayField")
    finer(lambda: array.setEditText("size"), lambda: name.setText(""))
    assert point_arrays(str(file)) == ["size"]
    text.setText("0.1")
    panel.type_length("minSizeField", "2 mm")
    panel.mesh()
    assert longest_edge_near(mesh.FemMesh, Vector(10, 10, 0), 5.0) > 1.5
    assert mesh.MinSize.Value == pytest.approx(2.0)
    window.picture(output / "size-fields.png")
    panel.press("Ok")
    panel = window.double_click(mesh)
    assert panel.widget("expressionField").text() == "0.1"
    revision = mesh.MeshRevision
    panel.press("Ok")
    assert mesh.MeshRevision == revision


def test_narrow_gaps(document, output):
    panel = window.open_panel(sketches.slit(document))
    panel.set_size("0.5 mm")
    field = panel.widget("narrowGapsField")
    field.setValue(40.0)
    panel.mesh()
    assert "0.002 wide at" in panel.message and "narrow gaps = 0" in panel.message
    (mesh,) = window.planar_meshes(document)
    fine = mesh.Triangles
    window.picture(output / "narrow-gaps.png")
    field.setValue(0.0)
    del field
    panel.mesh()
    assert mesh.Triangles < fine / 4
    assert "narrow" not in panel.message
    panel.press("Ok")
    revision = mesh.MeshRevision
    panel = window.double_click(mesh)
    assert panel.widget("narrowGapsField").text() == "Leave coarse"
    panel.press("Ok")
    assert (mesh.NarrowGaps, mesh.MeshRevision) == (0.0, revision)


def test_roles(document, output):
    sketch = sketches.plate(document)
    sketches.add_polygon(sketch, [(20, 5), (20, 55)], closed=False)
    document.recompute()
    panel = window.open_panel(sketch)
    panel.set_size("6 mm")
    panel.mesh()
    (mesh,) = window.planar_meshes(document)
    assert mesh.Regions == 1
    panel.choose("roleField", "Ignored")
    window.select((sketch, "Edge5"))
    panel.widget("addButton").click()
    panel.mesh()
    assert sketches.fem_area(mesh.FemMesh) == pytest.approx(6000.0)
    assert [(o.Name, tuple(n)) for o, n in mesh.Ignored] == [("Plate", ("Edge5",))]
    window.show_from_above()
    window.picture(output / "roles.png")
    panel.choose("roleField", "Constraint")
    panel.widget("addButton").click()
    assert panel.constraints() == ["Plate: Edge5 (Constraint)"]
    panel.choose("roleField", "Boundary")
    panel.widget("addButton").click()
    assert panel.constraints() == ["Plate: Edge5 (Boundary)"]
    panel.mesh()
    assert sketches.fem_area(mesh.FemMesh) < 5400.0
    other = sketches.only_open(document)
    window.select(other)
    panel.widget("addButton").click()
    assert "Open" in panel.message and len(panel.constraints()) == 1
    panel.press("Ok")
    assert [(o.Name, tuple(n)) for o, n in mesh.Boundaries] == [("Plate", ("Edge5",))]
    assert not mesh.Ignored and not mesh.Constraints


def test_construction_geometry(document):
    sketch = sketches.plate(document)
    index = sketch.GeometryCount
    sketches.add_polygon(sketch, [(0, 50), (100, 50)], closed=False)
    sketch.toggleConstruction(index)
    document.recompute()
    panel = window.open_panel(sketch)
    panel.set_size("6 mm")
    panel.mesh()
    (mesh,) = window.planar_meshes(document)

    def groups():
        return {mesh.FemMesh.getGroupName(g) for g in mesh.FemMesh.Groups}

    assert f"Plate_Geometry{index}" not in groups()
    panel.widget("constructionField").click()
    panel.mesh()
    assert f"Plate_Geometry{index}" in groups()
    panel.press("Ok")
    assert mesh.Construction


def test_region_of_a_face(document):
    """Faces of a solid that is meshed by two of its faces."""
    import Part

    left, right = Part.makePlane(40, 40), Part.makePlane(40, 40, FreeCAD.Vector(40, 0, 0))
    shape = document.addObject("Part::Feature", "Pair")
    shape.Shape = Part.Compound([left, right])
    document.recompute()
    panel = window.open_panel(shape)
    panel.set_size("8 mm")
    window.select((shape, "Face2"))
    panel.widget("addSizeButton").click()
    assert panel.sizes()[0][0] == "Face2"
    panel.type_cell(0, 1, "2")
    panel.mesh()
    (mesh,) = window.planar_meshes(document)
    assert longest_edge_near(mesh.FemMesh, Vector(60, 20, 0), 15.0) < 4.0
    assert longest_edge_near(mesh.FemMesh, Vector(10, 20, 0), 12.0) > 5.0
    panel.press("Cancel")
