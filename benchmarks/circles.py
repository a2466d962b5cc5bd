# SPDX-License-Identifier: MIT
"""2,000 circles that overlap at random, against OpenCASCADE's General Fuse (Part's generalFuse) of
200, in one process: processor time per resulting face. `arrange` is the arrangement alone, `mesh`
everything from the shape to the triangles of all faces, the shape's way through a .brep included.

/usr/bin/python3 benchmarks/circles.py [FILE.json]   (after tools/build; status 1 if arranging a face
takes more than 1/100 of fusing one; FILE.json gets a section for tools/bench_table.py)"""

import json
import math
import os
import random
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "workbench"))
sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402
import Part  # noqa: E402

import tessera  # noqa: E402


def circles(count, low, high):
    uniform = random.Random(33).uniform
    return [
        (uniform(0.0, 1.0), uniform(0.0, 1.0), uniform(low, high)) for _ in range(count)
    ]


def shape_of(x, y, radius):
    return Part.makeCircle(radius, FreeCAD.Vector(x, y, 0.0))


def crossings_of(given):
    """By the formula."""
    count = 0
    for i, (x, y, r) in enumerate(given):
        for u, v, s in given[:i]:
            count += 2 if abs(r - s) < math.hypot(x - u, y - v) < r + s else 0
    return count


def fuse(given):
    faces = [Part.Face(Part.Wire(shape_of(*circle))) for circle in given]
    begin = time.process_time()
    result, _ = faces[0].generalFuse(faces[1:])
    return time.process_time() - begin, len(result.Faces)


def mesh(given):
    shape = Part.Compound([shape_of(*circle) for circle in given])
    begin = time.process_time()
    result = tessera.mesh(shape, fill="all", refine=False, optimize=False)
    seconds = time.process_time() - begin
    report = result.report
    # The stages' times are those of the wall; the share is the same.
    share = report["seconds"]["arrange"] / report["seconds"]["total"]
    return seconds, share * seconds, report


def write_section(path, engines):
    """engines: (name, seconds, faces), as a benchmark of milliseconds for a thousand faces."""
    case = "2,000 circles, a thousand faces"
    runs = [
        {
            "name": f"{case}/{name}",
            "family_index": index,
            "run_type": "iteration",
            "cpu_time": 1e6 * seconds / faces,
            "time_unit": "ms",
            "faces": faces,
        }
        for index, (name, seconds, faces) in enumerate(engines)
    ]
    context = {
        "title": "Circles that overlap at random",
        "peers": "OCCT " + Part.OCC_VERSION,
        "load_avg": os.getloadavg(),
        f"expect {case}": "General Fuse of 200|0.01|0|",
    }
    Path(path).write_text(json.dumps({"context": context, "benchmarks": runs}))


def main():
    many = circles(2000, 0.03, 0.08)
    seconds, arranging, report = mesh(many)
    faces = report["regions"]
    expected = crossings_of(many)
    print(f"2,000 circles: {report['crossings']} crossings ({expected} by the formula), "
          f"{faces} faces; mesh {seconds:.2f} s, arrange {arranging:.2f} s")
    fusing, fused = fuse(circles(200, 0.07, 0.14))
    print(f"General Fuse of 200 circles: {fused} faces, {fusing:.2f} s")
    per_face = fusing / fused
    arrange_ratio = per_face / (arranging / faces)
    print(f"per face: fuse {1e6 * per_face:.0f} us, mesh {1e6 * seconds / faces:.1f} us (1/"
          f"{per_face / (seconds / faces):.0f}), arrange {1e6 * arranging / faces:.1f} us (1/"
          f"{arrange_ratio:.0f})")
    if len(sys.argv) > 1:
        write_section(
            sys.argv[1],
            [
                ("Tessera, arrangement", arranging, faces),
                ("Tessera, mesh", seconds, faces),
                ("General Fuse of 200", fusing, fused),
            ],
        )
    return 0 if arrange_ratio > 100.0 else 1


status = main()
sys.stdout.flush()
os._exit(status)  # FreeCAD's own end is slow
