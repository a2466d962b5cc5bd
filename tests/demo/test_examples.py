# SPDX-License-Identifier: MIT
"""resources/examples: the script draws the same every time, and the bundled documents are its."""

import os
import re
import subprocess
import zipfile
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
NAMES = ["boolean", "bracket", "concrete", "ship"]


def draw(folder):
    subprocess.run(
        ["freecadcmd", EXAMPLES / "make_examples.py"],
        env={**os.environ, "TESSERA_EXAMPLES_OUT": str(folder)},
        check=True,
        capture_output=True,
    )
    return folder


@pytest.fixture(scope="module")
def drawings(tmp_path_factory):
    return [draw(tmp_path_factory.mktemp("drawn")) for _ in range(2)]


def geometry(path):
    """The lines of a document that say what its sketches draw, without FreeCAD's numbering."""
    with zipfile.ZipFile(path) as archive:
        text = archive.read("Document.xml").decode()
    kinds = "LineSegment|ArcOfCircle|Circle|BSplineCurve|Pole"
    return re.findall(rf"<(?:{kinds}) [^>]*>", text)


@pytest.mark.parametrize("name", NAMES)
def test_drawing_twice_gives_the_same_bytes(drawings, name):
    first, second = ((folder / f"{name}.FCStd").read_bytes() for folder in drawings)
    assert first == second


@pytest.mark.parametrize("name", NAMES)
def test_bundled_document_is_what_the_script_draws(drawings, name):
    drawn = geometry(drawings[0] / f"{name}.FCStd")
    assert len(drawn) > 5
    assert geometry(EXAMPLES / f"{name}.FCStd") == drawn
