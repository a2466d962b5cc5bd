# SPDX-License-Identifier: MIT
"""Cells of Booleans and imprints: how they are remembered, found again and colored."""

import colorsys

import FreeCAD
import numpy as np

#: Step of the hue from one cell to the next: neighbors in the list never look alike.
_GOLDEN = 0.618034


def color(number):
    """(r, g, b) of a cell by its number from 0."""
    return colorsys.hsv_to_rgb((0.52 + _GOLDEN * number) % 1.0, 0.45, 0.90)


def inside_point(face, placement):
    """A point (x, y, 0) of the plane's frame that lies well inside the Part face; placement leads from
    the frame to space."""
    corners, triangles = face.tessellate(0.01 * face.BoundBox.DiagonalLength)
    points = np.array([tuple(corner) for corner in corners])[np.array(triangles)]
    areas = np.linalg.norm(
        np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1
    )
    center = points[areas.argmax()].mean(axis=0)
    x, y, _, _ = np.linalg.inv(placement) @ (*center, 1.0)
    return FreeCAD.Vector(x, y, 0)


def contains(rings, point):
    """The point (x, y, ...) lies inside the polygon: an odd number of its edges lies to the right."""
    inside = False
    for ring in rings:
        x, y = ring.T
        next_x, next_y = np.roll(x, -1), np.roll(y, -1)
        spans = (y <= point[1]) != (next_y <= point[1])
        with np.errstate(divide="ignore", invalid="ignore"):
            at = x + (point[1] - y) / (next_y - y) * (next_x - x)
        inside ^= bool(np.count_nonzero(spans & (at > point[0])) % 2)
    return inside


def kept(all_rings, points):
    """Numbers of the cells that hold one of the points; without points all of them."""
    return [
        number
        for number, rings in enumerate(all_rings)
        if not points or any(contains(rings, point) for point in points)
    ]


def different(faces):
    """Numbers of the faces that a compound of them shows, which counts each face once."""
    seen = {}
    numbers = []
    for number, face in enumerate(faces):
        same = seen.setdefault(face.hashCode(), [])
        if not any(face.isSame(other) for other in same):
            same.append(face)
            numbers.append(number)
    return numbers


def items_of(links):
    """What a property with links gives, as tessera.overlay() and tessera.imprint() take it."""
    items = []
    for owner, names in links:
        faces = [name for name in names if name]
        items.append((owner, faces) if faces else owner)
    return items


def label_of(item):
    """What the user calls an item."""
    if isinstance(item, tuple):
        return f"{item[0].Label}: {', '.join(item[1])}"
    return item.Label
