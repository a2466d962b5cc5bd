# SPDX-License-Identifier: MIT
"""The task panel: what it does to the document, and what it does not."""

import FreeCAD
import FreeCADGui
import pytest
import sketches
import window

from tessera.objects import planar_mesh
from tessera.shapes import edge_of_geometry


def state(document):
    """All that must not change when nothing was meshed."""
    names = [obj.Name for obj in document.Objects]
    return names, document.UndoCount, document.HasPendingTransaction


def made(document, size="20 mm"):
    """A plate that was meshed by a user."""
    panel = window.open_panel(sketches.plate(document))
    panel.set_size(size)
    panel.mesh()
    panel.press("Ok")
    (mesh,) = window.planar_meshes(document)
    return mesh


def test_nothing_happens_before_mesh_is_pressed(document):
    sketch = sketches.plate(document)
    before = state(document)
    panel = window.open_panel(sketch)
    assert panel.widget("sourceName").text() == "Plate"
    assert float(panel.widget("sizeField").property("rawValue")) == pytest.approx(2.92)
    panel.set_size("7 mm")
    assert state(document) == before
    panel.press("Cancel")
    assert window.Panel.find() is None
    assert state(document) == before


@pytest.mark.parametrize("text", ["nan", "abc", "-2", "5 kg", "inf", ""])
def test_what_is_no_length_is_told_not_replaced(document, text):
    panel = window.open_panel(sketches.plate(document))
    panel.set_size("20 mm")
    before = state(document)
    panel.press_keys("sizeField", text)
    panel.widget("weldField").setFocus()
    window.wait(0.1)  # some fields now show their last value again
    panel.mesh()
    # Some fields do not take the keys after the first wrong one.
    quoted = panel.message.split("'")[1]
    assert text.startswith(quoted) and bool(quoted) == bool(text)
    assert "cannot be used" in panel.message
    assert state(document) == before
    panel.press_keys("sizeField", "20")
    panel.mesh()
    assert "triangles" in panel.message
    panel.press("Cancel")


@pytest.mark.parametrize(
    "text, size", [("20", 20.0), ("12.5", 12.5), ("2 cm", 20.0), ("15mm", 15.0), ("0.02 m", 20.0)]
)
def test_typed_lengths_are_taken(document, text, size):
    panel = window.open_panel(sketches.plate(document))
    panel.press_keys("sizeField", text)
    panel.widget("weldField").setFocus()
    panel.mesh()
    assert "triangles" in panel.message
    panel.press("Ok")
    (mesh,) = window.planar_meshes(document)
    assert mesh.Size.Value == pytest.approx(size)


def test_cancel_takes_the_mesh_back(document):
    sketch = sketches.plate(document)
    before = state(document)
    panel = window.open_panel(sketch)
    panel.mesh()
    assert window.planar_meshes(document)
    panel.press("Cancel")
    assert state(document) == before


def test_all_is_one_step_of_undo(document):
    sketch = sketches.plate(document)
    before = document.UndoCount
    panel = window.open_panel(sketch)
    panel.set_size("20 mm")
    panel.mesh()
    panel.set_size("1 cm")
    panel.choose("orderField", "Second order")
    panel.mesh()
    panel.press("Ok")
    assert document.UndoCount == before + 1
    (mesh,) = window.planar_meshes(document)
    name, count = mesh.Name, mesh.Triangles
    assert (mesh.Size.Value, mesh.ElementOrder) == (10.0, 2)
    window.undo(document)
    assert document.getObject(name) is None
    window.redo(document)
    mesh = document.getObject(name)
    assert mesh.FemMesh.FaceCount == mesh.Triangles == count


def test_ok_meshes_what_is_not_meshed_yet(document):
    panel = window.open_panel(sketches.plate(document))
    panel.press("Ok")
    window.wait_until(lambda: window.Panel.find() is None, 20)
    (mesh,) = window.planar_meshes(document)
    assert mesh.FemMesh.FaceCount > 1000
    assert not document.HasPendingTransaction


def test_edit(document):
    mesh = made(document)
    count, undo_count = mesh.Triangles, document.UndoCount
    panel = window.double_click(mesh)
    assert float(panel.widget("sizeField").property("rawValue")) == pytest.approx(20.0)
    assert f"{count} triangles" in panel.message
    panel.set_size("5 mm")
    panel.mesh()
    assert mesh.FemMesh.FaceCount == mesh.Triangles > 2 * count
    panel.press("Cancel")
    assert FreeCADGui.ActiveDocument.getInEdit() is None
    assert mesh.FemMesh.FaceCount == mesh.Triangles == count
    assert mesh.Size.Value == 20.0

    panel = window.double_click(mesh)
    panel.set_size("5 mm")
    panel.mesh()
    finer = mesh.Triangles
    panel.press("Ok")
    assert FreeCADGui.ActiveDocument.getInEdit() is None
    assert document.UndoCount == undo_count + 1
    window.undo(document)
    assert mesh.FemMesh.FaceCount == mesh.Triangles == count
    window.redo(document)
    assert mesh.FemMesh.FaceCount == mesh.Triangles == finer


def test_ok_without_a_change_is_no_step(document):
    mesh = made(document)
    revision, undo_count = mesh.MeshRevision, document.UndoCount
    window.double_click(mesh).press("Ok")
    assert window.Panel.find() is None
    assert (mesh.MeshRevision, document.UndoCount) == (revision, undo_count)


def test_numbers_that_are_shown_rounded_stay(document):
    obj = planar_mesh.make_planar_mesh(sketches.plate(document), size=20.0 / 3.0, growth=0.1234)
    document.recompute()
    revision = obj.MeshRevision
    assert revision > 0
    window.double_click(obj).press("Ok")
    assert window.Panel.find() is None
    assert (obj.MeshRevision, obj.Size.Value, obj.GrowthRate) == (revision, 20.0 / 3.0, 0.1234)


def test_number_of_triangles_instead_of_a_size(document):
    panel = window.open_panel(sketches.plate(document))
    panel.set_size("20 mm")
    panel.widget("countField").setValue(3000)
    assert not panel.widget("sizeField").isEnabled()
    panel.mesh()
    assert not panel.widget("sizeField").isEnabled()
    assert "size found" in panel.message
    panel.press("Ok")
    (mesh,) = window.planar_meshes(document)
    assert (mesh.Count, mesh.Size.Value) == (3000, 20.0)
    assert 2850 <= mesh.Triangles <= 3150

    panel = window.double_click(mesh)
    assert panel.widget("countField").value() == 3000
    panel.widget("countField").setValue(0)
    assert panel.widget("sizeField").isEnabled()
    panel.mesh()
    panel.press("Ok")
    assert mesh.Count == 0
    assert mesh.Triangles < 2850


def test_largest_area_and_frozen_boundary(document):
    panel = window.open_panel(sketches.plate(document))
    panel.set_size("20 mm")
    field = panel.widget("maxAreaField")
    for text in ("5 kg", "10 mm", "-1", "nan", ""):
        field.setText(text)
        panel.mesh()
        assert f"'{text}' cannot be used" in panel.message
    del field
    panel.widget("maxAreaField").setText("0.1 cm^2")
    panel.widget("freezeField").setChecked(True)
    panel.mesh()
    assert "triangles" in panel.message
    panel.press("Ok")
    (mesh,) = window.planar_meshes(document)
    assert mesh.MaxArea.getValueAs("mm^2").Value == pytest.approx(10.0)
    assert mesh.FreezeBoundary
    groups = {mesh.FemMesh.getGroupName(g): g for g in mesh.FemMesh.Groups}
    assert len(mesh.FemMesh.getGroupElements(groups["Plate_Geometry0"])) == 1
    revision = mesh.MeshRevision

    panel = window.double_click(mesh)
    assert panel.widget("maxAreaField").text().startswith("10")
    assert panel.widget("freezeField").isChecked()
    panel.press("Ok")
    assert mesh.MeshRevision == revision


def test_source_that_was_deleted(document):
    panel = window.open_panel(sketches.plate(document))
    document.removeObject("Plate")
    panel.mesh()
    assert "deleted" in panel.message
    panel.press("Cancel")
    assert window.Panel.find() is None


def test_constraint_edges(document):
    sketch = sketches.plate(document)
    panel = window.open_panel(sketch)
    panel.set_size("5 mm")
    window.select((sketch, "Edge5"))
    panel.widget("addButton").click()
    assert panel.constraints() == ["Plate: Edge5 (Constraint)"]
    panel.mesh()
    (mesh,) = window.planar_meshes(document)
    assert sketches.fem_area(mesh.FemMesh) == pytest.approx(6000.0)
    assert [(o.Name, tuple(n)) for o, n in mesh.Constraints] == [("Plate", ("Edge5",))]
    panel.widget("constraintList").selectAll()
    panel.widget("removeButton").click()
    panel.mesh()
    assert sketches.fem_area(mesh.FemMesh) < 5400.0
    assert not mesh.Constraints


def test_another_sketch_as_constraints(document):
    sketch, line = sketches.plate(document), sketches.new_sketch(document, "Stiffener")
    sketches.add_polygon(line, [(0, 5), (100, 5)], closed=False)
    document.recompute()
    panel = window.open_panel(sketch)
    window.select(sketch, line)
    panel.widget("addButton").click()
    assert panel.constraints() == ["Stiffener (Constraint)"]
    panel.mesh()
    (mesh,) = window.planar_meshes(document)
    fem = mesh.FemMesh
    groups = {fem.getGroupName(g): g for g in fem.Groups}
    (name,) = [name for name in groups if name.startswith("Stiffener")]
    for edge in fem.getGroupElements(groups[name]):
        assert all(fem.getNodeById(n).y == pytest.approx(5.0) for n in fem.getElementNodes(edge))
    revision = mesh.MeshRevision
    panel.press("Ok")
    window.double_click(mesh).press("Ok")
    assert mesh.MeshRevision == revision


def test_fill(document):
    panel = window.open_panel(sketches.plate(document))
    panel.choose("fillField", "All")
    panel.mesh()
    (mesh,) = window.planar_meshes(document)
    assert mesh.Fill == "All"
    assert sketches.fem_area(mesh.FemMesh) == pytest.approx(6000.0)


def test_gap_is_explained_and_welded(document, output):
    sketch = sketches.new_sketch(document)
    sketches.add_polygon(sketch, [(0, 0), (40, 0), (40, 20), (0, 20), (0, 0.1)], closed=False)
    document.recompute()
    panel = window.open_panel(sketch)
    panel.mesh()
    assert "0.1 apart" in panel.message
    assert "Sketch_Geometry0" in panel.message and "Sketch_Geometry3" in panel.message
    (chosen,) = window.selected()
    ends = [edge_of_geometry(sketch, index) for index in (0, 3)]
    assert sorted(chosen[1]) == sorted(ends), "the edges with the free ends are selected"
    panel.type_length("weldField", "0.2 mm")
    panel.mesh()
    (mesh,) = window.planar_meshes(document)
    assert mesh.Weld.Value == pytest.approx(0.2)
    assert "weld tolerance 0.2" in " ".join(mesh.Messages)
    assert sketches.fem_area(mesh.FemMesh) == pytest.approx(800.0, rel=1e-2)


BAD_SOURCES = {
    "empty": sketches.empty,
    "only_open": sketches.only_open,
    "zero_area": sketches.zero_area,
}


@pytest.mark.parametrize("name", BAD_SOURCES)
def test_bad_source(document, output, name):
    sketch = BAD_SOURCES[name](document)
    before = state(document)
    window.show_from_above()
    panel = window.open_panel(sketch)
    panel.set_size("2 mm")
    window.select()
    panel.mesh()
    assert len(panel.message) > 20
    assert not panel.widget("messageIcon").pixmap().isNull()
    assert state(document) == before
    assert {obj for obj, _ in window.selected()} == {sketch.Name}
    if name == "only_open":
        assert [names for _, names in window.selected()][0], "the open edges are selected"
    window.picture(output / f"bad-{name}.png")
    panel.press("Ok")
    assert window.Panel.find() is not None, "what cannot be meshed keeps the panel open"
    panel.press("Cancel")
    assert state(document) == before


@pytest.mark.parametrize("size, words", [("0 mm", "greater than 0"), ("1 nm", "memory")])
def test_bad_size(document, output, size, words):
    sketch = sketches.plate(document)
    before = state(document)
    panel = window.open_panel(sketch)
    panel.set_size(size)
    panel.mesh()
    assert words in panel.message
    assert state(document) == before
    panel.set_size("20 mm")
    panel.mesh()
    assert "triangles" in panel.message


def test_what_is_no_size_is_not_taken(document):
    """FreeCAD's field keeps the last length; the form does not pass on anything else."""
    panel = window.open_panel(sketches.plate(document))
    panel.set_size("20 mm")
    for text in ("nan", "inf", "-5 mm", "5 kg", ""):
        panel.set_size(text)
        size = float(panel.widget("sizeField").property("rawValue"))
        assert 0.0 <= size < 1e9, text


def test_bad_size_keeps_the_old_mesh(document):
    mesh = made(document)
    kept = mesh.MeshRevision, mesh.Triangles, mesh.Size.Value
    before = state(document)
    panel = window.double_click(mesh)
    panel.set_size("0 mm")
    panel.mesh()
    assert "greater than 0" in panel.message
    assert (mesh.MeshRevision, mesh.Triangles, mesh.Size.Value) == kept
    panel.press("Cancel")
    assert state(document) == before
    assert mesh.FemMesh.FaceCount == mesh.Triangles


def test_several_sketches(document, output):
    first = sketches.plate(document, "First")
    second = sketches.plate(document, "Second")
    second.Placement.Base = FreeCAD.Vector(0, 80, 0)
    document.recompute()
    undo_count = document.UndoCount
    panel = window.open_panel(first, second)
    assert panel.widget("sourceName").text() == "First, Second"
    window.show_from_above()
    panel.mesh()
    assert panel.message.count("triangles") == 2
    meshes = window.planar_meshes(document)
    assert [m.Source.Name for m in meshes] == ["First", "Second"]
    assert min(node.y for node in meshes[1].FemMesh.Nodes.values()) == pytest.approx(80.0)
    window.picture(output / "several.png")
    panel.press("Ok")
    assert document.UndoCount == undo_count + 1
    window.undo(document)
    assert not window.planar_meshes(document)


def test_one_bad_sketch_among_several(document):
    good, bad = sketches.plate(document), sketches.only_open(document)
    before = state(document)
    panel = window.open_panel(good, bad)
    panel.mesh()
    assert panel.message.startswith("Open: ")
    assert state(document) == before


def test_joins_the_active_analysis(document, output):
    import FemGui
    import ObjectsFem

    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    FemGui.setActiveAnalysis(analysis)
    mesh = made(document)
    assert mesh in analysis.Group
    window.show_from_above()
    window.picture(output / "analysis.png")
    FemGui.setActiveAnalysis()


def test_analysis_of_another_document_is_left_alone(document):
    import FemGui
    import ObjectsFem

    other = FreeCAD.newDocument("Other")
    FemGui.setActiveAnalysis(ObjectsFem.makeAnalysis(other, "Analysis"))
    FreeCAD.setActiveDocument(document.Name)
    FreeCADGui.ActiveDocument = FreeCADGui.getDocument(document.Name)
    mesh = made(document)
    assert not mesh.InList
    FemGui.setActiveAnalysis()


def test_face_of_a_solid(document):
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    panel = window.open_panel((box, "Face6"))
    assert panel.widget("sourceName").text() == "Box: Face6"
    panel.mesh()
    (mesh,) = window.planar_meshes(document)
    assert mesh.Faces[0].Name == "Box" and list(mesh.Faces[1]) == ["Face6"]
    assert mesh.Area.getValueAs("mm^2").Value == pytest.approx(100.0)


def test_undo_while_the_panel_is_open(document):
    sketch = sketches.plate(document)
    panel = window.open_panel(sketch)
    panel.mesh()
    window.undo(document)
    assert not window.planar_meshes(document)
    panel.mesh()
    assert len(window.planar_meshes(document)) == 1
    panel.press("Ok")
    assert len(window.planar_meshes(document)) == 1


def test_document_closed_under_the_panel(document):
    panel = window.open_panel(sketches.plate(document))
    panel.mesh()
    FreeCAD.closeDocument(document.Name)
    window.wait(0.2)
    if window.Panel.find() is not None:
        panel.press("Ok")
    assert window.Panel.find() is None
    FreeCAD.newDocument("Next")
    window.wait(0.2)


def test_a_closed_panel_leaves_no_references(document):
    made(document)  # what stays after the first time is not the panel's
    before = window.references()
    window.double_click(window.planar_meshes(document)[0])
    assert window.references() > before
    window.Panel.press("Cancel")
    assert not window.references() - before
