# SPDX-License-Identifier: MIT
"""Mesh.to_fem(): FreeCAD's mesh says the same as ours."""

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD", reason="FreeCAD's Python modules are not installed")
import Part  # noqa: E402
from FreeCAD import Vector  # noqa: E402

import tessera  # noqa: E402


@pytest.fixture
def face():
    """In the plane x = z, with a hole."""
    outer = Part.Wire(
        Part.makePolygon(
            [Vector(*p) for p in [(0, 0, 0), (6, 0, 6), (6, 8, 6), (0, 8, 0), (0, 0, 0)]]
        )
    )
    hole = Part.Wire(Part.makeCircle(1.5, Vector(3, 4, 3), Vector(-1, 0, 1)))
    return Part.Face([outer, hole])


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("placed", [True, False])
def test_same_nodes_triangles_and_edges(face, order, placed):
    mesh = tessera.mesh(face, size=0.8, order=order)
    fem = mesh.to_fem(placed)
    assert fem.NodeCount == len(mesh.nodes)
    assert fem.FaceCount == fem.TriangleCount == len(mesh.triangles)
    assert fem.EdgeCount == len(mesh.edges)
    flat = np.column_stack([mesh.nodes, np.zeros(len(mesh.nodes))])
    wanted = mesh.points() if placed else flat
    nodes = np.array([tuple(fem.getNodeById(i + 1)) for i in range(fem.NodeCount)])
    assert np.abs(nodes - wanted).max() < (1e-13 if placed else 1e-300)

    for number in fem.Faces:
        corners = list(fem.getElementNodes(number))
        assert [n - 1 for n in corners[:3]] == mesh.triangles[number - 1].tolist()
        if order == 2:
            # FreeCAD's order: the middles of (0, 1), (1, 2), (2, 0).
            opposite = mesh.triangle_mid_nodes[number - 1].tolist()
            assert [n - 1 for n in corners[3:]] == [opposite[2], opposite[0], opposite[1]]
    found = sorted(tuple(n - 1 for n in fem.getElementNodes(number)) for number in fem.Edges)
    edges = mesh.edges
    if order == 2:
        edges = np.column_stack([edges, mesh.edge_mid_nodes])
    assert found == sorted(map(tuple, edges.tolist()))


def test_orientation_follows_the_face(face):
    for shape in (face, face.reversed()):
        mesh = tessera.mesh(shape, size=1.0)
        fem = mesh.to_fem()
        normal = shape.normalAt(0, 0)
        for number in fem.Faces[:20]:
            a, b, c = (fem.getNodeById(n) for n in fem.getElementNodes(number))
            assert (b - a).cross(c - a).dot(normal) > 0


def test_groups(face):
    mesh = tessera.mesh(face, size=0.8)
    fem = mesh.to_fem()
    kinds = {"triangles": "Face", "edges": "Edge", "nodes": "Node"}
    found = {fem.getGroupName(g): g for g in fem.Groups}
    assert set(found) == set(mesh.groups)
    for name, group in mesh.groups.items():
        assert fem.getGroupElementType(found[name]) == kinds[group.kind]
        assert len(fem.getGroupElements(found[name])) == len(group.members)
    circle = np.array(
        [
            tuple(fem.getNodeById(n))
            for number in fem.getGroupElements(found["Edge5"])
            for n in fem.getElementNodes(number)
        ]
    )
    assert np.abs(np.linalg.norm(circle - (3, 4, 3), axis=1) - 1.5).max() < 1e-12


def test_arrays_become_a_fem_mesh_too():
    fem = tessera.mesh([(0, 0), (4, 0), (4, 4), (0, 4)], size=1.0).to_fem()
    assert fem.Volume.Value == 0.0
    assert fem.BoundBox.XLength == fem.BoundBox.YLength == 4.0


def test_no_file_is_left(face, tmp_path, monkeypatch):
    from pathlib import Path

    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    before = set(Path("/dev/shm").glob("tessera-*"))
    tessera.mesh(face, size=2.0).to_fem()
    assert set(Path("/dev/shm").glob("tessera-*")) <= before and not list(tmp_path.iterdir())


def test_outside_of_freecad(monkeypatch):
    import sys

    mesh = tessera.mesh([(0, 0), (4, 0), (4, 4), (0, 4)], size=1.0)
    monkeypatch.delitem(sys.modules, "tessera.fem", raising=False)
    monkeypatch.setitem(sys.modules, "Fem", None)
    with pytest.raises(tessera.Error, match="freecadcmd"):
        mesh.to_fem()
