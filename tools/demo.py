# SPDX-License-Identifier: MIT
"""The part of tools/demo that runs in FreeCAD: meshes sketches, writes the results, checks them
against the drawing (demo_check.py) and prints a table to descriptor 3."""

import glob
import json
import os
import re
import sys
import time
import traceback

import FreeCAD

TOOLS = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, TOOLS)

EXAMPLES = os.path.join(os.path.dirname(TOOLS), "resources", "examples")
SKETCH = "Sketcher::SketchObject"
COLUMNS = (
    ("document", "", "{:<12}"),
    ("sketch", "", "{:<22}"),
    ("triangles", "", "{:>9}"),
    ("min", "angle", "{:>6}"),
    ("mean", "quality", "{:>7}"),
    ("area", "of mesh", "{:>12}"),
    ("area", "drawn", "{:>12}"),
    ("differ-", "ence", "{:>9}"),
    ("chords", "explain", "{:>9}"),
    ("crossings", "", "{:>9}"),
    ("seconds", "", "{:>7}"),
    ("checks", "", " {}"),
)
ROW = " ".join(form for _, _, form in COLUMNS)
HEADER = "\n".join(ROW.format(*(column[line] for column in COLUMNS)) for line in (0, 1))


class Job:
    """A mesh to make: of a sketch, of several together, or as a mesh object of the file asks."""

    def __init__(self, document, name, sketches, constraints=(), mesh_object=None):
        self.document = document
        self.title = title_of(document)
        self.name = name
        self.sketches = sketches
        self.constraints = list(constraints)
        self.mesh_object = mesh_object


class Result:
    def __init__(self, job, stem, mesh, seconds, comparison, drawing):
        self.job, self.stem, self.mesh, self.seconds = job, stem, mesh, seconds
        self.comparison, self.drawing = comparison, drawing

    def summary(self):
        """For summary.json: the mesh, what the drawing demands of it, and what was found."""
        comparison = self.comparison
        return {
            "document": self.job.title,
            "sketch": self.job.name,
            "file": self.stem + ".vtu",
            "triangles": self.mesh.report["triangles"],
            "area": comparison.area,
            "drawn_area": comparison.drawn_area,
            "chord_error": comparison.chord_error,
            "outline": comparison.outline,
            "drawn_outline": comparison.drawn_outline,
            "chord_shortening": comparison.chord_shortening,
            "crossings": self.mesh.report["crossings"],
            "drawn_crossings": self.drawing.crossings,
            "pieces": comparison.pieces,
            "missing_pieces": comparison.missing,
            "problems": comparison.problems,
            "seconds": self.seconds,
        }


def title_of(document):
    """The name of the document's file, whose letters FreeCAD's own name may lack."""
    return os.path.splitext(os.path.basename(document.FileName))[0]


def edges_of(sketch, base):
    """Edges of what the sketch draws, construction geometry left out, in the frame base."""
    frame = base.inverse().multiply(sketch.Placement)
    edges = []
    for index, geometry in enumerate(sketch.Geometry):
        if not sketch.getConstruction(index):
            shape = geometry.toShape()
            shape.Placement = frame.multiply(shape.Placement)
            edges += shape.Edges
    return edges


def drawing_of(sketches, constraints=()):
    from demo_check import Drawing

    base = sketches[0].Placement
    return Drawing(
        [edges_of(sketch, base) for sketch in sketches],
        [edge for sketch in constraints for edge in edges_of(sketch, base)],
    )


def has_closed_outline(sketch):
    edges = edges_of(sketch, sketch.Placement)
    return bool(edges) and any(curve.boundary for curve in drawing_of([sketch]).curves)


def jobs_of(document, only=None):
    """A job for each mesh object of the document, and one for each further sketch with a closed
    outline, or only for the sketch of that name."""
    from tessera.objects.planar_mesh import is_planar_mesh

    jobs, used = [], set()
    for obj in document.Objects:
        if is_planar_mesh(obj) and obj.Source is not None and obj.Source.isDerivedFrom(SKETCH):
            constraints = [link[0] for link in obj.Constraints]
            jobs.append(Job(document, obj.Source.Label, [obj.Source], constraints, obj))
            used.update(sketch.Name for sketch in [obj.Source] + constraints)
    for sketch in document.findObjects(SKETCH):
        wanted = sketch.Name == only if only else sketch.Name not in used
        if wanted and has_closed_outline(sketch):
            jobs.append(Job(document, sketch.Label, [sketch]))
    return jobs


def run(job, out, stem):
    """Meshes, puts the mesh into the document, writes and checks it."""
    import tessera
    from tessera.objects import planar_mesh

    stages = os.path.join(out, "stages", stem)
    if len(job.sketches) > 1:
        begin = time.perf_counter()
        mesh = tessera.mesh(job.sketches)
        seconds = time.perf_counter() - begin
        obj = job.document.addObject("Fem::FemMeshObject", "PlanarMesh")
        obj.Label = f"{job.name} mesh"
        obj.FemMesh = mesh.to_fem()
        tessera.mesh(job.sketches, recovery="steiner", stages=stages)
    else:
        obj = job.mesh_object or planar_mesh.make_planar_mesh(job.sketches[0])
        request = planar_mesh.request_of(obj)
        prepared = request.prepare()
        begin = time.perf_counter()
        mesh = request.mesh(prepared)
        seconds = time.perf_counter() - begin
        obj.Proxy.offer(request, mesh)
        obj.recompute()
        tessera.mesh(
            prepared, size=request.size, growth=request.growth, recovery="steiner", stages=stages
        )
    mesh.write(os.path.join(out, stem + ".vtu"))
    mesh.plot(os.path.join(out, stem + ".png"))

    from demo_check import MeshComparison, read_vtu

    drawing = drawing_of(job.sketches, job.constraints)
    comparison = MeshComparison(drawing, *read_vtu(os.path.join(out, stem + ".vtu")))
    if (obj.FemMesh.NodeCount, obj.FemMesh.FaceCount) != (len(mesh.nodes), len(mesh.triangles)):
        comparison.problems.append("the document's FEM mesh is another one")
    return Result(job, stem, mesh, seconds, comparison, drawing)


def file_name(text, taken):
    """A name made of the text that is not taken yet; takes it."""
    stem = name = re.sub(r"[^\w.-]+", "-", text)[:80].strip("-")
    number = 1
    while name in taken:
        number += 1
        name = f"{stem}-{number}"
    taken.add(name)
    return name


def place_for(path, out, taken):
    """Where the meshed document goes: never onto a document of the user."""
    stem, extension = os.path.splitext(os.path.basename(path))
    if os.path.dirname(os.path.realpath(path)) == os.path.realpath(out):
        stem += "-meshed"
    return os.path.join(out, file_name(stem, taken) + extension)


def table_row(result):
    report, comparison = result.mesh.report, result.comparison
    return ROW.format(
        result.job.title[:12],
        result.job.name[:22],
        report["triangles"],
        f"{report['min_angle_deg']:.1f}",
        f"{report['mean_quality']:.3f}",
        f"{comparison.area:.6f}",
        f"{comparison.drawn_area:.6f}",
        f"{comparison.area - comparison.drawn_area:+.2g}",
        f"{comparison.chord_error:.2g}",
        report["crossings"],
        f"{result.seconds:.2f}",
        "; ".join(comparison.problems) or f"ok, {comparison.pieces} pieces of curves",
    )


def bundled():
    """(file, name of the one sketch wanted or None, sketches to mesh together)."""
    for name in ("bracket", "concrete", "ship"):
        yield os.path.join(EXAMPLES, name + ".FCStd"), None, ()
    yield os.path.join(EXAMPLES, "boolean.FCStd"), None, ("Square", "Star")
    mod = os.path.join(FreeCAD.getHomePath(), "Mod")
    places = ("Path/PathTests", "CAM/CAMTests")  # before 1.0, since
    found = [f for place in places for f in glob.glob(os.path.join(mod, place, "Drilling_1.FCStd"))]
    if found:
        yield found[0], "largest", ()
    else:
        say("FreeCAD's own Drilling_1.FCStd is not installed")


def largest(document):
    def extent(sketch):
        return sketch.Shape.BoundBox.DiagonalLength

    return max(document.findObjects(SKETCH), key=extent).Name


def say(text):
    with open(3, "w", closefd=False) as terminal:
        print(text, file=terminal, flush=True)


def mesh_file(path, out, taken, only, together):
    """Summaries of the meshes, and whether all is well."""
    try:
        document = FreeCAD.openDocument(path)
    except Exception as error:
        say(f"{os.path.basename(path):<12} cannot be opened: {' '.join(str(error).split())}")
        return [], False
    jobs = jobs_of(document, largest(document) if only == "largest" else only)
    if together:
        sketches = [document.getObject(name) for name in together]
        jobs.append(Job(document, " + ".join(together), sketches))
    good = True
    summaries = []
    for job in jobs:
        try:
            result = run(job, out, file_name(f"{job.title}-{job.name}", taken))
            say(table_row(result))
            summaries.append(result.summary())
            good = good and not result.comparison.problems
        except Exception as error:
            traceback.print_exc()
            say(f"{job.title[:12]:<12} {job.name[:22]:<22} {error}")
            good = False
    if not jobs:
        say(f"{title_of(document):<12} no sketch with a closed outline")
    saved = place_for(path, out, taken)
    if os.path.exists(saved):
        os.remove(saved)  # FreeCAD would keep it beside as a backup
    document.saveAs(saved)
    FreeCAD.closeDocument(document.Name)
    return summaries, good and bool(jobs)


def main():
    out = os.environ["TESSERA_DEMO_OUT"]
    os.makedirs(out, exist_ok=True)
    files = [(path, None, ()) for path in os.environ["TESSERA_DEMO_FILES"].split("\n") if path]
    say(HEADER)
    taken = set()
    results = [mesh_file(path, out, taken, *more) for path, *more in files or bundled()]
    summaries = [summary for found, _ in results for summary in found]
    with open(os.path.join(out, "summary.json"), "w") as stream:
        json.dump(summaries, stream, indent=2)
    good = all(fine for _, fine in results)
    say(
        f"\n{len(summaries)} meshes in {len(results)} documents; "
        + ("all checks passed" if good else "NOT ALL COULD BE MESHED AND CHECKED, see above")
        + f"\ndocuments, .vtu, .png: {out}\npictures of the stages: {os.path.join(out, 'stages')}"
    )
    return 0 if good else 1


status = 2
try:
    status = main()
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
sys.stderr.flush()
os._exit(status)
