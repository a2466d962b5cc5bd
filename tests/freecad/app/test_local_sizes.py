# SPDX-License-Identifier: MIT
"""The document object's properties that ask for sizes."""

from dataclasses import replace

import FreeCAD
import pytest
import sketches

import tessera
from tessera.objects import planar_mesh
from tessera.tools.request import LocalSize


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


def test_several_local_sizes(mesh):
    before = mesh.Triangles
    source = mesh.Source
    first = LocalSize(elements=((source, ("Edge1",)),), size=0.5)
    second = LocalSize(points=((20.0, 45.0, 0.0),), size=0.2, far_size=3.0, far_distance=30.0)
    third = LocalSize(regions=((5.0, 5.0, 0.0),), size=1.0)
    counts = []
    for sizes in ((first,), (first, second), (first, second, third), (second,), ()):
        request = replace(planar_mesh.request_of(mesh), local_sizes=sizes)
        planar_mesh.apply_request(mesh, request)
        assert planar_mesh.request_of(mesh) == request
        counts.append(recompute(mesh))
    assert before == counts[4] < counts[0] < counts[1] < counts[2]
    assert before < counts[3] < counts[1]
    assert "RefinedSize2" not in mesh.PropertiesList


def test_sizes_of_a_file(mesh, tmp_path):
    path = tmp_path / "sizes.vtu"
    sketches.write_sizes(path)
    before = mesh.Triangles
    mesh.SizeFile = str(path)
    for array, words in (("", "FILE.vtu:ARRAY"), ("h", "there is")):
        mesh.SizeArray = array
        mesh.Document.recompute()
        assert not mesh.isValid()
        assert words in mesh.getStatusString()
    mesh.SizeArray = "size"
    assert recompute(mesh) > before
    mesh.SizeFile = ""
    assert recompute(mesh) == before


def test_properties_survive_saving(mesh, tmp_path):
    mesh.RefinedElements = [(mesh.Source, ["Edge1"])]
    mesh.RefinedSize = 0.5
    mesh.MinSize = 0.1
    mesh.ChordError = 0.2
    mesh.SizeExpression = "1 + 0.1*x"
    mesh.Curvature = 24
    mesh.GapElements = 2
    request = planar_mesh.request_of(mesh)
    path = str(tmp_path / "sizes.FCStd")
    name = mesh.Name
    mesh.Document.saveAs(path)
    FreeCAD.closeDocument(mesh.Document.Name)
    restored = planar_mesh.request_of(FreeCAD.openDocument(path).getObject(name))
    for field in ("min_size", "chord_error", "expression", "curvature", "gap"):
        assert getattr(restored, field) == getattr(request, field)
    (local,) = restored.local_sizes
    assert (local.size, [names for _, names in local.elements]) == (0.5, [("Edge1",)])
