# SPDX-License-Identifier: MIT
"""Writes the example documents beside this file; run by FreeCAD:

    freecadcmd resources/examples/make_examples.py

The geometry is computed here, without random numbers from outside, so that every run draws the same
sketches. TESSERA_EXAMPLES_OUT names another folder to write to."""

import itertools
import math
import os
import re
import sys
import tempfile
import uuid
import zipfile

import FreeCAD
import Part
import Sketcher

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "workbench"))
from tessera.objects.planar_mesh import make_planar_mesh

V = FreeCAD.Vector
Z = V(0, 0, 1)
START, END, CENTER = 1, 2, 3


def line(a, b):
    return Part.LineSegment(V(*a), V(*b))


def arc(center, radius, first, last):
    """Counter-clockwise from angle first to angle last, in degrees."""
    circle = Part.Circle(V(*center), Z, radius)
    return Part.ArcOfCircle(circle, math.radians(first), math.radians(last))


def circle(center, radius):
    return Part.Circle(V(*center), Z, radius)


def spline(poles):
    curve = Part.BSplineCurve()
    curve.buildFromPoles([V(*pole) for pole in poles], False, 3)
    return curve


def new_sketch(document, name, label=None):
    sketch = document.addObject("Sketcher::SketchObject", name)
    sketch.Label = label or name
    return sketch


def constrain(sketch, *constraints):
    sketch.addConstraint([Sketcher.Constraint(*c) for c in constraints])


# Bracket: a lug with a bore, bolt holes, slots and a B-spline edge


def slot(sketch, center, half_length, radius, angle):
    """A slot of two arcs and two lines, tangent to each other."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    ends = [(center[0] + k * half_length * c, center[1] + k * half_length * s) for k in (1, -1)]
    shift = (-s * radius, c * radius)

    def beside(end, side):
        return (end[0] + side * shift[0], end[1] + side * shift[1])

    first = sketch.addGeometry(
        [
            arc(ends[0], radius, angle - 90, angle + 90),
            line(beside(ends[0], 1), beside(ends[1], 1)),
            arc(ends[1], radius, angle + 90, angle + 270),
            line(beside(ends[1], -1), beside(ends[0], -1)),
        ]
    )[0]
    constrain(
        sketch,
        ("Tangent", first, END, first + 1, START),
        ("Tangent", first + 1, END, first + 2, START),
        ("Tangent", first + 2, END, first + 3, START),
        ("Tangent", first + 3, END, first, START),
        ("Equal", first, first + 2),
        ("Radius", first, radius),
    )
    place(sketch, first, CENTER, ends[0])
    if angle % 180 == 0:
        constrain(sketch, ("Horizontal", first + 1))
        constrain(sketch, ("DistanceX", first + 2, CENTER, ends[1][0]))
    elif angle % 180 == 90:
        constrain(sketch, ("Vertical", first + 1))
        constrain(sketch, ("DistanceY", first + 2, CENTER, ends[1][1]))
    else:
        place(sketch, first + 2, CENTER, ends[1])


def place(sketch, geometry, point, position):
    constrain(
        sketch,
        ("DistanceX", geometry, point, position[0]),
        ("DistanceY", geometry, point, position[1]),
    )


def hole(sketch, center, radius):
    index = sketch.addGeometry(circle(center, radius))
    constrain(sketch, ("Radius", index, radius))
    place(sketch, index, CENTER, center)


def bracket(document):
    sketch = new_sketch(document, "Bracket")
    bore, outer, fillet = (115.0, 75.0), 30.0, 10.0
    c150, s150 = math.cos(math.radians(150)), math.sin(math.radians(150))
    tangent_point = (bore[0] + outer * c150, bore[1] + outer * s150)
    last_pole = (tangent_point[0] - 18 * s150, tangent_point[1] + 18 * c150)
    outline = [
        line((fillet, 0), (145 - fillet, 0)),
        arc((145 - fillet, fillet), fillet, 270, 360),
        line((145, fillet), (145, bore[1])),
        arc(bore, outer, 0, 150),
        spline([tangent_point, last_pole, (58, 64), (26, 70), (0, 72), (0, 50)]),
        line((0, 50), (0, fillet)),
        arc((fillet, fillet), fillet, 180, 270),
    ]
    bottom, right_fillet, right, boss, edge, left, left_fillet = sketch.addGeometry(outline)
    constrain(
        sketch,
        ("Tangent", bottom, END, right_fillet, START),
        ("Tangent", right_fillet, END, right, START),
        ("Tangent", right, END, boss, START),
        ("Coincident", boss, END, edge, START),
        ("Coincident", edge, END, left, START),
        ("Tangent", left, END, left_fillet, START),
        ("Tangent", left_fillet, END, bottom, START),
        ("Horizontal", bottom),
        ("Vertical", right),
        ("Vertical", left),
        ("Equal", right_fillet, left_fillet),
        ("Radius", left_fillet, fillet),
        ("Radius", boss, outer),
        ("DistanceY", left, START, 50.0),
    )
    place(sketch, left_fillet, CENTER, (fillet, fillet))
    place(sketch, boss, CENTER, bore)
    constrain(sketch, ("DistanceX", boss, END, tangent_point[0]))

    bore_hole = sketch.addGeometry(circle(bore, 16.0))
    constrain(
        sketch, ("Radius", bore_hole, 16.0), ("Coincident", bore_hole, CENTER, boss, CENTER)
    )
    for angle in (45, 135, 225, 315):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        hole(sketch, (bore[0] + 23 * c, bore[1] + 23 * s), 2.5)
    hole(sketch, (62, 44), 9.0)
    slot(sketch, (44, 16), 16, 5, 0)
    slot(sketch, (20, 46), 9, 4.5, 90)
    slot(sketch, (108, 24), 14, 5, 20)
    make_planar_mesh(sketch, size=2.5)


# Concrete: convex gravels that do not meet, in a square whose border some of them cross


class Random:
    """A multiplicative congruential generator (Park and Miller): the same numbers everywhere."""

    def __init__(self, seed):
        self.state = seed

    def uniform(self, low, high):
        self.state = self.state * 48271 % 2147483647
        return low + (high - low) * self.state / 2147483647


def gravel(random, center, radius):
    """A convex polygon with its corners on an ellipse."""
    corners = int(random.uniform(5, 10))
    ratio, turn = random.uniform(0.65, 1.0), random.uniform(0, 2 * math.pi)
    c, s = math.cos(turn), math.sin(turn)
    polygon = []
    for k in range(corners):
        angle = 2 * math.pi * (k + random.uniform(-0.3, 0.3)) / corners
        x, y = radius * math.cos(angle), ratio * radius * math.sin(angle)
        polygon.append((round(center[0] + c * x - s * y, 4), round(center[1] + s * x + c * y, 4)))
    return polygon


def apart(a, b, gap):
    """Convex polygons a and b are at least gap apart along the normal of some side."""
    for first, second in ((a, b), (b, a)):
        for k, p in enumerate(first):
            q = first[(k + 1) % len(first)]
            nx, ny = q[1] - p[1], p[0] - q[0]
            length = math.hypot(nx, ny)
            if min(nx * (r[0] - p[0]) + ny * (r[1] - p[1]) for r in second) >= gap * length:
                return True
    return False


def gravels(count, side, seed):
    """count gravels from the coarsest to the finest, placed where there is room left."""
    random, placed = Random(seed), []
    for k in range(count):
        radius = side * (0.034 * (1 - k / count) ** 3 + 0.011)
        gap = side * 0.006
        while True:
            center = (random.uniform(0, side), random.uniform(0, side))
            candidate = gravel(random, center, radius)
            if all(
                math.dist(center, c) > radius + r + gap or apart(candidate, polygon, gap)
                for c, r, polygon in placed
            ) and clear_of_border(candidate, side, gap):
                placed.append((center, radius, candidate))
                break
    return [polygon for _, _, polygon in placed]


def clear_of_border(polygon, side, gap):
    """Either inside the square by a gap or across its border by more than one."""
    for axis in (0, 1):
        low, high = min(p[axis] for p in polygon), max(p[axis] for p in polygon)
        if -2 * gap < low < gap or side - gap < high < side + 2 * gap:
            return False
    return True


def concrete(document):
    side = 100.0
    outline = new_sketch(document, "Specimen")
    corners = [(0, 0), (side, 0), (side, side), (0, side)]
    polygon(outline, corners)
    for k in range(4):
        constrain(outline, ("Coincident", k, END, (k + 1) % 4, START))
    constrain(
        outline,
        ("Horizontal", 0),
        ("Vertical", 1),
        ("Horizontal", 2),
        ("Vertical", 3),
        ("Coincident", 0, START, -1, START),
        ("DistanceX", 0, START, 0, END, side),
        ("DistanceY", 1, START, 1, END, side),
    )
    stones = new_sketch(document, "Gravels")
    for stone in gravels(500, side, seed=2014):
        polygon(stones, stone)
    # The gravels bound nothing: the mesh covers the whole specimen and keeps their borders.
    make_planar_mesh(outline, size=2.0, constraints=((stones, ("",)),))


def polygon(sketch, corners):
    sides = [line(p, corners[(k + 1) % len(corners)]) for k, p in enumerate(corners)]
    return sketch.addGeometry(sides)


# Ship: a midship section; all that is not hull is drawn as open lines, which become constraints


def ship(document):
    sketch = new_sketch(document, "Midship")
    half = [(0, 0), (6, 0), (12.5, 0.05), (15.7, 0.5), (16.25, 3.6), (16.4, 9), (16.2, 15)]
    half.append((16, 20))
    camber = Part.Arc(V(16, 20), V(0, 20.5), V(-16, 20))
    hull = [spline(half), camber, spline([(-x, y) for x, y in reversed(half)])]
    sketch.addGeometry(hull)
    for k in range(3):
        constrain(sketch, ("Coincident", k, END, (k + 1) % 3, START))

    members = [
        ((-16.8, 1.9), (16.8, 1.9)),  # inner bottom, drawn through the shell
        ((-16.8, 8.5), (16.8, 8.5)),  # lower deck
        ((-16.8, 14.0), (16.8, 14.0)),  # tween deck
        ((0, -0.4), (0, 21.0)),  # center line bulkhead
    ]
    for side in (1, -1):
        members += [((side * x, -0.4), (side * x, 1.9)) for x in (3.5, 10.0)]  # girders
        members += [
            ((side * 7.0, -0.4), (side * 7.0, 2.4)),  # girder below ...
            ((side * 7.0, 1.4), (side * 7.0, 20.8)),  # ... and overlapping the bulkhead
            ((side * 13.8, 1.9), (side * 13.8, 20.7)),  # inner side shell
            ((side * 10.0, 1.9), (side * 16.9, 6.2)),  # hopper plate
            ((side * 9.2, 21.0), (side * 16.9, 14.9)),  # topside tank
            ((side * 13.8, 5.2), (side * 17.0, 5.2)),  # stringers
            ((side * 13.8, 11.2), (side * 17.0, 11.2)),
            ((side * 7.0, 8.5), (side * 13.8, 14.0)),  # struts that cross each other
            ((side * 7.0, 14.0), (side * 13.8, 8.5)),
            ((side * 15.0, 1.4), (side * 16.6, -0.2)),  # bilge keel
        ]
    sketch.addGeometry([line(a, b) for a, b in members])
    make_planar_mesh(sketch, size=0.6)


# Boolean: a polygon that crosses itself, over a square


def boolean(document):
    square = new_sketch(document, "Square")
    polygon(square, [(0, 0), (60, 0), (60, 60), (0, 60)])
    star = new_sketch(document, "Star", "Self-intersecting polygon")
    corners = []
    for k in range(7):  # every third of seven points around the square
        angle = math.radians(97 + 3 * k * 360 / 7)
        reach = (44, 35, 46, 38, 42, 34, 45)[k]
        x, y = 34 + reach * math.cos(angle), 28 + reach * math.sin(angle)
        corners.append((round(x, 3), round(y, 3)))
    polygon(star, corners)


# Imprint: sources and targets of a sweep that cross each other


def flat(z, *corners):
    """A face with straight edges."""
    points = [V(x, y, z) for x, y in corners]
    return Part.Face(Part.makePolygon([*points, points[0]]))


def imprint_sources():
    """Three strips of a plate."""
    return [
        flat(0, (0, 0), (3, 0), (5, 8), (0, 8)),
        flat(0, (3, 0), (9, 0), (7, 8), (5, 8)),
        flat(0, (9, 0), (12, 0), (12, 8), (7, 8)),
    ]


def imprint_targets():
    """A disk and three pieces of the plate around it, higher up."""
    z = 10
    disk = Part.Face(Part.Wire(Part.makeCircle(2.5, V(6, 4, z))))
    around = [
        flat(z, (0, 0), (12, 0), (12, 4), (0, 4)),
        flat(z, (0, 4), (6, 4), (6, 8), (0, 8)),
        flat(z, (6, 4), (12, 4), (12, 8), (6, 8)),
    ]
    return [disk] + [face.cut(disk).Faces[0] for face in around]


def save(document, path):
    """Saves with fixed times and numbers instead of today's: equal drawings are equal files."""
    uid = str(uuid.uuid5(uuid.NAMESPACE_DNS, "tessera." + document.Name)).encode()
    document.License = "MIT"
    document.LicenseURL = "https://spdx.org/licenses/MIT.html"
    with tempfile.TemporaryDirectory() as folder:
        saved = os.path.join(folder, "document.FCStd")
        document.saveCopy(saved)
        with zipfile.ZipFile(saved) as old, zipfile.ZipFile(path, "w") as new:
            for name in old.namelist():
                content = old.read(name)
                if name == "Document.xml":
                    today = rb'"[-0-9]{10}T[0-9:]{8}Z?"'
                    content = re.sub(today, b'"2024-01-01T00:00:00Z"', content)
                    content = re.sub(rb'<Uuid value="[^"]*"', b'<Uuid value="%s"' % uid, content)
                    number = itertools.count(1)
                    content = re.sub(
                        rb'(<Object type="[^"]*" name="[^"]*" id=)"[0-9]+"',
                        lambda match: match[1] + b'"%d"' % next(number),
                        content,
                    )
                entry = zipfile.ZipInfo(name, (2024, 1, 1, 0, 0, 0))
                new.writestr(entry, content, zipfile.ZIP_DEFLATED)


def main():
    folder = os.environ.get("TESSERA_EXAMPLES_OUT", HERE)
    for make in (bracket, concrete, ship, boolean):
        document = FreeCAD.newDocument(make.__name__)
        make(document)
        document.recompute(document.findObjects("Sketcher::SketchObject"))
        save(document, os.path.join(folder, make.__name__ + ".FCStd"))
        for sketch in document.findObjects("Sketcher::SketchObject"):
            print(make.__name__, sketch.Label, sketch.GeometryCount, "curves")
        FreeCAD.closeDocument(document.Name)
    for make in (imprint_sources, imprint_targets):
        Part.Compound(make()).exportBrep(os.path.join(folder, make.__name__ + ".brep"))


try:
    main()
except Exception:
    import traceback

    traceback.print_exc()
    sys.stdout.flush()
    os._exit(1)
sys.stdout.flush()
os._exit(0)
