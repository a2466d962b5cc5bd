# SPDX-License-Identifier: MIT
"""tessera.mesh() of sketches and shapes of FreeCAD, in plain Python."""

import random

import numpy as np
import pytest
from measures import assert_conforming, length_of, triangle_areas

FreeCAD = pytest.importorskip("FreeCAD", reason="FreeCAD's Python modules are not installed")
import Part  # noqa: E402
from FreeCAD import Vector  # noqa: E402

import tessera  # noqa: E402
from tessera import shapes  # noqa: E402


def rectangle(width, height, x=0.0, y=0.0):
    corners = [
        Vector(x, y), Vector(x + width, y), Vector(x + width, y + height), Vector(x, y + height)
    ]
    return [Part.LineSegment(corners[i], corners[(i + 1) % 4]) for i in range(4)]


def sketch(document, geometry, construction=(), label="Sketch"):
    new = document.addObject("Sketcher::SketchObject", label)
    for item in geometry:
        new.addGeometry(item, False)
    for item in construction:
        new.addGeometry(item, True)
    document.recompute()
    return new


def plate(document):
    """20 x 10 with a round hole of radius 2 and a spline inside."""
    spline = Part.BSplineCurve()
    spline.interpolate([Vector(2, 2), Vector(3, 5), Vector(2, 8)])
    return sketch(
        document,
        rectangle(20, 10) + [Part.Circle(Vector(12, 5), Vector(0, 0, 1), 2.0), spline],
        [Part.LineSegment(Vector(5, 1), Vector(6, 9))],
    )


def test_sketch(document):
    mesh = tessera.mesh(plate(document), size=1.0)
    assert_conforming(mesh)
    names = {f"Sketch_Geometry{i}" for i in range(6)} | {"Region1", "Outline"}
    assert set(mesh.groups) == names
    # The hole is a polygon inside the circle: at most a chord error smaller.
    circle = mesh.edges[mesh.groups["Sketch_Geometry4"].members]
    pieces = len(circle)
    hole = 0.5 * pieces * 4 * np.sin(2 * np.pi / pieces)
    assert mesh.report["area"] == pytest.approx(200 - hole, rel=1e-9)
    on_circle = mesh.nodes[circle.ravel()] - (12, 5)
    assert np.abs(np.hypot(*on_circle.T) - 2.0).max() < 1e-14
    spline = mesh.edges[mesh.groups["Sketch_Geometry5"].members]
    curve = document.Sketch.Geometry[5]
    for x, y in mesh.nodes[spline.ravel()]:
        nearest = curve.value(curve.parameter(Vector(x, y, 0)))
        assert nearest.distanceToPoint(Vector(x, y, 0)) < 1e-9
    assert length_of(mesh, spline) == pytest.approx(curve.length(), rel=0.01)


def test_second_order_nodes_lie_on_the_curves(document):
    mesh = tessera.mesh(plate(document), size=1.0, order=2)
    assert_conforming(mesh)
    members = mesh.groups["Sketch_Geometry4"].members
    middle = mesh.nodes[mesh.edge_mid_nodes[members]] - (12, 5)
    assert np.abs(np.hypot(*middle.T) - 2.0).max() < 1e-14
    # The triangles beside the circle share those nodes.
    assert np.isin(mesh.edge_mid_nodes[members], mesh.triangle_mid_nodes).all()


def test_construction_geometry_joins_on_request(document):
    mesh = tessera.mesh(plate(document), size=1.0, construction=True)
    line = mesh.edges[mesh.groups["Sketch_Geometry6"].members]
    assert length_of(mesh, line) == pytest.approx(np.hypot(1, 8))
    assert mesh.report["regions"] == 1


def test_poles_of_a_spline_are_no_construction_geometry(document):
    source = sketch(document, rectangle(20, 10))
    poles = [Vector(2, 2), Vector(6, 9), Vector(12, 1), Vector(16, 8)]
    index = source.addGeometry(Part.BSplineCurve(poles, None, None, False, 3, None, False))
    source.exposeInternalGeometry(index)
    document.recompute()
    assert len(source.Geometry) > 5
    mesh = tessera.mesh(source, size=1.0, construction=True)
    assert {name for name in mesh.groups if "Geometry" in name} == {
        f"Sketch_Geometry{i}" for i in range(5)
    }


def test_points_become_nodes_with_a_group(document):
    source = sketch(document, rectangle(20, 10) + [Part.Point(Vector(7, 3))])
    mesh = tessera.mesh(source, size=1.0)
    group = mesh.groups["Sketch_Geometry4"]
    assert group.kind == "nodes" and len(group.members) == 1
    assert mesh.nodes[group.members[0]].tolist() == [7.0, 3.0]


def test_placed_sketch_is_meshed_in_its_own_frame(document):
    source = plate(document)
    flat = tessera.mesh(source, size=1.0)
    source.Placement = FreeCAD.Placement(
        Vector(100, -30, 7), FreeCAD.Rotation(Vector(1, 2, 3), 40)
    )
    document.recompute()
    mesh = tessera.mesh(source, size=1.0)
    assert np.array_equal(mesh.nodes, flat.nodes)
    corner = source.Placement.multVec(Vector(*mesh.nodes[5], 0))
    assert np.abs(mesh.points()[5] - tuple(corner)).max() < 1e-13


def test_roles_by_number_name_and_link(document):
    source = sketch(document, rectangle(20, 10) + rectangle(4, 4, 3, 3))
    assert tessera.mesh(source, size=2).report["area"] == pytest.approx(184)
    for inner in (
        [4, 5, 6, 7],
        [f"Geometry{i}" for i in range(4, 8)],
        [f"Sketch_Geometry{i}" for i in range(4, 8)],
        [(source, tuple(shapes.edge_of_geometry(source, i) for i in range(4, 8)))],
    ):
        mesh = tessera.mesh(source, size=2, constraint=inner)
        assert mesh.report["area"] == pytest.approx(200)
        assert length_of(mesh, mesh.edges[mesh.groups["Sketch_Geometry4"].members]) == 4.0


def test_boundary_and_ignored_curves(document):
    """Open lines that the user makes a boundary; a loop left out."""
    source = sketch(document, rectangle(20, 10) + rectangle(4, 4, 3, 3))
    mesh = tessera.mesh(source, size=2, ignore=[4, 5, 6, 7])
    assert mesh.report["area"] == pytest.approx(200)
    assert "Sketch_Geometry4" not in mesh.groups
    mesh = tessera.mesh(source, size=2, constraint=[4, 5, 6, 7], boundary=[4, 5, 6, 7])
    assert mesh.report["area"] == pytest.approx(184)
    edge = shapes.edge_of_geometry(source, 5)
    mesh = tessera.mesh(source, size=2, ignore=[(source, (edge,))], constraint=[4, 6, 7])
    assert mesh.report["area"] == pytest.approx(200)
    with pytest.raises(tessera.InvalidOptionError, match="give other geometry as a source"):
        tessera.mesh(source, ignore=Part.makeCircle(2))


def test_edges_of_the_shape_and_geometry_find_each_other(document):
    source = plate(document)
    source.Placement = FreeCAD.Placement(Vector(1, 2, 3), FreeCAD.Rotation(Vector(0, 1, 0), 30))
    document.recompute()
    edges = [shapes.edge_of_geometry(source, i) for i in range(7)]
    assert edges[6] is None
    assert sorted(edges[:6]) == [f"Edge{i}" for i in range(1, 7)]
    for i, edge in enumerate(edges[:6]):
        assert shapes.geometry_of_edge(source, edge) == i
    assert shapes.geometry_of_edge(source, "Edge9") is None


def test_further_shapes_as_constraints(document):
    source = sketch(document, rectangle(20, 10))
    line = Part.makeLine(Vector(-5, 5, 0), Vector(15, 5, 0))
    mesh = tessera.mesh(source, size=1.0, constraint=line)
    kept = mesh.edges[mesh.groups["Shape2_Edge1"].members]
    assert length_of(mesh, kept) == pytest.approx(15.0)
    assert mesh.report["area"] == pytest.approx(200.0)
    ring = document.addObject("Part::Feature", "Ring")
    ring.Shape = Part.makeCircle(2, Vector(10, 5, 0))
    mesh = tessera.mesh(source, size=1.0, constraint=[ring, line])
    assert mesh.groups["Ring_Edge1"].kind == "edges"
    assert mesh.report["regions"] == 1


def test_face_with_hole_in_space(document):
    corners = [(0, 0, 0), (6, 0, 6), (6, 8, 6), (0, 8, 0), (0, 0, 0)]
    outer = Part.Wire(Part.makePolygon([Vector(*corner) for corner in corners]))
    hole = Part.Wire(Part.makeCircle(1.5, Vector(3, 4, 3), Vector(-1, 0, 1)))
    face = Part.Face([outer, hole])
    mesh = tessera.mesh(face, size=0.5, order=2)
    assert_conforming(mesh)
    assert mesh.report["messages"] == []
    points = mesh.points()
    assert np.abs(points[:, 0] - points[:, 2]).max() < 1e-13
    assert mesh.report["area"] == pytest.approx(48 * np.sqrt(2) - 2.25 * np.pi, rel=0.005)
    assert {"Edge1", "Edge5"} <= set(mesh.groups)


def test_face_of_a_solid_keeps_the_numbers_of_its_edges(document):
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    mesh = tessera.mesh((box, ["Face6"]), size=2.0)
    expected = {
        f"Box_Edge{i + 1}"
        for i, edge in enumerate(box.Shape.Edges)
        if any(edge.isSame(other) for other in box.Shape.Faces[5].Edges)
    }
    assert {name for name in mesh.groups if "Edge" in name} == expected
    assert np.abs(mesh.points()[:, 2] - 10).max() < 1e-13
    assert mesh.report["area"] == pytest.approx(100.0)


def test_list_of_shapes(document):
    disk = Part.Face(Part.Wire(Part.makeCircle(3, Vector(10, 5, 0))))
    mesh = tessera.mesh([plate(document), disk], size=1.0)
    assert_conforming(mesh)
    assert mesh.operands == ["Sketch", "Shape2"]
    assert mesh.report["area"] == pytest.approx(200.0, rel=0.02)
    assert triangle_areas(mesh)[mesh.groups["Shape2"].members].sum() == pytest.approx(
        9 * np.pi, rel=0.02
    )


def test_sketches_in_one_plane_with_different_placements(document):
    first = sketch(document, rectangle(10, 10), label="First")
    second = sketch(document, rectangle(10, 10), label="Second")
    for source, shift in ((first, 0), (second, 5)):
        source.Placement = FreeCAD.Placement(
            Vector(shift, 0, 0), FreeCAD.Rotation(Vector(1, 0, 0), 90)
        )
    document.recompute()
    mesh = tessera.mesh([first, second], size=1.0)
    assert mesh.report["area"] == pytest.approx(150.0)
    assert np.abs(mesh.points()[:, 1]).max() < 1e-12


def test_empty_sketch(document):
    with pytest.raises(tessera.InvalidInputError, match="Sketch has no geometry"):
        tessera.mesh(sketch(document, []))


def test_open_sketch_names_the_geometry(document):
    source = sketch(document, rectangle(20, 10)[:3])
    source.Placement = FreeCAD.Placement(Vector(0, 0, 50), FreeCAD.Rotation())
    with pytest.raises(tessera.NoInsideError, match="not closed") as caught:
        tessera.mesh(source, size=1.0)
    places = {place.element: place for place in caught.value.places}
    assert set(places) == {"Geometry0", "Geometry2"}
    assert places["Geometry0"].curve == "Sketch_Geometry0"
    assert places["Geometry0"].point == (0.0, 0.0, 50.0)


def test_a_circle_and_a_spline_that_approximates_it_are_one_curve():
    circle = Part.Circle(Vector(1, 2, 0), Vector(0, 0, 1), 3.0)
    spline = circle.toBSpline()
    apart = max(
        abs((spline.value(0.01 * i) - circle.Center).Length - 3.0) for i in range(628)
    )
    assert 1e-9 < apart < 1e-6  # crosses the circle many times
    alone = tessera.mesh(circle.toShape())
    both = tessera.mesh([circle.toShape(), spline.toShape()])
    assert both.report["regions"] == 1
    assert both.report["crossings"] == 0
    assert both.report["area"] == pytest.approx(alone.report["area"], rel=1e-12)
    assert len(both.triangles) == len(alone.triangles)
    assert any("runs along another one" in message for message in both.report["messages"])
    assert_conforming(both)


def drawn_again(circle, chance):
    """The circle, or an arc of it, as another kind of curve or the same."""
    start = chance.uniform(0.0, 6.0)
    arc = Part.Arc(circle, start, start + chance.uniform(0.3, 6.0))
    return chance.choice(
        (circle.toBSpline(), circle.toNurbs(), arc.toBSpline(), arc.toNurbs(), arc)
    ).toShape()


@pytest.mark.parametrize("seed", range(12))
def test_what_is_drawn_again_as_another_kind_of_curve_changes_nothing(seed):
    chance = random.Random(seed)
    circles = []
    for _ in range(5):
        center = Vector(chance.uniform(0, 10), chance.uniform(0, 10), 0)
        circles.append(Part.Circle(center, Vector(0, 0, 1), chance.uniform(1, 5)))
    once = [circle.toShape() for circle in circles]
    again = once + [drawn_again(circle, chance) for circle in circles]
    expected = tessera.mesh(once, fill="all", refine=False).report
    report = tessera.mesh(again, fill="all", refine=False).report
    assert report["regions"] == expected["regions"]
    # Arcs that end on a circle give it further points: chords nearer to it.
    assert report["area"] == pytest.approx(expected["area"], rel=2e-3)


def test_an_outline_thinner_than_the_tolerance_is_refused_and_says_why(document):
    arc = Part.Arc(Vector(0, 0, 0), Vector(5, 0.15, 0), Vector(10, 0, 0))
    source = sketch(document, [arc, Part.LineSegment(Vector(10, 0), Vector(0, 0))])
    assert tessera.mesh(source).report["area"] == pytest.approx(1.0, rel=0.01)
    with pytest.raises(tessera.NoInsideError, match="weld tolerance 0.2 .* smaller tolerance"):
        tessera.mesh(source, weld=0.2)


@pytest.mark.parametrize("places", [(0, 10, 0), (0, 10, -6, 4), (0, 1, 5, 8)], ids=str)
def test_a_spline_that_runs_forth_and_back_on_a_line(places):
    way = Vector(0.8, 0.6, 0)
    curve = Part.BezierCurve()
    curve.setPoles([Vector(1, 1, 0) + way * place for place in places])
    square = Part.makePlane(12, 12)
    mesh = tessera.mesh([square, curve.toShape()])
    assert mesh.report["area"] == pytest.approx(144, rel=1e-12)
    assert len(mesh.triangles) < 4000
    along = [(curve.value(0.001 * i) - Vector(1, 1, 0)).dot(way) for i in range(1001)]
    edges = mesh.edges[mesh.groups["Shape2_Edge1"].members]
    assert length_of(mesh, edges) == pytest.approx(max(along) - min(along), abs=1e-3)


def test_lines_that_overlap_in_part_are_named(document):
    sides = rectangle(20, 10)
    sides[0] = Part.LineSegment(Vector(0, 0), Vector(12, 0))
    rest = Part.LineSegment(Vector(8, 0), Vector(20, 0))
    source = sketch(document, [*sides, rest])
    with pytest.raises(tessera.NoInsideError, match="overlap between .8, 0. and .12, 0.") as caught:
        tessera.mesh(source, size=1.0)
    assert {place.element for place in caught.value.places} == {"Geometry0", "Geometry4"}
    assert tessera.mesh(source, size=1.0, fill="all").report["area"] == pytest.approx(200.0)


def test_roles_that_leave_no_outline_are_named(document):
    source = sketch(document, rectangle(20, 10))
    with pytest.raises(tessera.NoInsideError, match="No outline is left") as caught:
        tessera.mesh(source, size=1.0, constraint=[1, 3])
    assert [place.element for place in caught.value.places] == ["Geometry1", "Geometry3"]


def test_gap_below_and_above_the_weld_tolerance(document):
    sides = rectangle(20, 10)
    sides[3] = Part.LineSegment(Vector(0, 10), Vector(0, 0.1))
    source = sketch(document, sides)
    with pytest.raises(tessera.NoInsideError) as caught:
        tessera.mesh(source, size=1.0)
    assert "(0, 0) of Sketch_Geometry0 and (0, 0.1) of Sketch_Geometry3, 0.1 apart" in str(
        caught.value
    )
    places = {place.element: place.point for place in caught.value.places}
    assert places["Geometry0"] == (0.0, 0.0, 0.0)
    assert places["Geometry3"] == pytest.approx((0.0, 0.1, 0.0))
    mesh = tessera.mesh(source, size=1.0, weld=0.2)
    assert_conforming(mesh)
    assert mesh.report["welded"] == 1 and mesh.report["messages"]
    sides[3] = Part.LineSegment(Vector(0, 10), Vector(0, 1e-7))
    closed = tessera.mesh(sketch(document, sides, label="Closed"), size=1.0)
    assert closed.report["weld"] >= 1e-6 and closed.report["area"] == pytest.approx(200.0)


def test_an_open_outline_around_a_closed_loop_is_told(document):
    sides = rectangle(20, 10)
    sides[3] = Part.LineSegment(Vector(0, 10), Vector(0, 0.1))
    source = sketch(document, [*sides, Part.Circle(Vector(10, 5), Vector(0, 0, 1), 2)])
    mesh = tessera.mesh(source, size=1.0)
    assert mesh.report["area"] == pytest.approx(4 * np.pi, rel=0.05)
    left_out, reason = mesh.report["messages"]
    assert "Sketch_Geometry0" in left_out and "1 more" in left_out
    assert "(0, 0) of Sketch_Geometry0 and (0, 0.1) of Sketch_Geometry3, 0.1 apart" in reason


def test_constraints_outside_the_outline_are_left_out_and_told(document):
    lines = [
        Part.LineSegment(Vector(10, 5), Vector(30, 5)),
        Part.LineSegment(Vector(2, 2), Vector(8, 2)),
        Part.LineSegment(Vector(40, 2), Vector(48, 2)),
    ]
    source = sketch(document, rectangle(20, 10) + lines)
    mesh = tessera.mesh(source, size=1.0)
    assert mesh.report["area"] == pytest.approx(200.0)
    assert mesh.report["messages"][0] == (
        "Outside the outline, and therefore left out: Sketch_Geometry6; "
        "parts of Sketch_Geometry4."
    )
    kept = mesh.edges[mesh.groups["Sketch_Geometry4"].members]
    assert length_of(mesh, kept) == pytest.approx(10.0)
    inside = mesh.edges[mesh.groups["Sketch_Geometry5"].members]
    assert length_of(mesh, inside) == pytest.approx(6.0)
    assert "Sketch_Geometry6" not in mesh.groups
    # A user's boundary that crosses the outline loses its outer part as well, and that is told.
    mesh = tessera.mesh(source, size=1.0, boundary=[4])
    assert any("parts of Sketch_Geometry4" in text for text in mesh.report["messages"])


def test_overlapping_lines_enclose_nothing(document):
    line = Part.LineSegment(Vector(0, 0), Vector(5, 0))
    back = Part.LineSegment(Vector(5, 0), Vector(0, 0))
    with pytest.raises(tessera.NoInsideError, match="no area"):
        tessera.mesh(sketch(document, [line, back]))


def test_shapes_that_are_not_planar():
    for shape, word in (
        (Part.makeBox(1, 2, 3), "out of the plane"),
        (Part.makeSphere(3), "spherical"),
        (Part.makeCylinder(2, 5).Faces[0], "cylindrical"),
    ):
        with pytest.raises(tessera.InvalidInputError, match=word):
            tessera.mesh(shape)


def test_sketches_of_different_planes_are_refused_by_name(document):
    first = sketch(document, rectangle(10, 10), label="First")
    second = sketch(document, rectangle(10, 10), label="Second")
    second.Placement = FreeCAD.Placement(Vector(0, 0, 2.5), FreeCAD.Rotation())
    with pytest.raises(tessera.InvalidInputError, match="Second_Geometry0.*2.5") as caught:
        tessera.mesh([first, second])
    place = caught.value.places[0]
    assert (place.source, place.element) == (1, "Geometry0")
    assert place.point[2] == pytest.approx(2.5)


def test_null_shape_lost_face_and_mixed_sources(document):
    with pytest.raises(tessera.InvalidInputError, match="empty"):
        tessera.mesh(Part.Shape())
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    with pytest.raises(tessera.InvalidInputError, match="Face77"):
        tessera.mesh((box, ["Face77"]))
    with pytest.raises(tessera.InvalidInputError, match="together"):
        tessera.mesh([Part.makeCircle(2), [(0, 0), (1, 0), (0, 1)]])


def test_unknown_curves_are_refused(document):
    source = sketch(document, rectangle(10, 10))
    for options in ({"constraint": ["Geometry9"]}, {"boundary": [9]}, {"constraint": "Edge77"}):
        with pytest.raises(tessera.InvalidOptionError, match="Geometry0"):
            tessera.mesh(source, **options)


def test_every_sketch_of_the_corpora_has_freecads_area(corpora):
    """Within what chords cut off; second order follows the curves closer."""
    count = 0
    for path in sorted((corpora / "cad" / "native").glob("*.[fF][cC][sS][tT][dD]")):
        document = FreeCAD.openDocument(str(path))
        for source in document.Objects:
            if not shapes.is_sketch(source):
                continue
            try:
                area = Part.makeFace(source.Shape, "Part::FaceMakerBullseye").Area
            except Part.OCCError:
                continue
            mesh = tessera.mesh(source, size=source.Shape.BoundBox.DiagonalLength / 150)
            curved = [e for e in source.Shape.Edges if not isinstance(e.Curve, Part.Line)]
            size = mesh.report["default_size"]
            bend = sum(edge.Length for edge in curved) * size / 8
            assert abs(mesh.report["area"] - area) <= bend + 1e-9 * area, source.Label
            assert_conforming(mesh)
            count += 1
        FreeCAD.closeDocument(document.Name)
    assert count >= 30


def curves_of_every_kind():
    """(name, curve of a sketch), closed or to be closed by a line."""
    center, up = Vector(3, 2), Vector(0, 0, 1)
    ellipse = Part.Ellipse(Vector(8, 2), Vector(3, 4), center)
    parabola = Part.Parabola(Vector(2, 0), Vector(0, 0), up)
    hyperbola = Part.Hyperbola(Vector(5, 0), Vector(0, 3), Vector(0, 0))
    rational = Part.BSplineCurve()
    poles = [Vector(0, 0), Vector(4, -1), Vector(6, 5), Vector(1, 6)]
    rational.buildFromPolesMultsKnots(poles, [4, 4], [0, 1], False, 3, [1, 2, 0.5, 1])
    periodic = Part.BSplineCurve()
    periodic.buildFromPoles([Vector(0, 0), Vector(5, 0), Vector(6, 5), Vector(0, 4)], True, 3)
    return [
        ("circle", Part.Circle(center, up, 4)),
        ("arc", Part.ArcOfCircle(Part.Circle(center, up, 4), 0.3, 4)),
        ("ellipse", ellipse),
        ("ellipse arc", Part.ArcOfEllipse(ellipse, 0.3, 4)),
        ("parabola", Part.ArcOfParabola(parabola, -4, 5)),
        ("hyperbola", Part.ArcOfHyperbola(hyperbola, -1, 1.2)),
        ("rational spline", rational),
        ("periodic spline", periodic),
    ]


def area_inside(curve):
    """By polygons of 10,000 and 20,000 points; FreeCAD's own area is off by 1e-4 for splines."""
    parameters = np.linspace(curve.FirstParameter, curve.LastParameter, 20001)
    points = np.array([tuple(curve.value(t)) for t in parameters])
    areas = []
    for ring in (points[::2], points):
        x, y = ring[:, 0], ring[:, 1]
        areas.append(0.5 * abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))))
    return areas[1] + (areas[1] - areas[0]) / 3.0


@pytest.mark.parametrize("name, curve", curves_of_every_kind(), ids=lambda value: str(value)[:12])
def test_every_kind_of_curve(document, name, curve):
    geometry = [curve]
    start = curve.value(curve.FirstParameter)
    end = curve.value(curve.LastParameter)
    if start.distanceToPoint(end) > 1e-6:
        geometry.append(Part.LineSegment(end, start))
    source = sketch(document, geometry)
    source.Placement = FreeCAD.Placement(Vector(7, -3, 2), FreeCAD.Rotation(Vector(1, 1, 0), 50))
    document.recompute()
    mesh = tessera.mesh(source, order=2)
    assert_conforming(mesh)
    assert mesh.report["area"] == pytest.approx(area_inside(curve), rel=1e-6)
    members = mesh.groups["Sketch_Geometry0"].members
    nodes = np.concatenate([mesh.edges[members].ravel(), mesh.edge_mid_nodes[members]])
    edge = curve.toShape()
    for x, y in mesh.nodes[np.unique(nodes)]:
        assert edge.distToShape(Part.Vertex(x, y, 0))[0] < 1e-9
