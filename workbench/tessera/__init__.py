# SPDX-License-Identifier: MIT
"""Tessera: 2D meshes from sketches, planar faces and arrays.

    import tessera
    mesh = tessera.mesh(source, size=2.0)      # source: sketch, shape, list of them, or arrays
    mesh.nodes, mesh.triangles, mesh.groups, mesh.report
    mesh.to_fem(), mesh.write("a.vtu"), mesh.plot("a.png")
    tessera.overlay([a, b, c]).union()         # Booleans of any number of operands
    tessera.imprint(sources, targets).table    # which source piece lies on which target

Works the same in a FreeCAD macro, in FreeCAD's command line and in plain Python, where FreeCAD is
not needed for arrays. Errors are subclasses of tessera.Error.
"""

from tessera.errors import (
    CancelledError,
    Error,
    InvalidInputError,
    InvalidOptionError,
    NoInsideError,
    Place,
    TimeLimitError,
    TooLargeError,
    UnreadableError,
    UnwritableError,
)

# The workbench must start without the compiled module, to say how to build it: what needs it is
# loaded on first use.
_LAZY = {
    "mesh": ("tessera.meshing", "mesh"),
    "overlay": ("tessera.overlaying", "overlay"),
    "imprint": ("tessera.imprinting", "imprint"),
    "Mesh": ("tessera.result", "Mesh"),
    "Imprint": ("tessera.imprinting", "Imprint"),
    "Overlay": ("tessera.overlaying", "Overlay"),
    "Execution": ("tessera.meshing", "Execution"),
    "__version__": ("tessera.meshing", "VERSION"),
}

__all__ = [
    "CancelledError",
    "Error",
    "Execution",
    "Imprint",
    "InvalidInputError",
    "InvalidOptionError",
    "Mesh",
    "NoInsideError",
    "Overlay",
    "Place",
    "TimeLimitError",
    "TooLargeError",
    "UnreadableError",
    "UnwritableError",
    "imprint",
    "mesh",
    "overlay",
]


def __getattr__(name):
    if name not in _LAZY:
        raise AttributeError(f"module 'tessera' has no attribute {name!r}")
    from importlib import import_module

    module, attribute = _LAZY[name]
    value = getattr(import_module(module), attribute)
    globals()[name] = value
    return value


def __dir__():
    return sorted(set(globals()) | set(_LAZY))
