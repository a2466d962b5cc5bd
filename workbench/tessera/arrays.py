# SPDX-License-Identifier: MIT
"""Sources given as arrays; FreeCAD is not needed."""

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


def points_array(points, what):
    """An (n, 2) array of floats."""
    try:
        array = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidInputError(f"{what} must be numbers in an array of shape (n, 2).") from error
    if array.size == 0:
        return array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise InvalidInputError(f"{what} must have shape (n, 2), not {array.shape}.")
    return array


def index_array(values, columns, what):
    """An integer array of shape (m, columns), or (m,) if columns is 0."""
    try:
        array = np.asarray(values)
        if array.size == 0:
            return np.zeros((0, columns) if columns else 0, dtype=np.int64)
        whole = array.astype(np.int64)
        exact = np.array_equal(whole, array)
    except (TypeError, ValueError, OverflowError) as error:
        raise InvalidInputError(f"{what} must be whole numbers.") from error
    shape_fits = array.ndim == 2 and array.shape[1] == columns if columns else array.ndim == 1
    if not exact or not shape_fits:
        wanted = f"(m, {columns})" if columns else "(m,)"
        raise InvalidInputError(f"{what} must be whole numbers in an array of shape {wanted}.")
    return whole


def rings_of(item):
    """The rings of one polygon: itself, or its outline and its holes."""
    rings = [item] if is_ring(item) else item
    if not isinstance(rings, (list, tuple)) or not rings:
        raise InvalidInputError(
            "A polygon is an array of shape (n, 2), or a list of such: its outline, then its holes."
        )
    return [points_array(ring, "A polygon") for ring in rings]
