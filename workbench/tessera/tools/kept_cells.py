# SPDX-License-Identifier: MIT
"""Which cells of a Boolean or an imprint are kept, remembered so that they are found again when the
sources change.

A kept cell is remembered by a point in it and by what covers it. It is the cell that holds the point,
if that has the same cover. If it has not, the source has moved away: then it is the only cell with
that cover, if there was only one before, too. Otherwise it is lost; another is never taken for it.
"""

from collections import Counter
from typing import Any, List, NamedTuple

import FreeCAD
import numpy as np

translate = FreeCAD.Qt.translate


class Cell(NamedTuple):
    """A cell to be found."""

    rings: Any  #: [(n, 2) float64] in the frame of the plane
    cover: str = ""  #: what covers it, from cover(); "": that is not known


class Kept(NamedTuple):
    """A kept cell, remembered."""

    point: Any  #: (x, y, ...) in the frame of the plane
    cover: str = ""
    count: int = 0  #: of cells with that cover

    @property
    def text(self):
        """cover and count, as a document stores them."""
        return self.cover if self.count <= 1 else f"{self.cover}, one of {self.count}"


class Found(NamedTuple):
    """What became of the kept cells."""

    numbers: List[int]  #: of the cells that are kept, ascending
    kept: List[Kept]  #: as they were given, with what was not known about them
    messages: List[str]  #: for the user
    are_lost: bool  #: there were kept cells, and none is left


def cover(*sides):
    """The names of what covers a cell, side by side: sources, and the targets of an imprint."""
    return "/".join("+".join(sorted(names)) for names in sides)


def read(points, texts):
    """[Kept] of what a document stores; texts count only if there is one for each point."""
    if len(texts) != len(points):
        return [Kept(point) for point in points]
    kept = []
    for point, text in zip(points, texts):
        cover, _, count = text.partition(", one of ")
        kept.append(Kept(point, cover, int(count) if count.isdigit() else 1))
    return kept


def find(cells, kept, labels):
    """Found for cells [Cell] and kept ones [Kept]; none kept: all are. labels: what the user calls
    the names in the covers."""
    if not kept:
        return Found(list(range(len(cells))), [], [], False)
    holders = _Holders(cells)
    by_cover = {}
    for number, cell in enumerate(cells):
        by_cover.setdefault(cell.cover, []).append(number)
    numbers, known, messages = set(), [], []
    for one in kept:
        number = holders.of(one.point)
        here = "" if number is None else cells[number].cover
        if number is not None and not (one.cover and here):
            one = Kept(one.point, here, len(by_cover[here]) if here else 0)
        elif number is None or here != one.cover:
            number, message = _elsewhere(one, by_cover.get(one.cover, ()), labels)
            messages.append(message)
        if number is not None:
            numbers.add(number)
        known.append(one)
    return Found(sorted(numbers), known, messages, not numbers)


def remember(cells, numbers, point_in):
    """[Kept] of some cells [Cell]; point_in(number) gives a point in one. None if all are kept."""
    if len(numbers) == len(cells):
        return []
    counts = Counter(cell.cover for cell in cells)
    return [
        Kept(point_in(number), cells[number].cover, counts[cells[number].cover])
        for number in sorted(numbers)
    ]


def _elsewhere(one, same, labels):
    """(number or None, message) of a kept cell that is not at its point; same: numbers of the cells
    with its cover."""
    if not one.cover:
        place = f"({one.point[0]:.6g}, {one.point[1]:.6g})"
        text = translate("Tessera", "A kept cell is lost: there is none at {} any more.")
        return None, text.format(place)
    words = _words(one.cover, labels)
    if one.count == 1 and len(same) == 1:
        text = translate("Tessera", "The kept cell of {} lies elsewhere now, and is kept there.")
        return same[0], text.format(words)
    text = translate("Tessera", "A kept cell of {} is lost; choose the cells again.")
    return None, text.format(words)


def _words(covering, labels):
    """A cover in the user's words."""
    nothing = translate("Tessera", "nothing")
    sides = (
        " + ".join(labels.get(name, name) for name in side.split("+")) or nothing
        for side in covering.split("/")
    )
    return translate("Tessera", " on ").join(sides)


class _Holders:
    """Finds the cell that holds a point."""

    def __init__(self, cells):
        self._cells = cells
        self._low = np.array([cell.rings[0].min(axis=0) for cell in cells]).reshape(-1, 2)
        self._high = np.array([cell.rings[0].max(axis=0) for cell in cells]).reshape(-1, 2)

    def of(self, point):
        """Its number, or None."""
        place = np.array([point[0], point[1]])
        near = np.nonzero(((self._low <= place) & (place <= self._high)).all(axis=1))[0]
        return next((int(n) for n in near if _contains(self._cells[n].rings, place)), None)


def _contains(rings, point):
    """The point (x, y) lies inside the polygon: an odd number of its edges lies to the right."""
    inside = False
    for ring in rings:
        x, y = ring.T
        next_x, next_y = np.roll(x, -1), np.roll(y, -1)
        spans = (y <= point[1]) != (next_y <= point[1])
        with np.errstate(divide="ignore", invalid="ignore"):
            at = x + (point[1] - y) / (next_y - y) * (next_x - x)
        inside ^= bool(np.count_nonzero(spans & (at > point[0])) % 2)
    return inside


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
