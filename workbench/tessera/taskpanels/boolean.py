# SPDX-License-Identifier: MIT
"""The task panel of Booleans."""

import FreeCAD
import numpy as np

from tessera.objects import boolean
from tessera.taskpanels.cells import CellsPanel, PreviewCell, SourceList
from tessera.tools import forms

translate = FreeCAD.Qt.translate


class BooleanPanel(CellsPanel):
    """Which sources, which operation, which of its cells."""

    TITLE = translate("Tessera", "Boolean of sketches")
    ICON = "tessera_boolean"
    OBJECT_NAME = "TesseraBoolean"
    UNDO_TEXT = translate("Tessera", "Boolean of sketches")

    def __init__(self, links, obj=None):
        self.placement = np.eye(4)
        super().__init__((obj or links[0][0]).Document, obj)
        self._sources.set(links)
        if obj is not None:
            self._operation.setCurrentIndex(self._operation.findData(obj.Operation))
            self._priority.setCurrentIndex(self._priority.findData(obj.Priority))
            self._fill.setCurrentIndex(self._fill.findData(obj.Fill))
            self.set_length(self._weld, obj.Weld.Value)
            self._points = list(obj.KeptCells)
        else:
            self._operation.setCurrentIndex(self._operation.findData("Cells"))
        for field in (self._operation, self._priority, self._fill):
            field.currentIndexChanged.connect(self._on_changed)
        forms.connect(self._weld, "valueChanged(double)", self._on_changed)
        self._on_changed()

    @classmethod
    def of_object(cls, obj):
        return cls(obj.Sources, obj)

    def fields(self, layout):
        self._sources = SourceList(
            "source", translate("Tessera", "Sources, the first one first"), self._on_changed
        )
        layout.addWidget(self._sources.box)
        form = self.form_layout()
        self._operation = self.combo("operationField", _operation_texts())
        self._priority = self.combo("priorityField", _priority_texts())
        self._fill = self.combo("fillField", [(name, name) for name in boolean.FILL_RULES])
        self._weld = self.length_field("weldField")
        form.addRow(translate("Tessera", "Operation"), self._operation)
        form.addRow(translate("Tessera", "Overlaps belong to"), self._priority)
        form.addRow(translate("Tessera", "Fill"), self._fill)
        form.addRow(translate("Tessera", "Weld"), self._weld)
        layout.addLayout(form)

    def _on_changed(self, *_):
        self._priority.setEnabled(self._operation.currentData() == "Union")
        self.update()

    def links(self):
        return self._sources.links

    def values(self):
        return {
            "Sources": self._sources.values(),
            "Operation": self._operation.currentData(),
            "Priority": self._priority.currentData(),
            "Fill": self._fill.currentData(),
            "Weld": self.length_of(self._weld),
        }

    def preview_cells(self):
        values = self.values()
        polygons = boolean.combine(
            self._sources.items(),
            values["Operation"],
            values["Priority"],
            values["Fill"],
            values["Weld"],
        )
        self.placement = polygons.placement
        labels = [owner.Label for owner, _ in self._sources.links]
        whole = self._operation.currentText()
        found = [
            PreviewCell(
                " + ".join(labels[o] for o in polygon.operands) or whole,
                face.Area,
                [face],
                polygon.rings,
            )
            for polygon, face in zip(polygons, polygons.to_faces())
        ]
        return found, polygons.report["messages"]

    def make(self, values):
        sources = values.pop("Sources")
        return boolean.make_boolean(sources, values.pop("Operation"), **values)


def _operation_texts():
    return (
        ("Union", translate("Tessera", "Union")),
        ("Intersection", translate("Tessera", "Intersection")),
        ("Difference", translate("Tessera", "Difference: first less the others")),
        ("Symmetric difference", translate("Tessera", "Symmetric difference")),
        ("Cells", translate("Tessera", "Cells")),
    )


def _priority_texts():
    return (
        ("None", translate("Tessera", "all as one")),
        ("First", translate("Tessera", "the first source")),
        ("Last", translate("Tessera", "the last source")),
    )
