# SPDX-License-Identifier: MIT
"""How document objects look in FreeCAD's window; same file names as in objects/."""
