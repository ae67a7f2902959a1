#!/usr/bin/env python3
"""Makes the meshes of room.toml, beside this file: python3 scenes/make-meshes.py"""

from math import cos, pi, sin, sqrt
from pathlib import Path

HERE = Path(__file__).resolve().parent


def write_obj(name, what, vertices, faces):
    """Writes vertices and faces (tuples of indices from 0) as a Wavefront OBJ file."""
    lines = [f"# {what}; made by scenes/make-meshes.py"]
    lines += ["v " + " ".join(f"{x:.5f}" for x in vertex) for vertex in vertices]
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in faces]
    (HERE / name).write_text("\n".join(lines) + "\n")


def plus(a, b, t=1):
    return tuple(x + t * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    size = sqrt(sum(x * x for x in a))
    return tuple(x / size for x in a)


def knot(p, q, along, across, radius, thickness):
    """A tube about the (p, q) torus knot: `along` rings of `across` corners, joined by quadrilaterals."""

    def curve(t):
        r = radius * (2 + cos(q * t)) / 3
        return (r * cos(p * t), r * sin(p * t), radius * sin(q * t) / 3)

    vertices = []
    for i in range(along):
        t = 2 * pi * i / along
        here = curve(t)
        tangent = unit(plus(curve(t + 1e-3), curve(t - 1e-3), -1))
        # From the torus's own centre line outwards: a side that turns with the knot, so that the rings close.
        ring = (2 * radius / 3 * cos(p * t), 2 * radius / 3 * sin(p * t), 0)
        binormal = unit(cross(tangent, plus(here, ring, -1)))
        normal = cross(binormal, tangent)
        for j in range(across):
            angle = 2 * pi * j / across
            vertices.append(plus(plus(here, normal, thickness * cos(angle)), binormal, thickness * sin(angle)))

    def at(i, j):
        return (i % along) * across + j % across

    faces = [
        (at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)) for i in range(along) for j in range(across)
    ]
    return vertices, faces


def checkerboard(parity, squares, side):
    """Every second square of a board in the plane z = 0, from (0, 0) to (side, side)."""
    step = side / squares
    vertices = [(step * x, step * y, 0) for y in range(squares + 1) for x in range(squares + 1)]
    faces = []
    for y in range(squares):
        for x in range(squares):
            if (x + y) % 2 == parity:
                k = y * (squares + 1) + x
                faces.append((k, k + 1, k + squares + 2, k + squares + 1))
    return vertices, faces


def moved(mesh, by):
    return [plus(vertex, by) for vertex in mesh[0]], mesh[1]


write_obj("knot.obj", "A (2, 3) torus knot, 80 rings of 7 corners", *moved(knot(2, 3, 80, 7, 1.5, 0.3), (2.9, 3.2, 1.55)))
write_obj("floor-light.obj", "The light squares of a checkerboard of 8 by 8", *checkerboard(0, 8, 6))
write_obj("floor-dark.obj", "The dark squares of a checkerboard of 8 by 8", *checkerboard(1, 8, 6))
