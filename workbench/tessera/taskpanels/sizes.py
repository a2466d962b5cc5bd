# SPDX-License-Identifier: MIT
"""The part of the task panel that asks for sizes: a table of local sizes, and what makes the whole
mesh finer where it has to be."""

import math
import re
from dataclasses import replace

import FreeCAD
from PySide import QtCore, QtGui

from tessera.tools import forms, resources
from tessera.tools.number_field import AreaField, NumberField, length_of, length_text
from tessera.tools.request import LocalSize
from tessera.tools.selection import picked_point, selected_places

translate = FreeCAD.Qt.translate

#: Fields of LocalSize in the columns after the first.
_LENGTHS = ("size", "distance", "far_size", "far_distance")


class SizesForm(QtCore.QObject):
    """A form and what it shows. Signals and bound methods make no cycle of references: FreeCAD
    deletes the widgets of a closed panel, and nothing may refer to them afterwards."""

    said = QtCore.Signal(str)  #: what the user should read

    def __init__(self, targets):
        super().__init__()
        self.form = forms.load("sizes")
        self.form.setWindowIcon(QtGui.QIcon(resources.icon("tessera_mesh_sketch")))
        self._targets = targets
        self._rows = []
        self._wrong = {}  # (row, column): text that is no length or place
        self._filling = False
        self._min_size = NumberField(self.form.minSizeField)
        self._chord_error = NumberField(self.form.chordErrorField)
        self._max_area = AreaField(self.form.maxAreaField)
        self._narrow_gaps = NumberField(self.form.narrowGapsField, is_length=False)
        self._default = 0.0
        self._table = self.form.sizeTable
        self._name_columns()
        self._connect()

    def _name_columns(self):
        columns = (
            (translate("Tessera", "Where"), translate("Tessera", "Edges, vertices, faces, or points")),
            (translate("Tessera", "Size"), translate("Tessera", "Length of the mesh edges there")),
            (
                translate("Tessera", "Up to"),
                translate(
                    "Tessera", "The size holds up to this distance, then grows by the growth rate"
                ),
            ),
            (
                translate("Tessera", "Far size"),
                translate(
                    "Tessera", "The size grows linearly to this one; empty: by the growth rate"
                ),
            ),
            (
                translate("Tessera", "Far at"),
                translate("Tessera", "The distance at which the far size is reached"),
            ),
        )
        self._table.setColumnCount(len(columns))
        for column, (label, explanation) in enumerate(columns):
            item = QtGui.QTableWidgetItem(label)
            item.setToolTip(explanation)
            self._table.setHorizontalHeaderItem(column, item)
        header = self._table.horizontalHeader()
        header.resizeSection(0, 90)  # the panel is narrow; the user can widen it
        for column in range(1, len(columns)):
            header.setSectionResizeMode(column, QtGui.QHeaderView.ResizeToContents)

    def _connect(self):
        form = self.form
        forms.connect(self._table, "itemChanged(QTableWidgetItem*)", self._on_changed)
        forms.connect(form.addSizeButton, "clicked()", self._add_selected)
        forms.connect(form.addPointButton, "clicked()", self._add_point)
        forms.connect(form.addRegionButton, "clicked()", self._add_region)
        forms.connect(form.removeSizeButton, "clicked()", self._remove)
        forms.connect(form.browseButton, "clicked()", self._browse)

    # Values

    def set(self, request):
        form = self.form
        self._default = request.size
        self._min_size.set(request.min_size)
        self._chord_error.set(request.chord_error)
        self._max_area.set(request.max_area)
        form.curvatureField.setValue(request.curvature)
        form.gapField.setValue(request.gap)
        self._narrow_gaps.set(request.narrow_gaps)
        form.expressionField.setText(request.expression)
        form.fileField.setText(request.size_file)
        form.arrayField.setEditText(request.size_array)
        self._rows = list(request.local_sizes)
        self._wrong = {}
        self._show_rows()

    def values(self):
        """Fields of a MeshRequest. ValueError with what was typed but means nothing."""
        for text in self._wrong.values():
            raise ValueError(text)
        return {
            "min_size": self._min_size.get(),
            "chord_error": self._chord_error.get(),
            "max_area": self._max_area.get(),
            "curvature": self.form.curvatureField.value(),
            "gap": self.form.gapField.value(),
            "narrow_gaps": self._narrow_gaps.get(),
            "expression": self.form.expressionField.text(),
            "size_file": self.form.fileField.text(),
            "size_array": self.form.arrayField.currentText(),
            "local_sizes": tuple(self._rows),
        }

    def of_source(self, values, source):
        """The values as far as they concern one of several sources."""
        rows = []
        for row in values["local_sizes"]:
            own = tuple((owner, names) for owner, names in row.elements if owner is source)
            if own or row.points or row.regions:
                rows.append(replace(row, elements=own))
        return {**values, "local_sizes": tuple(rows)}

    # Table

    def _show_rows(self):
        self._filling = True
        table = self._table
        table.setRowCount(len(self._rows))
        for number, row in enumerate(self._rows):
            text = _where_text(row, self._targets)
            where = QtGui.QTableWidgetItem(text)
            where.setToolTip(text)
            if not _point_of(row):
                where.setFlags(where.flags() & ~QtCore.Qt.ItemIsEditable)
            table.setItem(number, 0, where)
            for column, field in enumerate(_LENGTHS, start=1):
                value = getattr(row, field)
                text = length_text(value) if value > 0.0 or field == "size" else ""
                table.setItem(number, column, QtGui.QTableWidgetItem(text))
                if row.regions and column > 1:  # a size in a region ends where the region does
                    item = table.item(number, column)
                    item.setFlags(item.flags() & ~QtCore.Qt.ItemIsEditable)
        for (row, column), text in self._wrong.items():
            table.item(row, column).setText(text)
        self._filling = False
        table.setVisible(bool(self._rows))
        self.form.hint.setVisible(not self._rows)
        self.form.removeSizeButton.setEnabled(bool(self._rows))

    def _on_changed(self, item):
        if self._filling:
            return
        row, column, text = item.row(), item.column(), item.text()
        if column == 0:
            changed = _moved(self._rows[row], text)
        else:
            changed = self._resized(self._rows[row], _LENGTHS[column - 1], text)
        self._wrong.pop((row, column), None)
        if changed is None:
            self._wrong[(row, column)] = text
            item.setBackground(QtGui.QColor(255, 190, 190))
            template = translate("Tessera", "'{}' cannot be used here; give a number, such as 2 mm.")
            if column == 0:
                template = translate("Tessera", "'{}' is no point; give coordinates, such as 10; 5.")
            self.said.emit(template.format(text))
            return
        self._rows[row] = changed
        self._show_rows()

    def _resized(self, row, field, text):
        """The row with another length, or None. What is only shown rounded stays."""
        if text == length_text(getattr(row, field)):
            return row
        if not text.strip() and field != "size":
            return replace(row, **{field: 0.0})
        value = length_of(text, self._table.locale())
        return None if value is None else replace(row, **{field: value})

    def _append(self, row):
        self._rows.append(replace(row, size=float(f"{0.25 * self._default:.3g}")))
        self._show_rows()
        self._table.setCurrentCell(len(self._rows) - 1, 1)
        self._table.scrollToBottom()

    def _add_selected(self):
        elements = tuple(
            (owner, names) for owner, names in selected_places() if self._may_take(owner)
        )
        if not elements:
            self.said.emit(
                translate("Tessera", "Select edges, vertices or faces of {} in the 3D view first.")
                .format(", ".join(t.source.Label for t in self._targets if t.source))
            )
            return
        self._append(LocalSize(elements=elements))

    def _may_take(self, owner):
        return any(target.source is owner for target in self._targets)

    def _add_point(self):
        self._append(LocalSize(points=(self._chosen_point(),)))

    def _add_region(self):
        self._append(LocalSize(regions=(self._chosen_point(),)))

    def _chosen_point(self):
        source = self._targets[0].source
        point = picked_point(source) if source else None
        if point is None:
            point = _middle_of(source)
        return tuple(float(f"{c:.4g}") for c in point)

    def _remove(self):
        gone = {index.row() for index in self._table.selectedIndexes()}
        kept = [number for number in range(len(self._rows)) if number not in gone]
        self._wrong = {
            (kept.index(row), column): text
            for (row, column), text in self._wrong.items()
            if row in kept
        }
        self._rows = [self._rows[number] for number in kept]
        self._show_rows()

    # File

    def _browse(self):
        title = translate("Tessera", "Sizes from a file")
        name, _ = QtGui.QFileDialog.getOpenFileName(self.form, title, "", "VTU (*.vtu)")
        if name:
            self.form.fileField.setText(name)
            self.form.arrayField.clear()
            self.form.arrayField.addItems(point_arrays(name))


def point_arrays(name):
    """Names of a .vtu file's point data with one number at each node, in the file's order."""
    with open(name, "rb") as file:
        head = file.read(1 << 20).decode("latin-1")
    section = re.search(r"<PointData\b[^>]*>(.*?)</PointData>", head, re.DOTALL)
    tags = re.findall(r"<DataArray\b[^>]*>", section.group(1)) if section else []
    arrays = [dict(re.findall(r'(\w+)="([^"]*)"', tag)) for tag in tags]
    return [
        array["Name"]
        for array in arrays
        if "Name" in array and array.get("NumberOfComponents", "1") in ("0", "1")
    ]


def _point_of(row):
    """(field, point) of a row that is one point or region and nothing else."""
    if row.elements or len(row.points) + len(row.regions) != 1:
        return None
    return ("points", row.points[0]) if row.points else ("regions", row.regions[0])


def _where_text(row, targets):
    parts = []
    for owner, names in row.elements:
        listed = ", ".join(name for name in names if name)
        if len(targets) == 1 and owner is targets[0].source and listed:
            parts.append(listed)
        else:
            parts.append(f"{owner.Label}: {listed}" if listed else owner.Label)
    parts += [translate("Tessera", "Point {}").format(_numbers(p)) for p in row.points]
    parts += [translate("Tessera", "Region {}").format(_numbers(p)) for p in row.regions]
    return ", ".join(parts)


def _numbers(point):
    shown = point if point[2] != 0.0 else point[:2]
    return "; ".join(f"{c:.10g}" for c in shown)


def _moved(row, text):
    """The row at the coordinates in the text, or None."""
    field, _ = _point_of(row)
    numbers = re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", text)
    values = [float(n) for n in numbers]
    if len(values) not in (2, 3) or not all(map(math.isfinite, values)):
        return None
    point = tuple(values) if len(values) == 3 else (*values, 0.0)
    return replace(row, **{field: (point,)})


def _middle_of(source):
    """In the frame of a sketch, else in space."""
    shape = getattr(source, "Shape", None)
    if shape is None or shape.isNull():
        return (0.0, 0.0, 0.0)
    center = shape.BoundBox.Center
    if hasattr(source, "Geometry"):
        center = source.Placement.inverse().multVec(center)
        center.z = 0.0
    return tuple(center)
