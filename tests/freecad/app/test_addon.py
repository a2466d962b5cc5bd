# SPDX-License-Identifier: MIT
"""The files by which FreeCAD knows the addon."""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import FreeCAD

import tessera
from tessera.tools import resources

ROOT = Path(__file__).resolve().parents[3]
NAMESPACE = {"a": "https://wiki.freecad.org/Package_Metadata"}


def metadata(path):
    return ElementTree.parse(ROOT / "package.xml").getroot().findtext(path, None, NAMESPACE)


def test_package_is_found_through_the_mod_folder():
    """FreeCAD restores document objects from modules below a Mod folder only."""
    home = Path(FreeCAD.getUserAppDataDir()) / "Mod" / "Tessera"
    assert Path(tessera.__file__) == home / "workbench" / "tessera" / "__init__.py"
    assert sum(Path(p).name == "workbench" and "Tessera" in p for p in sys.path) == 1


def test_metadata_name_what_is_there():
    init_gui = (ROOT / "InitGui.py").read_text(encoding="utf-8")
    classname = metadata("a:content/a:workbench/a:classname")
    assert f"class {classname}(" in init_gui
    assert f"addWorkbench({classname}())" in init_gui
    for path in ("a:icon", "a:content/a:workbench/a:icon"):
        assert (ROOT / metadata(path)).is_file()
    assert (ROOT / metadata("a:content/a:workbench/a:subdirectory")) == ROOT
    assert metadata("a:license") == "MIT"


def test_one_version_everywhere():
    cmake = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"project\(tessera VERSION ([\d.]+)", cmake).group(1)
    assert metadata("a:version") == version == tessera.__version__


def test_resources_are_well_formed():
    files = sorted(ROOT.glob("resources/icons/*.svg")) + sorted(ROOT.glob("resources/ui/*.ui"))
    assert len(files) >= 4
    for file in files:
        ElementTree.parse(file)
    icons = ("", "_mesh_sketch", "_planar_mesh", "_boolean", "_imprint_faces")
    for icon in (f"tessera{name}" for name in icons):
        assert Path(resources.icon(icon)).is_file()
    for form in ("planar_mesh", "sizes", "boolean", "imprinted_faces", "cells"):
        assert Path(resources.form(form)).is_file()


def test_forms_do_not_shadow_what_widgets_have():
    """A field called like a method of its form could not be reached."""
    methods = {"size", "pos", "width", "height", "font", "style", "layout", "show", "hide", "close"}
    for file in ROOT.glob("resources/ui/*.ui"):
        names = [w.get("name") for w in ElementTree.parse(file).iter("widget")]
        assert len(names) == len(set(names))
        assert not methods & set(names)
