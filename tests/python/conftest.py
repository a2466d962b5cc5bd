# SPDX-License-Identifier: MIT
"""Run with /usr/bin/python3 and PYTHONPATH=workbench. FreeCAD's modules are found where Debian puts
them; tests of arrays run without."""

import os
import sys
from pathlib import Path

import pytest

sys.path.append("/usr/lib/freecad-python3/lib")

PROJECT = Path(__file__).resolve().parents[2]


@pytest.fixture
def document():
    """A new FreeCAD document, closed afterwards."""
    import FreeCAD

    new = FreeCAD.newDocument()
    yield new
    FreeCAD.closeDocument(new.Name)


@pytest.fixture(scope="session")
def corpora():
    """Folder of the test corpora."""
    folder = Path(os.environ.get("TESSERA_CORPORA", PROJECT.parent / "shared" / "corpora"))
    if not folder.is_dir():
        pytest.skip(f"the corpora are not at {folder}; set TESSERA_CORPORA")
    return folder
