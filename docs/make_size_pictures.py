#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the pictures of size-field.md into docs/pictures: PYTHONPATH=workbench python3 THIS FILE."""

import sys
from pathlib import Path

import numpy as np
from PIL import Image

sys.path.append("/usr/lib/freecad-python3/lib")  # where Debian puts FreeCAD's modules

import FreeCAD  # noqa: E402,F401
import Part  # noqa: E402
from FreeCAD import Vector  # noqa: E402

import tessera  # noqa: E402

PICTURES = Path(__file__).resolve().parent / "pictures"
UP = Vector(0, 0, 1)


def circle(x, y, radius):
    return Part.Wire(Part.makeCircle(radius, Vector(x, y), UP))


def plate(*holes):
    outline = Part.makePolygon([Vector(*p) for p in ((0, 0), (30, 0), (30, 16), (0, 16), (0, 0))])
    return Part.Face([outline, *holes])


def bracket():
    """Curves of many radii."""
    slot = Part.Wire(
        [
            Part.makeLine(Vector(17, 4), Vector(25, 4)),
            Part.Arc(Vector(25, 4), Vector(25.7, 4.7), Vector(25, 5.4)).toShape(),
            Part.makeLine(Vector(25, 5.4), Vector(17, 5.4)),
            Part.Arc(Vector(17, 5.4), Vector(16.3, 4.7), Vector(17, 4)).toShape(),
        ]
    )
    return plate(circle(7, 8, 4.5), circle(16, 11.5, 1.2), circle(24, 11, 2.5), slot)


def fins():
    """Narrow webs between holes and to the border."""
    holes = []
    x = 2.0
    for width, web in ((4, 0.7), (4, 1.2), (4, 1.8), (4, 2.6), (4, 0)):
        corners = ((x, 3), (x + width, 3), (x + width, 15.2), (x, 15.2), (x, 3))
        holes.append(Part.makePolygon([Vector(*p) for p in corners]))
        x += width + web
    return plate(*holes)


def two_parts():
    left = Part.Face(Part.makePolygon([Vector(*p) for p in
                                       ((0, 0), (30, 0), (30, 16), (0, 16), (0, 0))]))
    return [left, Part.Face(circle(19, 8, 6))]


def remeshed():
    """Sizes from the bend of a function along a front, as an error estimate gives them."""
    face = plate()
    mesh = tessera.mesh(face, 1.0)
    for _ in range(2):
        from_front = np.abs(np.hypot(mesh.nodes[:, 0] - 4, mesh.nodes[:, 1] + 2) - 16)
        mesh = tessera.mesh(face, 2.0, size_from=(mesh, 0.15 + 0.5 * from_front))
    return mesh


def meshes():
    """(name of the picture, mesh)"""
    hole = plate(circle(10, 8, 3))
    far = {"size_at": [(24, 8, 0.1)]}
    yield "size-growth", tessera.mesh(plate(), 2.0, growth=0.15, **far)
    yield "size-point", tessera.mesh(hole, 2.0, size_at=[(22, 8, 0.3, 2.5), (10, 13, 0.1)])
    yield "size-curve", tessera.mesh(hole, 2.0, size_on={"Edge5": 0.3})
    yield "size-distance", tessera.mesh(hole, 3.0, size_on={"Edge5": (0.4, 2.0, 2.0, 14.0)})
    yield "size-region", tessera.mesh(two_parts(), 2.0, size_in={1: 0.45})
    yield "size-curvature", tessera.mesh(bracket(), 2.5, curvature=36)
    yield "size-gap", tessera.mesh(fins(), 2.5, gap=4)
    wave = "0.3 + 0.2*abs(y - 8 - 4*sin(x/5))"
    yield "size-expression", tessera.mesh(plate(), 2.0, size_expr=wave)
    yield "size-mesh", remeshed()


def shrink(path, width=900):
    with Image.open(path) as picture:
        height = round(picture.height * width / picture.width)
        small = picture.convert("RGB").resize((width, height), Image.LANCZOS)
    small.quantize(48).save(path, optimize=True)


def main():
    for name, mesh in meshes():
        path = PICTURES / f"{name}.png"
        mesh.plot(path)
        shrink(path)
        print(f"{name}: {len(mesh.triangles)} triangles, {mesh.report['mean_quality']:.3f}")


if __name__ == "__main__":
    main()
