# SPDX-License-Identifier: MIT
"""Every sketch and planar face of the FreeCAD files of other projects."""

import os
from pathlib import Path

import corpora_sketches
import pytest


@pytest.fixture
def folder():
    project = Path(__file__).resolve().parents[3]
    given = os.environ.get("TESSERA_CORPORA", project.parent / "shared" / "corpora")
    path = Path(given) / "cad" / "native"
    if not path.is_dir():
        pytest.skip(f"the corpora are not at {path}; set TESSERA_CORPORA")
    return path


def test_areas_are_freecads(folder, output):
    rows = [corpora_sketches.measure(path) for path in corpora_sketches.files(folder)]
    text = corpora_sketches.table(rows) + "\n" + corpora_sketches.refusals(rows)
    (output / "sketches.md").write_text(text)
    assert [(row.name, *wrong) for row in rows for wrong in row.wrong] == []
    assert sum(row.sketches for row in rows) >= 30
    assert sum(row.faces for row in rows) >= 300
    assert sum(row.compared for row in rows) >= 300
