# SPDX-License-Identifier: MIT
"""Source and target faces of a sweep, imprinted on each other.

The class path and the property names are stored in users' files: they never change.
"""

import FreeCAD
import Part

import tessera
from tessera.objects.boolean import FILL_RULES
from tessera.objects.face_feature import NORMAL, READ_ONLY, FaceFeature, make_feature
from tessera.tools import cells, kept_cells

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class ImprintedFaces(FaceFeature):
    """Proxy of the document object. Its shape is a compound of two: of the sources and of the
    targets, each in pieces on its own plane."""

    Type = "Tessera::ImprintedFaces"
    MEANING = ("Fill",)
    PROPERTIES = (
        (
            "Sources",
            "App::PropertyLinkSubListGlobal",
            "Imprint",
            QT_TRANSLATE_NOOP("App::Property", "Sketches and planar faces where the sweep starts"),
            None,
            NORMAL,
        ),
        (
            "Targets",
            "App::PropertyLinkSubListGlobal",
            "Imprint",
            QT_TRANSLATE_NOOP("App::Property", "Sketches and planar faces where the sweep ends"),
            None,
            NORMAL,
        ),
        (
            "Direction",
            "App::PropertyVector",
            "Imprint",
            QT_TRANSLATE_NOOP(
                "App::Property", "Direction of the sweep; (0, 0, 0): the normal of the sources"
            ),
            None,
            NORMAL,
        ),
        (
            "Tolerance",
            "App::PropertyLength",
            "Imprint",
            QT_TRANSLATE_NOOP(
                "App::Property",
                "Overlaps and gaps up to this width are closed; 0: the tolerance of the faces",
            ),
            None,
            NORMAL,
        ),
        (
            "Fill",
            "App::PropertyEnumeration",
            "Imprint",
            QT_TRANSLATE_NOOP("App::Property", "Which parts between the curves of a sketch are in it"),
            list(FILL_RULES),
            NORMAL,
        ),
        (
            "History",
            "App::PropertyStringList",
            "Result",
            QT_TRANSLATE_NOOP("App::Property", "By cell: its source, and the target it lies on"),
            None,
            READ_ONLY,
        ),
        (
            "ClosedPlaces",
            "App::PropertyStringList",
            "Result",
            QT_TRANSLATE_NOOP("App::Property", "Overlaps and gaps that the tolerance closed"),
            None,
            READ_ONLY,
        ),
        (
            "LeftPlaces",
            "App::PropertyStringList",
            "Result",
            QT_TRANSLATE_NOOP("App::Property", "Wider overlaps and gaps, which were left alone"),
            None,
            READ_ONLY,
        ),
    )

    def view_provider(self):
        from tessera.viewproviders.cells import ViewProviderImprintedFaces

        return ViewProviderImprintedFaces

    def compute(self, obj):
        sources, targets = cells.items_of(obj.Sources), cells.items_of(obj.Targets)
        result = imprint_items(sources, targets, obj.Direction, obj.Tolerance.Value, obj.Fill)
        found, labels = cells_of(result, sources, targets)
        numbers, warnings = self.kept(obj, found, labels)
        numbers = set(numbers)
        sides = []
        flat = []
        for side, faces in (
            (result.sources, result.source_faces()),
            (result.targets, result.target_faces()),
        ):
            kept = [
                [(cell, face) for cell, face in zip(one.cells, own) if cell in numbers]
                for one, own in zip(side, faces)
            ]
            sides.append(
                Part.Compound([Part.Compound([face for _, face in own]) for own in kept])
            )
            flat += [pair for own in kept for pair in own]
        obj.Shape = Part.Compound(sides)
        shown = cells.different([face for _, face in flat])
        obj.FaceCells = [flat[number][0] for number in shown]
        obj.Cells = len(result.cells)
        obj.Area = sum((result.cells[number].area for number in numbers), 0.0)
        obj.History = [history_text(result, number) for number in range(len(result.cells))]
        obj.ClosedPlaces = [place_text(place) for place in result.closed]
        obj.LeftPlaces = [place_text(place) for place in result.left]
        self.tell(obj, warnings, result.messages)


def cells_of(result, sources, targets):
    """The cells of a tessera.Imprint as cells to be found again, and what the user calls the names in
    their covers."""
    sides = (result.sources, sources), (result.targets, targets)
    names = [
        [cells.name_of(items[one.item], one.face) for one in own] for own, items in sides
    ]
    found = [
        kept_cells.Cell(
            cell.rings,
            kept_cells.cover(
                [names[0][s] for s in cell.sources], [names[1][t] for t in cell.targets]
            ),
        )
        for cell in result.cells
    ]
    labels = {
        name: one.name for (own, _), side in zip(sides, names) for name, one in zip(side, own)
    }
    return found, labels


def imprint_items(sources, targets, direction=None, tolerance=0.0, fill="Even-odd"):
    """tessera.Imprint of what the values of the properties ask for. Raises tessera.Error."""
    if direction is not None and direction.Length == 0.0:
        direction = None
    return tessera.imprint(
        sources,
        targets,
        direction=None if direction is None else tuple(direction),
        tolerance=tolerance or None,
        fill=FILL_RULES[fill],
    )


def history_text(result, number):
    """A cell in words: "Lower: on Upper_Face2"."""
    cell = result.cells[number]
    sources = ", ".join(result.sources[s].name for s in cell.sources)
    targets = ", ".join(result.targets[t].name for t in cell.targets)
    none = translate("Tessera", "nothing")
    return translate("Tessera", "{} on {}").format(sources or none, targets or none)


def place_text(place):
    """A mismatch in words."""
    at = ", ".join(f"{x:.6g}" for x in place.at)
    return translate("Tessera", "{}, {:.4g} mm wide, at ({})").format(place.kind, place.width, at)


def make_imprinted_faces(sources, targets, **values):
    """For macros: an imprint of document objects, or links (object, ["Face1"]), as a document object
    beside the first; values: further properties. Call the document's recompute()."""

    def links(items):
        return [item if isinstance(item, tuple) else (item, [""]) for item in items]

    if not sources or not targets:
        raise tessera.InvalidInputError("An imprint needs at least one source and one target.")
    values = {"Sources": links(sources), "Targets": links(targets), **values}
    label = translate("Tessera", "Imprinted faces")
    document = values["Sources"][0][0].Document
    return make_feature(document, "ImprintedFaces", label, ImprintedFaces, values)
