# SPDX-License-Identifier: MIT
"""Measures of a mesh from its arrays alone."""

from collections import Counter

import numpy as np


def triangle_areas(mesh):
    """Signed areas of the corner triangles."""
    a, b, c = (mesh.nodes[mesh.triangles[:, i]] for i in range(3))
    u, v = b - a, c - a
    return 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])


def side_counts(mesh):
    """How many triangles each side belongs to, by its sorted nodes."""
    sides = Counter()
    for corners in mesh.triangles.tolist():
        for i in range(3):
            sides[tuple(sorted((corners[i], corners[(i + 1) % 3])))] += 1
    return sides


def length_of(mesh, edges):
    """Sum of the straight lengths of the edges (k, 2)."""
    ends = mesh.nodes[np.asarray(edges, dtype=np.int64)]
    return np.hypot(*(ends[:, 1] - ends[:, 0]).T).sum()


def assert_conforming(mesh):
    """Counter-clockwise triangles; sides used once are exactly the group Outline, none more than
    twice; every node is used."""
    assert (triangle_areas(mesh) > 0).all()
    sides = side_counts(mesh)
    assert max(sides.values()) <= 2
    once = {side for side, count in sides.items() if count == 1}
    outline = {tuple(sorted(edge)) for edge in mesh.edges[mesh.groups["Outline"].members].tolist()}
    assert once == outline
    used = np.unique(mesh.triangles)
    if mesh.order == 2:
        used = np.union1d(used, mesh.triangle_mid_nodes)
    assert len(used) == len(mesh.nodes)
