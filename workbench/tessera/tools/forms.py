# SPDX-License-Identifier: MIT
"""Forms of task panels, loaded so that Python sees the widgets as what they are.

FreeCAD deletes the widgets of a closed panel behind PySide's back: a reference that is left to one
is taken for whatever new object comes to lie at its address, with the class of the old one.
"""

import gc

import FreeCADGui
from PySide import QtCore

from tessera.tools import resources


def load(name):
    """The form in resources/ui. References in cycles, which only the collector finds, go first."""
    gc.collect()
    return FreeCADGui.PySideUic.loadUi(resources.form(name))


class TextLine:
    """The line inside a spin box, whatever class a reference that somebody else has left gives it:
    only what every QObject can do is asked of it."""

    def __init__(self, spin_box):
        self._edit = next(child for child in spin_box.children() if child.inherits("QLineEdit"))

    def text(self):
        return self._edit.property("text")

    def when_edited(self, function):
        """function gets the text after each change by the user."""
        QtCore.QObject.connect(self._edit, QtCore.SIGNAL("textEdited(QString)"), function)
