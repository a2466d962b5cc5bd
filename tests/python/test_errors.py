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
        {"order": 3},
        {"order": "2"},
        {"fill": "evenodd"},
        {"recovery": "magic"},
        {"time_limit": 0},
        {"progress": 5},
        {"constraint": 3.5},
        {"constraint": ["Polygon9"]},
        {"boundary": [7]},
    ],
)
def test_bad_option(options):
    with pytest.raises(tessera.InvalidOptionError) as caught:
        tessera.mesh(SQUARE, **options)
    name = next(iter(options))
    assert isinstance(caught.value, tessera.Error)
    if name in ("size", "min_size", "max_area", "weld", "order", "fill", "recovery", "time_limit"):
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
        (SQUARE, [(0, 1, 2)]),
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
