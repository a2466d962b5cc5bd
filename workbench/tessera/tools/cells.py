# SPDX-License-Identifier: MIT
"""Cells of Booleans and imprints: how they are colored, and what their sources are called."""

import colorsys

#: Step of the hue from one cell to the next: neighbors in the list never look alike.
_GOLDEN = 0.618034


def color(number):
    """(r, g, b) of a cell by its number from 0."""
    return colorsys.hsv_to_rgb((0.52 + _GOLDEN * number) % 1.0, 0.45, 0.90)


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


def name_of(item, face=0):
    """What the document calls an item, or one of its faces, counted from 1: unlike a label or a
    place in the list it stays."""
    if not isinstance(item, tuple):
        return f"{item.Name}.Face{face}" if face else item.Name
    owner, faces = item
    return ".".join([owner.Name, *([faces[face - 1]] if face else faces)])
