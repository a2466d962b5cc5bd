# SPDX-License-Identifier: MIT
"""What the task panels of Booleans and imprints have in common: lists of sources, a preview of the
cells by color, and picking of the cells to keep, in a list or in the 3D view.

Nothing enters the document before OK, which is one step of undo.
"""

from typing import Any, Dict, List, NamedTuple

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import tessera
from tessera.objects.face_feature import apply_values
from tessera.taskpanels.source_list import SourceList, is_deleted
from tessera.taskpanels.task_panel import TaskPanel
from tessera.tools import cells, forms, kept_cells, resources
from tessera.tools.cell_preview import CellPreview
from tessera.tools.links import refuse_cycle
from tessera.tools.selection import select_places

translate = FreeCAD.Qt.translate

_INFORMATION = QtGui.QStyle.SP_MessageBoxInformation
_CRITICAL = QtGui.QStyle.SP_MessageBoxCritical


class PreviewCell(NamedTuple):
    """A cell as the panel shows it."""

    text: str  #: what covers it
    area: float
    faces: List[Any]  #: Part faces, where it is drawn
    cell: kept_cells.Cell


class Preview(NamedTuple):
    """What the panel shows."""

    cells: List[PreviewCell]
    placement: Any  #: 4 x 4, from the frame of the plane to space
    labels: Dict[str, str]  #: what the user calls the names in the covers of cells
    messages: List[str]


_NOTHING = Preview([], None, {}, [])


class CellsPanel(TaskPanel):
    """Task panel in FreeCAD's sense: form, accept, reject, getStandardButtons. A subclass has values(),
    preview(values), make(values) and meaning(), whose change makes other cells of all."""

    FORM = ""
    ICON = ""
    UNDO_TEXT = ""
    LISTS = ()

    def __init__(self, document, obj=None):
        self._document_name = document.Name
        self._edited = obj
        self._shown = _NOTHING
        self._kept = set()
        #: To be found among the next cells.
        self._remembered = (
            [] if obj is None else kept_cells.read(obj.KeptCells, obj.KeptCellCovers)
        )
        self._meant = None
        self._listing = False
        self._summary = ""
        self.form = forms.load(self.FORM)
        self.form.setWindowIcon(QtGui.QIcon(resources.icon(self.ICON)))
        self._cells_form = forms.load("cells")
        self.form.layout().addWidget(self._cells_form, 1)
        self._lists = [SourceList(self.form, stem, self.update) for stem in self.LISTS]
        self._table = self._cells_form.cellTable
        forms.connect(self._table, "itemChanged(QTableWidgetItem*)", self._on_item)
        forms.connect(self._table, "itemSelectionChanged()", self._paint)
        forms.connect(self._cells_form.keepAll, "clicked()", self._keep_all)
        forms.connect(self._cells_form.keepNone, "clicked()", self._keep_none)
        self._preview = CellPreview(self.toggle)

    @property
    def links(self):
        """[(object, names of faces)] of all lists."""
        return [link for one in self._lists for link in one.links]

    # Preview

    def update(self, *_):
        """Computes the cells anew; errors are told, and the geometry that they are about is
        selected. True if there are cells to show, and the user has seen what became of those that
        were kept."""
        kept = self._picks()
        if self._document_name not in FreeCAD.listDocuments():
            text = translate("Tessera", "The document has been closed; close the panel.")
            return self._fail(kept, text)
        if self._edited is not None and is_deleted(self._edited):
            text = translate("Tessera", "What is edited here has been deleted; close the panel.")
            return self._fail(kept, text)
        deleted = translate("Tessera", "{} has been deleted, and left the list.")
        news = [deleted.format(label) for one in self._lists for label in one.drop_deleted()]
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            if self._edited is not None:
                refuse_cycle(self._edited, [owner for owner, _ in self.links])
            preview = self.preview(self.values())
        except tessera.Error as error:
            self._fail(kept, " ".join([*news, str(error)]))
            self._select(error)
            return False
        except ImportError as error:
            return self._fail(kept, str(error))
        except ValueError as error:
            text = translate("Tessera", "'{}' cannot be used here; give a number, such as 2 mm.")
            return self._fail(kept, text.format(error))
        finally:
            QtGui.QApplication.restoreOverrideCursor()
        meaning = self.meaning()
        if self._meant not in (None, meaning):
            kept = [kept_cells.Kept(one.point) for one in kept]
        self._meant = meaning
        self._remembered = kept
        found = kept_cells.find([cell.cell for cell in preview.cells], kept, preview.labels)
        news += found.messages
        everything = range(len(preview.cells))
        self._show(preview, set(everything if found.are_lost else found.numbers))
        count = len(preview.cells)
        text = translate("Tessera", "{} cells").format(count) if count != 1 else \
            translate("Tessera", "1 cell")
        self._summary = "\n".join([text, *news, *preview.messages])
        self._tell(self._summary, _INFORMATION)
        return not news

    def _fail(self, kept, text):
        self._show(_NOTHING, set())
        self._remembered = kept
        self._tell(text, _CRITICAL)
        return False

    def _picks(self):
        """The kept cells, to be found again; none if all are kept."""
        if not self._shown.cells:
            return self._remembered
        return kept_cells.remember(
            [cell.cell for cell in self._shown.cells],
            self._kept,
            lambda number: kept_cells.inside_point(
                self._shown.cells[number].faces[0], self._shown.placement
            ),
        )

    def _show(self, preview, kept):
        self._shown = preview
        self._kept = kept
        self._preview.show([cell.faces for cell in preview.cells])
        self._list_cells()
        self._paint()

    def _list_cells(self):
        self._listing = True
        self._table.setRowCount(len(self._shown.cells))
        for row, cell in enumerate(self._shown.cells):
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
            self._table.setItem(row, 0, item)
        self._table.resizeRowsToContents()
        self._listing = False

    def _on_item(self, item):
        if self._listing:
            return
        if item.checkState() == QtCore.Qt.Checked:
            self._kept.add(item.row())
        else:
            self._kept.discard(item.row())
        self._tell(self._summary, _INFORMATION)
        self._paint()

    def toggle(self, number):
        """The user clicked on a cell in the 3D view."""
        self._table.item(number, 0).setCheckState(_check(number not in self._kept))

    def _keep_all(self):
        self._keep(True)

    def _keep_none(self):
        self._keep(False)

    def _keep(self, on):
        for row in range(len(self._shown.cells)):
            self._table.item(row, 0).setCheckState(_check(on))

    def _paint(self):
        marked = {index.row() for index in self._table.selectedIndexes()}
        self._preview.paint(self._kept, marked)

    def _tell(self, text, kind):
        icon = self.form.style().standardIcon(kind)
        self._cells_form.messageIcon.setPixmap(icon.pixmap(16, 16))
        self._cells_form.message.setText(text)

    def _select(self, error):
        owners = [owner for owner, _ in self.links]
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
        if self._shown.cells and not self._kept:
            self._tell(translate("Tessera", "Keep one cell at least."), _CRITICAL)
            return False
        if not self.update():
            return False
        document = FreeCAD.getDocument(self._document_name)
        kept = self._picks()
        values = {
            **self.values(),
            "KeptCells": [one.point for one in kept],
            "KeptCellCovers": [one.text for one in kept],
        }
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
        for owner, _ in self.links:
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


def fill_combo(combo, choices, value):
    """choices: [(value, text)]; value: the one that is shown."""
    for key, text in choices:
        combo.addItem(text, key)
    combo.setCurrentIndex(combo.findData(value))


def _check(on):
    return QtCore.Qt.Checked if on else QtCore.Qt.Unchecked
