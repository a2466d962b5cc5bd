# SPDX-License-Identifier: MIT
"""What can go wrong, as exceptions. The message is one sentence that says what is wrong and what to
do; places say where."""

from typing import NamedTuple, Optional, Tuple


class Place(NamedTuple):
    """Where an error lies."""

    position: Tuple[float, float]  #: in the plane of the mesh
    point: Tuple[float, float, float]  #: the same in space
    curve: Optional[str] = None  #: name of the curve, as its edge group is called
    element: Optional[str] = None  #: "Edge7", "Geometry3" of a sketch, "Segment5"
    source: Optional[int] = None  #: index of the source that the element belongs to


class Error(Exception):
    """Base class; places is a list of Place, possibly empty."""

    def __init__(self, message, places=()):
        super().__init__(message)
        self.places = list(places)

    def __reduce__(self):
        return type(self), (str(self), self.places)


class InvalidInputError(Error, ValueError):
    """Not finite, out of range, not planar, or numbers that do not exist."""


class InvalidOptionError(Error, ValueError):
    """A size, angle, count or tolerance outside its range, or a name that does not exist."""


class NoInsideError(Error, ValueError):
    """No closed outline: nothing to mesh."""


class TooLargeError(Error):
    """The result would not fit into memory; the message has the estimate."""


class UnreadableError(Error):
    """A file that does not exist or is not in its format."""


class UnwritableError(Error):
    """A file that could not be written."""


class CancelledError(Error):
    """cancel() was called."""


class TimeLimitError(Error):
    """The time limit ran out."""
