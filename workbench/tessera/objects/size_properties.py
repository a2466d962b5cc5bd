# SPDX-License-Identifier: MIT
"""Properties of a planar mesh that ask for sizes.

A document object has any number of local sizes: RefinedElements, RefinedSize and so on are the
first; RefinedElements2, RefinedSize2 and so on, which are added when they are needed, the second.
The names are stored in users' files: they never change.
"""

import FreeCAD

from tessera.tools.request import LocalSize

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

NORMAL = 0  #: attributes of a property that users edit

# (stem of the name, type, description, field of LocalSize)
_LOCAL = (
    (
        "RefinedElements",
        "App::PropertyLinkSubListGlobal",
        QT_TRANSLATE_NOOP(
            "App::Property", "Edges, vertices and faces of Source that get RefinedSize"
        ),
        "elements",
    ),
    (
        "RefinedPoints",
        "App::PropertyVectorList",
        QT_TRANSLATE_NOOP(
            "App::Property", "Points that get RefinedSize: x and y in a sketch, else in space"
        ),
        "points",
    ),
    (
        "RefinedRegions",
        "App::PropertyVectorList",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "RefinedSize holds everywhere in the regions around these points: x and y in a "
            "sketch, else in space",
        ),
        "regions",
    ),
    (
        "RefinedSize",
        "App::PropertyLength",
        QT_TRANSLATE_NOOP("App::Property", "Length of the mesh edges there; 0: as elsewhere"),
        "size",
    ),
    (
        "RefinedDistance",
        "App::PropertyLength",
        QT_TRANSLATE_NOOP(
            "App::Property", "RefinedSize holds up to this distance, and grows from there"
        ),
        "distance",
    ),
    (
        "RefinedFarSize",
        "App::PropertyLength",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "The size grows linearly to this one at RefinedFarDistance; 0: by GrowthRate",
        ),
        "far_size",
    ),
    (
        "RefinedFarDistance",
        "App::PropertyLength",
        QT_TRANSLATE_NOOP("App::Property", "Where RefinedFarSize is reached"),
        "far_distance",
    ),
)


def _name(stem, number):
    return stem if number == 1 else f"{stem}{number}"


def local_size_properties(number):
    """(name, type, group, description, default, attributes) of a local size, counted from 1."""
    group = "Sizes" if number == 1 else f"Sizes {number}"
    return tuple(
        (_name(stem, number), kind, group, description, None, NORMAL)
        for stem, kind, description, _ in _LOCAL
    )


SIZE_PROPERTIES = (
    (
        "MinSize",
        "App::PropertyLength",
        "Sizes",
        QT_TRANSLATE_NOOP("App::Property", "The mesh edges are nowhere made shorter; 0: no bound"),
        None,
        NORMAL,
    ),
    (
        "Curvature",
        "App::PropertyIntegerConstraint",
        "Sizes",
        QT_TRANSLATE_NOOP("App::Property", "Mesh edges for a full turn of a curve, from 3"),
        (20, 3, 10000, 1),
        NORMAL,
    ),
    (
        "ChordError",
        "App::PropertyLength",
        "Sizes",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Greatest distance between a curve and the straight mesh edges along it; 0: no bound",
        ),
        None,
        NORMAL,
    ),
    (
        "GapElements",
        "App::PropertyIntegerConstraint",
        "Sizes",
        QT_TRANSLATE_NOOP(
            "App::Property", "Elements across narrow gaps between curves; 0: gaps do not matter"
        ),
        (0, 0, 1000, 1),
        NORMAL,
    ),
    (
        "SizeExpression",
        "App::PropertyString",
        "Sizes",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Length of the mesh edges, in mm, as an expression in the sketch's x and y",
        ),
        None,
        NORMAL,
    ),
    (
        "SizeFile",
        "App::PropertyFile",
        "Sizes",
        QT_TRANSLATE_NOOP("App::Property", "A .vtu file with lengths of mesh edges at its nodes"),
        None,
        NORMAL,
    ),
    (
        "SizeArray",
        "App::PropertyString",
        "Sizes",
        QT_TRANSLATE_NOOP("App::Property", "Name of the point data of SizeFile, in mm"),
        None,
        NORMAL,
    ),
    *local_size_properties(1),
)


def links_of(links):
    """Of a property with links to edges, as a request has them."""
    return tuple((owner, tuple(names)) for owner, names in links)


def links_to(edges):
    return [(owner, list(names)) for owner, names in edges]


def _count(obj):
    """How many local sizes the object has properties for."""
    known = set(obj.PropertiesList)
    number = 1
    while _name("RefinedElements", number + 1) in known:
        number += 1
    return number


def _read(obj, number):
    values = {}
    for stem, kind, _, field in _LOCAL:
        value = getattr(obj, _name(stem, number))
        if kind == "App::PropertyLength":
            values[field] = value.Value
        elif kind == "App::PropertyVectorList":
            values[field] = tuple(tuple(point) for point in value)
        else:
            values[field] = links_of(value)
    return LocalSize(**values)


def local_sizes_of(obj):
    """What the object asks for, without what names no place."""
    sizes = (_read(obj, number) for number in range(1, _count(obj) + 1))
    return tuple(s for s in sizes if s.elements or s.points or s.regions)


def apply_local_sizes(obj, sizes):
    """Sets the properties, as far as they differ; adds and removes those of further sizes."""
    if local_sizes_of(obj) == sizes:
        return
    for number in range(_count(obj), max(len(sizes), 1), -1):
        for stem, *_ in _LOCAL:
            obj.removeProperty(_name(stem, number))
    for number in range(_count(obj) + 1, len(sizes) + 1):
        for name, kind, group, description, _, attributes in local_size_properties(number):
            obj.addProperty(kind, name, group, description, attributes)
    for number, size in enumerate(sizes or (LocalSize(),), start=1):
        current = _read(obj, number)
        for stem, kind, _, field in _LOCAL:
            value = getattr(size, field)
            if value == getattr(current, field):
                continue
            if kind == "App::PropertyVectorList":
                value = [FreeCAD.Vector(*point) for point in value]
            elif field == "elements":
                value = links_to(value)
            setattr(obj, _name(stem, number), value)
