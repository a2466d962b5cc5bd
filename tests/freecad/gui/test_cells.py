# SPDX-License-Identifier: MIT
"""Booleans of sketches and imprinted faces, as a user makes them: cells by color, and picking."""

import math

import FreeCAD
import FreeCADGui
import imprints
import Part
import pytest
import sketches
import window
from FreeCAD import Vector
from PySide import QtCore, QtGui

LENS = 2 * math.pi / 3 - math.sqrt(3) / 2


class CellPanel(window.Panel):
    """The open task panel of a Boolean or an imprint."""

    @staticmethod
    def find():
        names = ("TesseraBoolean", "TesseraImprintedFaces")
        forms = [w for w in window.visible_widgets() if w.objectName() in names]
        return forms[0] if forms else None

    @property
    def message(self):
        return self.widget("message").text()

    def rows(self):
        """[(what covers the cell, is it kept)]."""
        model = self.widget("cellTable").model()
        return [
            (
                model.index(row, 0).data().split("\n")[0],
                model.index(row, 0).data(QtCore.Qt.CheckStateRole) == int(QtCore.Qt.Checked),
            )
            for row in range(model.rowCount())
        ]

    def keep(self, row, on):
        model = self.widget("cellTable").model()
        state = QtCore.Qt.Checked if on else QtCore.Qt.Unchecked
        model.setData(model.index(row, 0), int(state), QtCore.Qt.CheckStateRole)
        window.wait(0.1)

    def choose_operation(self, value):
        field = self.widget("operationField")
        field.setCurrentIndex(field.findData(value))
        window.wait(0.2)


def open_panel(command, *items):
    window.select(*items)
    FreeCADGui.updateGui()
    toolbar = window.main_window().findChild(QtGui.QToolBar, "Tessera")
    (action,) = [a for a in toolbar.actions() if a.text().replace("&", "") == command]
    assert not action.icon().isNull()
    window.wait_until(action.isEnabled, 10)
    action.trigger()
    return CellPanel()


def circle(document, name, x):
    sketch = sketches.new_sketch(document, name)
    sketch.addGeometry(Part.Circle(Vector(x, 0, 0), Vector(0, 0, 1), 1), False)
    document.recompute()
    return sketch


@pytest.fixture
def pair(document):
    made = [circle(document, "Left", 0), circle(document, "Right", 1)]
    window.show_from_above()
    return made


def gl_widget():
    """What the 3D view is drawn on."""
    widgets = window.visible_widgets()
    (widget,) = [w for w in widgets if w.metaObject().className().endswith("GLWidget")]
    return widget


def click(point):
    """Clicks in the 3D view where a point in space is seen."""
    view = FreeCADGui.activeDocument().activeView()
    x, y = view.getPointOnScreen(point)
    viewport = gl_widget()
    ratio = viewport.devicePixelRatio()
    position = QtCore.QPointF(x / ratio, viewport.height() - 1 - y / ratio)
    for kind, buttons in (
        (QtCore.QEvent.MouseMove, QtCore.Qt.NoButton),
        (QtCore.QEvent.MouseButtonPress, QtCore.Qt.LeftButton),
        (QtCore.QEvent.MouseButtonRelease, QtCore.Qt.NoButton),
    ):
        button = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseMove else QtCore.Qt.LeftButton
        event = QtGui.QMouseEvent(kind, position, button, buttons, QtCore.Qt.NoModifier)
        QtCore.QCoreApplication.sendEvent(viewport, event)
        window.wait(0.1)


def color_at(path, point):
    """Color in a picture of the screen where a point in space is seen."""
    view = FreeCADGui.activeDocument().activeView()
    viewport = gl_widget()
    x, y = view.getPointOnScreen(point)
    corner = viewport.mapToGlobal(QtCore.QPoint(0, 0))
    image = QtGui.QImage(str(path))
    return image.pixelColor(corner.x() + x, corner.y() + viewport.height() - 1 - y).getRgb()


def booleans(document):
    return [obj for obj in document.Objects if obj.Name.startswith("Boolean")]


def test_boolean_by_picking_cells(document, pair, output):
    panel = open_panel("Boolean of sketches", *pair)
    assert sorted(text for text, _ in panel.rows()) == ["Left", "Left + Right", "Right"]
    assert all(kept for _, kept in panel.rows())
    assert not booleans(document), "the preview is not in the document"
    window.picture(output / "boolean-panel.png")
    row = [text for text, _ in panel.rows()].index("Right")
    panel.widget("keepNone").click()
    panel.press("Ok")
    assert "at least" in panel.message and not booleans(document)
    panel.widget("keepAll").click()
    panel.keep(row, False)
    window.picture(output / "boolean-picked.png")
    panel.press("Ok")
    assert CellPanel.find() is None
    (obj,) = booleans(document)
    assert obj.Shape.Area == pytest.approx(math.pi, rel=1e-9)
    assert len(obj.Shape.Faces) == 2 and obj.Shape.isValid()
    window.picture(output / "boolean-done.png")
    assert color_at(output / "boolean-done.png", Vector(-0.5, 0, 0)) != color_at(
        output / "boolean-done.png", Vector(0.5, 0, 0)
    ), "each cell has a color of its own"
    window.undo(document)
    assert not booleans(document)
    window.redo(document)
    assert booleans(document)[0].Shape.Area == pytest.approx(math.pi, rel=1e-9)


def test_a_click_in_the_view_picks_a_cell(document, pair, output):
    panel = open_panel("Boolean of sketches", *pair)
    window.wait(0.5)
    names = [text for text, _ in panel.rows()]
    click(Vector(0.5, 0, 0))
    assert [kept for _, kept in panel.rows()] == [name != "Left + Right" for name in names]
    window.picture(output / "boolean-clicked.png")
    click(Vector(0.5, 0, 0))
    assert all(kept for _, kept in panel.rows())
    panel.press("Cancel")
    assert not booleans(document)


def test_operations_and_editing(document, pair, tmp_path):
    panel = open_panel("Boolean of sketches", *pair)
    panel.choose_operation("Difference")
    assert len(panel.rows()) == 1
    panel.press("Ok")
    (obj,) = booleans(document)
    assert obj.Shape.Area == pytest.approx(math.pi - LENS, rel=1e-9)
    assert obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    panel = CellPanel()
    panel.choose_operation("Intersection")
    panel.press("Cancel")
    assert obj.Operation == "Difference"
    assert obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    panel = CellPanel()
    panel.choose_operation("Intersection")
    panel.press("Ok")
    assert obj.Shape.Area == pytest.approx(LENS, rel=1e-9)
    name = obj.Name
    opened = window.reopen(document, tmp_path / "boolean.FCStd")
    again = opened.getObject(name)
    assert again.ViewObject.Proxy is not None
    again.Operation = "Union"
    opened.recompute()
    assert again.Shape.Area == pytest.approx(2 * math.pi - LENS, rel=1e-9)


def test_what_is_wrong_is_told_and_selected(document, pair):
    pair[1].Placement = FreeCAD.Placement(Vector(0, 0, 1), FreeCAD.Rotation(Vector(1, 0, 0), 30))
    document.recompute()
    panel = open_panel("Boolean of sketches", *pair)
    assert "out of the plane" in panel.message
    assert {name for name, _ in window.selected()} == {"Right"}
    assert not panel.rows()
    panel.press("Ok")
    assert CellPanel.find() is not None and not booleans(document)
    panel.press("Cancel")
    assert not booleans(document)


def no_traceback():
    view = window.main_window().findChild(QtGui.QTextEdit, "Report view")
    return "Traceback" not in view.toPlainText()


def test_the_document_is_closed_under_the_panel(document, pair):
    panel = open_panel("Boolean of sketches", *pair)
    name = document.Name
    FreeCAD.closeDocument(name)
    window.wait(0.3)
    if CellPanel.find() is not None:  # FreeCAD may have closed it
        panel.choose_operation("Union")
        assert "has been closed" in panel.message
        panel.press("Cancel")
    assert CellPanel.find() is None
    assert no_traceback()
    made = FreeCAD.newDocument(name)
    again = [circle(made, "Left", 0), circle(made, "Right", 1)]
    assert len(open_panel("Boolean of sketches", *again).rows()) == 3


def test_a_source_is_deleted_under_the_panel(document, pair):
    panel = open_panel("Boolean of sketches", *pair)
    document.removeObject("Right")
    panel.press("Ok")
    assert "Right has been deleted" in panel.message
    assert panel.rows() == [("Left", True)] and not booleans(document)
    document.removeObject("Left")
    panel.choose_operation("Union")
    assert "Left has been deleted" in panel.message and "no source" in panel.message
    panel.press("Cancel")
    assert CellPanel.find() is None
    assert no_traceback()


def test_what_is_edited_is_no_source_of_itself_and_may_be_deleted(document, pair):
    panel = open_panel("Boolean of sketches", *pair)
    panel.press("Ok")
    (obj,) = booleans(document)
    assert obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    panel = CellPanel()
    window.select(obj)
    panel.widget("sourceAdd").click()
    assert "cannot be its own source" in panel.message
    panel.press("Ok")
    assert CellPanel.find() is not None
    assert obj not in obj.OutList and obj.isValid()
    document.removeObject(obj.Name)
    window.wait(0.3)
    if CellPanel.find() is not None:  # FreeCAD may have closed it
        panel.press("Ok")
        assert "has been deleted" in panel.message
        panel.press("Cancel")
    assert CellPanel.find() is None and not booleans(document)
    assert no_traceback()


def test_lost_cells_and_empty_results_are_told(document, pair):
    panel = open_panel("Boolean of sketches", *pair)
    for row, (text, _) in enumerate(panel.rows()):
        panel.keep(row, text == "Left + Right")
    panel.press("Ok")
    (obj,) = booleans(document)
    assert obj.KeptCellCovers == ["Left+Right"]
    pair[1].Placement.Base = Vector(7, 0, 0)
    document.recompute()
    assert not obj.isValid() and obj.Shape.Area == pytest.approx(LENS)
    assert obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    panel = CellPanel()
    assert "kept cell of Left + Right is lost" in panel.message
    panel.choose_operation("Intersection")
    assert "The result is empty" in panel.message
    panel.choose_operation("Cells")
    panel.press("Ok")
    assert obj.isValid() and not obj.KeptCells
    assert obj.Shape.Area == pytest.approx(2 * math.pi)


def imprinted(document):
    return [obj for obj in document.Objects if obj.Name.startswith("ImprintedFaces")]


def show_at_an_angle():
    view = FreeCADGui.activeDocument().activeView()
    view.viewIsometric()
    view.fitAll()


def test_imprint_of_three_sources_and_four_targets(document, output, tmp_path):
    sources, targets = imprints.sources(document), imprints.targets(document)
    show_at_an_angle()
    panel = open_panel("Imprint faces", *[(obj, "Face1") for obj in sources + targets])
    assert panel.widget("sourceList").model().rowCount() == 3
    assert panel.widget("targetList").model().rowCount() == 4
    assert len(panel.rows()) == imprints.CELLS
    assert ("Source1 on Target1", True) in panel.rows()
    window.picture(output / "imprint-panel.png")
    panel.press("Ok")
    (obj,) = imprinted(document)
    assert obj.Shape.isValid() and len(obj.Shape.Faces) == 2 * imprints.CELLS
    for side, originals in zip(obj.Shape.SubShapes, (sources, targets)):
        for own, original in zip(side.SubShapes, originals):
            assert own.Area == pytest.approx(original.Shape.Area, rel=1e-9)
    window.picture(output / "imprint-done.png")
    window.undo(document)
    assert not imprinted(document)
    window.redo(document)
    name = imprinted(document)[0].Name
    opened = window.reopen(document, tmp_path / "imprint.FCStd")
    assert len(opened.getObject(name).Shape.Faces) == 2 * imprints.CELLS


def test_tilted_faces_are_told_and_selected(document):
    sources, targets = imprints.sources(document), imprints.targets(document)
    targets[2].Placement = FreeCAD.Placement(Vector(), FreeCAD.Rotation(Vector(1, 0, 0), 20))
    document.recompute()
    panel = open_panel("Imprint faces", *[(obj, "Face1") for obj in sources + targets])
    assert "tilted by 20 degrees" in panel.message
    assert window.selected() == {(targets[2].Name, ("Face1",))}
    targets[2].Placement = FreeCAD.Placement()
    document.recompute()
    panel.widget("toleranceField").findChild(QtGui.QLineEdit).setText("0.01 mm")
    window.wait(0.2)
    assert len(panel.rows()) == imprints.CELLS
    panel.press("Cancel")
    assert not imprinted(document)


@pytest.mark.parametrize("command", ["Boolean of sketches", "Imprint faces"])
def test_a_closed_panel_leaves_no_references(document, command):
    sources = [circle(document, "A", 0), circle(document, "B", 1)]
    for time in range(2):  # what stays after the first time is not the panel's
        before = window.references()
        open_panel(command, *sources)
        assert window.references() > before
        window.Panel.press("Cancel")
    assert not window.references() - before
