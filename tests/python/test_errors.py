# SPDX-License-Identifier: MIT
"""Bad input: the right class, a message that helps, the places."""

import pickle

import numpy as np
import pytest

import tessera

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
SEGMENTS = [(0, 1), (1, 2), (2, 3), (3, 0)]
NAN = float("nan")


@pytest.mark.parametrize(
    "options",
    [
        {"size": 0},
        {"size": -1},
        {"size": NAN},
        {"size": float("inf")},
        {"size": "large"},
        {"size": True},
        {"min_size": 0},
        {"min_size": NAN},
        {"growth": 0},
        {"growth": 1.5},
        {"growth": NAN},
        {"min_angle": -1},
        {"min_angle": 60},
        {"max_area": 0},
        {"max_area": NAN},
        {"weld": -1},
        {"weld": NAN},
        {"narrow_gaps": -1},
        {"narrow_gaps": NAN},
        {"narrow_gaps": float("inf")},
        {"narrow_gaps": "all"},
        {"order": 3},
        {"order": "2"},
        {"fill": "evenodd"},
        {"recovery": "magic"},
        {"time_limit": 0},
        {"progress": 5},
        {"constraint": 3.5},
        {"constraint": [[1]]},
        {"constraint": [None]},
        {"constraint": [10**400]},
        {"constraint": [-1]},
        {"size": 10**400},
        {"size": 1j},
        {"size": [1.0, 2.0]},
        {"growth": None},
        {"order": None},
        {"order": [1]},
        {"order": 1.5},
        {"fill": None},
        {"execution": 5},
        {"stages": 5},
        {"constraint": ["Polygon9"]},
        {"boundary": [7]},
    ],
)
def test_bad_option(options):
    with pytest.raises(tessera.InvalidOptionError) as caught:
        tessera.mesh(SQUARE, **options)
    name = next(iter(options))
    assert isinstance(caught.value, tessera.Error)
    named = ("size", "min_size", "max_area", "weld", "order", "fill", "recovery", "time_limit")
    if name in (*named, "narrow_gaps"):
        assert name in str(caught.value)


@pytest.mark.parametrize(
    "source",
    [
        None,
        3,
        "square",
        {},
        [],
        np.zeros((4, 3)),
        np.zeros(4),
        [(0, 0), (1, 0)],
        [[]],
        [[(0, 0, 0), (1, 0, 0), (0, 1, 0)]],
        [["a", "b"]],
        [(0, 0), (1, 0), (10**400, 1)],
        [(0, 0), (1, 0), (None, 1)],
        [("0", "0"), ("1", "0"), ("0", "1")],
        [(0, 0), (1, 0), (1j, 1)],
        np.array([(0, 0), (1, 0), (0, 1)], dtype=complex),
        np.array([("0", "0"), ("1", "0"), ("0", "1")]),
        np.array([(0, 0), (1, 0), (0, 1)], dtype=bool),
        np.zeros(4, dtype=[("x", float), ("y", float)]),
        [(0, 0), (1, 0), (0, 1, 2)],
        [(0, 0), (1, 0), 5],
        [1.0, 2.0, 3.0],
        [None],
        [None, None, None],
        object(),
        {0, 1},
        ((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)),
        (SQUARE, [(0, 1, 2)]),
        (SQUARE, 5),
        (SQUARE, None),
        (None, SEGMENTS),
        (SQUARE, [(0, 1), (1,)]),
        (SQUARE, [("0", "1")]),
        (SQUARE, [(0, None)]),
        (SQUARE, [(0, NAN)]),
        (SQUARE, [(0, 10**400)]),
        (SQUARE, [(0, 1j)]),
        (SQUARE, [(True, False)]),
        (SQUARE, SEGMENTS, "abc"),
        (SQUARE, SEGMENTS, [1, 2, 3, 0.5]),
        ([(0, 0, 0), (1, 0, 0)], [(0, 1)]),
        (SQUARE, [(0, 4)]),
        (SQUARE, [(-1, 0)]),
        (SQUARE, [(0.5, 1)]),
        (SQUARE, [(0, 2**40)]),
        (SQUARE, SEGMENTS, [1, 2]),
        (SQUARE, SEGMENTS, [1, 2, 3, 2**40]),
        [(0, 0), (1, 0), (NAN, 1)],
        [(0, 0), (1, 0), (float("inf"), 1)],
        ([(0, 0), (1, 0), (0, NAN)], [(0, 1), (1, 2), (2, 0)]),
    ],
)
def test_bad_source(source):
    with pytest.raises(tessera.InvalidInputError):
        tessera.mesh(source, size=1.0)


@pytest.mark.parametrize(
    "source, text",
    [
        ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], r"\(n, 2\), not \(3, 3\)"),
        ([[(0, 0, 0), (1, 0, 0), (0, 1, 0)]], r"\(n, 2\), not \(3, 3\)"),
        (np.zeros((4, 3)), r"\(n, 2\), not \(4, 3\)"),
        ([1.0, 2.0, 3.0], r"\(n, 2\), not \(3,\)"),
        ([(0, 0), (1, 0), (0, 1, 2)], "point 2 has 3 coordinates"),
        ([(0, 0), (1, 0), (10**400, 1)], "too large"),
        ((SQUARE, [(0, 1, 2)]), r"\(m, 2\), not \(1, 3\)"),
        ((SQUARE, [(0, 10**400)]), "64 bits"),
        ((SQUARE, [(0, 4)]), "segments.0. = .0, 4. names a point that does not exist"),
    ],
)
def test_bad_source_is_told_in_words(source, text):
    with pytest.raises(tessera.InvalidInputError, match=text):
        tessera.mesh(source, size=1.0)


def test_fractions_are_numbers():
    from fractions import Fraction

    half = Fraction(1, 2)
    mesh = tessera.mesh([(0, 0), (half, 0), (half, half), (0, half)], size=1.0)
    assert mesh.report["area"] == 0.25


def test_not_finite_names_the_point():
    with pytest.raises(tessera.InvalidInputError, match="2"):
        tessera.mesh([(0, 0), (1, 0), (NAN, 1)])


def test_only_open_curves():
    with pytest.raises(tessera.NoInsideError) as caught:
        tessera.mesh(([(0, 0), (10, 0), (10, 10), (0, 9)], SEGMENTS[:3]), size=1.0)
    places = caught.value.places
    assert {place.position for place in places} == {(0.0, 0.0), (0.0, 9.0)}
    assert all(place.element.startswith("Segment") and place.source == 0 for place in places)
    assert places[0].point == (*places[0].position, 0.0)


def test_zero_area():
    with pytest.raises(tessera.NoInsideError, match="no area"):
        tessera.mesh([(0, 0), (5, 0), (10, 0)])


def test_two_equal_loops_cancel():
    with pytest.raises(tessera.NoInsideError):
        tessera.mesh([[SQUARE, SQUARE]])


def test_too_large_is_refused_with_the_number():
    with pytest.raises(tessera.TooLargeError, match=r"\d.*GB"):
        tessera.mesh(SQUARE, size=1e-7)


def test_unwritable_files(tmp_path):
    mesh = tessera.mesh(SQUARE, size=5)
    for path in (tmp_path / "no" / "a.vtu", tmp_path / "a.xyz", tmp_path / "a"):
        with pytest.raises(tessera.UnwritableError):
            mesh.write(path)
    for name in (5, None):
        with pytest.raises(tessera.UnwritableError, match="name of a file"):
            mesh.write(name)
    with pytest.raises(tessera.UnwritableError):
        mesh.plot(tmp_path / "a.vtu")
    assert list(tmp_path.iterdir()) == []


def test_errors_can_be_pickled():
    with pytest.raises(tessera.NoInsideError) as caught:
        tessera.mesh(([(0, 0), (10, 0), (10, 10)], SEGMENTS[:2]), size=1.0)
    again = pickle.loads(pickle.dumps(caught.value))
    assert type(again) is tessera.NoInsideError
    assert str(again) == str(caught.value) and again.places == caught.value.places


def test_classes():
    for name in (
        "InvalidInputError InvalidOptionError NoInsideError TooLargeError UnreadableError "
        "UnwritableError CancelledError TimeLimitError"
    ).split():
        assert issubclass(getattr(tessera, name), tessera.Error)
