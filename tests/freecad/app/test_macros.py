# SPDX-License-Identifier: MIT
"""The macros that come with Tessera do what they say."""

import csv
import shutil
from pathlib import Path

import FreeCAD
import pytest
import sketches

import tessera
from tessera.tools import resources


def run(name):
    """As FreeCAD does it."""
    path = Path(resources.folder("macros")) / f"{name}.FCMacro"
    scope = {"__name__": "__main__", "__file__": str(path)}
    exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), scope)
    return scope


def test_all_macros_are_tested():
    names = {path.stem for path in Path(resources.folder("macros")).iterdir()}
    assert names == {
        "imprint_faces",
        "local_sizes",
        "mesh_sketch",
        "plate_in_calculix",
        "size_study",
    }


def test_mesh_sketch(document):
    sketches.plate(document)
    run("mesh_sketch")
    (mesh,) = document.findObjects("Fem::FemMeshObject")
    area = sketches.fem_area(mesh.FemMesh)
    assert area == pytest.approx(sketches.PLATE_AREA, rel=1e-2)
    assert len(mesh.FemMesh.getElementNodes(mesh.FemMesh.Faces[0])) == 6


def test_mesh_sketch_explains_what_is_wrong(document):
    sketches.only_open(document)
    run("mesh_sketch")
    assert not document.findObjects("Fem::FemMeshObject")


def test_size_study(document, tmp_path):
    sketches.plate(document)
    document.saveAs(str(tmp_path / "plate.FCStd"))
    run("size_study")
    run("size_study")  # a second file
    assert {path.name for path in tmp_path.glob("*.csv")} == {
        "plate_size_study.csv",
        "plate_size_study_2.csv",
    }
    with open(tmp_path / "plate_size_study.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 5
    sizes = [float(row["size"]) for row in rows]
    triangles = [int(row["triangles"]) for row in rows]
    errors = [float(row["area"]) - sketches.PLATE_AREA for row in rows]
    assert all(b == pytest.approx(a / 2) for a, b in zip(sizes, sizes[1:]))
    assert all(3 * a < b < 5 * a for a, b in zip(triangles, triangles[1:]))
    assert all(0 < b < a / 2.5 for a, b in zip(errors, errors[1:])), "chords converge"
    assert all(float(row["min_angle_deg"]) > 25.0 for row in rows)


def test_local_sizes(document):
    run("local_sizes")
    (obj,) = [o for o in document.Objects if o.isDerivedFrom("Fem::FemMeshObject")]
    assert obj.isValid()
    assert len(obj.FemMesh.Edges) > 0
    groups = {obj.FemMesh.getGroupName(g): g for g in obj.FemMesh.Groups}
    hole = obj.FemMesh.getGroupElements(groups["Bracket_Geometry6"])
    assert len(hole) == pytest.approx(2 * 3.1416 * 8.0, abs=2)  # 1 mm each
    again = tessera.mesh(document.Bracket, 6.0).report["triangles"]
    assert obj.Triangles > 3 * again


def test_local_sizes_makes_a_document():
    sketches.close_all_documents()
    run("local_sizes")
    assert list(FreeCAD.listDocuments()) == ["LocalSizes"]
    sketches.close_all_documents()


def test_plate_in_calculix(tmp_path, monkeypatch):
    assert shutil.which("ccx"), "CalculiX is not installed"
    monkeypatch.setenv("TESSERA_MACRO_FOLDER", str(tmp_path))
    scope = run("plate_in_calculix")
    assert (tmp_path / "plate.vtu").stat().st_size > 10000
    whole = scope["STRESS"] * scope["WIDTH"] / scope["YOUNG"]
    found = scope["stretch"](tmp_path / "plate.dat")
    # The hole takes 24 of 60 mm, so the plate gives way more than without, and less than if a slot
    # of that width went all along it.
    assert 1.05 * whole < found < whole * 60 / (60 - 24)


def test_imprint_faces():
    scope = run("imprint_faces")
    obj = scope["imprinted"]
    assert obj.isValid() and obj.Shape.isValid()
    assert obj.Cells == 10 and not obj.LeftPlaces
    assert float(obj.Area) == pytest.approx(96.0)
    FreeCAD.closeDocument(obj.Document.Name)


@pytest.mark.parametrize("name", ["mesh_sketch", "size_study"])
def test_no_document(name):
    for open_document in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(open_document)
    run(name)
    assert not FreeCAD.listDocuments()
