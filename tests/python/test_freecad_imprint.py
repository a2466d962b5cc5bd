# SPDX-License-Identifier: MIT
"""tessera.imprint() and tessera.overlay() with FreeCAD's objects and faces."""

import math
from pathlib import Path

import pytest

import tessera

FreeCAD = pytest.importorskip("FreeCAD")
import Part
from FreeCAD import Vector


def polygon(z, *corners):
    points = [Vector(x, y, z) for x, y in corners]
    return Part.Face(Part.makePolygon([*points, points[0]]))


def disk(z, x, y, radius):
    return Part.Face(Part.Wire(Part.makeCircle(radius, Vector(x, y, z))))


def strips(z):
    return [
        polygon(z, (0, 0), (3, 0), (5, 8), (0, 8)),
        polygon(z, (3, 0), (9, 0), (7, 8), (5, 8)),
        polygon(z, (9, 0), (12, 0), (12, 8), (7, 8)),
    ]


def disk_and_rest(z):
    """A disk and three pieces of the plate around it."""
    whole = disk(z, 6, 4, 2.5)
    parts = [
        polygon(z, (0, 0), (12, 0), (12, 4), (0, 4)),
        polygon(z, (0, 4), (6, 4), (6, 8), (0, 8)),
        polygon(z, (6, 4), (12, 4), (12, 8), (6, 8)),
    ]
    return [whole] + [part.cut(whole).Faces[0] for part in parts]


def test_three_sources_and_four_targets_give_faces_on_both_planes():
    sources, targets = strips(0), disk_and_rest(10)
    result = tessera.imprint(sources, targets)
    assert len(result.cells) == 10 and not result.left
    for side, faces, z in (
        (result.sources, result.source_faces(), 0.0),
        (result.targets, result.target_faces(), 10.0),
    ):
        originals = sources if side is result.sources else targets
        for one, own, original in zip(side, faces, originals):
            assert len(own) == len(one.cells)
            assert one.area == pytest.approx(original.Area, rel=1e-12)
            for face, cell in zip(own, one.cells):
                assert face.isValid()
                assert face.Area == pytest.approx(result.cells[cell].area, rel=1e-9)
                assert face.BoundBox.ZMin == pytest.approx(z, abs=1e-9)
    # The cells' areas are those of OpenCASCADE's own intersections.
    for cell in result.cells:
        below = sources[cell.sources[0]].copy()
        below.translate(Vector(0, 0, 10))
        assert below.common(targets[cell.targets[0]]).Area == pytest.approx(cell.area, rel=1e-6)
    shape = result.to_shape()
    assert shape.isValid()
    upper = shape.SubShapes[1]
    arcs = [edge for edge in upper.Edges if isinstance(edge.Curve, Part.Circle)]
    assert sum(arc.Length for arc in {e.hashCode(): e for e in arcs}.values()) == pytest.approx(
        5 * math.pi
    )


def test_solids_sketches_and_links(document):
    import Sketcher  # noqa: F401

    box = document.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 4, 2, 3
    sketch = document.addObject("Sketcher::SketchObject", "Top")
    sketch.addGeometry(Part.Circle(Vector(2, 1, 0), Vector(0, 0, 1), 0.5), False)
    sketch.Placement = FreeCAD.Placement(Vector(0, 0, 7), FreeCAD.Rotation())
    document.recompute()
    bottom = next(
        f"Face{i + 1}" for i, face in enumerate(box.Shape.Faces) if face.BoundBox.ZMax < 1e-9
    )
    result = tessera.imprint((box, [bottom]), sketch)
    assert result.sources[0].name.startswith("Box")
    assert result.targets[0].area == pytest.approx(math.pi / 4)
    assert len(result.cells) == 2
    (face,) = result.target_faces()[0]
    assert face.BoundBox.ZMin == pytest.approx(7.0)
    with pytest.raises(tessera.InvalidInputError, match="tilted by 90 degrees") as caught:
        tessera.imprint((box, [bottom]), box)
    assert caught.value.places[0].source == 1
    assert caught.value.places[0].element == "Face1"
    with pytest.raises(tessera.InvalidInputError) as caught:
        tessera.imprint((box, [bottom]), (box, ["Face6", "Face2"]))
    assert caught.value.places[0].element == "Face2"


def test_parts_that_contain_the_faces_are_seen(document):
    part = document.addObject("App::Part", "Part")
    upper = document.addObject("Part::Feature", "Upper")
    upper.Shape = polygon(0, (0, 0), (1, 0), (1, 1), (0, 1))
    part.addObject(upper)
    part.Placement = FreeCAD.Placement(Vector(3, 0, 5), FreeCAD.Rotation())
    document.recompute()
    result = tessera.imprint(polygon(0, (3, 0), (4, 0), (4, 1), (3, 1)), upper)
    assert not result.left and len(result.cells) == 1
    assert result.target_faces()[0][0].BoundBox.Center.distanceToPoint(Vector(3.5, 0.5, 5)) < 1e-6


def test_the_bundled_example():
    folder = Path(__file__).resolve().parents[2] / "resources" / "examples"
    result = tessera.imprint(folder / "imprint_sources.brep", folder / "imprint_targets.brep")
    assert [side.name for side in result.sources] == [f"imprint_sources_Face{i}" for i in (1, 2, 3)]
    assert len(result.targets) == 4 and len(result.cells) == 10 and not result.left
    assert result.area == pytest.approx(96.0)


def test_overlay_gives_part_faces():
    cells = tessera.overlay([disk(0, 0, 0, 1), disk(0, 1, 0, 1)]).cells
    lens = 2 * math.pi / 3 - math.sqrt(3) / 2
    faces = cells.to_faces()
    assert len(faces) == len(cells) == 3
    assert cells.to_shape().isValid()
    for cell, face in zip(cells, faces):
        exact = lens if len(cell.operands) == 2 else math.pi - lens
        assert face.Area == pytest.approx(exact, rel=1e-9)
    assert len(cells.to_shape().Edges) == 6


def test_overlay_of_placed_sketches_lies_in_space(document):
    sketches = []
    for number in range(2):
        sketch = document.addObject("Sketcher::SketchObject", f"Sketch{number}")
        sketch.addGeometry(Part.Circle(Vector(number, 0, 0), Vector(0, 0, 1), 1), False)
        sketch.Placement = FreeCAD.Placement(
            Vector(0, 5, 0), FreeCAD.Rotation(Vector(1, 0, 0), 90)
        )
        sketches.append(sketch)
    document.recompute()
    shape = tessera.overlay(sketches).difference().to_shape()
    box = shape.BoundBox
    assert (box.YMin, box.YMax) == pytest.approx((5, 5), abs=1e-6)
    assert box.ZMax == pytest.approx(1.0, abs=1e-6)


def test_a_source_with_several_faces_is_one_operand():
    two = Part.Compound([polygon(0, (0, 0), (2, 0), (2, 2), (0, 2)),
                         polygon(0, (2, 0), (4, 0), (4, 2), (2, 2))])
    bar = polygon(0, (1, 1), (3, 1), (3, 3), (1, 3))
    overlay = tessera.overlay([two, bar])
    assert overlay.difference().area == pytest.approx(6.0)
    assert overlay.intersection().area == pytest.approx(2.0)
    assert {cell.operands for cell in overlay.cells} == {(0,), (0, 1), (1,)}
