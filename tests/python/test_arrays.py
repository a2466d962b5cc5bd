# SPDX-License-Identifier: MIT
"""tessera.mesh() of arrays, without FreeCAD."""

import json
import subprocess
import sys

import numpy as np
import pytest
from measures import assert_conforming, length_of, side_counts, triangle_areas

import tessera

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
HOLE = [(4, 4), (6, 4), (6, 6), (4, 6)]


def ring(count, radius=1.0, center=(0.0, 0.0)):
    angles = 2 * np.pi * np.arange(count) / count
    return np.column_stack([np.cos(angles), np.sin(angles)]) * radius + center


def test_polygon_is_meshed_to_its_area():
    mesh = tessera.mesh(SQUARE, size=1.0)
    assert_conforming(mesh)
    assert triangle_areas(mesh).sum() == pytest.approx(100.0, rel=1e-14)
    assert mesh.report["area"] == pytest.approx(100.0, rel=1e-14)
    assert length_of(mesh, mesh.edges[mesh.groups["Outline"].members]) == pytest.approx(40.0)
    assert np.array_equal(mesh.placement, np.eye(4))
    assert mesh.order == 1 and len(mesh.regions) == 1
    assert mesh.regions[0].area == pytest.approx(100.0)
    assert len(mesh.regions[0].triangles) == len(mesh.triangles)


def test_arrays_are_read_only_views_without_copies():
    mesh = tessera.mesh(SQUARE, size=1.0, order=2)
    for array, dtype, columns in (
        (mesh.nodes, np.float64, 2),
        (mesh.triangles, np.uint32, 3),
        (mesh.edges, np.uint32, 2),
        (mesh.triangle_mid_nodes, np.uint32, 3),
        (mesh.edge_mid_nodes, np.uint32, None),
        (mesh.triangle_regions, np.uint32, None),
        (mesh.groups["Region1"].members, np.uint32, None),
    ):
        assert array.dtype == dtype
        assert array.shape[1:] == (() if columns is None else (columns,))
        assert not array.flags.owndata and not array.flags.writeable
    nodes = mesh._data.nodes
    assert nodes.__array_interface__["data"] == mesh.nodes.__array_interface__["data"]


def test_views_outlive_the_mesh():
    nodes = tessera.mesh(SQUARE, size=0.5).nodes
    before = nodes.copy()
    for _ in range(5):
        tessera.mesh(SQUARE, size=0.4)
    assert np.array_equal(nodes, before)


def test_default_size_is_a_fortieth_of_the_diagonal():
    mesh = tessera.mesh(SQUARE)
    assert mesh.report["default_size"] == pytest.approx(np.hypot(10, 10) / 40)


def test_a_list_of_polygons_is_a_union():
    shifted = np.array(SQUARE) + (5, 5)
    mesh = tessera.mesh([SQUARE, shifted], size=1.0)
    assert_conforming(mesh)
    assert mesh.report["area"] == pytest.approx(175.0)
    assert mesh.report["crossings"] == 2
    assert sorted(region.operands for region in mesh.regions) == [(0,), (0, 1), (1,)]
    both = next(region for region in mesh.regions if region.operands == (0, 1))
    assert both.area == pytest.approx(25.0)
    assert mesh.operands == ["Polygon1", "Polygon2"]
    inside = mesh.groups["Polygon1"]
    assert inside.kind == "triangles"
    assert triangle_areas(mesh)[inside.members].sum() == pytest.approx(100.0)
    assert mesh.groups["Polygon2_Border"].kind == "edges"


def test_a_list_of_rings_is_a_polygon_with_holes():
    mesh = tessera.mesh([[SQUARE, HOLE]], size=1.0)
    assert_conforming(mesh)
    assert mesh.report["area"] == pytest.approx(96.0)
    assert mesh.report["messages"] == []


def test_closing_point_may_be_repeated():
    closed = SQUARE + SQUARE[:1]
    assert tessera.mesh(closed, size=2).report["area"] == pytest.approx(100.0)


def test_polygon_as_constraint_keeps_its_border_only():
    mesh = tessera.mesh([SQUARE, HOLE], size=1.0, constraint=[1])
    assert mesh.report["regions"] == 1
    assert mesh.report["area"] == pytest.approx(100.0)
    border = mesh.edges[mesh.groups["Polygon2_Border"].members]
    assert length_of(mesh, border) == pytest.approx(8.0)
    by_name = tessera.mesh([SQUARE, HOLE], size=1.0, constraint="Polygon2")
    assert np.array_equal(by_name.nodes, mesh.nodes)


def test_points_and_segments_with_markers():
    points = np.array(SQUARE + [(2, 5), (8, 5), (5, 8)], dtype=float)
    segments = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5)]
    mesh = tessera.mesh((points, segments, [1, 2, 3, 4, 9]), size=1.0)
    assert_conforming(mesh)
    assert mesh.report["area"] == pytest.approx(100.0)
    crack = mesh.edges[mesh.groups["Marker9"].members]
    assert length_of(mesh, crack) == pytest.approx(6.0)
    assert np.abs(mesh.nodes - (5, 8)).sum(axis=1).min() == 0.0  # the point on no segment


def test_segments_get_their_role_from_the_caller():
    points = SQUARE + HOLE
    segments = [(i, (i + 1) % 4) for i in range(4)] + [(4 + i, 4 + (i + 1) % 4) for i in range(4)]
    assert tessera.mesh((points, segments), size=2).report["area"] == pytest.approx(96.0)
    kept = tessera.mesh((points, segments), size=2, constraint=[4, 5, 6, 7])
    assert kept.report["area"] == pytest.approx(100.0)


@pytest.mark.parametrize(
    ("fill", "area"), [("even-odd", 96.0), ("nonzero", 100.0), ("all", 100.0), ("hull", 100.0)]
)
def test_fill_rules(fill, area):
    mesh = tessera.mesh([[SQUARE, HOLE]], size=1.0, fill=fill)
    assert mesh.report["area"] == pytest.approx(area)


def test_hull_of_a_point_set():
    points = np.random.default_rng(1).random((50, 2))
    mesh = tessera.mesh((points, np.zeros((0, 2), dtype=int)), fill="hull", refine=False)
    assert len(mesh.nodes) == 50
    assert (triangle_areas(mesh) > 0).all()
    # Every point lies left of each side used once, so those sides are the convex hull.
    for a, b in (side for side, count in side_counts(mesh).items() if count == 1):
        along, to = mesh.nodes[b] - mesh.nodes[a], points - mesh.nodes[a]
        turn = along[0] * to[:, 1] - along[1] * to[:, 0]
        assert (turn >= -1e-15).all() or (turn <= 1e-15).all()


def test_second_order_mid_nodes_of_straight_sides_are_in_the_middle():
    mesh = tessera.mesh(SQUARE, size=2.0, order=2)
    assert_conforming(mesh)
    for i in range(3):
        a = mesh.nodes[mesh.triangles[:, (i + 1) % 3]]
        b = mesh.nodes[mesh.triangles[:, (i + 2) % 3]]
        middle = mesh.nodes[mesh.triangle_mid_nodes[:, i]]
        assert np.abs(0.5 * (a + b) - middle).max() < 1e-14
    ends = mesh.nodes[mesh.edges]
    assert np.abs(ends.mean(axis=1) - mesh.nodes[mesh.edge_mid_nodes]).max() < 1e-14


def test_recovery_strategies_agree():
    star = ring(7)[[0, 3, 6, 2, 5, 1, 4]]
    meshes = [
        tessera.mesh(star, size=0.2, recovery=recovery, fill="nonzero")
        for recovery in ("steiner", "cavity")
    ]
    assert meshes[0].report["area"] == pytest.approx(meshes[1].report["area"], rel=1e-12)
    assert meshes[0].report["crossings"] == meshes[1].report["crossings"] == 14
    assert meshes[0].report["steiner_inserted"] >= 14


def test_without_refinement_there_are_no_new_nodes():
    mesh = tessera.mesh(SQUARE, size=0.1, refine=False)
    assert len(mesh.nodes) == 4 and len(mesh.triangles) == 2


def test_report_has_the_documented_keys():
    report = tessera.mesh(SQUARE, size=2.0).report
    keys = """version input crossings touches overlaps steiner_inserted steiner_removed regions
        vertices triangles quads area region_areas min_angle_deg max_angle_deg angle_p01_deg
        min_quality mean_quality size_conformity max_displacement snap_pixel unreached default_size
        weld seconds peak_memory_bytes"""
    assert set(keys.split()) <= set(report)
    stages = "read arrange sample triangulate recover color refine optimize extract write total"
    assert list(report["seconds"]) == stages.split()
    parts = sum(value for key, value in report["seconds"].items() if key != "total")
    assert parts == pytest.approx(report["seconds"]["total"], rel=0.05, abs=2e-4)
    json.dumps(report)


def test_quality_agrees_with_the_report():
    mesh = tessera.mesh([[ring(40, 5.0), ring(12, 1.0)]], size=0.7)
    quality = mesh.triangle_quality()
    assert quality.min() == pytest.approx(mesh.quality()["min_quality"])
    assert quality.mean() == pytest.approx(mesh.quality()["mean_quality"])
    assert mesh.quality()["min_angle_deg"] > 20


def test_same_input_same_bytes():
    first, second = (tessera.mesh([[ring(40, 5.0), ring(12, 1.0)]], size=0.7) for _ in range(2))
    assert first.nodes.tobytes() == second.nodes.tobytes()
    assert first.triangles.tobytes() == second.triangles.tobytes()


def test_files_appear(tmp_path):
    mesh = tessera.mesh(SQUARE, size=2.0)
    for name in ("a.vtu", "a.vtk", "a.msh", "a.inp", "a.poly", "a.svg", "a.png"):
        mesh.write(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 100
    mesh.plot(tmp_path / "b.svg")
    assert (tmp_path / "b.svg").read_text().lstrip().startswith(("<?xml", "<svg"))


def test_stages_are_drawn(tmp_path):
    tessera.mesh(SQUARE, size=2.0, stages=tmp_path / "stages")
    assert len(list((tmp_path / "stages").glob("*.svg"))) >= 6


def test_freecad_is_not_imported():
    code = (
        "import sys, tessera; tessera.mesh([(0, 0), (1, 0), (0, 1)], size=0.5); "
        "assert not {'FreeCAD', 'Part', 'Fem'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_missing_module_says_how_to_build(tmp_path):
    package = tmp_path / "tessera"
    package.mkdir()
    source = tessera.__path__[0]
    for name in ("__init__.py", "errors.py", "native.py", "meshing.py", "sources.py"):
        (package / name).write_text(open(f"{source}/{name}").read())
    code = (
        "import tessera\n"
        "try:\n    tessera.mesh([(0, 0), (1, 0), (0, 1)])\n"
        "except ImportError as error:\n    print(error)\n"
    )
    command = [sys.executable, "-c", code]
    printed = subprocess.run(command, cwd=tmp_path, env={}, stdout=subprocess.PIPE, check=True)
    assert b"tools/build" in printed.stdout and bytes(package) in printed.stdout


def test_ignored_segments_and_polygons():
    square = [(0, 0), (10, 0), (10, 10), (0, 10)]
    sides = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 2)]
    whole = tessera.mesh((square, sides), size=2, ignore=[4])
    assert whole.report["area"] == pytest.approx(100)
    assert whole.report["regions"] == 1
    half = tessera.mesh((square, sides), size=2, ignore=[0, 1])
    assert half.report["area"] == pytest.approx(50)
    inner = [(2, 2), (4, 2), (4, 4), (2, 4)]
    mesh = tessera.mesh([[square], [inner]], size=2, ignore=["Polygon1"])
    assert mesh.report["area"] == pytest.approx(4)
