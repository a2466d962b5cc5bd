# SPDX-License-Identifier: MIT
"""Meshes come back with undo and redo, and from files."""

import FreeCAD
import Fem
import sketches

from tessera.objects import planar_mesh
from tessera.tools.mesh_history import MeshHistory


def meshed_plate(document, size=20.0):
    obj = planar_mesh.make_planar_mesh(sketches.plate(document), size=size)
    document.recompute()
    assert obj.FemMesh.FaceCount > 0, obj.getStatusString()
    return obj


def step(document, obj, size):
    """One step of undo that changes the mesh; returns the number of triangles."""
    document.openTransaction(f"Size {size}")
    obj.Size = size
    document.recompute()
    document.commitTransaction()
    assert obj.FemMesh.FaceCount == obj.Triangles > 0
    return obj.Triangles


def test_ten_steps_back_and_forth(document):
    obj = meshed_plate(document)
    counts = [obj.Triangles]
    counts += [step(document, obj, 10.0 - 0.75 * i) for i in range(1, 11)]
    assert len(set(counts)) == len(counts)
    for _ in range(2):
        for count in reversed(counts[:-1]):
            document.undo()
            assert obj.FemMesh.FaceCount == obj.Triangles == count
        assert document.RedoCount == 10
        for count in counts[1:]:
            document.redo()
            assert obj.FemMesh.FaceCount == obj.Triangles == count
        assert document.UndoCount >= 10
    document.recompute()
    assert obj.FemMesh.FaceCount == counts[-1]


def test_new_step_after_undo(document):
    obj = meshed_plate(document)
    first = step(document, obj, 15.0)
    step(document, obj, 10.0)
    document.undo()
    other = step(document, obj, 8.0)
    document.undo()
    assert obj.FemMesh.FaceCount == first
    document.redo()
    assert obj.FemMesh.FaceCount == other


def test_undo_of_a_change_of_the_sketch(document):
    obj = meshed_plate(document)
    before = sketches.fem_area(obj.FemMesh)
    document.openTransaction("Radius")
    obj.Source.setDatum(0, FreeCAD.Units.Quantity("5 mm"))
    document.recompute()
    document.commitTransaction()
    after = sketches.fem_area(obj.FemMesh)
    assert after > before + 100
    document.undo()
    assert sketches.fem_area(obj.FemMesh) == before
    document.redo()
    assert sketches.fem_area(obj.FemMesh) == after


def test_abort_brings_the_mesh_back(document):
    obj = meshed_plate(document)
    count = obj.Triangles
    document.openTransaction("Given up")
    obj.Size = 5.0
    document.recompute()
    assert obj.FemMesh.FaceCount > count
    document.abortTransaction()
    assert obj.FemMesh.FaceCount == obj.Triangles == count


def test_undo_of_the_first_mesh(document):
    sketch = sketches.plate(document)
    document.openTransaction("Make")
    obj = planar_mesh.make_planar_mesh(sketch, size=10.0)
    document.commitTransaction()
    document.openTransaction("Mesh")
    document.recompute()
    document.commitTransaction()
    count = obj.FemMesh.FaceCount
    assert count > 0
    document.undo()
    assert obj.FemMesh.FaceCount == 0
    document.redo()
    assert obj.FemMesh.FaceCount == count


def test_undo_and_redo_of_the_creation(document):
    sketch = sketches.plate(document)
    document.openTransaction("Mesh sketch")
    obj = planar_mesh.make_planar_mesh(sketch, size=10.0)
    document.recompute()
    document.commitTransaction()
    name, count = obj.Name, obj.FemMesh.FaceCount
    assert count > 0
    document.undo()
    assert document.getObject(name) is None
    document.redo()
    assert document.getObject(name).FemMesh.FaceCount == count


def reopen(document, path):
    document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)
    return FreeCAD.openDocument(str(path))


def test_save_and_reload(document, tmp_path):
    obj = meshed_plate(document, 10.0)
    obj.Fill = "All"
    obj.ElementOrder = 2
    obj.GrowthRate = 0.2
    obj.Constraints = [(obj.Source, "Edge5")]
    document.recompute()
    assert obj.isValid(), obj.getStatusString()
    name = obj.Name
    results = [getattr(obj, p[0]) for p in planar_mesh.PROPERTIES if p[2] == "Result"]
    fem = obj.FemMesh
    groups = {
        (fem.getGroupName(g), fem.getGroupElementType(g), fem.getGroupElements(g))
        for g in fem.Groups
    }
    nodes, faces = fem.Nodes, {f: fem.getElementNodes(f) for f in fem.Faces}

    opened = reopen(document, tmp_path / "plate.FCStd")
    obj = opened.getObject(name)
    assert isinstance(obj.Proxy, planar_mesh.PlanarMesh)
    assert "Touched" not in obj.State
    assert obj.Source.Label == "Plate"
    assert (obj.Size.Value, obj.GrowthRate, obj.ElementOrder, obj.Fill) == (10.0, 0.2, 2, "All")
    assert [(owner.Name, tuple(names)) for owner, names in obj.Constraints] == [
        ("Plate", ("Edge5",))
    ]
    assert [getattr(obj, p[0]) for p in planar_mesh.PROPERTIES if p[2] == "Result"] == results
    fem = obj.FemMesh
    assert {f: fem.getElementNodes(f) for f in fem.Faces} == faces
    assert fem.Nodes.keys() == nodes.keys()
    assert max(fem.Nodes[n].distanceToPoint(nodes[n]) for n in nodes) < 1e-9
    assert {
        (fem.getGroupName(g), fem.getGroupElementType(g), fem.getGroupElements(g))
        for g in fem.Groups
    } == groups


def test_undo_after_reload(document, tmp_path):
    name = meshed_plate(document).Name
    opened = reopen(document, tmp_path / "plate.FCStd")
    opened.UndoMode = 1
    obj = opened.getObject(name)
    loaded = obj.FemMesh.FaceCount
    assert loaded > 0
    finer = step(opened, obj, 10.0)
    opened.undo()
    assert obj.FemMesh.FaceCount == obj.Triangles == loaded
    opened.redo()
    assert obj.FemMesh.FaceCount == obj.Triangles == finer


def test_copy_is_an_object_of_its_own(document):
    obj = meshed_plate(document)
    copy = document.copyObject(obj, False)
    assert copy.FemMesh.FaceCount == obj.FemMesh.FaceCount
    count = step(document, copy, 10.0)
    assert count > obj.FemMesh.FaceCount
    document.undo()
    assert copy.FemMesh.FaceCount == obj.FemMesh.FaceCount


def strip(count):
    """A FemMesh of count triangles."""
    fem = Fem.FemMesh()
    for i in range(count + 2):
        fem.addNode(i, i % 2, 0, i + 1)
    for i in range(count):
        fem.addFace([i + 1, i + 2, i + 3], i + 1)
    return fem


def test_history_is_bounded():
    history = MeshHistory(max_items=100)
    for revision in range(1, 10):
        history.remember(revision, strip(10))
    assert [r for r in range(1, 10) if r in history] == [6, 7, 8, 9]
    history.remember(10, strip(1000))
    assert history.get(10) is not None and history.get(9) is not None, "one step back is kept"
    assert len(history) == 2
    assert history.get(8) is None


def test_mesh_that_was_forgotten_is_made_again(document):
    obj = meshed_plate(document)
    count = obj.Triangles
    obj.Proxy._history = MeshHistory(max_items=1)
    step(document, obj, 10.0)
    step(document, obj, 5.0)
    document.undo()
    document.undo()
    assert "Touched" in obj.State
    document.recompute()
    assert obj.FemMesh.FaceCount == obj.Triangles == count


def test_history_numbers_are_never_used_twice():
    history = MeshHistory()
    first = history.next_revision(0)
    history.remember(first, strip(1))
    second = history.next_revision(first)
    assert history.next_revision(0) > second > first
    assert MeshHistory().next_revision(7) == 8
