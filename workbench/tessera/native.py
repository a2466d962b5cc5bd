# SPDX-License-Identifier: MIT
"""Finds the compiled module; says how to build it if there is none for this Python."""

import sys
from pathlib import Path


class NotBuiltError(ImportError):
    """The compiled module is missing; the message says how to build it."""


def _explain(reason):
    folder = Path(__file__).resolve().parent
    version = "{}.{}".format(*sys.version_info[:2])
    others = sorted(path.name for path in folder.glob("_tessera*.so"))
    if others:
        found = f"found only {', '.join(others)}"
    else:
        found = "there is none"
    return (
        f"Tessera's compiled module for Python {version} cannot be loaded from {folder} ({found}; "
        f"{reason}). Build it with tools/build in Tessera's source folder, using the Python that "
        "FreeCAD uses, then start again."
    )


try:
    from tessera import _tessera as module
except ImportError as error:
    raise NotBuiltError(_explain(error)) from error
