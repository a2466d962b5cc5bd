# SPDX-License-Identifier: MIT
"""Imprinted faces as document objects: three sources and four targets that cross."""

import FreeCAD
import imprints
import pytest
from FreeCAD import Vector

from tessera.objects.imprinted_faces import make_imprinted_faces


@pytest.fixture
def faces(document):
    return imprints.sources(document), imprints.targets(document)


def check(obj, faces):
    """Every source and target is divided into pieces with its area, on its own plane."""
    assert obj.isValid(), obj.getStatusString()
    assert obj.Cells == imprints.CELLS
    assert obj.Shape.isValid()
    assert len(obj.Shape.Faces) == 2 * imprints.CELLS == len(obj.FaceCells)
    for side, originals in zip(obj.Shape.SubShapes, faces):
        assert len(side.SubShapes) == len(originals)
        for own, original in zip(side.SubShapes, originals):
            assert own.Area == pytest.approx(original.Shape.Area, rel=1e-9)
            assert own.BoundBox.ZMin == pytest.approx(original.Shape.BoundBox.ZMin, abs=1e-6)
            assert all(face.isValid() for face in own.Faces)


def test_three_sources_and_four_targets(document, faces):
    obj = make_imprinted_faces(*faces)
    document.recompute()
    check(obj, faces)
    assert obj.History[0].startswith("Source")
    assert " on Target" in obj.History[0]
    assert not obj.LeftPlaces and not obj.ClosedPlaces
    for number, cell in zip(obj.FaceCells, obj.Shape.Faces):
        assert cell.Area == pytest.approx(obj.Shape.Faces[obj.FaceCells.index(number)].Area)


def test_gaps_and_tolerance(document, faces):
    faces[0][2].Placement = FreeCAD.Placement(Vector(0.01, 0, 0), FreeCAD.Rotation())
    document.recompute()
    obj = make_imprinted_faces(*faces)
    document.recompute()
    assert any("target without source" in text for text in obj.LeftPlaces)
    obj.Tolerance = 0.05
    document.recompute()
    assert obj.ClosedPlaces
    assert obj.Cells == imprints.CELLS
    assert not obj.LeftPlaces


def test_undo_save_and_reload(document, faces, tmp_path):
    document.openTransaction("Imprint")
    obj = make_imprinted_faces(*faces)
    document.recompute()
    document.commitTransaction()
    name = obj.Name
    document.openTransaction("Pick")
    obj.KeptCells = [Vector(6, 4, 0)]
    document.recompute()
    document.commitTransaction()
    assert len(obj.Shape.Faces) == 2
    document.undo()
    check(obj, faces)
    document.undo()
    assert document.getObject(name) is None
    document.redo()
    check(document.getObject(name), faces)
    document.saveAs(str(tmp_path / "imprint.FCStd"))
    FreeCAD.closeDocument(document.Name)
    opened = FreeCAD.openDocument(str(tmp_path / "imprint.FCStd"))
    again = opened.getObject(name)
    assert len(again.Shape.Faces) == 2 * imprints.CELLS
    again.touch()
    opened.recompute()
    assert again.isValid() and again.Cells == imprints.CELLS


def test_tilted_faces_are_refused_in_words(document, faces):
    faces[1][0].Placement = FreeCAD.Placement(
        Vector(), FreeCAD.Rotation(Vector(1, 0, 0), 20)
    )
    document.recompute()
    obj = make_imprinted_faces(*faces)
    document.recompute()
    assert not obj.isValid()
    assert "tilted by 20 degrees" in obj.getStatusString()
