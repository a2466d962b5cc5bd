# SPDX-License-Identifier: MIT
"""Cells that the user has picked, found again when the sources change, or told to be lost."""

import math

import FreeCAD
import imprints
import pytest
import sketches
from FreeCAD import Vector

from tessera.objects.boolean import make_boolean
from tessera.objects.imprinted_faces import make_imprinted_faces

AT_BOTH = Vector(3, 1, 0)
AT_FIRST = Vector(1, 1, 0)


def square(document, name, x, y=0, side=4):
    sketch = sketches.new_sketch(document, name)
    sketches.add_rectangle(sketch, x, y, side, side)
    document.recompute()
    return sketch


def move(sketch, x, y=0):
    sketch.Placement = FreeCAD.Placement(Vector(x, y, 0), FreeCAD.Rotation())
    sketch.Document.recompute()


@pytest.fixture
def pair(document):
    """Two squares of side 4 that share a strip of width 2."""
    made = square(document, "First", 0), square(document, "Second", 2)
    made[1].Label = "Zweites"
    return made


def picked(document, sources, *points, **values):
    obj = make_boolean(sources, "Cells", KeptCells=list(points), **values)
    document.recompute()
    assert obj.isValid(), obj.getStatusString()
    return obj


def test_what_covers_a_kept_cell_is_noted(document, pair):
    obj = picked(document, pair, AT_BOTH, AT_FIRST)
    assert obj.KeptCellCovers == ["First+Second", "First"]
    assert obj.Shape.Area == pytest.approx(16)
    assert not obj.Messages


def test_it_follows_as_long_as_its_point_is_in_it(document, pair):
    obj = picked(document, pair, AT_BOTH)
    move(pair[1], 0.5)
    assert obj.Shape.Area == pytest.approx(6)
    assert not obj.Messages


def test_another_cell_is_not_taken_for_it(document, pair):
    """The point that lay in both squares lies in the first one only."""
    obj = picked(document, pair, AT_BOTH, AT_FIRST)
    move(pair[1], 10)
    assert obj.isValid()
    assert obj.Shape.Area == pytest.approx(16)
    assert obj.Messages == ["A kept cell of First + Zweites is lost; choose the cells again."]
    move(pair[1], 0)
    assert obj.Shape.Area == pytest.approx(16) and len(obj.Shape.Faces) == 2
    assert not obj.Messages


def test_if_all_are_lost_the_shape_stays(document, pair):
    obj = picked(document, pair, AT_BOTH)
    move(pair[1], 10)
    assert not obj.isValid()
    assert "of First + Zweites is lost" in obj.getStatusString()
    assert obj.Shape.Area == pytest.approx(8)
    obj.KeptCells = []
    document.recompute()
    assert obj.isValid() and obj.Shape.Area == pytest.approx(32)


def test_the_only_one_of_its_cover_is_found_elsewhere(document, pair):
    obj = picked(document, pair, AT_BOTH)
    move(pair[1], -4.5)
    assert obj.isValid()
    assert obj.Shape.BoundBox.XMax == pytest.approx(1.5)
    assert obj.Messages == [
        "The kept cell of First + Zweites lies elsewhere now, and is kept there."
    ]


def test_one_of_several_is_not_looked_for_elsewhere(document):
    """A bar crosses a frame twice; then only once, where it is not kept."""
    frame = square(document, "Frame", 0, 0, 10)
    sketches.add_rectangle(frame, 1, 1, 8, 8)
    bar = sketches.new_sketch(document, "Bar")
    sketches.add_rectangle(bar, -1, 4, 12, 2)
    document.recompute()
    obj = picked(document, [frame, bar], Vector(9.5, 5, 0), Vector(2, 5, 0))
    assert obj.KeptCellCovers == ["Bar+Frame, one of 2", "Bar, one of 3"]
    assert obj.Shape.Area == pytest.approx(18)
    move(bar, -6)
    assert obj.Shape.Area == pytest.approx(8)
    assert obj.Messages == ["A kept cell of Bar + Frame is lost; choose the cells again."]


def test_points_alone_are_enough(document, pair):
    """As macros set them; and a point that is in no cell is told."""
    obj = picked(document, pair, AT_FIRST, Vector(50, 1, 0))
    assert obj.Messages == ["A kept cell is lost: there is none at (50, 1) any more."]
    obj.KeptCells = [AT_BOTH]
    assert obj.KeptCellCovers == []
    document.recompute()
    assert obj.KeptCellCovers == ["First+Second"] and not obj.Messages
    obj.Operation = "Union"
    document.recompute()
    assert obj.isValid() and obj.Shape.Area == pytest.approx(24)


def test_undo_save_and_reload_keep_what_covers(document, pair, tmp_path):
    obj = picked(document, pair, AT_BOTH)
    document.openTransaction("Pick")
    obj.KeptCells = [AT_FIRST]
    document.recompute()
    document.commitTransaction()
    assert obj.KeptCellCovers == ["First"]
    document.undo()
    assert obj.KeptCellCovers == ["First+Second"]
    document.redo()
    assert obj.KeptCellCovers == ["First"]
    name = obj.Name
    document.saveAs(str(tmp_path / "kept.FCStd"))
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(str(tmp_path / "kept.FCStd")).getObject(name)
    assert again.KeptCellCovers == ["First"]


def test_cells_of_an_imprint(document):
    sources, targets = imprints.sources(document), imprints.targets(document)
    obj = make_imprinted_faces(sources, targets, KeptCells=[Vector(6, 4, 0)])
    document.recompute()
    (cover,) = obj.KeptCellCovers
    source, target = cover.split("/")
    assert source.endswith(".Face1") and target.endswith(".Face1")
    area = obj.Shape.Area
    assert area > 0 and math.isfinite(area)
    for one in targets:
        move(one, 100)
    assert not obj.isValid()
    words = source.split(".")[0] + " on " + target.split(".")[0]
    assert f"kept cell of {words} is lost" in obj.getStatusString()
    assert obj.Shape.Area == pytest.approx(area)
