# SPDX-License-Identifier: MIT
"""resources/examples: the script draws the same every time, and the bundled documents are its."""

import os
import subprocess
import xml.etree.ElementTree as ElementTree
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
    """[(kind, {attribute: number})] of what a document's sketches draw, without their axes, which
    only newer versions of FreeCAD write."""
    kinds = ("LineSegment", "ArcOfCircle", "Circle", "BSplineCurve", "Pole")
    with zipfile.ZipFile(path) as archive:
        text = archive.read("Document.xml").decode()
    drawn = []
    for sketch in ElementTree.fromstring(text).iter("Property"):
        if sketch.get("name") == "Geometry":
            for element in sketch.iter():
                if element.tag in kinds:
                    drawn.append((element.tag, {k: float(v) for k, v in element.items()}))
    return drawn


@pytest.mark.parametrize("name", NAMES)
def test_drawing_twice_gives_the_same_bytes(drawings, name):
    first, second = ((folder / f"{name}.FCStd").read_bytes() for folder in drawings)
    assert first == second


@pytest.mark.parametrize("name", NAMES)
def test_bundled_document_is_what_the_script_draws(drawings, name):
    drawn = geometry(drawings[0] / f"{name}.FCStd")
    bundled = geometry(EXAMPLES / f"{name}.FCStd")
    assert len(drawn) == len(bundled) > 5
    for (kind, numbers), (bundled_kind, bundled_numbers) in zip(drawn, bundled):
        assert kind == bundled_kind
        common = numbers.keys() & bundled_numbers.keys()
        assert len(common) >= 3
        # The solver of another version of FreeCAD rounds differently.
        assert all(abs(numbers[k] - bundled_numbers[k]) < 1e-9 for k in common), kind
