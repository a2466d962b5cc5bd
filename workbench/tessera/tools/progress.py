# SPDX-License-Identifier: MIT
"""FreeCAD's progress bar during a recompute."""

import time

import FreeCAD

#: Shorter runs show nothing, s.
_PATIENCE = 0.5
_STEPS = 100


class RecomputeProgress:
    """Context manager; call it as the mesher does, with (fraction, stage). Esc in FreeCAD's window
    raises an exception in the call, which ends the run."""

    def __init__(self, text):
        self._text = text
        self._begin = time.monotonic()
        self._indicator = None
        self._shown = 0

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        if self._indicator is not None:
            self._indicator.stop()

    def __call__(self, fraction, stage):
        if self._indicator is None:
            if time.monotonic() - self._begin < _PATIENCE:
                return
            self._indicator = FreeCAD.Base.ProgressIndicator()
            self._indicator.start(self._text, _STEPS)
        while self._shown < int(fraction * _STEPS):
            self._shown += 1
            self._indicator.next(True)
