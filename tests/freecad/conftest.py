# SPDX-License-Identifier: MIT
"""Fixtures of the tests inside FreeCAD."""

import os
from pathlib import Path

import FreeCAD
import pytest


@pytest.fixture
def document():
    """A new document, undo switched on as in FreeCAD's window; closed afterwards."""
    made = FreeCAD.newDocument("Test")
    made.UndoMode = 1
    yield made
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


@pytest.fixture
def output():
    """Folder for what a person may want to look at after the tests."""
    names = ("TESSERA_SCREENSHOTS", "TESSERA_TEST_OUTPUT")
    folder = next((os.environ[name] for name in names if os.environ.get(name)), None)
    path = Path(folder) if folder else Path(__file__).parents[2] / "build" / "test-output"
    path.mkdir(parents=True, exist_ok=True)
    return path
