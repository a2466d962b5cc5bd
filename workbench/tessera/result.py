# SPDX-License-Identifier: MIT
"""The finished mesh as Python sees it."""

import json
import os
from typing import NamedTuple, Tuple

import numpy as np

from tessera.errors import Error, UnwritableError
from tessera.native import module as native

_QUALITY_KEYS = ("min_angle_deg", "max_angle_deg", "angle_p01_deg", "min_quality", "mean_quality")


class Group(NamedTuple):
    """Some of a mesh's triangles, edges or nodes."""

    name: str
    kind: str  #: "triangles", "edges" or "nodes"
    members: np.ndarray  #: indices, ascending, uint32


class Region(NamedTuple):
    """A connected part of the inside."""

    area: float
    attribute: float
    operands: Tuple[int, ...]  #: indices of the operands that cover it
    triangles: np.ndarray  #: indices, ascending, uint32


class Mesh:
    """Triangles in the plane of their source. All arrays are read-only views without copies.

    nodes               (n, 2) float64, in the frame of the plane
    triangles           (m, 3) uint32, corners counter-clockwise
    edges               (k, 2) uint32, the edges on curves
    triangle_mid_nodes  (m, 3) uint32, order 2: opposite corner 0, 1, 2; else (0, 3)
    edge_mid_nodes      (k,) uint32, order 2; else (0,)
    triangle_regions    (m,) uint32, index into regions
    groups              {name: Group}
    regions             [Region]
    operands            names of the sources' parts
    placement           (4, 4) float64, from the frame of the plane to space
    order               1 or 2
    report              the dictionary that the command line writes as JSON
    """

    def __init__(self, data, base):
        self._data = data
        self.nodes = data.nodes
        self.triangles = data.triangles
        self.edges = data.edges
        self.triangle_mid_nodes = data.triangle_mid_nodes
        self.edge_mid_nodes = data.edge_mid_nodes
        self.triangle_regions = data.triangle_regions
        self.order = data.order
        self.operands = data.operands
        self.placement = base @ data.matrix
        self.report = json.loads(data.report)
        self.groups = {}
        for name, kind, members in data.groups:
            key = name if name not in self.groups else f"{name} ({kind})"
            self.groups[key] = Group(name, kind, members)
        self.regions = self._make_regions()

    def _make_regions(self):
        by_region = np.argsort(self.triangle_regions, kind="stable").astype(np.uint32)
        starts = np.searchsorted(
            self.triangle_regions[by_region], np.arange(len(self._data.regions) + 1)
        )
        return [
            Region(area, attribute, tuple(operands), by_region[starts[i] : starts[i + 1]])
            for i, (area, attribute, operands) in enumerate(self._data.regions)
        ]

    def __repr__(self):
        return (
            f"<tessera.Mesh: {len(self.nodes)} nodes, {len(self.triangles)} triangles of order "
            f"{self.order}, {len(self.groups)} groups>"
        )

    def points(self):
        """(n, 3): the nodes in space."""
        return self.nodes @ self.placement[:3, :2].T + self.placement[:3, 3]

    def quality(self):
        """Smallest, largest and 1st-percentile angle in degrees, smallest and mean quality."""
        return {key: self.report[key] for key in _QUALITY_KEYS}

    def triangle_quality(self):
        """(m,) float64: 4 sqrt(3) area / sum of squared edges of each triangle; 1: equilateral."""
        a, b, c = (self.nodes[self.triangles[:, i]] for i in range(3))
        u, v, w = b - a, c - a, c - b
        squares = (u * u + v * v + w * w).sum(axis=1)
        return 2.0 * np.sqrt(3.0) * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / squares

    def to_fem(self, placed=True):
        """A Fem.FemMesh with triangles, the edges on curves and all groups; at the place of the
        source in space, or with z = 0 in the frame of its plane. Raises tessera.Error outside of
        FreeCAD."""
        try:
            from tessera.fem import to_fem
        except ModuleNotFoundError as error:
            raise Error(
                "A FemMesh can only be made where FreeCAD runs; start the script with freecadcmd, "
                "or write the mesh to a file."
            ) from error

        return to_fem(self, placed)

    def write(self, path):
        """Writes by extension: .vtu, .vtk, .msh, .inp, .poly, .svg or .png, with z = 0 in the frame
        of the plane. Raises tessera.UnwritableError."""
        native.write(self._data, name_of(path))

    def write_triangles(self, path):
        """As write(), without the edges and the groups."""
        native.write_triangles(self._data, name_of(path))

    def plot(self, path):
        """Draws the mesh as .svg or .png, by extension."""
        path = name_of(path)
        if not path.lower().endswith((".svg", ".png")):
            raise UnwritableError(f"{path}: a picture is called .svg or .png.")
        native.write(self._data, path)


def name_of(path):
    try:
        return os.fsdecode(path)
    except TypeError as error:
        raise UnwritableError(f"The name of a file must be a text or a path, not {path!r}.") from error
