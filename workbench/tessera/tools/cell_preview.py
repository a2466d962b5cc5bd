# SPDX-License-Identifier: MIT
"""Cells drawn into the 3D view while a task panel is open, for looking and for picking."""

import FreeCADGui
from pivy import coin

from tessera.tools import cells

_GREY = (0.75, 0.75, 0.75)
_KEPT, _LEFT_OUT, _MARKED = 0.15, 0.8, 0.0
_LIFT = -2.0  # polygon offset: in front of the faces that the cells come from


class CellPreview:
    """Colored faces above the document: nothing of it is in the document. picked(number) is called
    when the user clicks on a cell."""

    def __init__(self, picked):
        self._picked = picked
        self._view = None
        self._root = None
        self._nodes = []
        self._materials = []
        self._callback = None

    def show(self, faces):
        """Draws the cells, each a list of Part faces; replaces what is there."""
        self._attach()
        if self._root is None:
            return
        self._root.removeAllChildren()
        self._nodes = []
        self._materials = []
        offset = coin.SoPolygonOffset()
        offset.factor = _LIFT
        offset.units = _LIFT
        hints = coin.SoLightModel()
        hints.model = coin.SoLightModel.BASE_COLOR
        self._root.addChild(hints)
        self._root.addChild(offset)
        for own in faces:
            node = coin.SoSeparator()
            material = coin.SoMaterial()
            node.addChild(material)
            for face in own:
                node.addChild(_triangles(face))
            self._root.addChild(node)
            self._nodes.append(node)
            self._materials.append(material)

    def paint(self, kept, marked=()):
        """Colors the cells: those that are kept in their color, the others pale, marked ones full."""
        for number, material in enumerate(self._materials):
            material.diffuseColor = cells.color(number) if number in kept else _GREY
            material.transparency = (
                _MARKED if number in marked else _KEPT if number in kept else _LEFT_OUT
            )

    def cell_of(self, path):
        """Number of the cell that a path of the scene leads through, or None."""
        for number, node in enumerate(self._nodes):
            if path.containsNode(node):
                return number
        return None

    def close(self):
        if self._root is not None:
            try:
                self._view.removeEventCallbackPivy(
                    coin.SoMouseButtonEvent.getClassTypeId(), self._callback
                )
                self._view.getSceneGraph().removeChild(self._root)
            except RuntimeError:
                pass  # the view has been closed, and has taken all of it along
        self._view = self._root = self._callback = None
        self._nodes = []
        self._materials = []

    def _attach(self):
        if self._root is not None:
            return
        document = FreeCADGui.activeDocument()
        view = None if document is None else document.activeView()
        if not hasattr(view, "getSceneGraph"):
            return  # a spreadsheet or a drawing
        self._view = view
        self._root = coin.SoSeparator()
        view.getSceneGraph().addChild(self._root)
        self._callback = view.addEventCallbackPivy(
            coin.SoMouseButtonEvent.getClassTypeId(), self._on_mouse
        )

    def _on_mouse(self, callback):
        event = callback.getEvent()
        is_click = (
            event.getButton() == coin.SoMouseButtonEvent.BUTTON1
            and event.getState() == coin.SoButtonEvent.DOWN
        )
        point = callback.getPickedPoint() if is_click else None
        number = None if point is None else self.cell_of(point.getPath())
        if number is not None:
            callback.setHandled()
            self._picked(number)


def _triangles(face):
    corners, triangles = face.tessellate(0.005 * face.BoundBox.DiagonalLength)
    group = coin.SoGroup()
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(corners), [tuple(corner) for corner in corners])
    indices = [i for triangle in triangles for i in (*triangle, -1)]
    face_set = coin.SoIndexedFaceSet()
    face_set.coordIndex.setValues(0, len(indices), indices)
    shape = coin.SoShapeHints()  # seen from both sides
    shape.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    shape.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    for node in (shape, coordinates, face_set):
        group.addChild(node)
    return group
