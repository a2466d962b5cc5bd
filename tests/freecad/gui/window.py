# SPDX-License-Identifier: MIT
"""Hands and eyes of the tests in FreeCAD's window."""

import collections
import gc
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

COMMAND = "Tessera_MeshSketch"


def wait(seconds):
    """Lets the window live for a while."""
    wait_until(lambda: False, seconds, fail=False)


def wait_until(condition, seconds=60.0, fail=True):
    """Lets the window live until the condition holds."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            assert not fail, "it did not happen in time"
            return
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        time.sleep(0.005)


def picture(path, after=0.5):
    """A picture of the whole screen, 3D view included, after some seconds for drawing."""
    wait(after)
    assert QtGui.QApplication.primaryScreen().grabWindow(0).save(str(path))


def main_window():
    return FreeCADGui.getMainWindow()


def visible_widgets():
    """References from QObject.findChildren() would stay for ever and be taken for new widgets at
    the address of deleted ones; these go with the list."""
    return [widget for widget in QtGui.QApplication.allWidgets() if widget.isVisible()]


def references():
    """How many widgets of each class Python refers to."""
    gc.collect()
    widgets = [w for w in gc.get_objects() if isinstance(w, QtGui.QWidget)]
    return collections.Counter(type(w).__name__ for w in widgets)


def select(*items):
    """Objects, or (object, "Edge1", ...)."""
    FreeCADGui.Selection.clearSelection()
    for item in items:
        obj, *names = item if isinstance(item, tuple) else (item,)
        for name in names or [""]:
            FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, name)
    wait(0.1)


def selected():
    """{(object's name, sub-element names)}."""
    return {
        (item.ObjectName, tuple(item.SubElementNames))
        for item in FreeCADGui.Selection.getSelectionEx()
    }


def toolbar_action():
    """The button "Mesh sketch" in the workbench's toolbar."""
    toolbar = main_window().findChild(QtGui.QToolBar, "Tessera")
    (action,) = [a for a in toolbar.actions() if a.text().replace("&", "") == "Mesh sketch"]
    return action


def show_from_above():
    view = FreeCADGui.activeDocument().activeView()
    view.viewTop()
    view.fitAll()


class Panel:
    """The open task panel, as a user sees it. Widgets are looked up when they are needed: a
    reference to a deleted one could be taken for a new widget at the same address."""

    def __init__(self):
        wait_until(lambda: self.find() is not None, fail=False)
        assert self.find() is not None, (
            f"no panel opened; there is{'' if FreeCADGui.Control.activeDialog() else ' not'} a "
            f"dialog, the button is {'en' if toolbar_action().isEnabled() else 'dis'}abled, "
            f"selected: {selected()}"
        )

    @staticmethod
    def find():
        """The panel's form; those of closed panels may still wait to be deleted."""
        forms = [w for w in visible_widgets() if w.objectName() == "TesseraPlanarMesh"]
        return forms[0] if forms else None

    def widget(self, name):
        """In the panel's first box, or in that of the sizes."""
        forms = [w for w in visible_widgets() if w.objectName() == "TesseraSizes"]
        for form in [self.find(), *forms]:
            found = form.findChild(QtGui.QWidget, name)
            if found is not None:
                return found
        raise AssertionError(f"there is no {name}")

    def constraints(self):
        """What the list of constraint edges shows."""
        model = self.widget("constraintList").model()
        return [model.index(row, 0).data() for row in range(model.rowCount())]

    def sizes(self):
        """What the table of local sizes shows, row by row."""
        model = self.widget("sizeTable").model()
        return [
            [model.index(row, column).data() for column in range(model.columnCount())]
            for row in range(model.rowCount())
        ]

    def type_cell(self, row, column, text):
        """Types into the table of local sizes."""
        model = self.widget("sizeTable").model()
        model.setData(model.index(row, column), text)
        wait(0.1)

    @property
    def message(self):
        label = self.widget("message")
        return label.text() if label.isVisible() else ""

    @property
    def running(self):
        return self.widget("progressBar").isVisible()

    def set_size(self, text):
        self.type_length("sizeField", text)

    def type_length(self, name, text):
        """Types into a field."""
        self.widget(name).findChild(QtGui.QLineEdit).setText(text)
        wait(0.1)

    def press_keys(self, name, text):
        """Replaces what a field shows, key by key."""
        edit = self.widget(name).findChild(QtGui.QLineEdit)
        edit.selectAll()
        keys = [(QtCore.Qt.Key_Delete, "")] + [(0, character) for character in text]
        for key, character in keys:
            for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
                event = QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier, character)
                QtCore.QCoreApplication.sendEvent(edit, event)
        wait(0.1)

    def choose(self, name, text):
        combo = self.widget(name)
        index = combo.findText(text)
        assert index >= 0, f"there is no {text}"
        combo.setCurrentIndex(index)

    def press_mesh(self):
        self.widget("meshButton").click()

    def mesh(self):
        """Presses Mesh and waits for the end."""
        self.press_mesh()
        wait_until(lambda: not self.running, fail=False)
        bar = self.widget("progressBar")
        assert not self.running, f"still at {bar.value() / 10:g} %, {bar.text()}"
        wait(0.1)

    @staticmethod
    def press(button):
        """Presses OK or Cancel at the top of the task view."""
        _click_later(button)
        wait(0.3)


def _click_later(name):
    """Clicks when no reference is left here to what the click deletes."""
    kind = getattr(QtGui.QDialogButtonBox, name)
    for box in visible_widgets():
        button = box.button(kind) if isinstance(box, QtGui.QDialogButtonBox) else None
        if button is not None:
            QtCore.QTimer.singleShot(0, button.click)
            return
    raise AssertionError(f"there is no {name}")


def open_panel(*items):
    """Selects, then presses the toolbar's button."""
    select(*items)
    FreeCADGui.updateGui()
    wait_until(lambda: toolbar_action().isEnabled(), fail=False)
    assert toolbar_action().isEnabled(), f"nothing to mesh in what is selected: {selected()}"
    toolbar_action().trigger()
    return Panel()


def close_panel():
    """As users do: FreeCADGui.Control.closeDialog() would leave references to the form."""
    if FreeCADGui.Control.activeDialog():
        Panel.press("Cancel")
    assert not FreeCADGui.Control.activeDialog()


def double_click(obj):
    """Opens the panel of an object as a double click in the tree does."""
    assert obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    return Panel()


def planar_meshes(document):
    from tessera.objects.planar_mesh import is_planar_mesh

    return [obj for obj in document.Objects if is_planar_mesh(obj)]


def undo(document, count=1):
    for _ in range(count):
        document.undo()
    wait(0.1)


def redo(document, count=1):
    for _ in range(count):
        document.redo()
    wait(0.1)


def reopen(document, path):
    """Saves, closes and opens again."""
    document.saveAs(str(path))
    FreeCAD.closeDocument(document.Name)
    wait(0.1)
    opened = FreeCAD.openDocument(str(path))
    wait(0.3)
    return opened
