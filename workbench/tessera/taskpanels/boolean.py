# SPDX-License-Identifier: MIT
"""The task panel of Booleans."""

import FreeCAD

from tessera.objects import boolean
from tessera.taskpanels.cells import CellsPanel, Preview, PreviewCell, fill_combo
from tessera.tools import forms
from tessera.tools.number_field import NumberField

translate = FreeCAD.Qt.translate


class BooleanPanel(CellsPanel):
    """Which sources, which operation, which of its cells."""

    FORM = "boolean"
    ICON = "tessera_boolean"
    UNDO_TEXT = translate("Tessera", "Boolean of sketches")
    LISTS = ("source",)

    def __init__(self, links, obj=None):
        super().__init__((obj or links[0][0]).Document, obj)
        self._sources = self._lists[0]
        self._sources.set(links)
        form = self.form
        fills = [(name, name) for name in boolean.FILL_RULES]
        fill_combo(form.operationField, _operation_texts(), obj.Operation if obj else "Cells")
        fill_combo(form.priorityField, _priority_texts(), obj.Priority if obj else "None")
        fill_combo(form.fillField, fills, obj.Fill if obj else "Even-odd")
        self._weld = NumberField(form.weldField)
        self._weld.set(obj.Weld.Value if obj else 0.0)
        for field in (form.operationField, form.priorityField, form.fillField):
            forms.connect(field, "currentIndexChanged(int)", self.update)
        forms.connect(form.weldField, "valueChanged(double)", self.update)
        self.update()

    @classmethod
    def of_object(cls, obj):
        return cls(obj.Sources, obj)

    def update(self, *_):
        self.form.priorityField.setEnabled(self.form.operationField.currentData() == "Union")
        return super().update()

    def values(self):
        return {
            "Sources": self._sources.values(),
            "Operation": self.form.operationField.currentData(),
            "Priority": self.form.priorityField.currentData(),
            "Fill": self.form.fillField.currentData(),
            "Weld": self._weld.get(),
        }

    def meaning(self):
        form = self.form
        fields = (form.operationField, form.priorityField, form.fillField)
        return tuple(field.currentData() for field in fields)

    def preview(self, values):
        items = self._sources.items()
        polygons = boolean.combine(
            items, values["Operation"], values["Priority"], values["Fill"], values["Weld"]
        )
        labels = [owner.Label for owner, _ in self._sources.links]
        whole = self.form.operationField.currentText()
        found = [
            PreviewCell(" + ".join(labels[o] for o in polygon.operands) or whole, face.Area,
                        [face], cell)
            for polygon, face, cell in zip(
                polygons, polygons.to_faces(), boolean.cells_of(polygons, items)
            )
        ]
        messages = polygons.report["messages"]
        return Preview(found, polygons.placement, boolean.labels_of(items), messages)

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
