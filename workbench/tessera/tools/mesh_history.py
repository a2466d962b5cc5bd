# SPDX-License-Identifier: MIT
"""Meshes that undo and redo may need again."""

from collections import OrderedDict

import Fem

#: Triangles and nodes kept for undo: a million triangles with their nodes take about 160 MB.
MAX_ITEMS = 3_000_000


class MeshHistory:
    """FemMeshes by revision number, the latest ones as far as memory is meant for them.

    FreeCAD does not bring back an earlier FemMesh on undo. It does bring back the revision number,
    which finds the mesh here. A mesh that is no longer here has to be made again.
    """

    def __init__(self, max_items=MAX_ITEMS):
        self._meshes = OrderedDict()
        self._max_items = max_items
        self._latest = 0

    def __contains__(self, revision):
        return revision in self._meshes

    def __len__(self):
        return len(self._meshes)

    def get(self, revision):
        """The mesh, or None. Revision 0 is always the empty mesh."""
        if revision == 0:
            return Fem.FemMesh()
        return self._meshes.get(revision)

    def next_revision(self, current):
        """A number that no mesh has had."""
        self._latest = max(self._latest, current, *self._meshes, 0) + 1
        return self._latest

    def remember(self, revision, mesh):
        """Keeps the mesh; forgets the oldest others that are too many."""
        self._meshes[revision] = mesh
        self._meshes.move_to_end(revision)
        total = sum(_items(kept) for kept in self._meshes.values())
        while total > self._max_items and len(self._meshes) > 2:
            _, oldest = self._meshes.popitem(last=False)
            total -= _items(oldest)


def _items(mesh):
    return mesh.NodeCount + mesh.FaceCount + mesh.EdgeCount
