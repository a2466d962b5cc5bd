# SPDX-License-Identifier: MIT
"""Run by FreeCAD when it starts, with or without a window: makes `import tessera` work."""

import inspect
import os
import sys


def _package_folder(variables):
    """The folder with the package `tessera`. FreeCAD runs this file by exec, without __file__: from
    1.0 on the code knows its file, before that the caller's variable InstallFile does. Links are
    not resolved: FreeCAD restores document objects from modules below a Mod folder only."""
    file = inspect.currentframe().f_code.co_filename
    if not os.path.isfile(file):
        file = variables["InstallFile"]
    return os.path.join(os.path.dirname(file), "workbench")


_folder = _package_folder(locals())
if _folder not in sys.path:
    sys.path.insert(0, _folder)
