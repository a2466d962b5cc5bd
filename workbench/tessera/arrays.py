# SPDX-License-Identifier: MIT
"""Sources given as arrays; FreeCAD is not needed."""

import numbers

import numpy as np

from tessera.errors import InvalidInputError


def is_ring(item):
    """A sequence of (x, y) pairs."""
    if isinstance(item, np.ndarray):
        return item.ndim == 2
    if not isinstance(item, (list, tuple)) or not item:
        return False
    return all(
        isinstance(p, (list, tuple, np.ndarray)) and len(p) == 2 and np.isscalar(p[0]) for p in item
    )


def is_points_and_segments(source):
    """A tuple (points, segments) or (points, segments, markers)."""
    return isinstance(source, tuple) and len(source) in (2, 3) and not is_ring(source)


def _is_flat(item):
    """A sequence of single values."""
    if isinstance(item, np.ndarray):
        return item.ndim == 1
    return isinstance(item, (list, tuple)) and all(np.isscalar(x) or x is None for x in item)


def refuse_odd_points(items):
    """Says what is wrong with a sequence that is no polygon because its points are no pairs."""
    items = list(items)
    if not items or not all(_is_flat(item) or np.isscalar(item) for item in items):
        return
    widths = [0 if np.isscalar(item) else len(item) for item in items]
    if len(set(widths)) > 1:
        odd = next(i for i, width in enumerate(widths) if width != widths[0])
        raise InvalidInputError(
            f"A polygon must have shape (n, 2); point {odd} has {_coordinates(widths[odd])}, "
            f"point 0 has {_coordinates(widths[0])}."
        )
    if widths[0] != 2:
        shape = (len(items), widths[0]) if widths[0] else (len(items),)
        raise InvalidInputError(f"A polygon must have shape (n, 2), not {shape}.")


def _coordinates(count):
    return "1 coordinate" if count == 1 else f"{count or 'no'} coordinates"


def _numbers(values, kinds):
    """An array of numbers as they are; None if they are no numbers of these kinds (of dtypes)."""
    array = np.asarray(values)
    if array.dtype.kind == "O":  # numbers that no type of NumPy holds, or something else
        return array if all(isinstance(x, numbers.Real) for x in array.flat) else None
    return array if array.dtype.kind in kinds or array.size == 0 else None


def points_array(points, what):
    """An (n, 2) array of floats."""
    try:
        array = _numbers(points, "iuf")
        array = None if array is None else array.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidInputError(
            f"{what} must be numbers in an array of shape (n, 2); its rows differ in length."
        ) from error
    except OverflowError as error:
        raise InvalidInputError(
            f"{what}: a number is too large; coordinates reach to 1e150."
        ) from error
    if array is None:
        raise InvalidInputError(f"{what} must be real numbers in an array of shape (n, 2).")
    if array.size == 0:
        return array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise InvalidInputError(f"{what} must have shape (n, 2), not {array.shape}.")
    return array


def index_array(values, columns, what):
    """An integer array of shape (m, columns), or (m,) if columns is 0."""
    try:
        array = _numbers(values, "iuf")
        if array is not None and array.size == 0:
            return np.zeros((0, columns) if columns else 0, dtype=np.int64)
        with np.errstate(invalid="ignore"):  # NaN is not exact
            whole = None if array is None else array.astype(np.int64)
    except (TypeError, ValueError) as error:
        raise InvalidInputError(f"{what} must be whole numbers in rows of one length.") from error
    except OverflowError as error:
        raise InvalidInputError(f"{what}: a number does not fit into 64 bits.") from error
    if array is None:
        raise InvalidInputError(f"{what} must be whole numbers.")
    exact = np.array_equal(whole, array)
    shape_fits = array.ndim == 2 and array.shape[1] == columns if columns else array.ndim == 1
    if not exact or not shape_fits:
        wanted = f"(m, {columns})" if columns else "(m,)"
        raise InvalidInputError(
            f"{what} must be whole numbers in an array of shape {wanted}"
            + (f", not {array.shape}." if exact else ".")
        )
    return whole


def rings_of(item):
    """The rings of one polygon: itself, or its outline and its holes."""
    rings = [item] if is_ring(item) else item
    if not isinstance(rings, (list, tuple)) or not rings:
        raise InvalidInputError(
            "A polygon is an array of shape (n, 2), or a list of such: its outline, then its holes."
        )
    refuse_odd_points(rings)
    return [points_array(ring, "A polygon") for ring in rings]
