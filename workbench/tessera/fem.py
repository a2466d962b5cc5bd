# SPDX-License-Identifier: MIT
"""A mesh as FreeCAD's FemMesh.

FreeCAD reads a .vtu with raw appended data about four times as fast as it adds nodes and triangles
one by one. It numbers what it reads by itself and complains about each edge, so edges are added
afterwards and all numbers are checked.
"""

import os
import tempfile

import Fem
import FreeCAD
import numpy as np

from tessera.errors import Error

_KINDS = {"triangles": "Face", "edges": "Edge", "nodes": "Node"}


def to_fem(mesh, placed=True):
    """The FemMesh of a tessera.Mesh."""
    fem = _read_triangles(mesh)
    _check_numbers(mesh, fem)
    edges = _add_edges(mesh, fem)
    _add_groups(mesh, fem, edges)
    if placed and not np.array_equal(mesh.placement, np.eye(4)):
        fem.transformGeometry(FreeCAD.Matrix(*mesh.placement.ravel()))
    return fem


def _read_triangles(mesh):
    folder = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    handle, path = tempfile.mkstemp(suffix=".vtu", prefix="tessera-", dir=folder)
    os.close(handle)
    try:
        mesh.write_triangles(path)
        return Fem.read(path)
    finally:
        os.remove(path)


def _check_numbers(mesh, fem):
    """FreeCAD gives number i + 1 to node i and triangle i of a .vtu."""
    nodes, triangles = len(mesh.nodes), len(mesh.triangles)
    good = fem.NodeCount == nodes and fem.FaceCount == triangles
    for i in {0, nodes - 1}:
        point = fem.getNodeById(i + 1) if good else None
        good = good and (point.x, point.y) == tuple(mesh.nodes[i])
    for i in {0, triangles - 1}:
        good = good and list(fem.getElementNodes(i + 1))[:3] == [
            int(node) + 1 for node in mesh.triangles[i]
        ]
    if not good:
        raise Error(
            f"FreeCAD read {fem.NodeCount} nodes and {fem.FaceCount} triangles instead of {nodes} "
            f"and {triangles}, or numbered them differently; report this with your version of it."
        )


def _add_edges(mesh, fem):
    """Numbers of the edges in FreeCAD."""
    ends = mesh.edges.astype(np.int64) + 1
    if mesh.order == 2:
        ends = np.column_stack([ends, mesh.edge_mid_nodes.astype(np.int64) + 1])
    return [fem.addEdge(nodes) for nodes in ends.tolist()]


def _add_groups(mesh, fem, edges):
    for group in mesh.groups.values():
        number = fem.addGroup(group.name, _KINDS[group.kind])
        if group.kind == "edges":
            members = [edges[i] for i in group.members]
        else:
            members = (group.members.astype(np.int64) + 1).tolist()
        fem.addGroupElements(number, members)
