# SPDX-License-Identifier: MIT
"""Sizes at the curves, vertices and faces of FreeCAD's sketches and shapes."""

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD", reason="FreeCAD's Python modules are not installed")
import Part  # noqa: E402
from FreeCAD import Placement, Rotation, Vector  # noqa: E402

import tessera  # noqa: E402


@pytest.fixture
def sketch(document):
    """20 x 10 with a round hole, tilted and moved in space."""
    new = document.addObject("Sketcher::SketchObject", "Sketch")
    corners = [Vector(0, 0), Vector(20, 0), Vector(20, 10), Vector(0, 10)]
    for i in range(4):
        new.addGeometry(Part.LineSegment(corners[i], corners[(i + 1) % 4]), False)
    new.addGeometry(Part.Circle(Vector(12, 5), Vector(0, 0, 1), 2.0), False)
    new.Placement = Placement(Vector(7, -3, 2), Rotation(Vector(1, 1, 0), 40))
    document.recompute()
    return new


def mean_edge(mesh, place, radius):
    ends = np.concatenate([mesh.triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    a, b = mesh.nodes[ends[:, 0]], mesh.nodes[ends[:, 1]]
    mask = np.linalg.norm(0.5 * (a + b) - place, axis=1) < radius
    return np.linalg.norm(b - a, axis=1)[mask].mean()


def on_hole(mesh, group):
    edges = mesh.edges[mesh.groups[group].members]
    return np.linalg.norm(mesh.nodes[edges[:, 0]] - mesh.nodes[edges[:, 1]], axis=1)


@pytest.mark.parametrize("curve", ["Geometry4", 4, "Sketch_Geometry4"])
def test_on_a_geometry_of_a_sketch(sketch, curve):
    mesh = tessera.mesh(sketch, 2.0, size_on={curve: 0.2})
    assert on_hole(mesh, "Sketch_Geometry4").max() < 0.21


def test_on_an_edge_in_the_3d_view(sketch):
    edges = sketch.Shape.Edges
    hole = next(f"Edge{i + 1}" for i, e in enumerate(edges) if len(e.Vertexes) == 1)
    mesh = tessera.mesh(sketch, 2.0, size_on=[((sketch, [hole]), 0.2)])
    assert on_hole(mesh, "Sketch_Geometry4").max() < 0.21
    with pytest.raises(tessera.InvalidOptionError, match="not a curve of what is meshed"):
        tessera.mesh(sketch, 2.0, size_on=[((sketch, ["Edge99"]), 0.2)])


def test_at_vertices_and_points_in_space(sketch):
    number = next(
        i + 1
        for i, v in enumerate(sketch.Shape.Vertexes)
        if v.Point.distanceToPoint(sketch.Placement.multVec(Vector(20, 10))) < 1e-9
    )
    for place in (
        f"Vertex{number}",
        (sketch, f"Vertex{number}"),
        sketch.Placement.multVec(Vector(20, 10)),
    ):
        mesh = tessera.mesh(sketch, 2.0, size_at=[(place, 0.1, 0.5)])
        assert mean_edge(mesh, (20, 10), 0.4) == pytest.approx(0.1, rel=0.2)
        assert mean_edge(mesh, (0, 0), 2.0) > 1.2
    with pytest.raises(tessera.InvalidOptionError, match="no vertex called 'Vertex99'"):
        tessera.mesh(sketch, 2.0, size_at=[("Vertex99", 0.1)])


def test_in_one_of_two_faces():
    left, right = Part.makePlane(4, 4), Part.makePlane(4, 4, Vector(4, 0, 0))
    mesh = tessera.mesh([left, right], 1.0, size_in={1: 0.2})
    assert mean_edge(mesh, (6, 2), 1.5) == pytest.approx(0.2, rel=0.1)
    assert mean_edge(mesh, (0.5, 2), 1.0) > 0.5
    around = tessera.mesh(Part.Compound([left, right]), 1.0, size_in=[(Vector(6, 2, 0), 0.2)])
    assert mean_edge(around, (6, 2), 1.5) == pytest.approx(0.2, rel=0.1)
    face = tessera.mesh(Part.Compound([left, right]), 1.0, size_in=[("Face2", 0.2)])
    assert mean_edge(face, (6, 2), 1.5) == pytest.approx(0.2, rel=0.1)
    with pytest.raises(tessera.InvalidOptionError, match="no face called 'Face3'"):
        tessera.mesh(Part.Compound([left, right]), 1.0, size_in=[("Face3", 0.2)])
    with pytest.raises(tessera.InvalidOptionError, match="no source called 5"):
        tessera.mesh([left, right], 1.0, size_in={5: 0.2})


def test_curvature_and_chord_error(sketch):
    pieces = [
        len(on_hole(tessera.mesh(sketch, 2.0, **options), "Sketch_Geometry4"))
        for options in ({}, {"curvature": 60}, {"chord_error": 0.0005})
    ]
    assert pieces[0] == 20
    assert pieces[1] == 60
    # sagitta = radius (1 - cos(pi / n))
    assert 2.0 * (1 - np.cos(np.pi / pieces[2])) < 0.0005
    assert pieces[2] == pytest.approx(np.pi / np.arccos(1 - 0.0005 / 2), abs=1.1)
