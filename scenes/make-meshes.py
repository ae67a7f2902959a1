#!/usr/bin/env python3
"""Makes the meshes of room.toml, mesh-far.toml and edges.toml, beside this file: python3 scenes/make-meshes.py"""

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


def icosahedron(middle):
    """Twelve corners at (0, ±1, ±1.618) and their turns: a golden number that ends, so that the corners are exact."""
    g = 1.618
    vertices = [(0, s, t * g) for s in (-1, 1) for t in (-1, 1)]
    vertices += [(t * g, 0, s) for s in (-1, 1) for t in (-1, 1)]
    vertices += [(s, t * g, 0) for s in (-1, 1) for t in (-1, 1)]
    faces = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                a, b, c = vertices[i], vertices[j], vertices[k]
                if all(sqrt(sum(x * x for x in plus(p, q, -1))) < 2.1 for p, q in ((a, b), (b, c), (c, a))):
                    n = cross(plus(b, a, -1), plus(c, a, -1))
                    outwards = sum(x * y for x, y in zip(n, a)) > 0
                    faces.append((i, j, k) if outwards else (i, k, j))
    return [plus(vertex, middle) for vertex in vertices], faces


def seen_at(scale, pixel, t):
    """What the view of mesh-far.toml or edges.toml sees at that pixel (column, row from the bottom), t lengths of D off.

    A pixel's step is (2, -2, 1) to the right and (-2, -1, 2) upwards, both times `scale`; rays start in the origin's
    plane and run along (-1, -2, -2). Each has length 3 and is square to the others, so that all can stay whole.
    """
    start = plus(plus((0, 0, 0), (2, -2, 1), scale * pixel[0]), (-2, -1, 2), scale * pixel[1])
    return plus(start, (-1, -2, -2), t)


def octahedron(corner, depth):
    """One whose corners and edges lie on the pixels of edges.toml, from pixel `corner` on."""
    front, back = (40, 36, -30), (46, 32, 30)
    rim = [(76, 36, 4), (40, 72, -4), (4, 36, 4), (40, 0, -4)]
    vertices = [seen_at(1, (corner[0] + j, corner[1] + i), depth + k) for j, i, k in (front, back, *rim)]
    # The last two corners of a face are an edge for which Moeller and Trumbore need u + v = 1; neighbours share it.
    faces = [(2, 3, 0), (4, 0, 3), (4, 5, 0), (2, 0, 5), (2, 1, 3), (4, 3, 1), (4, 1, 5), (2, 5, 1)]
    return vertices, faces


def together(*meshes):
    """One mesh of several."""
    vertices, faces = [], []
    for mesh in meshes:
        faces += [tuple(k + len(vertices) for k in face) for face in mesh[1]]
        vertices += mesh[0]
    return vertices, faces


def moved(mesh, by):
    return [plus(vertex, by) for vertex in mesh[0]], mesh[1]


write_obj("knot.obj", "A (2, 3) torus knot, 80 rings of 7 corners", *moved(knot(2, 3, 80, 7, 1.5, 0.3), (2.9, 3.2, 1.55)))
write_obj("floor-light.obj", "The light squares of a checkerboard of 8 by 8", *checkerboard(0, 8, 6))
write_obj("floor-dark.obj", "The dark squares of a checkerboard of 8 by 8", *checkerboard(1, 8, 6))
write_obj(
    "icosahedra.obj",
    "Six icosahedra on the view of mesh-far.toml, 1e1, 1e3, 1e5, 1e6, 1e7 and 3e7 lengths of D off",
    *together(
        *(
            icosahedron(seen_at(0.025, (29.5 + 60 * (k % 3), 89.5 - 60 * (k // 3)), far))
            for k, far in enumerate((1e1, 1e3, 1e5, 1e6, 1e7, 3e7))
        )
    ),
)
write_obj(
    "octahedra.obj",
    "Two octahedra, the second a tenth deeper, so that its corners are not quite where they are written",
    *together(octahedron((0, 0), 100), octahedron((80, 0), 100.1)),
)
