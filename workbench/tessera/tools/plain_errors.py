# SPDX-License-Identifier: MIT
"""Errors of a recompute as FreeCAD's report view shall show them: one sentence, no traceback."""


class _ShownAs(type):
    """FreeCAD puts the text of the class before the message."""

    def __str__(cls):
        return "Tessera"


class RecomputeError(RuntimeError, metaclass=_ShownAs):
    """Why an object could not be recomputed; the message is for the user."""


def recomputing(compute):
    """What FreeCAD shall call, with the object, to recompute: compute(obj), which may raise
    tessera.Error. An error marks the object, and FreeCAD shows it where the user looks for it."""
    from tessera.errors import Error

    def recompute(obj):
        try:
            compute(obj)
        except (Error, ImportError) as error:
            return RecomputeError(f"{obj.Label}: {error}")
        return None

    return _raising(recompute)


def _raising(function):
    """A callable that calls the function, and raises what it returns if that is an exception. It
    does so from compiled code: an exception raised in Python brings its traceback along."""
    try:
        from tessera.native import module as native
    except ImportError:  # not built: the error will say so
        return _Raising(function)
    return native.raising(function)


class _Raising:
    def __init__(self, function):
        self._function = function

    def __call__(self, *arguments):
        result = self._function(*arguments)
        if isinstance(result, BaseException):
            raise result
        return result
