# SPDX-License-Identifier: MIT
"""Booleans of sketches as document objects."""

import math

import FreeCAD
import Part
import pytest
import sketches
from FreeCAD import Vector

import tessera
from tessera.objects.boolean import OPERATIONS, make_boolean


def circle(document, name, x, radius=1.0):
    sketch = sketches.new_sketch(document, name)
    sketch.addGeometry(Part.Circle(Vector(x, 0, 0), Vector(0, 0, 1), radius), False)
    document.recompute()
    return sketch


LENS = 2 * math.pi / 3 - math.sqrt(3) / 2
AREAS = {
    "Union": 2 * math.pi - LENS,
    "Intersection": LENS,
    "Difference": math.pi - LENS,
    "Symmetric difference": 2 * math.pi - 2 * LENS,
    "Cells": 2 * math.pi - LENS,
}


@pytest.fixture
def pair(document):
    return [circle(document, "A", 0), circle(document, "B", 1)]


@pytest.mark.parametrize("operation", OPERATIONS)
def test_operations(document, pair, operation):
    obj = make_boolean(pair, operation)
    document.recompute()
    assert obj.isValid()
    assert obj.Shape.isValid()
    assert obj.Shape.Area == pytest.approx(AREAS[operation], rel=1e-9)
    assert float(obj.Area) == pytest.approx(AREAS[operation], rel=1e-9)
    assert all(isinstance(edge.Curve, Part.Circle) for edge in obj.Shape.Edges)


def test_it_follows_its_sketches(document, pair):
    obj = make_boolean(pair, "Intersection")
    document.recompute()
    geometry = Part.Circle(Vector(5, 0, 0), Vector(0, 0, 1), 1)
    pair[1].delGeometry(0)
    pair[1].addGeometry(geometry, False)
    document.recompute()
    assert obj.Cells == 0 and not obj.Shape.Faces
    pair[1].delGeometry(0)
    pair[1].addGeometry(Part.Circle(Vector(0, 0, 0), Vector(0, 0, 1), 0.5), False)
    document.recompute()
    assert obj.Shape.Area == pytest.approx(0.25 * math.pi)


def test_kept_cells_are_found_again(document, pair):
    obj = make_boolean(pair, "Cells", KeptCells=[Vector(-0.5, 0, 0), Vector(0.5, 0, 0)])
    document.recompute()
    assert len(obj.Shape.Faces) == 2 and obj.Cells == 3
    assert obj.CellSources == ["1", "1+2"] or obj.CellSources == ["1+2", "1"]
    assert obj.Shape.Area == pytest.approx(math.pi)


def test_undo_redo_save_and_reload(document, pair, tmp_path):
    document.openTransaction("Boolean")
    obj = make_boolean(pair, "Union")
    document.recompute()
    document.commitTransaction()
    document.openTransaction("Change")
    obj.Operation = "Intersection"
    document.recompute()
    document.commitTransaction()
    document.undo()
    assert obj.Shape.Area == pytest.approx(AREAS["Union"])
    document.redo()
    assert obj.Shape.Area == pytest.approx(AREAS["Intersection"])
    name = obj.Name
    document.saveAs(str(tmp_path / "boolean.FCStd"))
    FreeCAD.closeDocument(document.Name)
    opened = FreeCAD.openDocument(str(tmp_path / "boolean.FCStd"))
    again = opened.getObject(name)
    assert again.Proxy.Type == "Tessera::Boolean"
    assert again.Shape.Area == pytest.approx(AREAS["Intersection"])
    again.Operation = "Difference"
    opened.recompute()
    assert again.Shape.Area == pytest.approx(AREAS["Difference"])


def test_placed_sketches_give_faces_in_their_plane(document, pair):
    placement = FreeCAD.Placement(Vector(1, 2, 3), FreeCAD.Rotation(Vector(0, 1, 0), 90))
    for sketch in pair:
        sketch.Placement = placement
    obj = make_boolean(pair, "Union")
    document.recompute()
    box = obj.Shape.BoundBox
    assert (box.XMin, box.XMax) == pytest.approx((1, 1), abs=1e-6)
    assert obj.Shape.Area == pytest.approx(AREAS["Union"])


def in_container(document, kind, sketch, *offset):
    container = document.addObject(kind, "Container")
    container.addObject(sketch)
    container.Placement.Base = Vector(*offset)
    document.recompute()
    return container


def test_sketches_are_combined_where_the_user_sees_them(document):
    """Squares of side 4, in a body at (10, 0), in a part at (12, 2), and outside of any."""
    squares = [sketches.new_sketch(document, name) for name in "ABC"]
    for square, x in zip(squares, (0, 0, 13)):
        sketches.add_rectangle(square, x, 0, 4, 4)
    in_container(document, "PartDesign::Body", squares[0], 10, 0, 0)
    in_container(document, "App::Part", squares[1], 12, 2, 0)
    a, b, c = squares
    for pair, box, area in (
        ([a, b], (12, 2, 14, 4), 4),
        ([b, a], (12, 2, 14, 4), 4),
        ([a, c], (13, 0, 14, 4), 4),
        ([c, b], (13, 2, 16, 4), 6),
    ):
        obj = make_boolean(pair, "Intersection")
        document.recompute()
        found = obj.Shape.BoundBox
        assert (found.XMin, found.YMin, found.XMax, found.YMax) == pytest.approx(box)
        assert obj.Shape.Area == pytest.approx(area)
        overlay = tessera.overlay(pair).intersection()
        assert overlay.area == pytest.approx(area)
        assert overlay.to_shape().BoundBox.XMax == pytest.approx(box[2])
    alone = make_boolean([b], "Union")
    document.recompute()
    assert alone.Shape.BoundBox.XMin == pytest.approx(12)


@pytest.mark.parametrize("kind", ["App::Part", "PartDesign::Body"])
def test_it_follows_the_container_of_a_source(document, kind, pair):
    obj = make_boolean(pair, "Intersection")
    container = in_container(document, kind, pair[1], 0, 0, 0)
    assert obj.Shape.Area == pytest.approx(LENS)
    outer = in_container(document, "App::Part", container, 0, 0, 0)
    for moved in (container, outer):
        moved.Placement.Base = Vector(-1, 0, 0)
        document.recompute()
        assert obj.Shape.Area == pytest.approx(math.pi)
        assert document.recompute() == 0, "nothing moved: nothing is computed"
        moved.Placement.Base = Vector(0, 0, 0)
        document.recompute()
        assert obj.Shape.Area == pytest.approx(LENS)


def test_in_a_part_it_stays_where_its_sources_are_seen(document, pair):
    obj = make_boolean(pair, "Union")
    document.recompute()
    part = in_container(document, "App::Part", obj, 0, 5, 0)
    for y in (5, 7):
        part.Placement.Base = Vector(0, y, 0)
        document.recompute()
        seen = obj.Shape.copy()
        seen.Placement = part.Placement.multiply(seen.Placement)
        assert seen.BoundBox.YMax == pytest.approx(1, abs=1e-6)


def test_what_is_made_from_it_is_refused(document, pair):
    obj = make_boolean(pair, "Union")
    other = make_boolean([obj], "Union")
    document.recompute()
    for owner, words in ((obj, "its own source"), (other, "which it is made from")):
        obj.Sources = [(pair[0], [""]), (owner, [""])]
        document.recompute()
        assert not obj.isValid()
        assert words in obj.getStatusString()
        assert obj.Shape.Area == pytest.approx(AREAS["Union"])
        obj.Sources = [(sketch, [""]) for sketch in pair]
        document.recompute()
        assert obj.isValid() and other.isValid()


def test_an_empty_result_is_told(document, pair):
    pair[1].Placement.Base = Vector(5, 0, 0)
    document.recompute()
    obj = make_boolean(pair, "Intersection")
    document.recompute()
    assert obj.isValid() and not obj.Shape.Faces
    assert obj.Messages == ["The result is empty. No place is covered by all 2 operands."]
    line = sketches.new_sketch(document, "Line")
    sketches.add_polygon(line, [(0, 0), (1, 0), (1, 1)], closed=False)
    document.recompute()
    obj.Sources = [(line, [""])]
    document.recompute()
    assert "2 ends are free" in obj.Messages[-1]
    (text,) = tessera.overlay([Part.Vertex(0, 0, 0)]).union().report["messages"]
    assert "There are no curves" in text


def test_bad_sources_keep_the_shape_and_are_told(document, pair):
    obj = make_boolean(pair, "Union")
    document.recompute()
    obj.Sources = []
    document.recompute()
    assert not obj.isValid()
    assert "no source" in obj.getStatusString()
    assert obj.Shape.Area == pytest.approx(AREAS["Union"])
    with pytest.raises(tessera.Error):
        tessera.overlay([])


def test_what_cannot_be_made_leaves_nothing_behind(document, pair):
    before = [obj.Name for obj in document.Objects]
    for sources, operation, values in (
        ([], "Union", {}),
        (pair, "Sum", {}),
        (pair, "Union", {"Priority": "Middle"}),
        (pair, "Union", {"NoSuchProperty": 1}),
    ):
        with pytest.raises((tessera.Error, ValueError, AttributeError)):
            make_boolean(sources, operation, **values)
        assert [obj.Name for obj in document.Objects] == before
