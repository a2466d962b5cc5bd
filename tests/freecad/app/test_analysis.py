# SPDX-License-Identifier: MIT
"""The mesh serves an analysis."""

import shutil

import ObjectsFem
import pytest
import sketches

from tessera.objects import planar_mesh

LENGTH, WIDTH, THICKNESS = 100.0, 10.0, 2.0
E_MODULUS, FORCE = 210000.0, 1000.0


def test_joins_an_analysis(document):
    from femtools import membertools

    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    obj = planar_mesh.make_planar_mesh(sketches.plate(document), analysis)
    document.recompute()
    assert obj in analysis.Group
    assert membertools.get_mesh_to_solve(analysis)[0] is obj


def bar_in_tension(document, order):
    """A bar that is held at its left edge and pulled at its right one, without lateral strain."""
    sketch = sketches.new_sketch(document)
    sketches.add_rectangle(sketch, 0, 0, LENGTH, WIDTH)
    document.recompute()
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    solvers = ("makeSolverCalculiXCcxTools", "makeSolverCalculixCcxTools")
    make_solver = next(getattr(ObjectsFem, n) for n in solvers if hasattr(ObjectsFem, n))
    solver = make_solver(document, "CalculiX")
    material = ObjectsFem.makeMaterialSolid(document, "Steel")
    material.Material = {
        "Name": "Steel",
        "YoungsModulus": f"{E_MODULUS} MPa",
        "PoissonRatio": "0.0",
        "Density": "7900 kg/m^3",
    }
    thickness = ObjectsFem.makeElementGeometry2D(document, THICKNESS, "Thickness")
    left, right = edge_at(sketch, 0.0), edge_at(sketch, LENGTH)
    fixed = ObjectsFem.makeConstraintFixed(document, "Fixed")
    fixed.References = [(sketch, left)]
    force = ObjectsFem.makeConstraintForce(document, "Force")
    force.References = [(sketch, right)]
    is_float = force.getTypeIdOfProperty("Force") == "App::PropertyFloat"
    force.Force = FORCE if is_float else f"{FORCE} N"
    force.Direction = (sketch, [edge_along_x(sketch)])
    force.Reversed = False
    mesh = planar_mesh.make_planar_mesh(sketch, analysis, size=4.0, order=order)
    for member in (solver, material, thickness, fixed, force):
        analysis.addObject(member)
    document.recompute()
    assert mesh.isValid(), mesh.getStatusString()
    if force.DirectionVector.x < 0:
        force.Reversed = True
        document.recompute()
    return analysis, solver


def edge_at(sketch, x):
    return next(
        f"Edge{i + 1}"
        for i, edge in enumerate(sketch.Shape.Edges)
        if all(abs(v.X - x) < 1e-9 for v in edge.Vertexes)
    )


def edge_along_x(sketch):
    return next(
        f"Edge{i + 1}"
        for i, edge in enumerate(sketch.Shape.Edges)
        if all(abs(v.Y) < 1e-9 for v in edge.Vertexes)
    )


@pytest.mark.parametrize("order", [1, 2])
def test_calculix_solves_a_bar(document, order, tmp_path):
    from femtools import ccxtools

    assert shutil.which("ccx"), "CalculiX is not installed"
    analysis, solver = bar_in_tension(document, order)
    tools = ccxtools.FemToolsCcx(analysis, solver)
    tools.setup_working_dir(str(tmp_path))
    tools.update_objects()
    assert tools.check_prerequisites() == ""
    tools.purge_results()
    tools.write_inp_file()
    tools.setup_ccx()
    assert tools.ccx_run() in (0, None)
    tools.load_results()
    result = next(
        obj
        for obj in document.Objects
        if obj.isDerivedFrom("Fem::FemResultObject") and obj.DisplacementVectors
    )
    stretch = FORCE * LENGTH / (E_MODULUS * WIDTH * THICKNESS)
    assert max(v.x for v in result.DisplacementVectors) == pytest.approx(stretch, rel=1e-3)
