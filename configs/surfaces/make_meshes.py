#!/usr/bin/python3
"""Writes the meshes that configs/surfaces.toml and docs/surfaces.md use: a torus (OBJ, quads) and a bumpy sphere (OFF).

    /usr/bin/python3 configs/surfaces/make_meshes.py [FOLDER]
"""
import math
import pathlib
import sys


def torus(around=48, across=24, radius=1.0, tube=0.4):
    """Vertices and quads of a torus around the z axis."""
    vertices, faces = [], []
    for i in range(around):
        for j in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
            distance = radius + tube * math.cos(v)
            vertices.append((distance * math.cos(u), distance * math.sin(u), tube * math.sin(v)))
            right, up = (i + 1) % around, (j + 1) % across
            faces.append((i * across + j, right * across + j, right * across + up, i * across + up))
    return vertices, faces


def icosphere(halvings):
    """Vertices on the unit sphere and triangles: an icosahedron whose triangles are divided into four, again and
    again."""
    g = (1 + math.sqrt(5)) / 2
    vertices = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    vertices = [tuple(c / math.hypot(*v) for c in v) for v in vertices]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    for _ in range(halvings):
        middles, divided = {}, []

        def middle(a, b):
            key = min(a, b), max(a, b)
            if key not in middles:
                sums = [p + q for p, q in zip(vertices[a], vertices[b])]
                vertices.append(tuple(c / math.hypot(*sums) for c in sums))
                middles[key] = len(vertices) - 1
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            divided += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = divided
    return vertices, faces


def bumpy_sphere():
    """A sphere with waves."""
    vertices, faces = icosphere(3)
    waved = []
    for x, y, z in vertices:
        r = 1 + 0.18 * math.sin(4 * x + 1) * math.sin(5 * y) + 0.12 * math.cos(6 * z)
        waved.append((r * x, r * y, r * z))
    return waved, faces


def write_obj(path, vertices, faces):
    with open(path, "w", encoding="ascii") as file:
        for v in vertices:
            file.write("v %.6g %.6g %.6g\n" % v)
        for face in faces:
            file.write("f " + " ".join(str(i + 1) for i in face) + "\n")


def write_off(path, vertices, faces):
    with open(path, "w", encoding="ascii") as file:
        file.write("OFF\n%d %d 0\n" % (len(vertices), len(faces)))
        for v in vertices:
            file.write("%.6g %.6g %.6g\n" % v)
        for face in faces:
            file.write(" ".join(str(i) for i in (len(face), *face)) + "\n")


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    write_obj(folder / "torus.obj", *torus())
    write_off(folder / "bumpy-sphere.off", *bumpy_sphere())


if __name__ == "__main__":
    main()
