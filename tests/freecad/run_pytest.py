# SPDX-License-Identifier: MIT
"""Runs pytest inside FreeCAD: `freecadcmd run_pytest.py`, or `freecad run_pytest.py` for tests that
need its window. TESSERA_PYTEST holds pytest's arguments, one per line. Exits with pytest's status.

FreeCAD answers an error in a script with status 0, loses what was printed before an exit, and runs
the script a second time; so this one prints to the process's own output and ends the process."""

import os
import sys
import traceback


def run():
    status = 1
    try:
        sys.stdout = sys.__stdout__ = open(1, "w", buffering=1, closefd=False)
        sys.stderr = sys.__stderr__ = open(2, "w", buffering=1, closefd=False)
        import pytest

        arguments = ["-p", "no:cacheprovider", "-p", "no:faulthandler", "--capture=sys"]
        status = int(pytest.main(arguments + os.environ["TESSERA_PYTEST"].split("\n")))
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


import FreeCAD

if FreeCAD.GuiUp:
    from PySide import QtCore

    # The window is complete only when its event loop runs.
    QtCore.QTimer.singleShot(1500, run)
else:
    run()
