# SPDX-License-Identifier: MIT
"""The options of tessera.mesh() that ask for sizes, as the compiled module takes them.

A size at a place is a number, or a tuple (size, radius) or (size, radius, far_size, far_radius): the
size holds up to the radius and grows from there by the growth rate, or linearly to far_size at
far_radius.
"""

import math
import os

import numpy as np

from tessera import arrays
from tessera.errors import InvalidOptionError
from tessera.native import module as native


def local_sizes(prepared, curvature, chord_error, gap, size_at, size_on, size_in, size_expr,
                size_from):
    """A native LocalSizes. Raises tessera.Error."""
    sizes = native.LocalSizes()
    if curvature is not None:
        sizes.curvature = number("curvature", curvature)
    if chord_error is not None:
        sizes.chord_error = positive("chord_error", chord_error)
    if gap is not None:
        sizes.gap = positive("gap", gap)
    for item in _entries("size_at", size_at, "(x, y, size) or (place, size)"):
        place, law = _place_and_law(item)
        sizes.add_point(*_in_plane(prepared, place), law)
    for elements, law in _pairs("size_on", size_on):
        curves = []
        for element in _elements(elements):
            curves += prepared.curves(element)
        sizes.add_curves(curves, _law("size_on", law))
    for place, size in _pairs("size_in", size_in):
        _add_region(sizes, prepared, place, positive("size_in", size))
    for text in [size_expr] if isinstance(size_expr, str) else _entries(
        "size_expr", size_expr, "text in x and y"
    ):
        if not isinstance(text, str):
            raise InvalidOptionError(f"size_expr must be a list of text in x and y, not of {text!r}.")
        sizes.add_expression(text)
    for item in _backgrounds(size_from):
        _add_background(sizes, item)
    return sizes


def number(name, value):
    """A finite float; FreeCAD quantities in their own unit (mm)."""
    value = getattr(value, "Value", value)
    if isinstance(value, (bool, str, bytes)):
        raise InvalidOptionError(f"{name} must be a number, not {value!r}.")
    try:
        result = float(value)
    except (TypeError, ValueError) as error:
        raise InvalidOptionError(f"{name} must be a number, not {value!r}.") from error
    except OverflowError as error:
        raise InvalidOptionError(f"{name} is too large.") from error
    if not math.isfinite(result):
        raise InvalidOptionError(f"{name} must be finite, not {result}.")
    return result


def positive(name, value):
    result = number(name, value)
    if result <= 0.0:
        raise InvalidOptionError(f"{name} must be greater than 0, not {result:g}.")
    return result


def _entries(name, value, of):
    if value is None:
        return []
    if isinstance(value, (str, bytes, dict)) or not hasattr(value, "__iter__"):
        raise InvalidOptionError(f"{name} must be a list of {of}, not {value!r}.")
    return list(value)


def _pairs(name, value):
    """[(where, size)] of a dictionary or a list of pairs."""
    pairs = list(value.items()) if isinstance(value, dict) else _entries(name, value, "(where, size)")
    for pair in pairs:
        if not isinstance(pair, (tuple, list)) or len(pair) != 2:
            raise InvalidOptionError(f"{name} must be a list of (where, size), not of {pair!r}.")
    return pairs


def _law(name, value):
    """[size, radius, far_size, far_radius]"""
    if isinstance(value, (tuple, list, np.ndarray)):
        values = [number(name, v) for v in value]
    else:
        values = [number(name, value)]
    if len(values) not in (1, 2, 4):
        raise InvalidOptionError(
            f"{name} takes a size, (size, radius) or (size, radius, far_size, far_radius), not "
            f"{value!r}."
        )
    return values + [0.0] * (4 - len(values))


def _place_and_law(item):
    """(x, y, size, ...) or (place, size, ...)."""
    if not isinstance(item, (tuple, list, np.ndarray)) or len(item) < 2:
        raise InvalidOptionError(
            f"size_at must be a list of (x, y, size) or (place, size), not of {item!r}."
        )
    if isinstance(item, np.ndarray) or _is_number(item[0]):
        if len(item) < 3:
            raise InvalidOptionError(f"size_at must be a list of (x, y, size), not of {item!r}.")
        return (item[0], item[1]), _law("size_at", list(item[2:]))
    return item[0], _law("size_at", list(item[1:]))


def _is_number(value):
    return isinstance(value, (int, float, np.integer, np.floating)) or hasattr(value, "Value")


def _elements(elements):
    is_list = isinstance(elements, list) or (
        isinstance(elements, tuple) and not (elements and hasattr(elements[0], "Shape"))
    )
    return list(elements) if is_list else [elements]


def _in_plane(prepared, place):
    """(x, y) in the frame of the plane of (x, y) there, or of a point or vertex in space."""
    if isinstance(place, str) or (
        isinstance(place, tuple) and place and hasattr(place[0], "Shape")
    ):
        place = prepared.place(place)
    try:
        values = [number("size_at", v) for v in place]
    except TypeError as error:
        raise InvalidOptionError(f"{place!r} is no place; give (x, y), or a point.") from error
    if len(values) == 2:
        return values
    if len(values) != 3:
        raise InvalidOptionError(f"{place!r} is no place; give (x, y), or a point.")
    return prepared.to_plane(values)


def _add_region(sizes, prepared, place, size):
    is_face = isinstance(place, str) and place.startswith("Face") and place[4:].isdigit()
    if not is_face and (_is_number(place) or isinstance(place, str)):
        for operand in prepared.operands(place):
            sizes.add_operand(operand, size)
    else:
        sizes.add_region(*_in_plane(prepared, place), size)


def _backgrounds(value):
    if value is None:
        return []
    return value if isinstance(value, list) else [value]


def _add_background(sizes, item):
    """A file and the name of its point data, (nodes, triangles, sizes), or (mesh, sizes)."""
    if isinstance(item, (str, os.PathLike)):
        sizes.add_file(os.fspath(item))
        return
    if isinstance(item, tuple) and len(item) == 2 and hasattr(item[0], "triangles"):
        item = (item[0].nodes, item[0].triangles, item[1])
    if not isinstance(item, tuple) or len(item) != 3:
        raise InvalidOptionError(
            "size_from takes 'FILE.vtu:ARRAY', (nodes, triangles, sizes) or (mesh, sizes)."
        )
    values = np.asarray(item[2], dtype=np.float64)
    if values.ndim != 1:
        raise InvalidOptionError(f"The sizes of size_from have shape {values.shape}, not (n,).")
    nodes = arrays.points_array(item[0], "The nodes of size_from")
    triangles = arrays.index_array(item[1], 3, "The triangles of size_from")
    sizes.add_background(nodes, triangles, values)
