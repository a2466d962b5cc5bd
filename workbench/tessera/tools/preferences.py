# SPDX-License-Identifier: MIT
"""What the user has chosen for all documents, in FreeCAD's parameter editor (Tools, Edit parameters)."""

import FreeCAD

GROUP = "User parameter:BaseApp/Preferences/Mod/Tessera"
_MOST_THREADS = 1024


def threads():
    """How many threads the mesher may use (the integer Threads); None, also for what is no such
    number: as many as there are cores. Meshes do not depend on it. For the main thread."""
    count = FreeCAD.ParamGet(GROUP).GetInt("Threads", 0)
    return count if 1 <= count <= _MOST_THREADS else None
