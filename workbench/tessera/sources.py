# SPDX-License-Identifier: MIT
"""Turns what the user wants meshed into the compiled module's input.

A source is a sketch, a document object with a Shape, a link (object, ["Face1", ...]), a shape, or
arrays: (points, segments), (points, segments, markers), a polygon (n, 2), or a list of its outline
and holes. A list of sources makes one operand of each.
"""

from contextlib import contextmanager

import numpy as np

from tessera import arrays
from tessera.errors import Error, InvalidInputError, InvalidOptionError
from tessera.native import module as native


class Prepared:
    """The compiled input. base: 4 x 4, from its frame to the body or part that contains the first
    source; container: 4 x 4, from there to space. names finds what the user names in the sources."""

    def __init__(self, network, base, names, container):
        self.network = network
        self.base = base
        self.container = container
        self._names = names

    def curves(self, element):
        """Ids of the curves of an element, as for constraint."""
        return [
            curve
            for source, number in self._names.curves(element)
            for curve in self.network.curves_of(source, number)
        ]

    def place(self, element):
        """The point in space of "Vertex3" or (object, "Vertex3"); of a face, a point inside."""
        return self._names.place(element)

    def operands(self, element):
        """Ids of the operands of a source, by its number from 0 or its name."""
        return self.network.operands_of(self._names.source(element))

    def to_plane(self, point):
        """(x, y) in the frame of the plane of a point in space."""
        return self.network.to_plane((np.linalg.inv(self.base) @ (*point, 1.0))[:3].tolist())

    @contextmanager
    def placed_errors(self):
        """Errors of the compiled module know points in its own frame only."""
        try:
            yield
        except Error as error:
            with np.errstate(invalid="ignore"):  # the place of a point that is not finite
                error.places = [
                    place._replace(point=tuple((self.base @ (*place.point, 1.0))[:3].tolist()))
                    for place in error.places
                ]
            raise


def prepare(source, construction=False, constraint=(), boundary=(), ignore=()):
    """Reads the source. Raises tessera.Error."""
    items = _items(source)
    roles = (
        (native.Role.constraint, _list(constraint, "constraint")),
        (native.Role.boundary, _list(boundary, "boundary")),
        (native.Role.ignored, _list(ignore, "ignore")),
    )
    if any(_looks_like_cad(item) for item in items):
        return _prepare_cad(items, construction, roles)
    return _prepare_arrays(items, roles)


def _looks_like_cad(item):
    if isinstance(item, tuple) and len(item) == 2 and hasattr(item[0], "Shape"):
        return True
    return any(hasattr(item, name) for name in ("exportBrepToString", "Shape", "Geometry"))


def _items(source):
    """The operands one by one."""
    if source is None:
        raise InvalidInputError("There is no source; give a sketch, a shape or arrays.")
    if _looks_like_cad(source) or arrays.is_points_and_segments(source):
        return [source]
    if arrays.is_ring(source):
        return [source]
    if isinstance(source, np.ndarray):
        raise InvalidInputError(f"A polygon must have shape (n, 2), not {source.shape}.")
    if isinstance(source, (str, bytes, dict)) or not hasattr(source, "__iter__"):
        raise InvalidInputError(
            f"{source!r} is no source; give a sketch, a shape, (points, segments) or polygons."
        )
    items = list(source)
    arrays.refuse_odd_points(items)
    if not items:
        raise InvalidInputError("The list of sources is empty; give a sketch, a shape or arrays.")
    return items


def _list(value, what):
    """A list of elements; one may be given alone."""
    if value is None:
        return []
    if isinstance(value, (str, int, np.integer)) or _looks_like_cad(value):
        return [value]
    try:
        return list(value)
    except TypeError as error:
        raise InvalidOptionError(
            f"{what} must be a list of numbers or names, not a {type(value).__name__}."
        ) from error


# Arrays


def _prepare_arrays(items, roles):
    """roles: (role, elements); of several that name one element the last counts."""
    for _, elements in roles:
        for element in elements:
            if not _is_array_element(element, items):
                raise InvalidOptionError(_nothing_called(element))
    network = native.NetworkInput()
    for number, item in enumerate(items):
        name = f"Polygon{number + 1}"
        if arrays.is_points_and_segments(item):
            _add_segments(network, item, len(items), number, roles)
        else:
            role = native.Role.boundary
            for given, elements in roles:
                role = given if _has(elements, name, number) else role
            network.add_polygon(arrays.rings_of(item), name, role)
    return Prepared(network, np.eye(4), ArrayNames(items), np.eye(4))


class ArrayNames:
    """Segments by number, polygons by number or as "Polygon1", ..."""

    def __init__(self, items):
        self._items = items

    def curves(self, element):
        if not _is_array_element(element, self._items):
            raise InvalidOptionError(_nothing_called(element))
        if len(self._items) == 1 and arrays.is_points_and_segments(self._items[0]):
            return [(0, int(element))]
        return [(self.source(element), -1)]

    def source(self, element):
        if isinstance(element, str):
            names = [f"Polygon{i + 1}" for i in range(len(self._items))]
            element = names.index(element) if element in names else -1
        if not isinstance(element, (int, np.integer)) or not 0 <= element < len(self._items):
            raise InvalidOptionError(_nothing_called(element))
        return int(element)

    def place(self, element):
        raise InvalidOptionError(f"Arrays have no {element!r}; give the place as (x, y).")


def _nothing_called(element):
    return (
        f"There is nothing called {element!r} in the source; polygons are numbered from 0 or called "
        "'Polygon1', 'Polygon2', ...; segments are numbered from 0."
    )


def _has(elements, name, number):
    return any(
        element == name or (not isinstance(element, str) and element == number)
        for element in elements
    )


def _is_array_element(element, items):
    if isinstance(element, (int, np.integer)) and not isinstance(element, bool):
        if len(items) == 1 and arrays.is_points_and_segments(items[0]):
            segments = arrays.index_array(items[0][1], 2, "segments")
            return 0 <= element < len(segments)
        return 0 <= element < len(items)
    return isinstance(element, str) and element in {f"Polygon{i + 1}" for i in range(len(items))}


def _add_segments(network, item, count, number, roles):
    points = arrays.points_array(item[0], "points")
    segments = arrays.index_array(item[1], 2, "segments")
    markers = arrays.index_array(item[2] if len(item) == 3 else (), 0, "markers")
    given = []
    if count == 1:
        given = [(int(i), role) for role, elements in roles for i in elements]
    network.add_segments(points, segments, markers, f"Segments{number + 1}", given)


# FreeCAD


def _prepare_cad(items, construction, roles):
    from tessera import shapes

    for item in items:
        if not shapes.is_cad(item):
            raise InvalidInputError("Arrays and FreeCAD shapes cannot be used together.")
    sources = [shapes.make_source(item, construction) for item in items]
    added = []
    for role, elements in roles:
        for element in elements:
            if shapes.is_cad(element):
                added += _give_role(sources, element, role, construction, shapes)
            else:
                source, number = _find(sources, element)
                source.roles[number] = role
    everything = sources + added
    prefixes = _prefixes(everything)

    home = shapes.container_placement(everything[0].owner)
    placements = [
        _in_container(source, shapes.between_containers(source.owner, home))
        for source in everything
    ]
    base = next((p for s, p in zip(everything, placements) if s.placement is not None), None)
    network = native.NetworkInput()
    matrix = np.eye(4) if base is None else matrix_of(base)
    prepared = Prepared(network, matrix, CadNames(everything, home), matrix_of(home))
    given = [
        source.native(prefix, _to_frame(placement, base))
        for source, prefix, placement in zip(everything, prefixes, placements)
    ]
    with prepared.placed_errors():
        network.add_shapes(given, base is not None)
    return prepared


class CadNames:
    """Curves as for constraint, vertices as FreeCAD numbers them in the source's Shape. home: where
    the container of the first source lies."""

    def __init__(self, sources, home):
        self._sources = sources
        self._home = home

    def curves(self, element):
        if isinstance(element, tuple):
            owner, subs = element
            found = []
            for sub in [subs] if isinstance(subs, str) else subs:
                for index, source in enumerate(self._sources):
                    if source.owner is not owner:
                        continue
                    number = source.edge_number(sub) if sub else -1  # all of it
                    if number is not None:
                        found.append((index, number))
            if not found:
                raise InvalidOptionError(
                    f"{subs!r} of {owner.Label} is not a curve of what is meshed."
                )
            return found
        source, number = _find(self._sources, element)
        return [(self._sources.index(source), number)]

    def source(self, element):
        if isinstance(element, (int, np.integer)) and 0 <= element < len(self._sources):
            return int(element)
        prefixes = _prefixes(self._sources)
        if element in prefixes:
            return prefixes.index(element)
        raise InvalidOptionError(
            f"There is no source called {element!r}; sources are numbered from 0, or called by "
            f"their labels: {', '.join(map(repr, prefixes))}."
        )

    def place(self, element):
        from tessera.shapes import between_containers

        owners = [source.owner for source in self._sources]
        if isinstance(element, tuple):
            owner, name = element
            name = name if isinstance(name, str) else "".join(name)
        else:
            owner, name = owners[0], element
        shape = getattr(owner, "Shape", owner)
        for kind, elements in (("Vertex", shape.Vertexes), ("Face", shape.Faces)):
            digits = name[len(kind):]
            if not name.startswith(kind) or not digits.isdigit():
                continue
            if 1 <= int(digits) <= len(elements):
                chosen = elements[int(digits) - 1]
                point = chosen.Point if kind == "Vertex" else _point_inside(chosen)
                between = between_containers(owner, self._home)
                return tuple(point if between is None else between.multVec(point))
            raise InvalidOptionError(
                f"There is no {kind.lower()} called {name!r}; there are {len(elements)}, from "
                f"'{kind}1' on."
            )
        raise InvalidOptionError(f"{name!r} is no place; give a vertex, such as 'Vertex1'.")


def _point_inside(face):
    """The middle of the largest triangle of its picture."""
    points, triangles = face.tessellate(0.01 * face.BoundBox.DiagonalLength)
    corners = [[points[i] for i in triangle] for triangle in triangles]
    a, b, c = max(corners, key=lambda t: (t[1] - t[0]).cross(t[2] - t[0]).Length)
    return (a + b + c) / 3.0


def _in_container(source, between):
    """The placement that brings a source's shape into the container of the first one, from which
    another container leads by the given placement; None: it is there."""
    if between is None:
        return source.placement
    return between if source.placement is None else between.multiply(source.placement)


def _to_frame(placement, base):
    """The placement that goes on into the frame of the first sketch, whose own shape is in it
    already; None: leave it."""
    if base is None:
        return placement
    if placement is None:
        return base.inverse()
    if np.array_equal(matrix_of(placement), matrix_of(base)):
        return None
    return base.inverse().multiply(placement)


def _prefixes(sources):
    """What the names of each source's curves begin with: its label, made different from the others;
    nothing for a single shape without a label."""
    if len(sources) == 1:
        return [sources[0].label]
    prefixes = []
    for number, source in enumerate(sources):
        stem = prefix = source.label or f"Shape{number + 1}"
        count = 1
        while prefix in prefixes:
            count += 1
            prefix = f"{stem}_{count}"
        prefixes.append(prefix)
    return prefixes


def _find(sources, element):
    """(source, edge number) of a curve that the user named."""
    found = []
    for source, prefix in zip(sources, _prefixes(sources)):
        name = element
        if isinstance(element, (int, np.integer)) and len(sources) == 1:
            name = source.number_kind + str(element)
        if not isinstance(name, str):
            continue
        own = name[len(prefix) + 1:] if prefix and name.startswith(prefix + "_") else name
        if own == name and len(sources) > 1:
            continue
        number = source.edge_number(own)
        if number is not None:
            found.append((source, number))
    if len(found) != 1:
        first = next(iter(sources[0].numbers), "Edge1")
        known = first if len(sources) == 1 else f"{_prefixes(sources)[0]}_{first}"
        raise InvalidOptionError(
            f"There is no curve called {element!r} in the source; curves are called, for example, "
            f"{known!r}."
        )
    return found[0]


def _give_role(sources, item, role, construction, shapes):
    """Edges of a source get the role; other geometry is returned as further sources of
    constraints."""
    if shapes.is_link(item):
        owner, subs = item
        subs = [subs] if isinstance(subs, str) else list(subs)
        for source in sources:
            numbers = [source.edge_number(sub) for sub in subs]
            if source.owner is owner and subs and None not in numbers:
                for number in numbers:
                    source.roles[number] = role
                return []
    if role != native.Role.constraint:
        raise InvalidOptionError(
            "boundary and ignore take curves of what is meshed only; give other geometry as a "
            "source."
        )
    source = shapes.make_source(item, construction)
    for number in range(1, len(source.elements) + 1):
        source.roles[number] = role
    return [source]


def matrix_of(placement):
    """A FreeCAD Placement as a 4 x 4 array."""
    return np.array(placement.toMatrix().A, dtype=np.float64).reshape(4, 4)
