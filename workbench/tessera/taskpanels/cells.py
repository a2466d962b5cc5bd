# SPDX-License-Identifier: MIT
"""What the task panels of Booleans and imprints have in common: lists of sources, a preview of the
cells by color, and picking of the cells to keep, in a list or in the 3D view.

Nothing enters the document before OK, which is one step of undo.
"""

from typing import Any, List, NamedTuple

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import tessera
from tessera.objects.face_feature import apply_values
from tessera.taskpanels.task_panel import TaskPanel
from tessera.tools import cells, resources
from tessera.tools.cell_preview import CellPreview
from tessera.tools.selection import select_places, selected_sources

translate = FreeCAD.Qt.translate

_INFORMATION = QtGui.QStyle.SP_MessageBoxInformation
_CRITICAL = QtGui.QStyle.SP_MessageBoxCritical


class PreviewCell(NamedTuple):
    """A cell as the panel shows it."""

    text: str  #: what covers it
    area: float
    faces: List[Any]  #: Part faces, where it is drawn
    rings: Any  #: in the frame of the plane


class SourceList:
    """A list of sources with buttons that add what is selected and remove what is marked."""

    def __init__(self, name, title, changed):
        self.links = []
        self._changed = changed
        self.box = QtGui.QGroupBox(title)
        self.list = QtGui.QListWidget()
        self.list.setObjectName(f"{name}List")
        self.list.setMaximumHeight(90)
        narrow(self.list)
        self.list.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        add = QtGui.QPushButton(translate("Tessera", "Add selected"))
        add.setObjectName(f"{name}Add")
        remove = QtGui.QPushButton(translate("Tessera", "Remove"))
        remove.setObjectName(f"{name}Remove")
        layout = QtGui.QGridLayout(self.box)
        layout.addWidget(self.list, 0, 0, 1, 2)
        narrow(add)
        narrow(remove)
        layout.addWidget(add, 1, 0)
        layout.addWidget(remove, 1, 1)
        add.clicked.connect(self._add)
        remove.clicked.connect(self._remove)

    def set(self, links):
        """links: [(object, names of faces)]; those of one object are joined."""
        joined = {}
        for owner, names in links:
            joined.setdefault(owner, []).extend(name for name in names if name)
        self.links = [(owner, tuple(dict.fromkeys(names))) for owner, names in joined.items()]
        self.list.clear()
        for owner, names in self.links:
            self.list.addItem(f"{owner.Label}: {', '.join(names)}" if names else owner.Label)

    def values(self):
        """As a property takes them."""
        return [(owner, list(names) or [""]) for owner, names in self.links]

    def items(self):
        return cells.items_of(self.links)

    def _add(self):
        self.set([*self.links, *selected_sources()])
        self._changed()

    def _remove(self):
        rows = {index.row() for index in self.list.selectedIndexes()}
        self.set([link for row, link in enumerate(self.links) if row not in rows])
        self._changed()


class CellsPanel(TaskPanel):
    """Task panel in FreeCAD's sense: form, accept, reject, getStandardButtons. A subclass has
    fields(layout), values(), preview_cells() and make(values)."""

    TITLE = ""
    ICON = ""
    OBJECT_NAME = ""
    UNDO_TEXT = ""

    def __init__(self, document, obj=None):
        self._document_name = document.Name
        self._edited = obj
        self._cells = []
        self._kept = set()
        self._points = []  #: of a stored selection, until the cells are there
        self._listing = False
        self.form = QtGui.QWidget()
        self.form.setObjectName(self.OBJECT_NAME)
        self.form.setWindowTitle(self.TITLE)
        self.form.setWindowIcon(QtGui.QIcon(resources.icon(self.ICON)))
        self._preview = CellPreview(self.toggle)
        layout = QtGui.QVBoxLayout(self.form)
        self.fields(layout)
        self._add_table(layout)
        self._add_message(layout)

    # Form

    def _add_table(self, layout):
        box = QtGui.QGroupBox(translate("Tessera", "Cells to keep"))
        inner = QtGui.QVBoxLayout(box)
        self.table = QtGui.QTableWidget(0, 1)
        self.table.setObjectName("cellTable")
        self.table.setMinimumHeight(170)
        narrow(self.table)
        self.table.horizontalHeader().setVisible(False)
        self.table.setToolTip(
            translate("Tessera", "Which cells are kept; a click in the 3D view changes it too.")
        )
        self.table.horizontalHeader().setSectionResizeMode(0, QtGui.QHeaderView.Stretch)
        self.table.verticalHeader().setVisible(False)
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.table.itemChanged.connect(self._on_item)
        self.table.itemSelectionChanged.connect(self._paint)
        inner.addWidget(self.table)
        buttons = QtGui.QHBoxLayout()
        for name, text, slot in (
            ("keepAll", translate("Tessera", "All"), self._keep_all),
            ("keepNone", translate("Tessera", "None"), self._keep_none),
        ):
            button = QtGui.QPushButton(text)
            button.setObjectName(name)
            narrow(button)
            button.clicked.connect(slot)
            buttons.addWidget(button)
        inner.addLayout(buttons)
        layout.addWidget(box, 1)

    @staticmethod
    def form_layout():
        form = QtGui.QFormLayout()
        form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        return form

    def _add_message(self, layout):
        row = QtGui.QHBoxLayout()
        self._message_icon = QtGui.QLabel()
        self.message = QtGui.QLabel()
        self.message.setObjectName("message")
        self.message.setWordWrap(True)
        self.message.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        row.addWidget(self._message_icon, 0, QtCore.Qt.AlignTop)
        row.addWidget(self.message, 1)
        layout.addLayout(row)

    @staticmethod
    def combo(name, choices):
        """choices: [(value, text)]."""
        field = QtGui.QComboBox()
        narrow(field)
        field.setObjectName(name)
        for value, text in choices:
            field.addItem(text, value)
        return field

    @staticmethod
    def length_field(name):
        field = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        narrow(field)
        field.setObjectName(name)
        field.setProperty("unit", "mm")
        field.setProperty("minimum", 0.0)
        return field

    @staticmethod
    def set_length(field, value):
        field.setProperty("value", FreeCAD.Units.Quantity(value, FreeCAD.Units.Length))

    @staticmethod
    def length_of(field):
        return float(field.property("rawValue"))

    # Preview

    def update(self):
        """Computes the cells anew; errors are told, and the geometry that they are about is
        selected. True if there are cells to show."""
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            found, messages = self.preview_cells()
        except tessera.Error as error:
            self._show([])
            self._tell(str(error), _CRITICAL)
            self._select(error)
            return False
        except (ImportError, ReferenceError) as error:
            self._show([])
            self._tell(str(error), _CRITICAL)
            return False
        finally:
            QtGui.QApplication.restoreOverrideCursor()
        self._show(found)
        number = len(found)
        text = translate("Tessera", "{} cells").format(number) if number != 1 else \
            translate("Tessera", "1 cell")
        self._tell("\n".join([text, *messages]), _INFORMATION)
        return True

    def _show(self, found):
        points = self._points or self._kept_points()
        self._cells = found
        self._kept = set(cells.kept([cell.rings for cell in found], points))
        if not self._kept:
            self._kept = set(range(len(found)))
        self._points = []
        self._preview.show([cell.faces for cell in found])
        self._list_cells()
        self._paint()

    def _list_cells(self):
        self._listing = True
        self.table.setRowCount(len(self._cells))
        for row, cell in enumerate(self._cells):
            area = FreeCAD.Units.Quantity(cell.area, FreeCAD.Units.Area).UserString
            item = QtGui.QTableWidgetItem(f"{cell.text}\n{area}")
            item.setFlags(
                QtCore.Qt.ItemIsUserCheckable
                | QtCore.Qt.ItemIsEnabled
                | QtCore.Qt.ItemIsSelectable
            )
            item.setCheckState(_check(row in self._kept))
            swatch = QtGui.QPixmap(12, 12)
            swatch.fill(QtGui.QColor.fromRgbF(*cells.color(row)))
            item.setIcon(QtGui.QIcon(swatch))
            self.table.setItem(row, 0, item)
        self.table.resizeRowsToContents()
        self._listing = False

    def _on_item(self, item):
        if self._listing:
            return
        if item.checkState() == QtCore.Qt.Checked:
            self._kept.add(item.row())
        else:
            self._kept.discard(item.row())
        self._paint()

    def toggle(self, number):
        """The user clicked on a cell in the 3D view."""
        self.table.item(number, 0).setCheckState(_check(number not in self._kept))

    def _keep_all(self):
        for row in range(len(self._cells)):
            self.table.item(row, 0).setCheckState(QtCore.Qt.Checked)

    def _keep_none(self):
        for row in range(len(self._cells)):
            self.table.item(row, 0).setCheckState(QtCore.Qt.Unchecked)

    def _paint(self):
        marked = {index.row() for index in self.table.selectedIndexes()}
        self._preview.paint(self._kept, marked)

    def _kept_points(self):
        """Points that find the kept cells again; none if all are kept."""
        if len(self._kept) == len(self._cells):
            return []
        return [
            cells.inside_point(self._cells[number].faces[0], self.placement)
            for number in sorted(self._kept)
        ]

    def _tell(self, text, kind):
        self._message_icon.setPixmap(self.form.style().standardIcon(kind).pixmap(16, 16))
        self.message.setText(text)

    def _select(self, error):
        owners = [owner for owner, _ in self.links()]
        places = [place for place in error.places if place.source is not None]
        if places and places[0].source < len(owners):
            number = places[0].source
            select_places(owners[number], [p for p in places if p.source == number])

    # What FreeCAD calls

    def accept(self):
        """OK: FreeCAD closes the panel if the answer is True."""
        if self._document_name not in FreeCAD.listDocuments():
            self._preview.close()
            return True
        if self._cells and not self._kept:
            self._tell(translate("Tessera", "Keep one cell at least."), _CRITICAL)
            return False
        if not self.update():
            return False
        document = FreeCAD.getDocument(self._document_name)
        values = {**self.values(), "KeptCells": self._kept_points()}
        document.openTransaction(self.UNDO_TEXT)
        obj = self._edited
        if obj is None:
            obj = self.make(values)
        else:
            apply_values(obj, values)
        document.recompute([obj])
        if not obj.isValid():
            text = obj.getStatusString()
            document.abortTransaction()
            self._tell(text, _CRITICAL)
            return False
        for owner, _ in self.links():
            if self._edited is None and owner.ViewObject is not None:
                owner.ViewObject.Visibility = False
        document.commitTransaction()
        self._leave()
        return True

    def reject(self):
        """Cancel: the document is as it was before the panel opened."""
        self._leave()
        return True

    def _leave(self):
        self._preview.close()
        if self._document_name in FreeCAD.listDocuments():
            document = FreeCADGui.getDocument(self._document_name)
            if document.getInEdit() is not None:
                document.resetEdit()


def narrow(widget):
    """Lets the widget be as narrow as the task view is."""
    policy = widget.sizePolicy()
    policy.setHorizontalPolicy(QtGui.QSizePolicy.Ignored)
    widget.setSizePolicy(policy)
    widget.setMinimumWidth(60)


def _check(on):
    return QtCore.Qt.Checked if on else QtCore.Qt.Unchecked
