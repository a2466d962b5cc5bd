# SPDX-License-Identifier: MIT
"""What the user has selected, and how to show something by selecting it."""

import FreeCADGui

_SKETCH = "Sketcher::SketchObject"


def selected_sources():
    """[(object, names of its selected faces)] of what may be meshed: sketches, even empty ones, and
    objects with a shape."""
    sources = []
    for item in FreeCADGui.Selection.getSelectionEx():
        obj = item.Object
        if obj.isDerivedFrom(_SKETCH):
            sources.append((obj, ()))
        elif obj.isDerivedFrom("Part::Feature") and not obj.Shape.isNull():
            faces = [name for name in item.SubElementNames if name.startswith("Face")]
            sources.append((obj, tuple(faces)))
    return sources


def selected_edges():
    """[(object, names of its selected edges)]; "" stands for all of an object that is selected as a
    whole."""
    edges = []
    for item in FreeCADGui.Selection.getSelectionEx():
        names = [name for name in item.SubElementNames if name.startswith("Edge")]
        if not item.SubElementNames and item.Object.isDerivedFrom("Part::Feature"):
            names = [""]
        if names:
            edges.append((item.Object, tuple(names)))
    return edges


def selected_places():
    """[(object, names of its selected edges, vertices and faces)]."""
    places = []
    for item in FreeCADGui.Selection.getSelectionEx():
        kinds = ("Edge", "Vertex", "Face")
        names = tuple(name for name in item.SubElementNames if name.startswith(kinds))
        if names:
            places.append((item.Object, names))
    return places


def picked_point(source):
    """Where the user has clicked last, on the source or on anything else that is selected: in the
    frame of a sketch, else where the source's shape is; None if nothing was clicked."""
    from tessera.shapes import container_placement

    points = [point for item in FreeCADGui.Selection.getSelectionEx() for point in item.PickedPoints]
    if not points:
        return None
    point = container_placement(source).inverse().multVec(points[-1])
    if source.isDerivedFrom(_SKETCH):
        point = source.Placement.inverse().multVec(point)
        point.z = 0.0
    return tuple(point)


def select_places(source, places):
    """Selects the geometry of the source that an error is about; the source itself if the error
    names none that can be seen."""
    document, name = source.Document.Name, source.Name
    FreeCADGui.Selection.clearSelection()
    elements = {_visible_element(source, place.element) for place in places if place.element}
    elements.discard(None)
    for element in sorted(elements):
        FreeCADGui.Selection.addSelection(document, name, element)
    if not elements:
        FreeCADGui.Selection.addSelection(document, name)


def _visible_element(source, element):
    """What the 3D view calls "Geometry3" of a sketch."""
    prefix = "Geometry"
    if not (source.isDerivedFrom(_SKETCH) and element.startswith(prefix)):
        return element
    from tessera.shapes import edge_of_geometry

    return edge_of_geometry(source, int(element[len(prefix):]))
