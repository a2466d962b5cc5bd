# SPDX-License-Identifier: MIT
"""tessera.imprint() of arrays and files, without FreeCAD."""

import pytest

import tessera

HALVES = [[[(0, 0), (2, 0), (2, 2), (0, 2)]], [[(2, 0), (5, 0), (5, 2), (2, 2)]]]
THIRDS = [[[(0, 0), (3.01, 0), (3.01, 2), (0, 2)]], [[(3, 0), (5, 0), (5, 2), (3, 2)]]]


def test_cells_and_history():
    result = tessera.imprint(HALVES, THIRDS)
    assert sum(cell.area for cell in result.cells) == pytest.approx(10.0, abs=1e-12)
    pairs = {(cell.sources, cell.targets): cell.area for cell in result.cells}
    assert pairs.keys() == {((0,), (0,)), ((1,), (0,)), ((1,), (1,)), ((1,), (0, 1))}
    assert pairs[(0,), (0,)] == 4.0
    assert [side.name for side in result.sources] == ["Polygon1", "Polygon2"]
    assert [side.item for side in result.targets] == [0, 1]
    for sides, index in ((result.sources, 1), (result.targets, 2)):
        for number, side in enumerate(sides):
            assert side.cells == tuple(
                i for i, cell in enumerate(result.cells) if number in cell[index]
            )
            assert side.area == pytest.approx(sum(result.cells[i].area for i in side.cells))
    assert sorted(result.table) == sorted(
        (i, s, t) for i, c in enumerate(result.cells) for s in c.sources for t in c.targets
    )
    (left,) = result.left
    assert left.kind == "target overlap" and left.targets == (0, 1) and left.sources == (1,)
    assert left.width == pytest.approx(0.01, rel=0.02)
    assert left.at[0] == pytest.approx(3.005, abs=1e-3)


def test_tolerance_closes_and_tells():
    result = tessera.imprint(HALVES, THIRDS, tolerance=0.1)
    assert len(result.cells) == 3 and not result.left
    (closed,) = result.closed
    assert closed.kind == "target overlap" and closed.area == pytest.approx(0.02)
    assert all(len(c.sources) == len(c.targets) == 1 for c in result.cells)


def test_files(tmp_path):
    names = []
    for name, polygons in (("s", HALVES), ("t", THIRDS)):
        lines = [
            "POLYGON((" + ",".join(f"{x} {y}" for x, y in [*ring, ring[0]]) + "))"
            for (ring,) in polygons
        ]
        names.append(tmp_path / f"{name}.wkt")
        names[-1].write_text("\n".join(lines))
    result = tessera.imprint(str(names[0]), [names[1]], tolerance=0.1)
    assert len(result.cells) == 3
    assert len(result.wkt.splitlines()) == 3
    for name in ("out.wkt", "out.brep", "out.step", "out.vtu", "out.svg"):
        result.write(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 0
    again = tessera.imprint([tmp_path / "out.brep"], str(tmp_path / "out.step"))
    # Both files hold the cells of sources and of targets, in one plane.
    assert again.area == pytest.approx(10.0)
    assert len(again.cells) == 3


def test_wrong_arguments_are_refused():
    for wrong in (
        {"fill": "hull"},
        {"tolerance": -1},
        {"chord_error": 0},
        {"progress": 3},
        {"direction": (1, 0)},
        {"direction": "up"},
        {"direction": (1, 0, 0)},
        {"direction": (0, 0, 0)},
        {"direction": (0, float("nan"), 1)},
        {"direction": (float("inf"), 0, 0)},
    ):
        with pytest.raises(tessera.InvalidOptionError):
            tessera.imprint(HALVES, THIRDS, **wrong)
    for sources, targets in (([], THIRDS), (HALVES, None), (HALVES, ["a.brep"])):
        with pytest.raises(tessera.InvalidInputError):
            tessera.imprint(sources, targets)
    with pytest.raises(tessera.UnreadableError):
        tessera.imprint("missing.wkt", THIRDS)
