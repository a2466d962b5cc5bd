# SPDX-License-Identifier: MIT
"""The task panel of imprints."""

import FreeCAD
import numpy as np
from PySide import QtGui

from tessera.objects import imprinted_faces
from tessera.taskpanels.cells import CellsPanel, PreviewCell, SourceList, narrow
from tessera.tools import forms

translate = FreeCAD.Qt.translate


class ImprintedFacesPanel(CellsPanel):
    """Which sources and targets, how far apart they may be, which of the cells."""

    TITLE = translate("Tessera", "Imprint faces")
    ICON = "tessera_imprint_faces"
    OBJECT_NAME = "TesseraImprintedFaces"
    UNDO_TEXT = translate("Tessera", "Imprint faces")

    def __init__(self, sources, targets, obj=None):
        self.placement = np.eye(4)
        super().__init__((obj or (sources + targets)[0][0]).Document, obj)
        self._sources.set(sources)
        self._targets.set(targets)
        if obj is not None:
            for field, value in zip(self._direction, obj.Direction):
                field.setValue(value)
            self.set_length(self._tolerance, obj.Tolerance.Value)
            self._fill = obj.Fill
            self._points = list(obj.KeptCells)
        forms.connect(self._tolerance, "valueChanged(double)", self._on_changed)
        for field in self._direction:
            field.valueChanged.connect(self._on_changed)
        self.update()

    @classmethod
    def of_object(cls, obj):
        return cls(list(obj.Sources), list(obj.Targets), obj)

    def fields(self, layout):
        self._fill = "Even-odd"
        self._sources = SourceList("source", translate("Tessera", "Sources"), self._on_changed)
        self._targets = SourceList("target", translate("Tessera", "Targets"), self._on_changed)
        layout.addWidget(self._sources.box)
        layout.addWidget(self._targets.box)
        form = self.form_layout()
        row = QtGui.QHBoxLayout()
        self._direction = []
        for axis in "XYZ":
            field = QtGui.QDoubleSpinBox()
            field.setObjectName(f"direction{axis}")
            narrow(field)
            field.setRange(-1e6, 1e6)
            field.setDecimals(4)
            field.setToolTip(
                translate("Tessera", "Direction of the sweep; 0, 0, 0: the normal of the sources")
            )
            row.addWidget(field)
            self._direction.append(field)
        self._tolerance = self.length_field("toleranceField")
        self._tolerance.setToolTip(
            translate(
                "Tessera", "Overlaps and gaps up to this width are closed; 0: as the faces need it"
            )
        )
        form.addRow(translate("Tessera", "Direction"), row)
        form.addRow(translate("Tessera", "Tolerance"), self._tolerance)
        layout.addLayout(form)

    def _on_changed(self, *_):
        self.update()

    def links(self):
        return self._sources.links + self._targets.links

    def values(self):
        return {
            "Sources": self._sources.values(),
            "Targets": self._targets.values(),
            "Direction": FreeCAD.Vector(*(field.value() for field in self._direction)),
            "Tolerance": self.length_of(self._tolerance),
            "Fill": self._fill,
        }

    def preview_cells(self):
        values = self.values()
        result = imprinted_faces.imprint_items(
            self._sources.items(),
            self._targets.items(),
            values["Direction"],
            values["Tolerance"],
            values["Fill"],
        )
        self.placement = result.placement
        faces = [[] for _ in result.cells]
        for sides, own_faces in (
            (result.sources, result.source_faces()),
            (result.targets, result.target_faces()),
        ):
            for side, own in zip(sides, own_faces):
                for cell, face in zip(side.cells, own):
                    faces[cell].append(face)
        found = [
            PreviewCell(
                imprinted_faces.history_text(result, number), cell.area, faces[number], cell.rings
            )
            for number, cell in enumerate(result.cells)
        ]
        closed = translate("Tessera", "Closed: {}")
        left = translate("Tessera", "Left: {}")
        messages = [closed.format(imprinted_faces.place_text(place)) for place in result.closed]
        messages += [left.format(imprinted_faces.place_text(place)) for place in result.left]
        return found, messages + result.messages

    def make(self, values):
        return imprinted_faces.make_imprinted_faces(
            values.pop("Sources"), values.pop("Targets"), **values
        )


def split_by_plane(links):
    """What is selected as (sources, targets): what lies in one plane with the first is a source; if
    everything does, the first alone."""
    if not links:
        return [], []
    planes = [_plane(owner, names) for owner, names in links]
    normal, height = planes[0]
    sources = [
        link
        for link, (_, other) in zip(links, planes)
        if abs(normal.dot(other) - normal.dot(height)) < 1e-6 * (1.0 + height.Length)
    ]
    if len(sources) == len(links):
        sources = links[:1]
    return sources, [link for link in links if link not in sources]


def split_faces(links):
    """Links to several faces as one for each."""
    return [
        (owner, names) for owner, all_names in links for names in ([(n,) for n in all_names] or [()])
    ]


def _plane(owner, names):
    """(normal, a point) of a face or sketch."""
    shape = owner.Shape.getElement(names[0]) if names else owner.Shape
    normal = owner.Placement.Rotation.multVec(FreeCAD.Vector(0, 0, 1))
    if shape.Faces:
        normal = shape.Faces[0].normalAt(0, 0)
    vertexes = shape.Vertexes
    return normal, vertexes[0].Point if vertexes else owner.Placement.Base
