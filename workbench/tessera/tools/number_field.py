# SPDX-License-Identifier: MIT
"""Lengths, areas and numbers as users type them into the fields of a task panel."""

import math

import FreeCAD

from tessera.tools import forms


class NumberField:
    """A field that shows a number rounded: what the user leaves alone keeps all its digits.

    FreeCAD's fields for lengths silently replace what was typed but is no length, some at once,
    some when they lose the focus: get() raises ValueError with that text, and again as long as the
    field shows it."""

    def __init__(self, field, is_length=True):
        self._field = field
        self._is_length = is_length
        self._value = self._shown = 0.0
        self._refused = None
        self._line = forms.text_line(field)
        if is_length:
            forms.connect(self._line, "textEdited(QString)", self._note_typed)

    def _note_typed(self, text):
        is_length = length_of(text, self._field.locale()) is not None
        self._refused = None if is_length else text

    def set(self, value):
        if self._is_length:
            quantity = FreeCAD.Units.Quantity(value, FreeCAD.Units.Length)
            self._field.setProperty("value", quantity)
        else:
            self._field.setValue(value)
        self._value, self._shown, self._refused = value, self._read(), None

    def get(self):
        """Lengths in millimeters."""
        if self._refused is not None:
            text = self._refused
            if self._line.text() != text:
                self._refused = None
            raise ValueError(text)
        shown = self._read()
        return self._value if shown == self._shown else shown

    def _read(self):
        return float(self._field.property("rawValue" if self._is_length else "value"))


class AreaField:
    """A line of text for an area. FreeCAD's own fields refuse "10 m", for that is no area, so that
    they take "10 mm^2" for 10^2."""

    def __init__(self, line):
        self._line = line
        self._value, self._shown = 0.0, ""

    def set(self, value):
        self._line.setText(FreeCAD.Units.Quantity(value, FreeCAD.Units.Area).UserString)
        self._value, self._shown = value, self._line.text()

    def get(self):
        """Square millimeters; what is shown rounded and left alone keeps all its digits."""
        text = self._line.text()
        if text == self._shown:
            return self._value
        value = _amount_of(text.replace("²", "^2"), self._line.locale(), FreeCAD.Units.Area)
        if value is None:
            raise ValueError(text)
        return value


def length_of(text, locale):
    """Millimeters of a text that is a length of 0 or more, or a number; else None. Its unit and
    separators are the user's."""
    return _amount_of(text, locale, FreeCAD.Units.Length)


def _amount_of(text, locale, unit):
    plain = text.replace(locale.groupSeparator(), "").replace(locale.decimalPoint(), ".")
    for candidate in (text, plain):
        try:
            quantity = FreeCAD.Units.Quantity(candidate)
        except (ValueError, OSError, ArithmeticError, FreeCAD.Base.FreeCADError):
            continue
        is_usable = quantity.Unit in (unit, FreeCAD.Units.Unit())
        if is_usable and math.isfinite(quantity.Value) and quantity.Value >= 0.0:
            return float(quantity.Value) if candidate.strip() else None
    return None


def length_text(value):
    """A length in the user's unit, as the user would type it."""
    return FreeCAD.Units.Quantity(value, FreeCAD.Units.Length).UserString
