# SPDX-License-Identifier: MIT
"""Forms of task panels, loaded so that Python sees the widgets as what they are.

FreeCAD deletes the widgets of a closed panel behind PySide's back: a reference that is left to one,
by whomever, is taken for whatever new widget comes to lie at its address, with the class of the old
one. connect() leaves none, load() copes with those of others.
"""

import gc
from xml.etree import ElementTree

import FreeCADGui
from PySide import QtCore, QtGui

from tessera.tools import resources


def load(name):
    """The form in resources/ui. Loaded again, at other addresses, while it or any of its widgets is
    taken for another."""
    path = resources.form(name)
    names = [widget.get("name") for widget in ElementTree.parse(path).iter("widget")]
    loaded = []  # what is given up keeps its addresses meanwhile
    for _ in range(20):
        gc.collect()
        loaded.append(FreeCADGui.PySideUic.loadUi(path))
        if _is_seen_right(loaded[-1], names[1:]):
            loaded[-1].is_loaded = True
            break
    return loaded[-1]


def connect(widget, signal, slot):
    """As widget.signal.connect(slot), which in PySide2 keeps a reference to a widget of a form for
    ever. signal: as in Qt's own documentation, such as "clicked()"."""
    QtCore.QObject.connect(widget, QtCore.SIGNAL(signal), slot)


def text_line(spin_box):
    """The line inside a spin box in which the user types."""
    return spin_box.findChild(QtGui.QLineEdit)


def _is_seen_right(form, names):
    """The form and its widgets of these names."""
    if hasattr(form, "is_loaded"):  # taken for an older form, whose attributes it has
        return False
    try:
        return _has_right_class(form) and all(_has_right_class(getattr(form, n)) for n in names)
    except (AttributeError, RuntimeError):  # a reference that PySide knows to be to a deleted one
        return False


def _has_right_class(widget):
    if not isinstance(widget, _nearest_class(widget.metaObject())):
        return False
    return not widget.inherits("QAbstractSpinBox") or text_line(widget) is not None


def _nearest_class(meta):
    """The class that PySide has for a widget; of FreeCAD's own widgets, of what they derive from."""
    while meta is not None:
        known = getattr(QtGui, meta.className(), None)
        if known is not None:
            return known
        meta = meta.superClass()
    return QtGui.QWidget
