# SPDX-License-Identifier: MIT
"""Sizes at places, on curves, in regions, in gaps, by expressions and from other meshes."""

import numpy as np
import pytest
from measures import assert_conforming

import tessera

PLATE = [(0, 0), (10, 0), (10, 6), (0, 6)]
WINDOW = [(6, 1), (9, 1), (9, 5), (6, 5)]


def mean_edge(mesh, chosen):
    """Mean length of the triangles' sides whose middle is chosen."""
    ends = np.concatenate([mesh.triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    a, b = mesh.nodes[ends[:, 0]], mesh.nodes[ends[:, 1]]
    mask = chosen(0.5 * (a + b))
    assert mask.any()
    return np.linalg.norm(b - a, axis=1)[mask].mean()


def near(place, radius):
    return lambda p: np.linalg.norm(p - np.array(place), axis=1) < radius


def in_window(p):
    return (np.abs(p[:, 0] - 7.5) < 1.2) & (np.abs(p[:, 1] - 3) < 1.7)


def far_left(p):
    return p[:, 0] < 2


def test_sizes_at_places():
    mesh = tessera.mesh(PLATE, 1.0, size_at=[(1, 1, 0.05, 0.3), ((1, 5), 0.1, 0.3)])
    assert_conforming(mesh)
    assert mean_edge(mesh, near((1, 1), 0.25)) == pytest.approx(0.05, rel=0.2)
    assert mean_edge(mesh, near((1, 5), 0.25)) == pytest.approx(0.1, rel=0.2)
    slow = tessera.mesh(PLATE, 1.0, size_at=[(6, 3, 0.1, 0.5, 0.4, 3.5)])
    assert mean_edge(slow, near((6, 5), 0.3)) == pytest.approx(0.25, rel=0.15)
    in_space = tessera.mesh(PLATE, 1.0, size_at=[((1.0, 1.0, 0.0), 0.05, 0.3)])
    assert mean_edge(in_space, near((1, 1), 0.25)) == pytest.approx(0.05, rel=0.2)


def test_sizes_on_curves():
    on_window = lambda p: (np.abs(p[:, 0] - 6) < 0.25) & (np.abs(p[:, 1] - 3) < 2)  # noqa: E731
    for given in ({"Polygon2": (0.1, 0.3)}, [(1, (0.1, 0.3))], [([1], (0.1, 0.3))]):
        mesh = tessera.mesh([PLATE, WINDOW], 1.0, size_on=given)
        assert mean_edge(mesh, on_window) == pytest.approx(0.1, rel=0.2)
    segments = ([(0, 0), (10, 0), (10, 6), (0, 6)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    mesh = tessera.mesh(segments, 1.0, size_on={1: (0.1, 0.3)})
    assert mean_edge(mesh, lambda p: p[:, 0] > 9.8) == pytest.approx(0.1, rel=0.2)


def test_sizes_in_operands_and_regions():
    for given in ({1: 0.15}, {"Polygon2": 0.15}, [((7, 3), 0.15)]):
        mesh = tessera.mesh([PLATE, WINDOW], 1.0, size_in=given)
        assert_conforming(mesh)
        assert mean_edge(mesh, in_window) == pytest.approx(0.15, rel=0.1)
        assert mean_edge(mesh, far_left) > 0.6


def test_gaps_expressions_and_curvature():
    strip = [(0, 0), (10, 0), (10, 0.2), (0, 0.2)]
    mesh = tessera.mesh(strip, 1.0, gap=4)
    middle = lambda p: np.abs(p[:, 0] - 5) < 3  # noqa: E731
    assert mean_edge(mesh, middle) == pytest.approx(0.05, rel=0.15)
    mesh = tessera.mesh(PLATE, 1.0, size_expr="0.1 + 0.05*x")
    assert mean_edge(mesh, near((1, 3), 0.4)) == pytest.approx(0.15, rel=0.15)
    both = tessera.mesh(PLATE, 1.0, size_expr=["0.1 + 0.05*x", "0.1 + 0.05*(10 - x)"])
    assert mean_edge(both, near((9, 3), 0.4)) == pytest.approx(0.15, rel=0.15)


def test_expressions_count_where_there_is_something_to_mesh():
    corner = [(0, 0), (10, 0), (10, 2), (2, 2), (2, 10), (0, 10)]
    mesh = tessera.mesh(corner, 1.0, size_expr="1.4 - 0.1*(x + y)")  # below 0 between the legs
    assert mean_edge(mesh, near((9.5, 1.5), 0.4)) == pytest.approx(0.3, rel=0.15)
    with pytest.raises(tessera.InvalidOptionError, match=r"above 0 in all that is meshed.*max"):
        tessera.mesh(corner, 1.0, size_expr="1.1 - 0.1*(x + y)")


def test_sizes_from_another_mesh(tmp_path):
    coarse = tessera.mesh(PLATE, 1.0)
    sizes = 0.1 + 0.05 * coarse.nodes[:, 0]
    for given in (
        (coarse, sizes),
        (coarse.nodes, coarse.triangles, sizes),
        [(coarse, sizes), (coarse, sizes)],
    ):
        mesh = tessera.mesh(PLATE, 1.0, size_from=given)
        assert mean_edge(mesh, near((1, 3), 0.4)) == pytest.approx(0.15, rel=0.15)
        assert mean_edge(mesh, near((9, 3), 0.5)) == pytest.approx(0.55, rel=0.15)
    coarse.write(tmp_path / "coarse.vtu")
    with pytest.raises(tessera.UnreadableError, match="no point data called 'h'; there is origin"):
        tessera.mesh(PLATE, 1.0, size_from=f"{tmp_path}/coarse.vtu:h")


def test_adaptive_remeshing_follows_an_error():
    """Sizes from a solution, as a user would loop: the error of a function's linear interpolation
    falls as its second derivative says."""
    f = lambda p: np.tanh(8 * (p[:, 0] - 4))  # noqa: E731
    mesh = tessera.mesh(PLATE, 0.5)
    for _ in range(2):
        x = mesh.nodes[:, 0]
        bending = np.abs(128 * np.tanh(8 * (x - 4)) / np.cosh(8 * (x - 4)) ** 2)
        sizes = np.clip(np.sqrt(8 * 0.01 / np.maximum(bending, 1e-9)), 0.03, 1.0)
        mesh = tessera.mesh(PLATE, 1.0, size_from=(mesh, sizes))
    centers = mesh.nodes[mesh.triangles].mean(axis=1)
    error = np.abs(f(mesh.nodes)[mesh.triangles].mean(axis=1) - f(centers))
    uniform = tessera.mesh(PLATE, np.sqrt(60 / len(mesh.triangles) * 4 / np.sqrt(3)))
    centers = uniform.nodes[uniform.triangles].mean(axis=1)
    uniform_error = np.abs(f(uniform.nodes)[uniform.triangles].mean(axis=1) - f(centers))
    assert error.max() < 0.5 * uniform_error.max()


@pytest.mark.parametrize(
    "options, text",
    [
        ({"size_at": 3}, "size_at must be a list"),
        ({"size_at": [(1, 2)]}, "list of \\(x, y, size\\)"),
        ({"size_at": [(1, 2, 0.1, 0.2, 0.3)]}, "takes a size"),
        ({"size_at": [(1, 2, -0.1)]}, "number above 0"),
        ({"size_at": [("Vertex1", 0.1)]}, "Arrays have no 'Vertex1'"),
        ({"size_on": {"Polygon3": 0.1}}, "nothing called 'Polygon3'"),
        ({"size_on": {7: 0.1}}, "nothing called 7"),
        ({"size_on": 0.1}, "size_on must be a list"),
        ({"size_in": {5: 0.1}}, "nothing called 5"),
        ({"size_in": {0: 0.0}}, "size_in must be greater than 0"),
        ({"size_in": [((70, 3), 0.1)]}, "not inside"),
        ({"size_expr": "x +"}, "cannot be read"),
        ({"size_expr": "x - 5"}, "it must be a number above 0"),
        ({"size_from": 3}, "size_from takes"),
        ({"size_from": ([(0, 0), (1, 0), (2, 0)], [(0, 1, 2)], [1, 2, 3])}, "triangle 0.* no area"),
        ({"size_expr": 3}, "size_expr must be a list of text in x and y, not 3"),
        ({"size_expr": ["x", 3]}, "size_expr must be a list of text in x and y, not of 3"),
        ({"size_at": 3}, r"size_at must be a list of \(x, y, size\) or \(place, size\), not 3"),
        ({"size_at": [((), 1)]}, "is no place"),
        ({"size_at": [(None, 1)]}, "None is no place"),
        ({"size_at": [(1, 2, "small")]}, "size_at must be a number, not 'small'"),
        ({"size_from": ([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)], [1, 2])}, "2 sizes for 3 nodes"),
        ({"size_from": ([(0, 0), (1, 0), (0, 1)], [(0, 1, -1)], [1, 2, 3])}, "has a node"),
        ({"size_from": ([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)], [1, 2, np.nan])}, "is nan"),
        ({"curvature": 2}, "between 3 and 10000"),
        ({"gap": -1}, "gap must be greater than 0"),
        ({"chord_error": 0}, "chord_error must be greater than 0"),
    ],
)
def test_what_is_wrong_is_said(options, text):
    with pytest.raises(tessera.InvalidOptionError, match=text):
        tessera.mesh([PLATE, WINDOW], 1.0, **options)
