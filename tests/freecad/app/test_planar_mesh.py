# SPDX-License-Identifier: MIT
"""The document object without a window: meshing, properties, errors."""

import math
import re
import sys

import FreeCAD
import Part
import pytest
import sketches
from FreeCAD import Vector

import tessera
from tessera.objects import planar_mesh
from tessera.shapes import edge_of_geometry
from tessera.tools import preferences
from tessera.tools.request import MeshRequest, default_size


def mesh_of(source, **options):
    obj = planar_mesh.make_planar_mesh(source, **options)
    recompute(obj)
    return obj


def recompute(obj):
    obj.Document.recompute()
    assert obj.isValid(), obj.getStatusString()


def test_the_format_of_files(document):
    """Class path, property names and types are in users' files: this list may only grow."""
    obj = planar_mesh.make_planar_mesh(sketches.plate(document))
    proxy = type(obj.Proxy)
    assert f"{proxy.__module__}.{proxy.__name__}" == "tessera.objects.planar_mesh.PlanarMesh"
    assert obj.TypeId == "Fem::FemMeshObjectPython"
    assert {
        "Source": "App::PropertyLinkGlobal",
        "Faces": "App::PropertyLinkSubGlobal",
        "Constraints": "App::PropertyLinkSubListGlobal",
        "Boundaries": "App::PropertyLinkSubListGlobal",
        "Ignored": "App::PropertyLinkSubListGlobal",
        "Construction": "App::PropertyBool",
        "Size": "App::PropertyLength",
        "Count": "App::PropertyIntegerConstraint",
        "MaxArea": "App::PropertyArea",
        "FreezeBoundary": "App::PropertyBool",
        "NarrowGaps": "App::PropertyFloatConstraint",
        "GrowthRate": "App::PropertyFloatConstraint",
        "ElementOrder": "App::PropertyIntegerConstraint",
        "Fill": "App::PropertyEnumeration",
        "Weld": "App::PropertyLength",
        "MinSize": "App::PropertyLength",
        "Curvature": "App::PropertyIntegerConstraint",
        "ChordError": "App::PropertyLength",
        "GapElements": "App::PropertyIntegerConstraint",
        "RefinedElements": "App::PropertyLinkSubListGlobal",
        "RefinedSize": "App::PropertyLength",
        "RefinedPoints": "App::PropertyVectorList",
        "RefinedRegions": "App::PropertyVectorList",
        "RefinedDistance": "App::PropertyLength",
        "RefinedFarSize": "App::PropertyLength",
        "RefinedFarDistance": "App::PropertyLength",
        "SizeFile": "App::PropertyFile",
        "SizeArray": "App::PropertyString",
        "SizeExpression": "App::PropertyString",
        "Triangles": "App::PropertyInteger",
        "Area": "App::PropertyArea",
        "MinAngle": "App::PropertyAngle",
        "MeanQuality": "App::PropertyFloat",
        "Regions": "App::PropertyInteger",
        "Crossings": "App::PropertyInteger",
        "Messages": "App::PropertyStringList",
        "ContainerPlacements": "App::PropertyPlacementList",
        "MeshRevision": "App::PropertyInteger",
    } == {name: obj.getTypeIdOfProperty(name) for name, *_ in planar_mesh.PROPERTIES}
    assert obj.getEnumerationsOfProperty("Fill") == [
        "Even-odd",
        "Nonzero",
        "Positive",
        "Negative",
        "All",
        "Hull",
    ]


def test_plate(document):
    obj = mesh_of(sketches.plate(document), size=5.0)
    fem = obj.FemMesh
    assert fem.FaceCount == obj.Triangles > 300
    area = sketches.fem_area(fem)
    assert sketches.PLATE_AREA < area < sketches.PLATE_AREA + sketches.chord_error(15.0, 5.0)
    assert obj.Area.getValueAs("mm^2").Value == pytest.approx(area, rel=1e-12)
    assert float(obj.MinAngle) > 30.0
    assert 0.9 < obj.MeanQuality <= 1.0
    assert (obj.Regions, obj.Crossings) == (1, 0)
    assert any("hole" in message for message in obj.Messages)


def test_number_of_triangles(document):
    obj = mesh_of(sketches.plate(document), size=1.0, count=3000)
    assert 2850 <= obj.Triangles <= 3150
    assert obj.Size.Value == 1.0  # it does not count, and stays
    (found,) = [message for message in obj.Messages if "size found" in message]
    size = FreeCAD.Units.Quantity(re.search(r"is (.*)\.", found).group(1)).Value
    assert size > 1.0
    obj.Count, obj.Size = 0, size
    recompute(obj)
    assert 2850 <= obj.Triangles <= 3150
    assert not any("size found" in message for message in obj.Messages)


def test_largest_area(document):
    obj = mesh_of(sketches.plate(document), size=20.0)
    before = obj.Triangles
    obj.MaxArea = "10 mm^2"
    recompute(obj)
    assert obj.Triangles > 2 * before
    fem = obj.FemMesh
    for face in fem.Faces:
        a, b, c = (fem.getNodeById(node) for node in fem.getElementNodes(face))
        assert (b - a).cross(c - a).Length / 2.0 <= 10.0 + 1e-9


def test_frozen_boundary(document):
    source = sketches.plate(document)
    obj = mesh_of(source, size=5.0, freeze_boundary=True)
    groups = {obj.FemMesh.getGroupName(g): g for g in obj.FemMesh.Groups}
    assert len(obj.FemMesh.getGroupElements(groups["Plate_Geometry0"])) == 1
    assert len(obj.FemMesh.getGroupElements(groups["Plate_Geometry4"])) >= 18
    obj.FreezeBoundary = False
    recompute(obj)
    groups = {obj.FemMesh.getGroupName(g): g for g in obj.FemMesh.Groups}
    assert len(obj.FemMesh.getGroupElements(groups["Plate_Geometry0"])) > 1


def test_narrow_gaps(document):
    obj = mesh_of(sketches.slit(document), size=0.5, narrow_gaps=40.0)
    (message,) = obj.Messages
    assert "0.002 wide at" in message
    fine = obj.Triangles
    obj.NarrowGaps = 0.0
    recompute(obj)
    assert obj.Triangles < fine / 4
    assert obj.Messages == []
    obj.NarrowGaps = -1.0  # FreeCAD keeps it above its bound
    assert obj.NarrowGaps == 0.0


def test_threads_that_the_user_prefers(document, monkeypatch):
    given = []
    mesh = tessera.mesh

    def observed(*args, **options):
        given.append(options["threads"])
        return mesh(*args, **options)

    monkeypatch.setattr(tessera, "mesh", observed)
    obj = mesh_of(sketches.plate(document), size=10.0)
    count = obj.Triangles
    group = FreeCAD.ParamGet(preferences.GROUP)
    try:
        for number in (1, -1):
            group.SetInt("Threads", number)
            obj.touch()
            recompute(obj)
            assert obj.Triangles == count
    finally:
        group.RemInt("Threads")
    assert given == [None, 1, None]


def test_results_are_read_only(document):
    obj = mesh_of(sketches.plate(document))
    for name in ("Triangles", "Area", "MinAngle", "MeanQuality", "Regions", "Crossings"):
        assert "ReadOnly" in obj.getEditorMode(name)
    assert "Hidden" in obj.getEditorMode("MeshRevision")


def test_edge_groups_lie_on_their_curves(document):
    fem = mesh_of(sketches.plate(document), size=5.0).FemMesh
    groups = {fem.getGroupName(g): g for g in fem.Groups}
    circle = fem.getGroupElements(groups["Plate_Geometry4"])
    assert len(circle) >= 18
    center = Vector(50, 30, 0)
    for edge in circle:
        for node in fem.getElementNodes(edge):
            assert fem.getNodeById(node).distanceToPoint(center) == pytest.approx(15.0, abs=1e-9)
    lower = fem.getGroupElements(groups["Plate_Geometry0"])
    length = sum(
        fem.getNodeById(a).distanceToPoint(fem.getNodeById(b))
        for a, b in (fem.getElementNodes(edge) for edge in lower)
    )
    assert length == pytest.approx(100.0)


def test_follows_its_source(document):
    sketch = sketches.plate(document)
    obj = mesh_of(sketch, size=5.0)
    before = sketches.fem_area(obj.FemMesh)
    sketch.setDatum(0, FreeCAD.Units.Quantity("10 mm"))
    recompute(obj)
    grown = math.pi * (15.0**2 - 10.0**2)
    difference = sketches.fem_area(obj.FemMesh) - before
    assert difference == pytest.approx(grown, abs=sketches.chord_error(15.0, 5.0))


def test_follows_its_properties(document):
    obj = mesh_of(sketches.plate(document), size=10.0)
    coarse = obj.Triangles
    obj.Size = 5.0
    recompute(obj)
    assert 2 * coarse < obj.Triangles < 6 * coarse  # the hole is fine already
    obj.Size = "1 cm"
    recompute(obj)
    assert obj.Triangles == coarse


def test_nothing_to_do_leaves_the_mesh(document):
    obj = mesh_of(sketches.plate(document))
    revision = obj.MeshRevision
    document.recompute()
    assert obj.MeshRevision == revision


def test_second_order(document):
    obj = mesh_of(sketches.plate(document), size=5.0, order=2)
    fem = obj.FemMesh
    assert all(len(fem.getElementNodes(face)) == 6 for face in fem.Faces)
    on_circle = [
        node
        for node in fem.Nodes.values()
        if abs(node.distanceToPoint(Vector(50, 30, 0)) - 15) < 1e-9
    ]
    edges = math.ceil(2 * math.pi * 15 / 5)
    assert len(on_circle) >= 2 * (edges - 1)


def test_fill_all_keeps_the_hole(document):
    obj = mesh_of(sketches.plate(document), fill="All")
    assert sketches.fem_area(obj.FemMesh) == pytest.approx(6000.0)
    assert obj.Regions == 2


def test_constraint_edges_do_not_bound(document):
    sketch = sketches.plate(document)
    obj = planar_mesh.make_planar_mesh(sketch, size=5.0)
    circle = next(
        f"Edge{i + 1}"
        for i, edge in enumerate(sketch.Shape.Edges)
        if isinstance(edge.Curve, Part.Circle)
    )
    obj.Constraints = [(sketch, circle)]
    recompute(obj)
    fem = obj.FemMesh
    assert sketches.fem_area(fem) == pytest.approx(6000.0)
    groups = {fem.getGroupName(g): g for g in fem.Groups}
    assert fem.getGroupElements(groups["Plate_Geometry4"])


def test_ignored_edges_and_construction_geometry(document):
    sketch = sketches.plate(document)
    line = sketch.addGeometry(Part.LineSegment(Vector(10, 10, 0), Vector(30, 10, 0)), True)
    document.recompute()
    circle = edge_of_geometry(sketch, 4)
    obj = planar_mesh.make_planar_mesh(sketch, size=5.0)
    obj.Ignored = [(sketch, circle)]
    recompute(obj)
    fem = obj.FemMesh
    assert sketches.fem_area(fem) == pytest.approx(6000.0)
    assert "Plate_Geometry4" not in {fem.getGroupName(g) for g in fem.Groups}
    obj.Construction = True
    recompute(obj)
    fem = obj.FemMesh
    groups = {fem.getGroupName(g): g for g in fem.Groups}
    assert len(fem.getGroupElements(groups[f"Plate_Geometry{line}"])) >= 4


def test_boundary_edges_come_after_constraints(document):
    sketch = sketches.plate(document)
    circle = edge_of_geometry(sketch, 4)
    obj = planar_mesh.make_planar_mesh(sketch, size=5.0)
    obj.Constraints = [(sketch, circle)]
    obj.Boundaries = [(sketch, circle)]
    recompute(obj)
    hole = sketches.fem_area(obj.FemMesh) - sketches.PLATE_AREA
    assert 0 < hole < sketches.chord_error(15.0, 5.0)


def test_crossing_lines_are_counted(document):
    sketch = sketches.new_sketch(document)
    sketches.add_rectangle(sketch, 0, 0, 40, 40)
    sketches.add_rectangle(sketch, 20, 20, 40, 40)
    document.recompute()
    obj = mesh_of(sketch, size=4.0)
    assert obj.Crossings == 2
    assert sketches.fem_area(obj.FemMesh) == pytest.approx(2 * 1600 - 2 * 400)
    obj.Fill = "Nonzero"
    recompute(obj)
    assert sketches.fem_area(obj.FemMesh) == pytest.approx(2 * 1600 - 400)


def test_face_of_a_solid(document):
    box = document.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 30, 20, 10
    document.recompute()
    obj = planar_mesh.make_planar_mesh(box, faces=("Face6",))
    assert default_size(box, ("Face6",)) == pytest.approx(math.hypot(30, 20) / 40, rel=1e-2)
    recompute(obj)
    assert all(node.z == pytest.approx(10.0) for node in obj.FemMesh.Nodes.values())
    assert obj.Area.getValueAs("mm^2").Value == pytest.approx(600.0)


def test_planar_shape(document):
    face = document.addObject("Part::Feature", "Disc")
    face.Shape = Part.Face(Part.Wire(Part.makeCircle(10.0)))
    obj = mesh_of(face)
    assert obj.Area.getValueAs("mm^2").Value == pytest.approx(100 * math.pi, rel=0.01)


def test_mesh_lies_where_the_sketch_does(document):
    """Also inside a body that has been moved."""
    body = document.addObject("PartDesign::Body", "Body")
    sketch = sketches.new_sketch(document)
    body.addObject(sketch)
    sketches.add_rectangle(sketch, 0, 0, 20, 10)
    sketch.Placement = FreeCAD.Placement(Vector(1, 2, 3), FreeCAD.Rotation(Vector(1, 0, 0), 90))
    body.Placement = FreeCAD.Placement(Vector(100, 0, 0), FreeCAD.Rotation(Vector(0, 0, 1), 90))
    document.recompute()
    obj = mesh_of(sketch)
    corner = sketch.getGlobalPlacement().multVec(Vector(20, 10, 0))
    distances = [node.distanceToPoint(corner) for node in obj.FemMesh.Nodes.values()]
    assert min(distances) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("kind", ["App::Part", "PartDesign::Body"])
def test_follows_the_container_when_it_moves(document, kind):
    container = document.addObject(kind, "Container")
    sketch = sketches.plate(document)
    container.addObject(sketch)
    mesh = mesh_of(sketch, size=10.0)
    start = mesh.FemMesh.BoundBox
    count = mesh.Triangles
    container.Placement = FreeCAD.Placement(Vector(100, 0, 30), FreeCAD.Rotation())
    recompute(mesh)
    moved = mesh.FemMesh.BoundBox
    assert (moved.XMin, moved.ZMin) == pytest.approx((start.XMin + 100, start.ZMin + 30))
    assert mesh.Triangles == count
    revision = mesh.MeshRevision
    recompute(mesh)
    assert mesh.MeshRevision == revision  # nothing moved: nothing is meshed


@pytest.mark.parametrize("kind", ["App::Part", "PartDesign::Body"])
def test_follows_the_container_of_a_constraint_when_it_moves(document, kind):
    container = document.addObject(kind, "Container")
    line = sketches.new_sketch(document, "Line")
    sketches.add_polygon(line, [(10, 10), (90, 10)], closed=False)
    container.addObject(line)
    document.recompute()
    mesh = mesh_of(sketches.plate(document), size=10.0)
    mesh.Constraints = [(line, ["Edge1"])]
    recompute(mesh)

    def nodes_at(height):
        return [n for n in mesh.FemMesh.Nodes.values() if abs(n.y - height) < 1e-9 and 11 < n.x < 89]

    assert len(nodes_at(10)) >= 5
    container.Placement = FreeCAD.Placement(Vector(0, -3, 0), FreeCAD.Rotation())
    recompute(mesh)
    assert len(nodes_at(7)) >= 5 > len(nodes_at(10))
    revision = mesh.MeshRevision
    recompute(mesh)
    assert mesh.MeshRevision == revision


def test_size_is_chosen_from_the_source(document):
    sketch = sketches.plate(document)
    diagonal = math.hypot(100, 60)
    assert default_size(sketch) == pytest.approx(diagonal / 40, rel=5e-3)
    obj = document.addObject(planar_mesh.FEM_TYPE, "ByHand")
    planar_mesh.PlanarMesh(obj)
    obj.Source = sketch
    assert obj.Size.Value == default_size(sketch)
    recompute(obj)


def test_offered_mesh_is_taken_only_for_what_it_was_made(document):
    sketch = sketches.plate(document)
    request = MeshRequest(sketch, size=20.0)
    mesh = request.mesh(request.prepare())
    obj = planar_mesh.make(request)
    obj.Proxy.offer(request, mesh)
    recompute(obj)
    assert obj.Triangles == len(mesh.triangles)
    obj.Size = 5.0
    obj.Proxy.offer(request, mesh)
    recompute(obj)
    assert obj.Triangles > 2 * len(mesh.triangles)


def test_weld_closes_a_gap(document):
    sketch = sketches.new_sketch(document)
    sketches.add_polygon(sketch, [(0, 0), (40, 0), (40, 20), (0, 20), (0, 0.01)], closed=False)
    document.recompute()
    obj = planar_mesh.make_planar_mesh(sketch, size=5.0)
    document.recompute()
    assert not obj.isValid()
    assert "0.01 apart" in obj.getStatusString()
    obj.Weld = 0.02
    recompute(obj)
    assert sketches.fem_area(obj.FemMesh) == pytest.approx(800.0, rel=1e-3)


BAD_SOURCES = {
    "empty": (sketches.empty, "no geometry"),
    "only_open": (sketches.only_open, "open|closed"),
    "zero_area": (sketches.zero_area, "no area"),
}


@pytest.mark.parametrize("name", BAD_SOURCES)
def test_bad_source_is_explained(document, name):
    make, words = BAD_SOURCES[name]
    obj = planar_mesh.make_planar_mesh(make(document), size=1.0)
    document.recompute()
    assert not obj.isValid()
    assert re.search(words, obj.getStatusString()), obj.getStatusString()
    assert (obj.FemMesh.FaceCount, obj.MeshRevision) == (0, 0)


def test_failed_recompute_is_told_in_one_sentence(document, capfd):
    """What FreeCAD's report view shows."""
    planar_mesh.make_planar_mesh(sketches.zero_area(document), size=1.0)
    capfd.readouterr()
    document.recompute()
    told = "".join(capfd.readouterr())
    assert "Traceback" not in told
    assert "Tessera: Flat mesh: The outline encloses no area" in told


@pytest.mark.parametrize(
    "size, words",
    [(0.0, "greater than 0"), (math.nan, "finite"), (1e-6, "memory")],
)
def test_bad_size_keeps_the_mesh(document, size, words):
    obj = mesh_of(sketches.plate(document))
    kept = (obj.MeshRevision, obj.Triangles, obj.FemMesh.FaceCount)
    obj.Size = size
    document.recompute()
    assert not obj.isValid()
    assert words in obj.getStatusString()
    assert (obj.MeshRevision, obj.Triangles, obj.FemMesh.FaceCount) == kept
    obj.Size = 5.0
    recompute(obj)


def test_source_that_became_bad_keeps_the_mesh(document):
    sketch = sketches.plate(document)
    obj = mesh_of(sketch)
    count = obj.FemMesh.FaceCount
    assert count > 0
    for index in (3, 2):
        sketch.delGeometry(index)
    sketch.delGeometry(sketch.GeometryCount - 1)
    document.recompute()
    assert not obj.isValid()
    assert obj.FemMesh.FaceCount == count


def test_without_a_source(document):
    obj = document.addObject(planar_mesh.FEM_TYPE, "Alone")
    planar_mesh.PlanarMesh(obj)
    document.recompute()
    assert not obj.isValid()
    assert "Source" in obj.getStatusString()


def test_without_the_compiled_module(document, monkeypatch):
    """The workbench starts, files open, and the message says what to do."""
    for name in [n for n in sys.modules if n.startswith("tessera.")]:
        if name.split(".")[1] in ("meshing", "native", "result", "sources", "shapes", "_tessera"):
            monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "tessera._tessera", None)
    for name in ("mesh", "Execution", "_tessera", "native", "sources", "meshing"):
        monkeypatch.delitem(tessera.__dict__, name, raising=False)
    obj = planar_mesh.make_planar_mesh(sketches.plate(document))
    document.recompute()
    assert not obj.isValid()
    assert "tools/build" in obj.getStatusString()
