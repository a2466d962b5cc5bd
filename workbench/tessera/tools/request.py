# SPDX-License-Identifier: MIT
"""What a user asks to be meshed, apart from where it is kept: in a document object's properties or
in the fields of a task panel."""

from dataclasses import dataclass
from typing import Any, Tuple

import tessera
from tessera.meshing import NARROW_GAPS

#: Values of the property Fill and what the mesher calls them.
FILLS = {
    "Even-odd": "even-odd",
    "Nonzero": "nonzero",
    "Positive": "positive",
    "Negative": "negative",
    "All": "all",
    "Hull": "hull",
}


Links = Tuple[Tuple[Any, Tuple[str, ...]], ...]  #: (object, names of its edges, vertices, faces)
Points = Tuple[Tuple[float, float, float], ...]


@dataclass(frozen=True)
class LocalSize:
    """An edge length at some places. Points are in the frame of a sketch, of other sources in
    space."""

    elements: Links = ()  #: edges, vertices, and faces, in which the size holds everywhere
    points: Points = ()
    regions: Points = ()  #: the size holds everywhere in the regions around these
    size: float = 0.0  #: mm; 0: as elsewhere
    distance: float = 0.0  #: the size holds up to this distance from the places, mm
    far_size: float = 0.0  #: size at far_distance, linear up to there, mm; 0: GrowthRate decides
    far_distance: float = 0.0  #: mm

    def law(self):
        """As tessera.mesh() takes sizes at places."""
        if self.far_size == 0.0 and self.far_distance == 0.0:
            return (self.size, self.distance)
        return (self.size, self.distance, self.far_size, self.far_distance)


@dataclass(frozen=True)
class MeshRequest:
    """Everything that decides what the mesh will be."""

    source: Any  #: document object, or None
    faces: Tuple[str, ...] = ()  #: names of the source's faces; none: the whole source
    size: float = 0.0  #: target edge length, mm
    count: int = 0  #: triangles to aim for instead, by finding the size; 0: size decides
    max_area: float = 0.0  #: of a triangle, mm^2; 0: no bound
    freeze_boundary: bool = False  #: no new nodes on straight edges
    narrow_gaps: float = NARROW_GAPS  #: share of triangles for gaps far narrower than the size
    growth: float = 0.3
    order: int = 1
    fill: str = "Even-odd"  #: a key of FILLS
    weld: float = 0.0  #: ends of curves closer than this become one, mm; 0: the shape's tolerance
    constraints: Links = ()  #: edges kept in the mesh that bound nothing
    boundaries: Links = ()  #: of the source
    ignored: Links = ()  #: of the source
    construction: bool = False  #: construction geometry of a sketch joins as constraints
    min_size: float = 0.0  #: nowhere smaller, mm; 0: no bound
    curvature: int = 20  #: mesh edges for a full turn of a curve
    chord_error: float = 0.0  #: greatest distance of mesh edges from curves, mm; 0: no bound
    gap: int = 0  #: elements across narrow gaps; 0: gaps do not matter
    local_sizes: Tuple[LocalSize, ...] = ()
    expression: str = ""  #: edge length as an expression in x and y, mm
    size_file: str = ""  #: a .vtu file with edge lengths at its nodes, mm
    size_array: str = ""  #: the name of its point data that holds them

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

    def mesh(self, prepared, progress=None, execution=None, threads=None):
        """Runs the mesher, on any thread. Raises tessera.Error."""
        return tessera.mesh(
            prepared,
            size=None if self.count else self.size,
            count=self.count or None,
            max_area=self.max_area or None,
            freeze_boundary=self.freeze_boundary,
            narrow_gaps=self.narrow_gaps,
            growth=self.growth,
            order=self.order,
            fill=FILLS[self.fill],
            weld=None if self.weld == 0.0 else self.weld,
            min_size=self.min_size or None,
            curvature=self.curvature,
            chord_error=self.chord_error or None,
            gap=self.gap or None,
            size_expr=self.expression.strip() or (),
            size_from=f"{self.size_file}:{self.size_array}" if self.size_file else None,
            **self._sizes_at_places(),
            threads=threads,
            progress=progress,
            execution=execution,
        )

    def _sizes_at_places(self):
        """size_at, size_on and size_in."""
        size_at, size_on, size_in = [], [], []
        has_frame = hasattr(self.source, "Geometry")  # a sketch: points are (x, y) in it
        for local in self.local_sizes:
            if local.size == 0.0:
                continue
            law = local.law()
            for link in ((owner, name) for owner, names in local.elements for name in names):
                if link[1].startswith("Vertex"):
                    size_at.append((link, *law))
                elif link[1].startswith("Face"):
                    size_in.append((link, local.size))
                else:
                    size_on.append((link, law))
            count = 2 if has_frame else 3
            size_at += [(point[:count], *law) for point in local.points]
            size_in += [(point[:count], local.size) for point in local.regions]
        return {"size_at": size_at, "size_on": size_on, "size_in": size_in}


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
