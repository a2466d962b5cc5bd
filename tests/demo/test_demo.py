# SPDX-License-Identifier: MIT
"""tools/demo from start to end, and its meshes proved by VTK: every cell valid, the area that of
the drawing, no hanging nodes (the edges used once have the outline's length)."""

import json
import os
import subprocess
import zipfile
from pathlib import Path

import pytest
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkFiltersGeneral import vtkCellValidator
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

PROJECT = Path(__file__).resolve().parents[2]
DEMO = PROJECT / "tools" / "demo"
MESHES = [
    "bracket-Bracket",
    "concrete-Specimen",
    "ship-Midship",
    "boolean-Square",
    "boolean-Self-intersecting-polygon",
    "boolean-Square-Star",
    "Drilling_1-Sketch",
]
VTK_TRIANGLE = 5


def run_demo(out, *files):
    return subprocess.run(
        [DEMO, *files],
        cwd="/",
        env={**os.environ, "TESSERA_DEMO_OUT": str(out)},
        capture_output=True,
        text=True,
    )


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    """The folder that a demo without arguments leaves, and what it printed."""
    out = tmp_path_factory.mktemp("the demo")
    run = run_demo(out)
    assert run.returncode == 0, run.stdout + run.stderr
    return out, run.stdout


@pytest.fixture(scope="module")
def summaries(demo):
    found = json.loads((demo[0] / "summary.json").read_text())
    return {Path(summary["file"]).stem: summary for summary in found}


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def triangles_of(path):
    """The surface of a file, as VTK makes it."""
    surface = vtkGeometryFilter()
    surface.SetInputData(read(path))
    surface.Update()
    return surface.GetOutput()


def sizes(data, kind):
    size = vtkCellSizeFilter()
    size.SetInputData(data)
    size.Update()
    return vtk_to_numpy(size.GetOutput().GetCellData().GetArray(kind))


def test_meshes_five_documents(demo, summaries):
    assert sorted(summaries) == sorted(MESHES)
    assert len({summary["document"] for summary in summaries.values()}) == 5
    assert "all checks passed" in demo[1]


@pytest.mark.parametrize("name", MESHES)
def test_drawing_demands_nothing_more(summaries, name):
    summary = summaries[name]
    assert summary["problems"] == [] and summary["missing_pieces"] == 0
    assert summary["crossings"] == summary["drawn_crossings"]


def test_crossings_are_those_of_the_drawings(summaries):
    crossings = {name: summary["crossings"] for name, summary in summaries.items()}
    assert crossings["boolean-Self-intersecting-polygon"] == 14  # seven sides, each crossing four
    assert crossings["concrete-Specimen"] > 40
    assert crossings["ship-Midship"] > 30
    assert crossings["bracket-Bracket"] == crossings["Drilling_1-Sketch"] == 0


@pytest.mark.parametrize("name", MESHES)
def test_vtk_finds_every_cell_valid(demo, summaries, name):
    grid = read(demo[0] / f"{name}.vtu")
    validator = vtkCellValidator()
    validator.SetInputData(grid)
    validator.Update()
    states = vtk_to_numpy(validator.GetOutput().GetCellData().GetArray("ValidityState"))
    assert len(states) == grid.GetNumberOfCells() > 0
    assert not states.any()
    kinds = [grid.GetCellType(i) for i in range(grid.GetNumberOfCells())]
    assert kinds.count(VTK_TRIANGLE) == summaries[name]["triangles"]


@pytest.mark.parametrize("name", MESHES)
def test_vtk_finds_the_area_and_no_hanging_nodes(demo, summaries, name):
    summary = summaries[name]
    surface = triangles_of(demo[0] / f"{name}.vtu")
    area = sizes(surface, "Area").sum()
    slack = 1e-9 * summary["drawn_area"]
    assert abs(area - summary["drawn_area"]) <= summary["chord_error"] + slack

    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.BoundaryEdgesOn()
    edges.Update()
    length = sizes(edges.GetOutput(), "Length").sum()
    assert length == pytest.approx(summary["outline"], rel=1e-9)
    assert length <= summary["drawn_outline"] * (1 + 1e-9)
    assert length >= (summary["drawn_outline"] - summary["chord_shortening"]) * (1 - 1e-9)


@pytest.mark.parametrize("name", MESHES)
def test_pictures_show_something(demo, name):
    stages = demo[0] / "stages" / name
    pictures = [demo[0] / f"{name}.png"] + sorted(stages.glob("*.png"))
    assert [path.stem for path in pictures[1:8]] == [
        "1-rectangle",
        "2-points",
        "3-before-recovery",
        "4-recovered",
        "5-outside-removed",
        "6-optimized",
        "7-zoom",
    ]
    for path in pictures:
        with Image.open(path) as picture:
            assert max(picture.size) >= 800, path
            assert len(picture.convert("RGB").getcolors(1 << 24)) > 2, path


def test_steiner_points_are_drawn_before_and_after(demo):
    for name in ("concrete-Specimen", "ship-Midship"):
        for stage in ("steiner-before", "steiner-after"):
            assert (demo[0] / "stages" / name / f"{stage}.png").is_file()


def test_documents_hold_the_meshes(demo, summaries):
    for document in {summary["document"] for summary in summaries.values()}:
        with zipfile.ZipFile(demo[0] / f"{document}.FCStd") as archive:
            meshes = [info for info in archive.infolist() if info.filename.startswith("FemMesh")]
            expected = [s for s in summaries.values() if s["document"] == document]
            assert len(meshes) == len(expected)
            for info in meshes:  # an element takes more than ten characters in FreeCAD's format
                assert info.file_size > 10 * min(s["triangles"] for s in expected)


def test_a_file_that_cannot_be_read_is_refused(tmp_path):
    run = run_demo(tmp_path / "out", tmp_path / "missing.FCStd")
    assert run.returncode == 1
    assert "missing.FCStd" in run.stderr
    assert not (tmp_path / "out").exists()


@pytest.fixture(scope="module")
def odd_documents(tmp_path_factory):
    folder = tmp_path_factory.mktemp("odd documents")
    home = tmp_path_factory.mktemp("home")
    environment = {
        **os.environ,
        "TESSERA_ODD_DOCUMENTS": str(folder),
        "FREECAD_USER_HOME": str(home),
    }
    script = Path(__file__).with_name("odd_documents.py")
    subprocess.run(["freecadcmd", script], env=environment, check=True, capture_output=True)
    return folder


def test_odd_documents(odd_documents, tmp_path):
    """What has no closed outline or cannot be opened is told in a line; the rest is meshed."""
    files = sorted(odd_documents.glob("*.FCStd"))
    assert len(files) == 5
    before = {path: path.read_bytes() for path in files}
    run = run_demo(tmp_path, *files)
    assert run.returncode == 1
    lines = run.stdout.splitlines()
    for name, words in (
        ("construction", "no sketch with a closed outline"),
        ("box", "no sketch with a closed outline"),
        ("broken", "cannot be opened"),
    ):
        assert [line for line in lines if line.startswith(name) and words in line], run.stdout
    assert "Traceback" not in run.stdout
    summaries = json.loads((tmp_path / "summary.json").read_text())
    areas = {summary["file"]: summary["drawn_area"] for summary in summaries}
    assert sorted(areas.values()) == pytest.approx([50 - 3.14159265, 50, 100])
    assert len(areas) == 3 and all(summary["problems"] == [] for summary in summaries)
    assert all((tmp_path / name).is_file() for name in areas)
    assert {path: path.read_bytes() for path in files} == before


def test_documents_in_the_folder_of_the_demo_stay(odd_documents, tmp_path):
    copy = tmp_path / "rotated.FCStd"
    copy.write_bytes((odd_documents / "rotated.FCStd").read_bytes())
    before = copy.read_bytes()
    run = run_demo(tmp_path, copy)
    assert run.returncode == 0, run.stdout + run.stderr
    assert copy.read_bytes() == before
    assert (tmp_path / "rotated-meshed.FCStd").is_file()
