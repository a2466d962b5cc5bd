# SPDX-License-Identifier: MIT
"""FreeCAD's window, ready for a test."""

import gc

import FreeCADGui
import pytest
import window
from PySide import QtGui


@pytest.fixture(autouse=True)
def workbench():
    """The window in full size, the workbench active; the panel closed afterwards."""
    gc.collect()  # cycles may refer to deleted widgets, which PySide takes for new ones
    window.main_window().setGeometry(QtGui.QApplication.primaryScreen().geometry())
    FreeCADGui.activateWorkbench("TesseraWorkbench")
    window.wait(0.2)
    yield
    window.close_panel()
