# SPDX-License-Identifier: MIT
"""`cmake --install` into a Mod folder leaves an addon that FreeCAD finds and that meshes. Needs a
finished build, whose folder TESSERA_BUILD names."""

import os
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]

MESH_A_SQUARE = """
import os, sys, traceback
status = 1
try:
    import FreeCAD, Part, tessera
    corners = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)]
    square = Part.makePolygon([FreeCAD.Vector(*corner) for corner in corners])
    mesh = tessera.mesh(square, size=1.0)
    fem = mesh.to_fem()
    print(f"area {mesh.report['area']:.9f} faces {fem.FaceCount == len(mesh.triangles)}")
    print("from", os.path.dirname(tessera.__file__))
    status = 0
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
os._exit(status)
"""


@pytest.fixture(scope="module")
def user_folder(tmp_path_factory):
    """A user's FreeCAD folder, with a space in its name, where the addon has been installed."""
    folder = tmp_path_factory.mktemp("free cad")
    subprocess.run(
        ["cmake", "--install", os.environ["TESSERA_BUILD"], "--prefix", folder / "Mod" / "Tessera"],
        check=True,
        capture_output=True,
    )
    return folder


def test_no_caches_and_no_foreign_modules_are_installed(user_folder):
    # First of all tests: running the addon makes caches.
    addon = user_folder / "Mod" / "Tessera"
    assert not list(addon.rglob("__pycache__"))
    assert len(list(addon.rglob("*.so"))) == 1


def test_freecad_meshes_with_the_installed_addon(user_folder):
    script = user_folder / "mesh_a_square.py"
    script.write_text(MESH_A_SQUARE)
    run = subprocess.run(
        ["freecadcmd", str(script)],
        env={**os.environ, "FREECAD_USER_HOME": str(user_folder)},
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert "area 16.000000000 faces True" in run.stdout
    assert f"from {user_folder}/Mod/Tessera/" in run.stdout


def test_addon_has_all_that_its_metadata_names(user_folder):
    addon = user_folder / "Mod" / "Tessera"
    root = ElementTree.parse(addon / "package.xml").getroot()
    space = {"p": "https://wiki.freecad.org/Package_Metadata"}
    named = [icon.text for icon in root.findall(".//p:icon", space)]
    named += [license.get("file") for license in root.findall("p:license", space)]
    assert len(named) >= 2
    for name in named + ["Init.py", "InitGui.py"]:
        assert (addon / name).is_file(), name


def test_installed_command_line_runs(user_folder):
    version = subprocess.run(
        [user_folder / "Mod" / "Tessera" / "bin" / "tessera", "--version"],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    metadata = ElementTree.parse(user_folder / "Mod" / "Tessera" / "package.xml").getroot()
    assert metadata.findtext("{https://wiki.freecad.org/Package_Metadata}version") in version
