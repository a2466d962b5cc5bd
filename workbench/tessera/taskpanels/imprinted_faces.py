# SPDX-License-Identifier: MIT
"""The task panel of imprints."""

import FreeCAD

from tessera.objects import imprinted_faces
from tessera.taskpanels.cells import CellsPanel, Preview, PreviewCell
from tessera.tools import forms
from tessera.tools.number_field import NumberField

translate = FreeCAD.Qt.translate


class ImprintedFacesPanel(CellsPanel):
    """Which sources and targets, how far apart they may be, which of the cells."""

    FORM = "imprinted_faces"
    ICON = "tessera_imprint_faces"
    UNDO_TEXT = translate("Tessera", "Imprint faces")
    LISTS = ("source", "target")

    def __init__(self, sources, targets, obj=None):
        super().__init__((obj or (sources + targets)[0][0]).Document, obj)
        self._sources, self._targets = self._lists
        self._sources.set(sources)
        self._targets.set(targets)
        self._fill = obj.Fill if obj else "Even-odd"
        form = self.form
        self._direction = [
            NumberField(field, is_length=False)
            for field in (form.directionX, form.directionY, form.directionZ)
        ]
        for field, value in zip(self._direction, obj.Direction if obj else (0.0, 0.0, 0.0)):
            field.set(value)
        self._tolerance = NumberField(form.toleranceField)
        self._tolerance.set(obj.Tolerance.Value if obj else 0.0)
        for field in (form.toleranceField, form.directionX, form.directionY, form.directionZ):
            forms.connect(field, "valueChanged(double)", self.update)
        self.update()

    @classmethod
    def of_object(cls, obj):
        return cls(list(obj.Sources), list(obj.Targets), obj)

    def values(self):
        return {
            "Sources": self._sources.values(),
            "Targets": self._targets.values(),
            "Direction": FreeCAD.Vector(*(field.get() for field in self._direction)),
            "Tolerance": self._tolerance.get(),
            "Fill": self._fill,
        }

    def meaning(self):
        return self._fill

    def preview(self, values):
        sources, targets = self._sources.items(), self._targets.items()
        result = imprinted_faces.imprint_items(
            sources, targets, values["Direction"], values["Tolerance"], values["Fill"]
        )
        faces = [[] for _ in result.cells]
        for sides, own_faces in (
            (result.sources, result.source_faces()),
            (result.targets, result.target_faces()),
        ):
            for side, own in zip(sides, own_faces):
                for cell, face in zip(side.cells, own):
                    faces[cell].append(face)
        found, labels = imprinted_faces.cells_of(result, sources, targets)
        shown = [
            PreviewCell(
                imprinted_faces.history_text(result, number),
                result.cells[number].area,
                faces[number],
                cell,
            )
            for number, cell in enumerate(found)
        ]
        closed = translate("Tessera", "Closed: {}")
        left = translate("Tessera", "Left: {}")
        messages = [closed.format(imprinted_faces.place_text(place)) for place in result.closed]
        messages += [left.format(imprinted_faces.place_text(place)) for place in result.left]
        return Preview(shown, result.placement, labels, messages + result.messages)

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
