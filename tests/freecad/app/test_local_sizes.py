# SPDX-License-Identifier: MIT
"""The document object's properties that ask for sizes."""

import FreeCAD
import pytest
import sketches

from tessera.objects import planar_mesh


@pytest.fixture
def mesh(document):
    obj = planar_mesh.make_planar_mesh(sketches.plate(document), size=3.0)
    recompute(obj)
    return obj


def recompute(obj):
    obj.Document.recompute()
    assert obj.isValid(), obj.getStatusString()
    return obj.Triangles


def test_each_property_makes_the_mesh_finer_where_it_says(mesh):
    before = mesh.Triangles
    source = mesh.Source
    mesh.RefinedElements = [(source, ["Edge1", "Vertex3"])]
    assert recompute(mesh) == before  # no size yet
    mesh.RefinedSize = 0.2
    at_elements = recompute(mesh)
    assert at_elements > before
    mesh.RefinedDistance = 1.0
    assert recompute(mesh) > at_elements
    mesh.RefinedElements = []
    assert recompute(mesh) == before
    mesh.SizeExpression = "0.5 + 0.05*x"
    assert recompute(mesh) > before
    mesh.SizeExpression = ""
    mesh.GapElements = 5
    assert recompute(mesh) >= before
    mesh.GapElements = 0
    mesh.Curvature = 60
    assert recompute(mesh) > before
    mesh.Curvature = 20
    assert recompute(mesh) == before


def test_all_edges_of_an_object(mesh):
    before = mesh.Triangles
    mesh.RefinedElements = [(mesh.Source, [""])]
    mesh.RefinedSize = 0.5
    assert recompute(mesh) > 2 * before


def test_errors_are_shown_at_the_object_and_its_mesh_stays(mesh):
    before = mesh.FemMesh.FaceCount
    for expression in ("x +", "x - 5", "nonsense"):
        mesh.SizeExpression = expression
        mesh.Document.recompute()
        assert not mesh.isValid()
        assert "size expression" in mesh.getStatusString()
        assert mesh.FemMesh.FaceCount == before
    mesh.SizeExpression = ""
    recompute(mesh)


def test_properties_survive_saving(mesh, tmp_path):
    mesh.RefinedElements = [(mesh.Source, ["Edge1"])]
    mesh.RefinedSize = 0.5
    mesh.SizeExpression = "1 + 0.1*x"
    mesh.Curvature = 24
    mesh.GapElements = 2
    request = planar_mesh.request_of(mesh)
    path = str(tmp_path / "sizes.FCStd")
    name = mesh.Name
    mesh.Document.saveAs(path)
    FreeCAD.closeDocument(mesh.Document.Name)
    restored = planar_mesh.request_of(FreeCAD.openDocument(path).getObject(name))
    for field in ("refined_size", "expression", "curvature", "gap"):
        assert getattr(restored, field) == getattr(request, field)
    assert [names for _, names in restored.refined] == [("Edge1",)]
