# SPDX-License-Identifier: MIT
"""tessera.overlay() of arrays, without FreeCAD."""

import sys

import numpy as np
import pytest

import tessera

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
BAR = [(2, 1), (6, 1), (6, 3), (2, 3)]


def shoelace(ring):
    x, y = ring.T
    return 0.5 * (np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def operands():
    return tessera.overlay([[SQUARE], [BAR]])


def test_operations_have_their_areas():
    both = operands()
    assert both.union().area == 20.0
    assert both.intersection().area == 4.0
    assert both.difference().area == 12.0
    assert both.symmetric_difference().area == 16.0
    assert both.theta["o"] == 4.0 and both.theta["t"] == 12.0 and both.theta["s"] == 4.0


def test_cells_know_their_operands_and_edges_their_curves():
    cells = operands().cells
    assert sorted(cell.operands for cell in cells) == [(0,), (0, 1), (1,)]
    for cell in cells:
        assert sum(shoelace(ring) for ring in cell.rings) == cell.area
        for ring, curves in zip(cell.rings, cell.edge_curves):
            assert len(ring) == len(curves)
            assert all(len(on) == 1 for on in curves)
    (shared,) = (cell for cell in cells if cell.operands == (0, 1))
    assert sorted(on[0] for on in shared.edge_curves[0]) == [1, 4, 6, 7]


def test_holes_priorities_and_files(tmp_path):
    ring = [SQUARE, [(1, 1), (3, 1), (3, 3), (1, 3)]]
    overlay = tessera.overlay([ring, [[(2, 0), (6, 0), (6, 4), (2, 4)]]])
    union = overlay.union()
    assert union.area == 22.0
    first = overlay.union(priority="first")
    assert {part.operands for part in first} == {(0,), (1,)}
    assert sum(part.area for part in first) == 22.0
    union.write(tmp_path / "union.wkt")
    assert (tmp_path / "union.wkt").read_text() == union.wkt
    overlay.cells.write(tmp_path / "cells.vtu")
    assert (tmp_path / "cells.vtu").stat().st_size > 0


def test_nothing_left_is_empty():
    apart = tessera.overlay([[SQUARE], [[(9, 9), (10, 9), (10, 10)]]])
    assert len(apart.intersection()) == 0
    assert apart.intersection().wkt == "GEOMETRYCOLLECTION EMPTY\n"


def test_wrong_options_are_refused():
    for wrong in ({"fill": "hull"}, {"weld": -1}, {"chord_error": 0}, {"progress": 3}):
        with pytest.raises(tessera.InvalidOptionError):
            tessera.overlay([[SQUARE], [BAR]], **wrong)
    with pytest.raises(tessera.InvalidOptionError):
        operands().union(priority="middle")


def test_files_of_unknown_kinds_are_refused_with_what_there_is(tmp_path):
    with pytest.raises(tessera.UnwritableError, match=r"results are written as \.wkt, \.brep, \.step, \.vtu"):
        operands().union().write(tmp_path / "out.foo")
    with pytest.raises(tessera.UnwritableError, match="a text or a path"):
        operands().union().write(3)


def test_faces_need_freecad(monkeypatch):
    monkeypatch.setitem(sys.modules, "Part", None)  # as where it is not installed
    with pytest.raises(tessera.Error, match="where FreeCAD runs"):
        operands().union().to_shape()


def test_the_polygon_that_is_none_is_named():
    with pytest.raises(tessera.InvalidInputError, match="Polygon2 has 2 points"):
        tessera.overlay([[SQUARE], [SQUARE[:2]]])
    with pytest.raises(tessera.InvalidInputError, match="Polygon2: point 1, counted from 0"):
        tessera.overlay([[SQUARE], [[(0, 0), (1, float("nan")), (1, 1)]]])


def test_rounding_to_the_grid_is_told():
    """A fan of lines at 1e8 whose crossings cannot be told apart."""
    rings = []
    for i in range(40):
        y = 1e8 + 1e-7 * i
        rings.append([(1e8, y), (1e8 + 10, 2e8 + 1.0 - y), (1e8 + 5, 1e8 + 20 + i)])
    messages = tessera.overlay([[ring] for ring in rings]).cells.report
    told = [text for text in messages["messages"] if "rounded to a grid" in text]
    assert len(told) == (1 if messages["snap_pixel"] > 0 else 0)
    assert messages["snap_pixel"] > 0
