# SPDX-License-Identifier: MIT
"""What a drawing demands of its mesh, worked out from FreeCAD's curves without the mesher: area of
the inside, crossings, and every piece of every curve. Compares a mesh with it.

Inside is what any operand covers; an operand covers by the even-odd rule what its boundary curves
enclose. Boundary curves are those on closed chains, the others are constraints."""

import math

import numpy as np

# Five Gauss-Legendre points: exact for polynomials up to degree 9.
GAUSS_X, GAUSS_W = np.polynomial.legendre.leggauss(5)
SPANS = 64  # integration spans of a piece of a curve that is not straight


class DrawnCurve:
    """One edge of the drawing, in the x-y plane of the first sketch."""

    def __init__(self, edge, operand):
        self.edge = edge
        self.operand = operand
        self.boundary = False
        self.first, self.last = edge.ParameterRange
        self.straight = edge.Curve.TypeId == "Part::GeomLine"
        self.ends = [self.point(self.first), self.point(self.last)]
        box = edge.BoundBox
        self.box = (box.XMin, box.YMin, box.XMax, box.YMax)
        self.cuts = [self.first, self.last]  # parameters where the drawing splits it

    def point(self, t):
        p = self.edge.valueAt(t)
        return np.array([p.x, p.y])

    def parameter(self, p):
        """Of the nearest point of the whole line, circle, ...; may lie outside of the range."""
        if self.straight:
            a, b = self.ends
            fraction = np.dot(p - a, b - a) / np.dot(b - a, b - a)
            return self.first + fraction * (self.last - self.first)
        from FreeCAD import Vector

        t = self.edge.Curve.parameter(Vector(p[0], p[1], 0))
        if self.edge.Curve.isPeriodic():
            period = self.edge.Curve.period()
            t = min((t - period, t, t + period), key=lambda u: max(self.first - u, u - self.last))
        return t


class Drawing:
    """operands: a list of lists of edges; constraints: further edges that bound nothing."""

    def __init__(self, operands, constraints=()):
        self.curves = [DrawnCurve(e, i) for i, edges in enumerate(operands) for e in edges]
        self.curves += [DrawnCurve(edge, None) for edge in constraints]
        boxes = np.array([curve.box for curve in self.curves])
        self.boxes = boxes
        self.size = float(np.hypot(*(boxes[:, 2:].max(axis=0) - boxes[:, :2].min(axis=0))))
        self.tolerance = 1e-8 * self.size
        self._set_roles()
        self.crossings, self.touches = self._split()
        self._operand_segments = [self._segments_of(i) for i in range(len(operands))]
        #: (curve, from, to, covered on the left, on the right) of each piece between cuts.
        self.pieces = list(self._pieces())

    def key(self, p):
        return tuple(np.round(p / (10 * self.tolerance)).astype(np.int64))

    def _set_roles(self):
        """Boundary: the curves of a chain whose every end joins an even number of curves."""
        for operand in {c.operand for c in self.curves} - {None}:
            curves = [c for c in self.curves if c.operand == operand]
            degree, leader = {}, {}

            def find(key):
                while leader.setdefault(key, key) != key:
                    key = leader[key]
                return key

            for curve in curves:
                for end in curve.ends:
                    degree[self.key(end)] = degree.get(self.key(end), 0) + 1
                leader[find(self.key(curve.ends[0]))] = find(self.key(curve.ends[1]))
            open_chains = {find(key) for key, count in degree.items() if count % 2}
            for curve in curves:
                curve.boundary = find(self.key(curve.ends[0])) not in open_chains

    def _split(self):
        """Cuts every curve where another meets it; returns the numbers of distinct points where
        curves cross and none ends, and where ends lie inside other curves."""
        crossings, touches = set(), set()
        for i, curve in enumerate(self.curves):
            near = np.flatnonzero(
                (self.boxes[:, 0] <= curve.box[2] + self.tolerance)
                & (self.boxes[:, 2] >= curve.box[0] - self.tolerance)
                & (self.boxes[:, 1] <= curve.box[3] + self.tolerance)
                & (self.boxes[:, 3] >= curve.box[1] - self.tolerance)
            )
            for j in near[near > i]:
                other = self.curves[j]
                for point in self._meetings(curve, other):
                    inner = [self._cut(c, point) for c in (curve, other)]
                    if all(inner):
                        crossings.add(self.key(point))
                    elif any(inner):
                        touches.add(self.key(point))
        for curve in self.curves:
            curve.cuts = self._distinct(curve)
        ends = {self.key(end) for curve in self.curves for end in curve.ends}
        return len(crossings - ends), len(touches | crossings & ends)

    def _cut(self, curve, point):
        """Notes that the point lies on the curve; true if inside it, not at an end."""
        if min(np.hypot(*(point - end)) for end in curve.ends) <= 10 * self.tolerance:
            return False
        curve.cuts.append(curve.parameter(point))
        return True

    def _distinct(self, curve):
        cuts = []
        for t in sorted(curve.cuts):
            if not cuts or np.hypot(*(curve.point(t) - curve.point(cuts[-1]))) > self.tolerance:
                cuts.append(t)
        if len(cuts) == 1:  # a closed curve that nothing meets
            return [curve.first, curve.last]
        cuts[-1] = curve.last
        return cuts

    def _meetings(self, a, b):
        if a.straight and b.straight:
            points = line_meetings(*a.ends, *b.ends)
        elif a.straight or b.straight:
            points = line_curve_meetings(*((a, b) if a.straight else (b, a)))
        else:
            points = [np.array([p.X, p.Y]) for p in a.edge.Curve.intersectCC(b.edge.Curve)]
        points += [p for p in a.ends + b.ends]
        return [p for p in points if self._on(a, p) and self._on(b, p)]

    def _on(self, curve, p):
        t = min(max(curve.parameter(p), curve.first), curve.last)
        return np.hypot(*(curve.point(t) - p)) <= self.tolerance

    def _segments_of(self, operand):
        """The operand's boundary as many short segments, for inside()."""
        segments = []
        for curve in self.curves:
            if curve.boundary and curve.operand == operand:
                if curve.straight:
                    points = np.array(curve.ends)
                else:
                    fine = curve.edge.discretize(QuasiDeflection=1e-7 * self.size)
                    points = np.array([(p.x, p.y) for p in fine])
                    points[0], points[-1] = curve.ends
                segments.append(np.hstack([points[:-1], points[1:]]))
        return np.vstack(segments) if segments else np.zeros((0, 4))

    def inside(self, p):
        """The operands that cover p."""
        covering = set()
        for operand, s in enumerate(self._operand_segments):
            spans = (s[:, 1] > p[1]) != (s[:, 3] > p[1])
            s = s[spans]
            x = s[:, 0] + (p[1] - s[:, 1]) / (s[:, 3] - s[:, 1]) * (s[:, 2] - s[:, 0])
            if np.count_nonzero(x > p[0]) % 2:
                covering.add(operand)
        return covering

    def _pieces(self):
        for curve in self.curves:
            for t0, t1 in zip(curve.cuts, curve.cuts[1:]):
                t = t0 + 0.4871 * (t1 - t0)
                d = curve.edge.derivative1At(t)
                normal = 1e-5 * self.size * np.array([-d.y, d.x]) / math.hypot(d.x, d.y)
                p = curve.point(t)
                yield curve, t0, t1, self.inside(p + normal), self.inside(p - normal)

    def measure(self):
        """(area of the inside, length of its outline), by integrals along the curves."""
        area = length = 0.0
        for curve, t0, t1, left, right in self.pieces:
            if bool(left) != bool(right):
                a, s = integrate(curve, t0, t1)
                area += a if left else -a
                length += s
        return area, length


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def line_meetings(a, b, c, d):
    """Where the lines a-b and c-d meet, unless parallel."""
    u, v = b - a, d - c
    if abs(cross(u, v)) <= 1e-12 * np.hypot(*u) * np.hypot(*v):
        return []
    return [a + cross(c - a, v) / cross(u, v) * u]


def line_curve_meetings(line, curve):
    """Where a curve passes from one side of a line to the other, by bisection. (OpenCASCADE's own
    intersection misses some.)"""
    a, b = line.ends

    def side(t):
        return cross(b - a, curve.point(t) - a)

    parameters = np.linspace(curve.first, curve.last, 256)
    sides = [side(t) for t in parameters]
    points = []
    for i in range(len(sides) - 1):
        if sides[i] * sides[i + 1] < 0:
            low, high = parameters[i], parameters[i + 1]
            for _ in range(60):
                middle = 0.5 * (low + high)
                if side(middle) * sides[i] > 0:
                    low = middle
                else:
                    high = middle
            points.append(curve.point(low))
        elif sides[i] == 0:
            points.append(curve.point(parameters[i]))
    return points


def integrate(curve, t0, t1):
    """(half the integral of x dy - y dx, length) of a piece."""
    spans = np.linspace(t0, t1, 2 if curve.straight else SPANS + 1)
    area = length = 0.0
    for low, high in zip(spans, spans[1:]):
        for x, weight in zip(GAUSS_X, GAUSS_W):
            t = 0.5 * (low + high + x * (high - low))
            p, d = curve.edge.valueAt(t), curve.edge.derivative1At(t)
            w = 0.5 * weight * (high - low)
            area += 0.5 * w * (p.x * d.y - p.y * d.x)
            length += w * math.hypot(d.x, d.y)
    return area, length


def sagitta(curve, u, v, p=None, q=None):
    """Greatest distance of the curve between parameters u and v from the line through p and q; they
    are the curve's own points unless given."""
    p = curve.point(u) if p is None else p
    q = curve.point(v) if q is None else q
    chord = max(np.hypot(*(q - p)), 1e-300)
    return max(abs(cross(q - p, curve.point(u + k / 8 * (v - u)) - p)) / chord for k in range(9))


class MeshComparison:
    """A triangle mesh against a drawing; problems lists, in words, all that is wrong.

    points (n, 2), triangles (m, 3). area is the mesh's, drawn_area the drawing's; the chords of
    curved edges explain a difference of at most chord_error."""

    def __init__(self, drawing, points, triangles):
        self.problems = []
        a, b, c = (points[triangles[:, i]] for i in range(3))
        doubled = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
        if (doubled <= 0).any():
            self.problems.append(f"{np.count_nonzero(doubled <= 0)} inverted triangles")
        self.area = float(0.5 * doubled.sum())
        self.drawn_area, self.drawn_outline = drawing.measure()
        self.sides, uses = sides_of(triangles)
        lengths = np.hypot(*(points[self.sides[:, 0]] - points[self.sides[:, 1]]).T)
        self.outline = float(lengths[uses == 1].sum())
        if (uses > 2).any():
            self.problems.append("sides with more than two triangles")

        self.chord_error = self.chord_shortening = 0.0
        self.pieces = self.missing = 0
        self._side_set = set(map(tuple, self.sides.tolist()))
        nodes = np.unique(triangles)
        self._nodes = nodes[np.argsort(points[nodes, 0], kind="stable")]  # by x
        self._points = points[self._nodes]
        self._drawing = drawing
        self._reach = self._reaches()
        self._shift = 0.0  # between drawn crossings and the mesh's, summed along the outline
        for curve, t0, t1, left, right in drawing.pieces:
            if left or right:
                self._follow(curve, t0, t1, bool(left) != bool(right))
        if self.missing:
            self.problems.append(f"{self.missing} of {self.pieces} pieces of curves are missing")
        slack = 1e-9 * self.drawn_area
        if abs(self.area - self.drawn_area) > self.chord_error + slack:
            self.problems.append("the area differs by more than chords explain")
        slack = 1e-9 * self.drawn_outline + self._shift
        if not -slack <= self.drawn_outline - self.outline <= self.chord_shortening + slack:
            self.problems.append(
                f"the sides of one triangle are {self.outline:.9g} long together, the outline is "
                f"{self.drawn_outline:.9g}"
            )

    def _reaches(self):
        """How far from a drawn crossing the mesh may have it: a curve crossed on a chord is missed
        by its sagitta, divided by the sine of the angle (taken as 1/4 or more)."""
        reaches = {}
        for curve in self._drawing.curves:
            if curve.straight:
                continue
            nodes = [t for t, _, _ in self._nodes_on(curve, curve.first, curve.last)]
            for t in curve.cuts:
                u = max((v for v in nodes if v <= t), default=curve.first)
                v = min((v for v in nodes if v >= t), default=curve.last)
                if u < v:
                    key = self._drawing.key(curve.point(t))
                    reaches[key] = max(reaches.get(key, 0.0), 4 * sagitta(curve, u, v))
        return reaches

    def _end(self, point):
        """(node, its point) of the mesh where the drawing has a piece's end, or None."""
        squares = ((self._points - point) ** 2).sum(axis=1)
        nearest = int(squares.argmin())
        reach = 10 * self._drawing.tolerance + self._reach.get(self._drawing.key(point), 0.0)
        if squares[nearest] > reach**2:
            return None
        return int(self._nodes[nearest]), self._points[nearest]

    def _follow(self, curve, t0, t1, outline):
        """A piece is in the mesh if nodes lie at its ends and sides join those along it."""
        self.pieces += 1
        chain = self._nodes_on(curve, t0, t1)
        for t in (t0, t1):
            end = self._end(curve.point(t))
            if end is None:
                self.missing += 1
                return
            if all(t != u or end[0] != node for u, node, _ in chain):
                chain.append((t, *end))
        chain.sort(key=lambda item: item[0])
        numbers = [number for _, number, _ in chain]
        sides = [(min(side), max(side)) for side in zip(numbers, numbers[1:]) if len(set(side)) > 1]
        if not sides or not self._side_set.issuperset(sides):
            self.missing += 1
            return
        if outline and not curve.straight:
            for (u, _, p), (v, _, q) in zip(chain, chain[1:]):
                # A smooth arc and its chord enclose less than the chord's length times the sagitta.
                chord = np.hypot(*(q - p))
                self.chord_error += chord * sagitta(curve, u, v, p, q)
                self.chord_shortening += max(integrate(curve, u, v)[1] - chord, 0.0)
        if outline:
            ends = ((t0, chain[0][2]), (t1, chain[-1][2]))
            self._shift += sum(np.hypot(*(curve.point(t) - p)) for t, p in ends)

    def _nodes_on(self, curve, t0, t1):
        """(parameter, node, point) of the nodes on a piece, in its order."""
        tolerance = self._drawing.tolerance
        x = self._points[:, 0]
        first = np.searchsorted(x, curve.box[0] - tolerance)
        last = np.searchsorted(x, curve.box[2] + tolerance)
        y = self._points[first:last, 1]
        in_box = (y >= curve.box[1] - tolerance) & (y <= curve.box[3] + tolerance)
        near = first + np.flatnonzero(in_box)
        if curve.straight:
            a, b = curve.ends
            u = (b - a) / np.hypot(*(b - a))
            w = self._points[near] - a
            near = near[np.abs(w[:, 0] * u[1] - w[:, 1] * u[0]) <= tolerance]
        chain = []
        slack = 10 * tolerance * (curve.last - curve.first) / curve.edge.Length
        whole = t0 == curve.first and t1 == curve.last
        closed = whole and np.hypot(*(curve.ends[0] - curve.ends[1])) < tolerance
        for index in near:
            p = self._points[index]
            t = curve.parameter(p)
            if t0 - slack <= t <= t1 + slack and np.hypot(*(curve.point(t) - p)) <= tolerance:
                t = min(max(t, t0), t1)
                chain.append((t, int(self._nodes[index]), p))
                if closed and min(t - t0, t1 - t) <= slack:  # where it closes: both ends
                    chain.append((t1 if t - t0 <= slack else t0, int(self._nodes[index]), p))
        return sorted(chain, key=lambda item: item[0])


def sides_of(triangles):
    """(k, 2) sides, smaller node first, and how many triangles have each."""
    sides = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)


def read_vtu(path):
    """(points (n, 2), triangles (m, 3)) of a plane mesh of triangles, read by VTK."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    corners = [
        [grid.GetCell(i).GetPointId(k) for k in range(3)]
        for i in range(grid.GetNumberOfCells())
        if grid.GetCell(i).GetCellDimension() == 2
    ]
    return points[:, :2].astype(float), np.array(corners)
