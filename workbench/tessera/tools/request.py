# SPDX-License-Identifier: MIT
"""What a user asks to be meshed, apart from where it is kept: in a document object's properties or
in the fields of a task panel."""

from dataclasses import dataclass
from typing import Any, Tuple

import tessera

#: Values of the property Fill and what the mesher calls them.
FILLS = {
    "Even-odd": "even-odd",
    "Nonzero": "nonzero",
    "Positive": "positive",
    "Negative": "negative",
    "All": "all",
    "Hull": "hull",
}


@dataclass(frozen=True)
class MeshRequest:
    """Everything that decides what the mesh will be."""

    source: Any  #: document object, or None
    faces: Tuple[str, ...] = ()  #: names of the source's faces; none: the whole source
    size: float = 0.0  #: target edge length, mm
    growth: float = 0.3
    order: int = 1
    fill: str = "Even-odd"  #: a key of FILLS
    weld: float = 0.0  #: ends of curves closer than this become one, mm; 0: the shape's tolerance
    constraints: Tuple[Tuple[Any, Tuple[str, ...]], ...] = ()  #: (object, edge names)
    boundaries: Tuple[Tuple[Any, Tuple[str, ...]], ...] = ()  #: of the source
    ignored: Tuple[Tuple[Any, Tuple[str, ...]], ...] = ()  #: of the source
    construction: bool = False  #: construction geometry of a sketch joins as constraints
    curvature: int = 20  #: mesh edges for a full turn of a curve
    gap: int = 0  #: elements across narrow gaps; 0: gaps do not matter
    refined: Tuple[Tuple[Any, Tuple[str, ...]], ...] = ()  #: (object, edge and vertex names)
    refined_size: float = 0.0  #: edge length there, mm; 0: as elsewhere
    refined_distance: float = 0.0  #: up to this distance from there, mm
    expression: str = ""  #: edge length as an expression in x and y, mm

    def prepare(self):
        """Reads the document, on the main thread; the result does not look at it again."""
        from tessera.sources import prepare

        if self.source is None:
            raise tessera.InvalidInputError(
                "There is nothing to mesh; choose a sketch or a planar shape as Source."
            )
        item = (self.source, list(self.faces)) if self.faces else self.source
        return prepare(
            item,
            construction=self.construction,
            constraint=list(self.constraints),
            boundary=list(self.boundaries),
            ignore=list(self.ignored),
        )

    def mesh(self, prepared, progress=None, execution=None):
        """Runs the mesher, on any thread. Raises tessera.Error."""
        return tessera.mesh(
            prepared,
            size=self.size,
            growth=self.growth,
            order=self.order,
            fill=FILLS[self.fill],
            weld=None if self.weld == 0.0 else self.weld,
            curvature=self.curvature,
            gap=self.gap or None,
            size_expr=self.expression.strip() or (),
            **self._refined_sizes(),
            progress=progress,
            execution=execution,
        )

    def _refined_sizes(self):
        """size_on and size_at of the refined elements."""
        if self.refined_size == 0.0:
            return {}
        names = [(owner, name) for owner, names in self.refined for name in names]
        law = (self.refined_size, self.refined_distance)
        return {
            "size_on": [(link, law) for link in names if not link[1].startswith("Vertex")],
            "size_at": [(link, *law) for link in names if link[1].startswith("Vertex")],
        }


def default_size(source, faces=()):
    """A size that gives a mesh of moderate number: the diagonal / 40, in round figures; 0 if the
    source has no extent."""
    shape = getattr(source, "Shape", None)
    if shape is None or shape.isNull():
        return 0.0
    box = shape.BoundBox
    if faces:
        box = shape.getElement(faces[0]).BoundBox
        for face in faces[1:]:
            box.add(shape.getElement(face).BoundBox)
    if not box.isValid() or not box.DiagonalLength > 0.0:
        return 0.0
    return float(f"{box.DiagonalLength / 40.0:.3g}")
