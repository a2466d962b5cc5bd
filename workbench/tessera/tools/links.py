# SPDX-License-Identifier: MIT
"""What the objects of a document depend on beyond what FreeCAD watches."""

import FreeCAD

from tessera.errors import InvalidInputError
from tessera.shapes import container_placement, same_place

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

#: A hidden property, as (name, type, group, description, default, attributes).
CONTAINER_PLACEMENTS = (
    "ContainerPlacements",
    "App::PropertyPlacementList",
    "Result",
    QT_TRANSLATE_NOOP(
        "App::Property", "Where the bodies and parts of all that is linked were at the last recompute"
    ),
    None,
    1 | 4,
)


def note_containers(obj, counts_itself=False):
    """To be called by a recompute: moving a body or part does not touch what is in it, so
    containers_moved() has to compare."""
    obj.ContainerPlacements = _container_placements(obj, counts_itself)


def containers_moved(obj, counts_itself=False):
    """A body or part that holds something that the object links to, or itself if that counts, lies
    elsewhere than at the last recompute."""
    then = obj.ContainerPlacements
    if not then:
        return False  # it was never recomputed, and is touched
    now = _container_placements(obj, counts_itself)
    return len(now) != len(then) or not all(same_place(a, b) for a, b in zip(now, then))


def stay_in_space(obj):
    """Keeps an object that counts itself where it is seen when its own container has moved: it is
    made in space."""
    home = container_placement(obj)
    then = obj.ContainerPlacements[-1] if obj.ContainerPlacements else FreeCAD.Placement()
    if not same_place(home, then):
        obj.Placement = home.inverse().multiply(then).multiply(obj.Placement)


def _container_placements(obj, counts_itself):
    linked = {other.Name: other for other in obj.OutList}
    ordered = [linked[name] for name in sorted(linked)]
    return [container_placement(other) for other in ordered + [obj] * counts_itself]


def refuse_cycle(obj, owners):
    """Raises tessera.Error if one of the owners is made from the object."""
    for owner in owners:
        if _depends_on(owner, obj):
            what = "its own source"
            if owner is not obj:
                what = f"a source of {obj.Label}, which it is made from"
            raise InvalidInputError(
                f"{owner.Label} cannot be {what}; remove it from the sources."
            )


def _depends_on(owner, obj):
    waiting, seen = [owner], set()
    while waiting:
        other = waiting.pop()
        if other is obj:
            return True
        if other not in seen:
            seen.add(other)
            waiting += other.OutList
    return False
