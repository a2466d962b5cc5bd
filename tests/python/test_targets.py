# SPDX-License-Identifier: MIT
"""Number of triangles, frozen boundaries, narrow gaps, threads, and what the report says of quality."""

import numpy as np
import pytest

import tessera

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]


def test_count_finds_the_size():
    mesh = tessera.mesh(SQUARE, count=2000)
    assert abs(len(mesh.triangles) - 2000) < 100
    assert mesh.report["count"]["target"] == 2000
    assert mesh.report["count"]["reached"] == len(mesh.triangles)
    again = tessera.mesh(SQUARE, size=mesh.report["count"]["size"])
    assert np.array_equal(again.nodes, mesh.nodes)


@pytest.mark.parametrize(
    "options", [{"count": 0}, {"count": 2.5}, {"count": 10, "size": 1}, {"threads": 0}]
)
def test_bad_targets_are_refused(options):
    with pytest.raises(tessera.InvalidOptionError):
        tessera.mesh(SQUARE, **options)


def test_frozen_boundaries_keep_their_segments():
    mesh = tessera.mesh(SQUARE, size=1, freeze_boundary=True)
    on_boundary = np.isin(np.asarray(mesh.nodes)[:, :2], (0.0, 10.0)).any(axis=1)
    assert np.count_nonzero(on_boundary) == 4
    assert len(mesh.triangles) > 50


def test_narrow_gaps_take_the_share_that_they_may():
    points = [*SQUARE, (3, 5), (7, 5), (3, 5.002), (7, 5.002)]
    slit = (points, [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (6, 7)])
    coarse = tessera.mesh(slit, size=0.5, narrow_gaps=0)
    assert coarse.report["messages"] == []
    fine = tessera.mesh(slit, size=0.5, narrow_gaps=40)
    assert len(fine.triangles) > 2 * len(coarse.triangles)
    (message,) = fine.report["messages"]
    assert "0.002 wide at" in message and "narrow gaps = 0" in message
    assert tessera.mesh(SQUARE, size=0.5, narrow_gaps=40).report["messages"] == []


def test_threads_change_nothing():
    one = tessera.mesh(SQUARE, size=0.1, threads=1)
    many = tessera.mesh(SQUARE, size=0.1, threads=3)
    assert np.array_equal(one.nodes, many.nodes)
    assert np.array_equal(one.triangles, many.triangles)


def test_report_counts_and_names_the_worst():
    mesh = tessera.mesh(SQUARE, size=0.5)
    report = mesh.report
    assert sum(report["angle_histogram"]) == len(mesh.triangles)
    assert sum(report["quality_histogram"]) == len(mesh.triangles)
    worst = report["worst"]
    assert len(worst) == 10
    angles = [item["min_angle_deg"] for item in worst]
    assert angles == sorted(angles) and angles[0] == report["min_angle_deg"]
    corners = np.asarray(mesh.nodes)[np.asarray(mesh.triangles)[worst[0]["triangle"]]]
    assert np.allclose(corners[:, :2].mean(axis=0), worst[0]["place"])
